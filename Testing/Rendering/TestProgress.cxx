// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Messages.h"

#include "Render.h"

#include "vtkVersion.h"

#include <algorithm>
#include <thread>

namespace
{
/// Records the reported progress, and aborts as soon as it exceeds a fraction.
struct Watcher
{
  std::vector<double> told;
  bool isOwnThread = true;
  double abortAt = 2.0;
  std::thread::id thread = std::this_thread::get_id();
  vtkNew<vtkCallbackCommand> command;

  explicit Watcher(vtkAlgorithm* filter)
  {
    this->command->SetClientData(this);
    this->command->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void* fraction)
      {
        auto* watcher = static_cast<Watcher*>(self);
        watcher->told.push_back(*static_cast<double*>(fraction));
        watcher->isOwnThread &= std::this_thread::get_id() == watcher->thread;
        if (watcher->told.back() > watcher->abortAt)
        {
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
        }
      });
    filter->AddObserver(vtkCommand::ProgressEvent, this->command);
  }
};
}

TEST(Progress, IncreasesToOneInTheCallersThread)
{
  Studio studio(640, 480);
  studio.tracer->SetInputData(makeSphere(200));
  Watcher watcher(studio.tracer);
  studio.tracer->Update();
  ASSERT_GT(watcher.told.size(), 2u);
  for (std::size_t k = 1; k < watcher.told.size(); ++k)
  {
    EXPECT_GE(watcher.told[k], watcher.told[k - 1]);
  }
  EXPECT_GE(watcher.told.front(), 0.0);
  EXPECT_EQ(watcher.told.back(), 1.0);
  EXPECT_TRUE(watcher.isOwnThread);
}

// Progress is also reported without computed normals, while cells are checked and divided and
// bounds are computed.
TEST(Progress, IsReportedWhileTheSceneIsCreated)
{
  std::vector<vtkIdType> ids(100000);
  std::vector<Vec> points;
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    ids[k] = static_cast<vtkIdType>(k);
    points.emplace_back(1e-5 * static_cast<double>(k), k % 2, 0.0);
  }
  const Mesh strip = makeMesh(points, {});
  strip->SetStrips(makeCells({ ids }));
  for (const Mesh& mesh : { makeSphere(150), strip })
  {
    Studio studio(64, 48);
    studio.tracer->SetCamera(nullptr);
    studio.property->SetInterpolationToFlat();
    studio.tracer->SetInputData(mesh);
    Watcher watcher(studio.tracer);
    studio.tracer->Update();
    EXPECT_TRUE(std::is_sorted(watcher.told.begin(), watcher.told.end()));
    EXPECT_GE(std::count_if(watcher.told.begin(), watcher.told.end(),
                [](double fraction) { return fraction > 0.0 && fraction < 0.095; }),
      3);
  }
}

// Many small inputs share one progress report.
TEST(Progress, IsReportedWhileManySurfacesAreCreated)
{
  Studio studio(64, 48);
  const Mesh square = makeSquare();
  for (int k = 0; k < 3000; ++k)
  {
    studio.tracer->AddInputDataObject(square);
  }
  Watcher watcher(studio.tracer);
  studio.tracer->Update();
  const auto early = std::count_if(watcher.told.begin(), watcher.told.end(),
    [](double fraction) { return fraction > 0.0 && fraction < 0.059; });
  EXPECT_GE(early, 1);
  EXPECT_LE(early, 10);
}

// Computing normals has its share of the progress.
TEST(Progress, IsReportedWhileNormalsAreComputed)
{
  Studio studio(64, 48);
  Mesh sphere = makeSphere(150);
  sphere->GetPointData()->SetNormals(nullptr);
  studio.tracer->SetInputData(sphere);
  Watcher watcher(studio.tracer);
  studio.tracer->Update();
  EXPECT_TRUE(std::is_sorted(watcher.told.begin(), watcher.told.end()));
  EXPECT_GT(std::count_if(watcher.told.begin(), watcher.told.end(),
              [](double fraction) { return fraction > 0.0 && fraction < 0.3; }),
    2);
  EXPECT_EQ(watcher.told.back(), 1.0);
  const Messages messages(studio.tracer);
  watcher.abortAt = 0.1;
  studio.tracer->Modified();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(Progress, AbortGivesAnEmptyOutputAndTheNextPictureIsRight)
{
  Studio studio(200, 100);
  studio.tracer->SetInputData(makeSphere(50));
  const Picture expected = render(studio.tracer);
  studio.tracer->Modified();
  Watcher watcher(studio.tracer);
  const Messages messages(studio.tracer);
  for (double fraction : { -1.0, 0.0, 0.2 })
  {
    watcher.abortAt = fraction;
    studio.tracer->Modified();
    studio.tracer->Update();
    EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0) << fraction;
    EXPECT_TRUE(render(studio.tracer).empty()) << "aborted twice, at " << fraction;
    watcher.abortAt = 2.0;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    studio.tracer->AbortExecuteOff(); // older executives do that themselves
#endif
    const Picture again = render(studio.tracer); // although nothing has changed
    EXPECT_SAME_BITS(expected, again) << fraction;
  }
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
}

// Aborts at each of up to twenty of the progress reports.
TEST(Progress, AbortAtAnyMoment)
{
  Studio studio(640, 480);
  studio.tracer->SetInputData(makeSphere(60));
  const Picture expected = render(studio.tracer);
  Watcher watcher(studio.tracer);
  studio.tracer->Modified();
  studio.tracer->Update();
  const std::vector<double> moments = watcher.told;
  ASSERT_GT(moments.size(), 3u);
  const std::size_t step = 1 + moments.size() / 20;
  for (std::size_t k = 0; k < moments.size(); k += step)
  {
    watcher.abortAt = std::nextafter(moments[k], -1.0);
    studio.tracer->Modified();
    studio.tracer->Update();
    EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0) << moments[k];
    EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetScalars(), nullptr) << moments[k];
    watcher.abortAt = 2.0;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    studio.tracer->AbortExecuteOff(); // older executives do that themselves
#endif
    const Picture again = render(studio.tracer);
    EXPECT_SAME_BITS(expected, again) << moments[k];
  }
}

// An abort before or during the computation of normals ends it, and is not an error.
TEST(Progress, AbortBeforeNormalsAreComputed)
{
  Studio studio(200, 100);
  const Mesh mesh = makeSphere(50);
  mesh->GetPointData()->SetNormals(nullptr);
  studio.tracer->SetInputData(mesh);
  const Picture expected = render(studio.tracer);
  const Messages messages(studio.tracer);
  Watcher watcher(studio.tracer);
  watcher.abortAt = -1.0; // at the start
  studio.tracer->Modified();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(messages.errors(), std::vector<std::string>());
  watcher.abortAt = 2.0;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  studio.tracer->AbortExecuteOff(); // older executives do that themselves
#endif
  const Picture again = render(studio.tracer);
  EXPECT_SAME_BITS(expected, again);
}

// The executive always reports 1; the rendering itself does so, too.
TEST(Progress, IncreasesToOneInTheCore)
{
  std::vector<float> floats(3 * 40 * 30);
  lambent::Image image;
  image.width = 40;
  image.height = 30;
  image.part = { 0, 40, 0, 30 };
  image.floats = floats.data();
  std::vector<double> told;
  bool goOn = true;
  const auto tell = [&](double fraction)
  {
    told.push_back(fraction);
    return goOn;
  };
  const lambent::Scene nothing;
  EXPECT_EQ(
    lambent::render(nothing, image, lambent::Parallel(), tell).outcome, lambent::Outcome::Done);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back(), 1.0);
  goOn = false;
  EXPECT_EQ(
    lambent::render(nothing, image, lambent::Parallel(), tell).outcome, lambent::Outcome::Aborted);
}
