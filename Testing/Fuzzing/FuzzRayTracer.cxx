// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkLambentRayTracer: any settings in any order, and any inputs. After each Update() there is an
// error and an empty output, or the whole picture that brute force gives for the same scene.
#include "FuzzChanges.h"
#include "FuzzInputs.h"
#include "FuzzMesh.h"
#include "FuzzReference.h"

#include "VectorTarget.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"

#include <array>
#include <vector>

namespace
{
constexpr int mostPixels = 48; // along a side

class Session
{
public:
  Session(const std::uint8_t* data, std::size_t size)
    : Input(data, size)
    , Count(this->Tracer)
    , Inputs(this->Input, this->Tracer)
    , Threads(this->Input.seldom(32) ? 2 + this->Input.choice(2) : 1)
  {
    this->Tracer->SetSupersampling(1 + this->Input.choice(4));
    this->setFilm(this->Input.byte());
    this->Tracer->SetImageSize(
      1 + this->Input.choice(mostPixels), 1 + this->Input.choice(mostPixels));
    this->Inputs.add(this->HasArrays);
  }

  void run()
  {
    while (!this->Input.empty())
    {
      this->step();
    }
    this->update();
    if (this->Count.errors > 0)
    {
      this->recover();
    }
  }

private:
  void step()
  {
    const int kind = this->Input.byte();
    constexpr int firstOfInputs = 180, firstOfTrees = 244;
    if (kind >= firstOfInputs)
    {
      kind >= firstOfTrees ? this->addTree() : this->Inputs.change();
      return;
    }
    switch (kind % 10)
    {
      case 0:
      case 1:
        this->changeCamera();
        break;
      case 2:
      case 3:
        this->changeLights();
        break;
      case 4:
        this->changeProperties();
        break;
      case 5:
      case 6:
        this->changeSettings();
        break;
      case 7:
        this->Inputs.clearSeldom();
        this->Inputs.add(this->HasArrays);
        break;
      case 8:
        this->Tracer->ResetCamera();
        break;
      default:
        this->update();
    }
  }

  /// Sets alpha, the background image and the passes by these bits.
  void setFilm(int bits)
  {
    this->Tracer->SetOutputAlpha((bits & 1) != 0);
    this->Tracer->SetGenerateDepth((bits & 2) != 0);
    this->Tracer->SetGenerateNormals((bits & 4) != 0);
    this->Tracer->SetGeneratePositions((bits & 8) != 0);
    this->Tracer->SetGenerateIds((bits & 16) != 0);
    this->Tracer->SetBackgroundImage((bits & 32) != 0 ? makeFuzzImage(this->Input).Get() : nullptr);
    this->HasArrays = (bits & 64) != 0;
    this->Tracer->RemoveAllPassArrays();
    this->PassArrays.clear();
    if ((bits & 128) != 0)
    {
      this->addPassArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heat");
      this->addPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
      if (this->Input.seldom(16))
      {
        static const char* const names[] = { "Depth", "Heat", "Other", "" };
        this->addPassArray(this->Input.choice(3), names[this->Input.choice(4)]);
      }
    }
  }

  void addPassArray(int association, const std::string& name)
  {
    this->Tracer->AddPassArray(association, name.c_str());
    if (!name.empty()) // an empty name is refused at once
    {
      this->PassArrays.push_back({ association, name });
    }
  }

  void changeCamera()
  {
    if (!this->Tracer->GetCamera())
    {
      vtkNew<vtkCamera> camera;
      this->Tracer->SetCamera(camera);
    }
    change(this->Input, this->Tracer->GetCamera());
    if (this->Input.seldom())
    {
      this->Tracer->SetCamera(nullptr);
    }
  }

  void changeLights()
  {
    vtkLightCollection* lights = this->Tracer->GetLights();
    if (lights->GetNumberOfItems() == 0 || this->Input.seldom(32))
    {
      vtkNew<vtkLight> light;
      this->Tracer->AddLight(light);
    }
    const int index = this->Input.choice(lights->GetNumberOfItems());
    auto* light = vtkLight::SafeDownCast(lights->GetItemAsObject(index));
    change(this->Input, light);
    if (this->Input.seldom())
    {
      this->Input.flag() ? this->Tracer->RemoveAllLights() : this->Tracer->RemoveLight(light);
    }
  }

  void changeProperties()
  {
    vtkNew<vtkProperty> property;
    change(this->Input, property);
    const bool isNone = this->Input.seldom();
    const int connection = this->Input.choice(FuzzInputs::most + 2) - 1;
    connection < 0 ? this->Tracer->SetProperty(isNone ? nullptr : property.Get())
                   : this->Tracer->SetInputProperty(connection, isNone ? nullptr : property.Get());
  }

  void changeSettings()
  {
    FuzzInput& input = this->Input;
    const int kind = input.byte();
    constexpr int firstOfFilm = 252, firstOfTransforms = 246;
    if (kind >= firstOfTransforms)
    {
      kind >= firstOfFilm ? this->setFilm(input.byte()) : this->Inputs.changeTransform();
      return;
    }
    switch (kind % 7)
    {
      case 0:
        this->changeImageSize();
        break;
      case 1:
        this->Tracer->SetAmbientModel(input.choice(2));
        break;
      case 2:
        this->Tracer->SetTwoSidedLighting(input.flag());
        break;
      case 3:
        this->Tracer->SetOutputScalarType(input.choice(2) == 0 ? VTK_FLOAT : VTK_UNSIGNED_CHAR);
        break;
      case 4:
        this->Tracer->SetUsePointNormals(input.flag());
        this->Tracer->SetFeatureAngle(this->Tracer->GetFeatureAngle() > 90.0 ? 20.0 : 180.0);
        break;
      case 5:
        this->Tracer->SetBackground(input.within(0.0, 1.0), input.within(0.0, 1.0), input.number());
        break;
      default:
        this->Tracer->SetGradientBackground(input.flag());
        this->Tracer->SetBackground2(input.number(), input.within(0.0, 1.0), 0.0);
    }
  }

  void changeImageSize()
  {
    if (this->Input.seldom(16))
    {
      static const int wrong[][2] = { { 0, 5 }, { 5, 0 }, { -7, 7 },
        { std::numeric_limits<int>::max(), std::numeric_limits<int>::max() } };
      const int* size = wrong[this->Input.choice(4)];
      this->Tracer->SetImageSize(size[0], size[1]);
    }
    else
    {
      this->Tracer->SetImageSize(
        1 + this->Input.choice(mostPixels), 1 + this->Input.choice(mostPixels));
    }
  }

  void addTree()
  {
    this->Inputs.clearSeldom();
    this->Inputs.addTree(this->HasArrays);
  }

  /// No error may spoil later pictures.
  void recover()
  {
    this->Inputs.reset();
    this->Tracer->SetProperty(nullptr);
    this->Tracer->SetCamera(nullptr);
    this->Tracer->RemoveAllLights();
    this->Tracer->SetImageSize(8, 8);
    this->Tracer->SetBackground(0.0, 0.0, 0.0);
    this->Tracer->SetGradientBackground(false);
    this->setFilm(0);
    this->update();
    require(this->Count.errors == 0, "a good scene has a picture, also after an error");
    double range[2];
    this->Tracer->GetOutput()->GetPointData()->GetScalars()->GetRange(range, 0);
    require(range[0] < range[1], "the picture shows the good scene");
  }

  bool isSizeLegal() const
  {
    const int* size = this->Tracer->GetImageSize();
    return size[0] >= 1 && size[1] >= 1 && size[0] <= mostPixels && size[1] <= mostPixels;
  }

  void update()
  {
    this->Count.errors = 0;
    const int* size = this->Tracer->GetImageSize();
    std::array<int, 6> extent{ 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
    if (this->isSizeLegal() && this->Input.seldom(64))
    {
      extent[0] = this->Input.choice(size[0]);
      extent[1] = extent[0] + this->Input.choice(size[0] - extent[0]);
      extent[2] = this->Input.choice(size[1]);
      extent[3] = extent[2] + this->Input.choice(size[1] - extent[2]);
    }
    // The previous picture must not pass as the result.
    this->Tracer->GetOutput()->Initialize();
    this->Tracer->Modified();
    const std::string backend = this->Threads > 1 ? vtkSMPTools::GetBackend() : "Sequential";
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ this->Threads, backend, false },
      [&]()
      {
        this->isSizeLegal() ? static_cast<void>(this->Tracer->UpdateExtent(extent.data()))
                            : this->Tracer->Update();
      });
    this->check(extent);
  }

  void check(const std::array<int, 6>& extent)
  {
    vtkImageData* output = this->Tracer->GetOutput();
    vtkDataArray* colors = output->GetPointData()->GetScalars();
    if (this->Count.errors > 0)
    {
      require(output->GetNumberOfPoints() == 0 && !colors, "after an error the output is empty");
      return;
    }
    require(this->isSizeLegal(), "an empty image, or one too large for memory, is an error");
    const int* const made = output->GetExtent();
    require(std::equal(extent.begin(), extent.end(), made), "the picture has the requested extent");
    require(colors && colors->GetNumberOfTuples() == output->GetNumberOfPoints() &&
        colors->GetNumberOfComponents() == (this->Tracer->GetOutputAlpha() ? 4 : 3) &&
        colors->GetDataType() == this->Tracer->GetOutputScalarType(),
      "there is a colour for each pixel");
    compareWithBruteForce({ this->Tracer, this->Inputs.all(), this->PassArrays }, extent);
  }

  FuzzInput Input;
  vtkNew<vtkLambentRayTracer> Tracer;
  ErrorCount Count;
  FuzzInputs Inputs;
  int Threads;
  bool HasArrays = false; ///< whether new inputs get arrays
  std::vector<lambent::adapters::SceneSettings::PassArray> PassArrays;
};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // The library has its own core, which uses vectors. The core that is linked here must be plain.
  lambent::useVectorTarget("plain");
  Session(data, size).run();
  return 0;
}
