// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The normal that shades a surface, the side from which it is seen, and its colour without
// lighting.
#include "Meshes.h"

#include "vtkLambentNormals.h"

namespace
{
/// A white triangle in the plane z = 0 that fills the view, under a directional light from l, with
/// an ambient term of 1/16.
struct Facing : Studio
{
  const Vec l{ 0.6, 0.0, 0.8 };
  Mesh mesh =
    makeMesh({ { -50.0, -50.0, 0.0 }, { 50.0, -50.0, 0.0 }, { 0.0, 100.0, 0.0 } }, { { 0, 1, 2 } });

  Facing()
    : Studio(7, 5)
  {
    this->property->SetAmbient(0.0625);
    this->tracer->SetInputData(this->mesh);
    this->tracer->AddLight(makeLight(this->l, { 0.0, 0.0, 0.0 }));
  }

  void expect(double diffuse, const char* what)
  {
    const Picture picture = render(this->tracer);
    for (int i = 0; i < this->width(); ++i)
    {
      expectColor(picture.at(i, 2), Vec(diffuse + 0.0625), what);
    }
  }

  void expectNothing(const char* what)
  {
    EXPECT_EQ(render(this->tracer).count(Studio::background()), 35) << what;
  }
};
}

TEST(ShadingModes, FlatUsesTheFacesNormal)
{
  Facing facing;
  facing.property->SetInterpolationToFlat();
  setPointNormals(facing.mesh, std::vector<Vec>(3, { 1.0, 0.0, 0.0 }));
  facing.expect(0.8, "the face's own");
  setCellNormals(facing.mesh, { { 5.0, 0.0, 0.0 } }); // of any length
  facing.expect(0.6, "the cell's");
}

TEST(ShadingModes, SmoothUsesThePointNormals)
{
  for (int interpolation : { VTK_GOURAUD, VTK_PHONG })
  {
    Facing facing;
    facing.property->SetInterpolation(interpolation);
    facing.expect(0.8, "computed");
    setCellNormals(facing.mesh, { { 0.0, 1.0, 0.0 } });
    facing.expect(0.8, "computed, with cell normals there");
    setPointNormals(facing.mesh, std::vector<Vec>(3, { 2.0, 0.0, 0.0 }));
    facing.expect(0.6, "the points'");
    facing.tracer->UsePointNormalsOff();
    facing.expect(0.8, "computed, with the points' there");
  }
}

TEST(ShadingModes, SmoothIsTheDefault)
{
  Facing facing;
  setPointNormals(facing.mesh, std::vector<Vec>(3, { 1.0, 0.0, 0.0 }));
  facing.tracer->SetProperty(nullptr);
  expectColor(render(facing.tracer).at(3, 2), Vec(0.6), "white, ambient 0, diffuse 1, smooth");
}

// The normal varies linearly over the triangle and is normalised at each pixel.
TEST(ShadingModes, NormalsAreInterpolatedThenNormalised)
{
  Facing facing;
  const std::vector<Vec> normals{ { 0.8, 0.0, 0.6 }, { 0.0, 0.0, 1.0 }, { -0.6, 0.48, 0.64 } };
  setPointNormals(facing.mesh, normals);
  const std::vector<Vec> points = pointsOf(facing.mesh);
  const glm::dmat3 toBarycentric = glm::inverse(glm::dmat3(Vec(points[0].x, points[0].y, 1.0),
    Vec(points[1].x, points[1].y, 1.0), Vec(points[2].x, points[2].y, 1.0)));
  facing.look({ 0.0, 10.0, 200.0 }, { 0.0, 10.0, 0.0 });
  const Picture picture = render(facing.tracer);
  for (int i = 0; i < facing.width(); ++i)
  {
    const Ray ray = facing.ray(i, 2);
    const Vec point = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
    const Vec b = toBarycentric * Vec(point.x, point.y, 1.0);
    Vec expected = Studio::background();
    if (b.x >= 0.0 && b.y >= 0.0 && b.z >= 0.0)
    {
      const Vec m = b.x * normals[0] + b.y * normals[1] + b.z * normals[2];
      expected = reflected(Vec(1.0), Vec(0.0625), Vec(1.0), facing.l, m);
    }
    expectColor(picture.at(i, 2), expected, pixelName(i, 2));
  }
  EXPECT_NE(picture.at(3, 2), Studio::background());
}

// If the normals cancel there is no direction; the ambient term remains.
TEST(ShadingModes, WithoutANormalTheAmbientTermRemains)
{
  Facing facing;
  setPointNormals(facing.mesh, std::vector<Vec>(3, { 0.0, 0.0, 0.0 }));
  facing.expect(0.0, "zero normals");
}

TEST(ShadingModes, UnlitIsTheDiffuseColour)
{
  Facing facing;
  facing.property->LightingOff();
  facing.property->SetDiffuseColor(0.25, 0.5, 0.75);
  facing.property->SetAmbientColor(1.0, 0.0, 0.0);
  facing.property->SetDiffuse(0.1);
  for (int sides : { 0, 1 })
  {
    facing.tracer->SetTwoSidedLighting(sides);
    EXPECT_EQ(render(facing.tracer).count({ 0.25, 0.5, 0.75 }), 35);
  }
}

TEST(ShadingModes, TwoSidedLightingTurnsTheNormalToTheViewer)
{
  for (int interpolation : { VTK_FLAT, VTK_PHONG })
  {
    Facing facing;
    setPointNormals(facing.mesh, std::vector<Vec>(3, { 0.0, 0.0, 1.0 }));
    facing.property->SetInterpolation(interpolation);
    facing.look({ 0.0, 0.0, -5.0 }, { 0.0, 0.0, 0.0 }); // the light is on the other side
    facing.expect(0.0, "from behind");
    facing.tracer->TwoSidedLightingOff();
    facing.expect(0.8, "from behind, one-sided");

    facing.tracer->RemoveAllLights();
    facing.tracer->AddLight(makeLight({ 0.0, 0.6, -0.8 }, { 0.0, 0.0, 0.0 }));
    facing.expect(0.0, "light on the viewer's side, one-sided");
    facing.tracer->TwoSidedLightingOn();
    facing.expect(0.8, "light on the viewer's side");
  }
}

// The winding determines the back of a face, unless the point normals disagree with it. An example
// is a mirrored mesh: its faces are reversed, but its normals still point outwards.
TEST(ShadingModes, NormalsOppositeToTheWindingDecideTheSide)
{
  Facing facing;
  setPointNormals(facing.mesh, std::vector<Vec>(3, { 0.0, 0.0, -1.0 }));
  setCellNormals(facing.mesh, { { 0.0, 0.0, -1.0 } });
  for (int interpolation : { VTK_FLAT, VTK_PHONG })
  {
    facing.property->SetInterpolation(interpolation);
    facing.look({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0 });
    facing.expect(0.8, "the lit side: the normal is turned over");
    facing.look({ 0.0, 0.0, -5.0 }, { 0.0, 0.0, 0.0 });
    facing.expect(0.0, "the dark side: the normal points at the viewer");
    facing.property->BackfaceCullingOn();
    facing.expectNothing("the dark side is the back by the winding, which culling goes by");
    facing.property->BackfaceCullingOff();
  }
}

TEST(ShadingModes, Culling)
{
  Facing facing;
  facing.property->SetInterpolationToFlat();
  facing.property->BackfaceCullingOn();
  facing.expect(0.8, "front, back faces culled");
  facing.property->FrontfaceCullingOn();
  facing.expectNothing("front, both culled");
  facing.property->BackfaceCullingOff();
  facing.expectNothing("front, front faces culled");
  facing.look({ 0.0, 0.0, -5.0 }, { 0.0, 0.0, 0.0 });
  facing.expect(0.0, "back, front faces culled");
  facing.property->FrontfaceCullingOff();
  facing.property->BackfaceCullingOn();
  facing.expectNothing("back, back faces culled");
}

// Culled faces hide nothing: a closed box shows its inside.
TEST(ShadingModes, CulledFacesHideNothing)
{
  Studio studio(9, 9);
  studio.property->SetInterpolationToFlat();
  studio.tracer->SetInputData(makeBox(1.0, 1.0, 1.0));
  studio.tracer->AddLight(makeLight({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, Vec(1.0), true));
  expectColor(render(studio.tracer).at(4, 4), Vec(0.0), "outside, away from the light");
  studio.property->FrontfaceCullingOn();
  expectColor(render(studio.tracer).at(4, 4), Vec(1.0), "inside, facing the light");
}

// A smooth surface without normals looks as if it came through vtkLambentNormals.
TEST(ShadingModes, ComputedNormalsEqualTheFilters)
{
  Studio studio(40, 30);
  Mesh sphere = makeSphere(9);
  sphere->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(sphere);
  studio.tracer->SetInputData(sphere);
  const Picture alone = render(studio.tracer);
  studio.tracer->SetInputConnection(normals->GetOutputPort());
  const Picture filtered = render(studio.tracer);
  EXPECT_SAME_BITS(alone, filtered);
  studio.property->SetInterpolationToFlat();
  EXPECT_NE(render(studio.tracer).bits(), alone.bits());
}

TEST(ShadingModes, InputPropertiesOverrideTheCommonOne)
{
  Studio studio(4, 1);
  Mesh left =
    makeMesh({ { -9.0, -9.0, 0.0 }, { 0.0, -9.0, 0.0 }, { 0.0, 9.0, 0.0 }, { -9.0, 9.0, 0.0 } },
      { { 0, 1, 2, 3 } });
  Mesh right =
    makeMesh({ { 0.0, -9.0, 0.0 }, { 9.0, -9.0, 0.0 }, { 9.0, 9.0, 0.0 }, { 0.0, 9.0, 0.0 } },
      { { 0, 1, 2, 3 } });
  studio.tracer->AddInputDataObject(left);
  studio.tracer->AddInputDataObject(right);
  studio.property->LightingOff();
  studio.property->SetColor(1.0, 0.0, 0.0);
  vtkNew<vtkProperty> blue;
  blue->LightingOff();
  blue->SetColor(0.0, 0.0, 1.0);
  studio.tracer->SetInputProperty(1, blue);
  EXPECT_EQ(studio.tracer->GetInputProperty(0), nullptr);
  EXPECT_EQ(studio.tracer->GetInputProperty(1), blue);
  Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.at(0, 0), Vec(1.0, 0.0, 0.0));
  EXPECT_EQ(picture.at(3, 0), Vec(0.0, 0.0, 1.0));
  studio.tracer->SetInputProperty(1, nullptr);
  EXPECT_EQ(render(studio.tracer).count({ 1.0, 0.0, 0.0 }), 4);
}
