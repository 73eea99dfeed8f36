// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// ResetCamera(), and the view without a camera, frame the inputs like vtkRenderer.
#include "Meshes.h"
#include "Messages.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace
{
/// A box away from the origin, longest along y.
Mesh makeSubject()
{
  const Mesh box = makeBox(0.5, 2.0, 1.0);
  std::vector<Vec> points = pointsOf(box);
  for (Vec& point : points)
  {
    point += Vec(3.0, -1.0, 0.5);
  }
  Mesh mesh = makeMesh(points, {});
  mesh->SetPolys(box->GetPolys());
  return mesh;
}

void resetByRenderer(vtkCamera* camera, const int size[2], const double bounds[6])
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->SetActiveCamera(camera);
  // VTK 9.1's viewport compares the size with one that is not set yet, but notices a change.
  window->SetSize(size[0] + 1, size[1] + 1);
  renderer->ComputeAspect();
  window->SetSize(size[0], size[1]);
  renderer->ResetCamera(bounds);
}

void expectNear(const Vec& found, const Vec& expected, const char* what)
{
  EXPECT_LE(glm::length(found - expected), 1e-12 * glm::length(expected)) << what;
}

void expectSameView(vtkCamera* found, vtkCamera* expected)
{
  expectNear(
    glm::make_vec3(found->GetPosition()), glm::make_vec3(expected->GetPosition()), "position");
  expectNear(glm::make_vec3(found->GetFocalPoint()), glm::make_vec3(expected->GetFocalPoint()),
    "focal point");
  expectNear(glm::make_vec3(found->GetViewUp()), glm::make_vec3(expected->GetViewUp()), "view-up");
  EXPECT_EQ(found->GetViewAngle(), expected->GetViewAngle());
  EXPECT_NEAR(
    found->GetParallelScale(), expected->GetParallelScale(), 1e-12 * expected->GetParallelScale());
  EXPECT_EQ(found->GetParallelProjection(), expected->GetParallelProjection());
  EXPECT_EQ(found->GetUseHorizontalViewAngle(), expected->GetUseHorizontalViewAngle());
}
}

TEST(ResetCamera, EqualsTheRenderers)
{
  const Mesh mesh = makeSubject();
  const int sizes[][2] = { { 300, 300 }, { 640, 200 }, { 100, 350 } };
  for (const auto& size : sizes)
  {
    for (int kind = 0; kind < 4; ++kind)
    {
      SCOPED_TRACE(testing::Message() << size[0] << " x " << size[1] << ", kind " << kind);
      Studio studio(size[0], size[1]);
      studio.look({ 1.0, 2.0, 9.0 }, { 0.5, 0.0, -3.0 }, { 0.2, 0.9, 0.1 });
      studio.camera->SetViewAngle(77.0);
      studio.camera->SetParallelProjection(kind & 1);
      studio.camera->SetUseHorizontalViewAngle(kind & 2);
      vtkNew<vtkCamera> expected;
      expected->DeepCopy(studio.camera);
      resetByRenderer(expected, size, mesh->GetBounds());
      studio.tracer->SetInputData(mesh);
      studio.tracer->ResetCamera();
      EXPECT_EQ(studio.tracer->GetCamera(), studio.camera);
      expectSameView(studio.camera, expected);
    }
  }
}

TEST(ResetCamera, ReplacesAParallelViewUpLikeTheRenderer)
{
  const Mesh mesh = makeSubject();
  Studio studio(60, 40);
  studio.look({ 0.0, 9.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0001 });
  vtkNew<vtkCamera> expected;
  expected->DeepCopy(studio.camera);
  vtkObject::GlobalWarningDisplayOff(); // the renderer warns
  resetByRenderer(expected, studio.tracer->GetImageSize(), mesh->GetBounds());
  vtkObject::GlobalWarningDisplayOn();
  studio.tracer->SetInputData(mesh);
  studio.tracer->ResetCamera();
  expectSameView(studio.camera, expected);
}

TEST(ResetCamera, FramesASinglePoint)
{
  Studio studio(60, 40);
  const Mesh mesh = makeMesh({ { 1.0, 2.0, 3.0 } }, { { 0, 0, 0 } });
  vtkNew<vtkCamera> expected;
  expected->DeepCopy(studio.camera);
  resetByRenderer(expected, studio.tracer->GetImageSize(), mesh->GetBounds());
  studio.tracer->SetInputData(mesh);
  studio.tracer->ResetCamera();
  expectSameView(studio.camera, expected);
}

TEST(ResetCamera, FramesAllInputs)
{
  Studio studio(60, 40);
  studio.tracer->AddInputDataObject(makeSubject());
  studio.tracer->AddInputDataObject(makeBox(4.0, 1.0, 1.0));
  studio.tracer->AddInputDataObject(makeMesh({}, {}));
  studio.tracer->ResetCamera();
  vtkNew<vtkCamera> expected;
  const double bounds[6] = { -4.0, 4.0, -3.0, 1.0, -1.0, 1.5 };
  resetByRenderer(expected, studio.tracer->GetImageSize(), bounds);
  expectSameView(studio.camera, expected);
}

TEST(ResetCamera, CreatesACameraIfThereIsNone)
{
  Studio studio(60, 40);
  studio.tracer->SetCamera(nullptr);
  studio.tracer->SetInputData(makeSubject());
  const Picture byDefault = render(studio.tracer);
  EXPECT_EQ(studio.tracer->GetCamera(), nullptr); // the default view sets no camera
  studio.tracer->ResetCamera();
  ASSERT_NE(studio.tracer->GetCamera(), nullptr);
  vtkNew<vtkCamera> expected;
  resetByRenderer(expected, studio.tracer->GetImageSize(), makeSubject()->GetBounds());
  expectSameView(studio.tracer->GetCamera(), expected);
  const Picture reset = render(studio.tracer);
  EXPECT_SAME_BITS(byDefault, reset);
  EXPECT_NE(reset.at(30, 20), Studio::background());
  EXPECT_EQ(reset.at(0, 0), Studio::background());
}

TEST(ResetCamera, UpdatesTheInputs)
{
  Studio studio(60, 40);
  const Mesh mesh = makeSubject();
  studio.tracer->SetInputData(mesh);
  studio.tracer->ResetCamera();
  const Vec before = studio.position();
  mesh->DeepCopy(makeBox(9.0, 9.0, 9.0));
  studio.tracer->ResetCamera();
  EXPECT_NE(studio.position(), before);
}

TEST(ResetCamera, KeepsTheCameraWithoutPoints)
{
  Studio studio(60, 40);
  studio.look({ 1.0, 2.0, 9.0 }, { 0.5, 0.0, -3.0 });
  studio.tracer->SetInputData(makeMesh({}, {}));
  studio.tracer->ResetCamera();
  EXPECT_EQ(studio.position(), Vec(1.0, 2.0, 9.0));
}

TEST(ResetCamera, BrokenMeshIsAnErrorAndKeepsTheCamera)
{
  Studio studio(60, 40);
  studio.look({ 1.0, 2.0, 9.0 }, { 0.5, 0.0, -3.0 });
  const Mesh mesh = makeSubject();
  mesh->GetPoints()->GetData()->SetNumberOfComponents(2);
  studio.tracer->AddInputDataObject(makeBox(4.0, 1.0, 1.0));
  studio.tracer->AddInputDataObject(mesh);
  const Messages messages(studio.tracer);
  studio.tracer->ResetCamera();
  expectMessage(messages.errors(), { "Input 1:", "points have 2 components, not 3" });
  EXPECT_EQ(studio.position(), Vec(1.0, 2.0, 9.0));
}
