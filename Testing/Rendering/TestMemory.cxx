// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// A thousand different pictures leak no memory. Under the address sanitizer no unreachable byte may
// be left when the process ends; otherwise the process may use no more memory than after the first
// few hundred pictures.
#include "Meshes.h"
#include "Messages.h"
#include "Sanitizers.h"

#include "vtkLambentNormals.h"
#include "vtkTrivialProducer.h"
#include "vtkVersion.h"

#include <fstream>
#include <functional>

#ifdef __unix__
#include <unistd.h>
#endif

namespace
{
constexpr double kilobyte = 1024.0;

/// The memory in use, in bytes. 0 if that is not known, or under sanitizers, which keep freed
/// memory for a while.
double residentMemory()
{
#if defined(__unix__) && !LAMBENT_ADDRESS_SANITIZER && !LAMBENT_THREAD_SANITIZER
  std::ifstream pages("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  if (pages >> total >> resident)
  {
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
  }
#endif
  return 0.0;
}

/// Calls step(0), step(1) and so on. A leak of a few kilobytes per step would show; the memory that
/// a process holds beyond what it uses varies by less.
void expectFlatMemory(const std::function<void(int)>& step)
{
  int k = 0;
  for (; k < 300; ++k)
  {
    step(k);
  }
  const double before = residentMemory();
  for (; k < 1300; ++k)
  {
    step(k);
  }
  EXPECT_LE(residentMemory() - before, 4000.0 * kilobyte);
}

/// Meshes of different sizes: with normals, through a filter of normals, without normals, broken.
class Inputs
{
public:
  Inputs()
  {
    this->Normals->SetInputConnection(this->Upstream->GetOutputPort());
    this->Broken->SetPolys(makeCells({ { 0, 1, 2 }, { 0, 7, 3 } }));
    for (int n : { 4, 9, 16 })
    {
      this->Meshes.push_back(makeSphere(n));
      this->Meshes.push_back(makeSphere(n));
      this->Meshes.back()->GetPointData()->SetNormals(nullptr);
    }
  }

  void connect(vtkLambentRayTracer* tracer, int k, bool isBroken)
  {
    tracer->RemoveAllInputConnections(0);
    this->Upstream->SetOutput(this->mesh(k));
    this->Normals->SetWeighting(k % 4);
    this->Normals->SetSplitting(k % 3 == 0);
    this->Normals->SetComputeCellNormals(k % 5 == 0);
    tracer->AddInputConnection(this->Normals->GetOutputPort());
    if (k % 2 == 0)
    {
      tracer->AddInputDataObject(this->mesh(k / 2));
    }
    if (isBroken)
    {
      tracer->AddInputDataObject(this->Broken);
    }
  }

private:
  vtkPolyData* mesh(int k) { return this->Meshes[k % this->Meshes.size()]; }

  vtkNew<vtkTrivialProducer> Upstream;
  vtkNew<vtkLambentNormals> Normals;
  Mesh Broken = makeSquare();
  std::vector<Mesh> Meshes;
};

/// Changes settings and replaces objects, depending on the number of the picture.
void change(Studio& studio, int k)
{
  vtkLambentRayTracer* const tracer = studio.tracer;
  tracer->SetImageSize(30 + k % 41, 20 + k % 37);
  tracer->SetOutputScalarType(k % 2 == 0 ? VTK_FLOAT : VTK_UNSIGNED_CHAR);
  tracer->SetGenerateIds(k % 3 == 0);
  tracer->SetUsePointNormals(k % 4 != 0);
  tracer->SetAmbientModel(k % 2);
  tracer->SetGradientBackground(k % 5 == 0);
  studio.camera->Azimuth(1.0);
  tracer->SetCamera(k % 6 == 0 ? nullptr : studio.camera.Get());
  tracer->RemoveAllLights();
  for (int light = 0; light < k % 4; ++light)
  {
    tracer->AddLight(makeLight({ 2.0, light - 1.0, 3.0 }, Vec(0.0), Vec(0.5), light == 1));
  }
  vtkNew<vtkProperty> property;
  property->SetInterpolation(k % 3);
  property->SetLighting(k % 7 != 0);
  tracer->SetProperty(property);
  tracer->SetInputProperty(k % 2, k % 9 == 0 ? property.Get() : nullptr);
}

/// Aborts the filter at its first progress event while this is enabled.
struct Aborter
{
  bool isOn = false;
  vtkNew<vtkCallbackCommand> command;

  explicit Aborter(vtkAlgorithm* filter)
  {
    this->command->SetClientData(this);
    this->command->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void*)
      {
        if (static_cast<Aborter*>(self)->isOn)
        {
          vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
        }
      });
    filter->AddObserver(vtkCommand::ProgressEvent, this->command);
  }
};
}

TEST(Memory, AThousandPicturesDoNotLeak)
{
  Studio studio;
  Inputs inputs;
  Messages messages(studio.tracer);
  Aborter aborter(studio.tracer);
  expectFlatMemory(
    [&](int k)
    {
      const bool isBroken = k % 10 == 7;
      aborter.isOn = k % 8 == 5;
      change(studio, k);
      inputs.connect(studio.tracer, k, isBroken);
      if (k % 11 == 3)
      {
        studio.tracer->ResetCamera();
      }
      int part[6] = { 3, 3 + k % 20, 5, 5 + k % 10, 0, 0 };
      k % 5 == 2 ? static_cast<void>(studio.tracer->UpdateExtent(part)) : studio.tracer->Update();
      EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints() == 0, isBroken || aborter.isOn)
        << k;
      EXPECT_EQ(messages.errors().size(), isBroken && !aborter.isOn ? 1u : 0u) << k;
      messages.clear();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
      studio.tracer->AbortExecuteOff(); // older executives do that themselves
#endif
    });
}

TEST(Memory, AThousandFiltersDoNotLeak)
{
  const Mesh mesh = makeSphere(20);
  expectFlatMemory(
    [&](int k)
    {
      Studio studio(60, 45);
      change(studio, k);
      vtkNew<vtkLambentNormals> normals;
      normals->SetInputData(mesh);
      studio.tracer->SetInputConnection(normals->GetOutputPort());
      studio.tracer->ResetCamera();
      studio.tracer->Update();
      EXPECT_GT(studio.tracer->GetOutput()->GetNumberOfPoints(), 0) << k;
    });
  EXPECT_EQ(mesh->GetReferenceCount(), 1);
}
