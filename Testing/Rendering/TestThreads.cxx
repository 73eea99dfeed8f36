// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The same bits with every backend of vtkSMPTools and any number of threads. Bugs of others with
// pictures that differ: mitsuba-renderer/mitsuba#184, POV-Ray/povray#350.
#include "Backends.h"
#include "Meshes.h"

#include "vtkSMPTools.h"

#include <thread>

#ifdef __unix__
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace
{
void setUp(Studio& studio, int resolution)
{
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  Mesh sphere = makeSphere(resolution);
  sphere->GetPointData()->SetNormals(nullptr);
  studio.tracer->AddInputDataObject(sphere);
  studio.tracer->AddInputDataObject(makeCylinder(31));
  studio.tracer->AddInputDataObject(makeBox(0.8, 0.9, 0.7));
  studio.tracer->AddLight(makeLight({ 2.0, 3.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.7, 0.3 }, true));
  studio.tracer->AddLight(makeLight({ -2.0, 1.0, 1.0 }, { 0.0, 0.0, 0.0 }, { 0.2, 0.3, 0.7 }));
}
}

TEST(Threads, GiveTheSameBits)
{
  Studio studio(321, 243);
  setUp(studio, 60);
  std::string expected;
  for (const std::string& backend : smpBackends())
  {
    for (int threads : { 1, 2, 3, 8 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, backend, false },
        [&]()
        {
          ASSERT_EQ(vtkSMPTools::GetBackend(), backend);
          studio.tracer->Modified();
          const std::string bits = render(studio.tracer).bits();
          expected = expected.empty() ? bits : expected;
          EXPECT_TRUE(bits == expected) << backend << ", " << threads << " threads";
        });
    }
  }
}

TEST(Threads, RepeatedPicturesAreTheSame)
{
  Studio studio(321, 243);
  setUp(studio, 60);
  const Picture first = render(studio.tracer);
  for (int k = 0; k < 20; ++k)
  {
    studio.tracer->Modified();
    const Picture again = render(studio.tracer);
    EXPECT_SAME_BITS(first, again);
  }
}

// Filters share no state, so several may run at the same time.
TEST(Threads, SeveralFiltersAtTheSameTime)
{
  constexpr int count = 3;
  const auto draw = [](int k, int times)
  {
    std::vector<std::string> pictures;
    Studio studio(150 + 10 * k, 120);
    setUp(studio, 20 + 3 * k);
    for (int time = 0; time < times; ++time)
    {
      studio.tracer->Modified();
      pictures.push_back(render(studio.tracer).bits());
    }
    return pictures;
  };
  std::vector<std::string> found[count];
  std::vector<std::thread> threads;
  for (int k = 0; k < count; ++k)
  {
    threads.emplace_back([&found, &draw, k]() { found[k] = draw(k, 10); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (int k = 0; k < count; ++k)
  {
    const std::string expected = draw(k, 1).front();
    for (const std::string& bits : found[k])
    {
      EXPECT_TRUE(bits == expected) << k;
    }
  }
}

#ifdef __unix__
// A process created by fork() has the backend, but none of its threads.
TEST(Threads, WorkAfterFork)
{
  for (const std::string& backend : smpBackends())
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, backend, false },
      [&]()
      {
        Studio studio(321, 243);
        setUp(studio, 30);
        const std::string expected = render(studio.tracer).bits();
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
        {
          alarm(60); // ends a process that hangs
          studio.tracer->Modified();
          _exit(render(studio.tracer).bits() == expected ? 0 : 1);
        }
        int status = -1;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0) << backend;
      });
  }
}
#endif
