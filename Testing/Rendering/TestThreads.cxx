// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The same bits on every backend of vtkSMPTools and for every number of threads, and
// no memory left behind.
#include "Meshes.h"

#include "vtkSMPTools.h"

#include <fstream>

#ifdef __unix__
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

/// Those that this VTK was built with.
std::vector<std::string> backends()
{
  return
  {
#if VTK_SMP_ENABLE_SEQUENTIAL
    "Sequential",
#endif
#if VTK_SMP_ENABLE_STDTHREAD
      "STDThread",
#endif
#if VTK_SMP_ENABLE_TBB
      "TBB",
#endif
#if VTK_SMP_ENABLE_OPENMP
      "OpenMP",
#endif
  };
}

/// Bytes of memory in use, 0 where that is not known.
double residentMemory()
{
#ifdef __unix__
  std::ifstream pages("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  if (pages >> total >> resident)
  {
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
  }
#endif
  return 0.0;
}
}

TEST(Threads, GiveTheSameBits)
{
  Studio studio(321, 243);
  setUp(studio, 60);
  std::string expected;
  for (const std::string& backend : backends())
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

// 32 kB of pixels and about as much of work a picture: to leak either would show.
TEST(Threads, AThousandPicturesDoNotGrowMemory)
{
  Studio studio(120, 90);
  setUp(studio, 15);
  const auto renderMany = [&](int count)
  {
    for (int k = 0; k < count; ++k)
    {
      studio.camera->Azimuth(1.0);
      studio.tracer->Update();
    }
  };
  renderMany(100);
  const double before = residentMemory();
  renderMany(1000);
  EXPECT_LT(residentMemory() - before, 30e6);
}

// A filter made, used and deleted leaves nothing behind either.
TEST(Threads, AThousandFiltersDoNotGrowMemory)
{
  const Mesh mesh = makeSphere(20);
  const auto renderMany = [&](int count)
  {
    for (int k = 0; k < count; ++k)
    {
      Studio studio(60, 45);
      studio.tracer->SetInputProperty(0, studio.property);
      studio.tracer->SetInputData(mesh);
      studio.tracer->ResetCamera();
      studio.tracer->Update();
    }
  };
  renderMany(100);
  const double before = residentMemory();
  renderMany(1000);
  EXPECT_LT(residentMemory() - before, 30e6);
  EXPECT_EQ(mesh->GetReferenceCount(), 1);
}
