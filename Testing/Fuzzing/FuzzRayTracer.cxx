// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkLambentRayTracer: any settings in any order, and any inputs. After each Update() there is an
// error and an empty output, or the whole picture that brute force gives for the same scene.
#include "FuzzMesh.h"

#include "Render.h"
#include "SceneFromSettings.h"
#include "Vec3FromVTK.h"
#include "VectorTarget.h"

#include "vtkCamera.h"
#include "vtkCollectionRange.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"
#include "vtkTrivialProducer.h"

#include <array>
#include <exception>
#include <vector>

namespace
{
constexpr int mostPixels = 48; // along a side
constexpr int mostInputs = 3;

void change(FuzzInput& input, vtkCamera* camera)
{
  std::array<double, 3> v{ input.number(), input.number(), input.number() };
  switch (input.choice(9))
  {
    case 0:
      camera->SetPosition(v.data());
      break;
    case 1:
      camera->SetFocalPoint(v.data());
      break;
    case 2:
      camera->SetViewUp(v.data());
      break;
    case 3:
      camera->SetViewAngle(v[0] * 30.0);
      break;
    case 4:
      camera->SetParallelScale(v[0]);
      break;
    case 5:
      camera->SetParallelProjection(input.flag());
      break;
    case 6:
      camera->SetUseHorizontalViewAngle(input.flag());
      break;
    case 7:
      camera->SetWindowCenter(v[0], v[1]);
      break;
    default:
      camera->SetViewShear(v.data()); // not supported: a warning
  }
}

void change(FuzzInput& input, vtkLight* light)
{
  const std::array<double, 3> v{ input.number(), input.number(), input.number() };
  switch (input.choice(10))
  {
    case 0:
      light->SetLightType(1 + input.choice(3));
      break;
    case 1:
      light->SetPosition(v.data());
      break;
    case 2:
      light->SetFocalPoint(v.data());
      break;
    case 3:
      light->SetPositional(input.flag());
      break;
    case 4:
      light->SetColor(v.data());
      break;
    case 5:
      light->SetIntensity(v[0]);
      break;
    case 6:
      light->SetConeAngle(v[0] * 30.0);
      light->SetExponent(v[1]);
      break;
    case 7:
      light->SetAttenuationValues(v.data());
      break;
    case 8:
      light->SetSwitch(input.flag());
      break;
    default:
    {
      vtkNew<vtkMatrix4x4> matrix;
      for (int k = 0; k < 3; ++k)
      {
        matrix->SetElement(k, input.choice(4), v[k]);
      }
      light->SetTransformMatrix(input.flag() ? matrix.Get() : nullptr);
    }
  }
}

void change(FuzzInput& input, vtkProperty* property)
{
  property->SetInterpolation(input.choice(3));
  property->SetLighting(!input.seldom(32));
  property->SetColor(input.within(0.0, 1.0), input.within(0.0, 1.0), input.within(0.0, 1.0));
  property->SetDiffuse(input.within(0.0, 1.0));
  property->SetAmbient(input.within(0.0, 1.0));
  property->SetFrontfaceCulling(input.seldom());
  property->SetBackfaceCulling(input.seldom());
  if (input.seldom())
  {
    property->SetDiffuseColor(input.number(), 0.0, 1.0);
  }
}

class Session
{
public:
  Session(const std::uint8_t* data, std::size_t size)
    : Input(data, size)
    , Count(this->Tracer)
    , Threads(this->Input.seldom(32) ? 2 + this->Input.choice(2) : 1)
  {
    this->Tracer->SetSupersampling(1 + this->Input.choice(4));
    this->Tracer->SetImageSize(
      1 + this->Input.choice(mostPixels), 1 + this->Input.choice(mostPixels));
    this->addInput();
  }

  void run()
  {
    while (!this->Input.empty())
    {
      this->step();
    }
    this->update();
  }

private:
  void step()
  {
    switch (this->Input.choice(10))
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
        this->changeInputs();
        break;
      case 8:
        this->Tracer->ResetCamera();
        break;
      default:
        this->update();
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
    const int connection = this->Input.choice(mostInputs + 2) - 1;
    connection < 0 ? this->Tracer->SetProperty(isNone ? nullptr : property.Get())
                   : this->Tracer->SetInputProperty(connection, isNone ? nullptr : property.Get());
  }

  void changeSettings()
  {
    FuzzInput& input = this->Input;
    switch (input.choice(7))
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

  void addInput()
  {
    this->Meshes.emplace_back();
    if (!this->Input.seldom())
    {
      this->Meshes.back() = makeFuzzMesh(this->Input);
    }
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(this->Meshes.back());
    this->Tracer->AddInputConnection(0, producer->GetOutputPort());
  }

  void changeInputs()
  {
    if (this->Meshes.size() == mostInputs || this->Input.seldom(32))
    {
      this->Tracer->RemoveAllInputConnections(0);
      this->Meshes.clear();
    }
    this->addInput();
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
    require(this->isSizeLegal(), "an image of no size or beyond memory is an error");
    const int* const made = output->GetExtent();
    require(std::equal(extent.begin(), extent.end(), made), "the picture has its extent");
    require(colors && colors->GetNumberOfTuples() == output->GetNumberOfPoints() &&
        colors->GetNumberOfComponents() == 3 &&
        colors->GetDataType() == this->Tracer->GetOutputScalarType(),
      "there is a colour for each pixel");
    this->compare(extent, colors);
  }

  void compare(const std::array<int, 6>& extent, vtkDataArray* colors)
  {
    const lambent::Parallel one;
    lambent::Image image;
    image.width = this->Tracer->GetImageSize()[0];
    image.height = this->Tracer->GetImageSize()[1];
    image.part = { extent[0], extent[1] + 1, extent[2], extent[3] + 1 };
    image.samples = this->Tracer->GetSupersampling();
    std::vector<float> floats(colors->GetNumberOfValues());
    std::vector<unsigned char> bytes(colors->GetNumberOfValues());
    const bool isFloat = colors->GetDataType() == VTK_FLOAT;
    if (isFloat)
    {
      image.floats = floats.data();
    }
    else
    {
      image.bytes = bytes.data();
    }
    const lambent::adapters::SceneSettings settings = this->settings();
    const lambent::adapters::SceneFromSettings scene(settings, one);
    const lambent::Report report =
      render(scene.scene(), image, one, nullptr, lambent::Settings::bruteForce(image.samplePart()));
    require(report.outcome == lambent::Outcome::Done, "brute force can draw it, too");
    for (std::size_t k = 0; k < floats.size(); ++k)
    {
      const double expected = isFloat ? static_cast<double>(floats[k]) : bytes[k];
      const double found = colors->GetComponent(static_cast<vtkIdType>(k / 3), k % 3);
      require(found == expected || (std::isnan(found) && std::isnan(expected)),
        "each pixel is that of brute force");
    }
  }

  lambent::adapters::SceneSettings settings() const
  {
    vtkLambentRayTracer* const tracer = this->Tracer;
    lambent::adapters::SceneSettings result;
    for (int k = 0; k < static_cast<int>(this->Meshes.size()); ++k)
    {
      result.inputs.push_back({ this->Meshes[k], tracer->GetInputProperty(k) });
    }
    result.camera = tracer->GetCamera();
    for (vtkLight* light : vtk::Range(tracer->GetLights()))
    {
      result.lights.push_back(light);
    }
    result.property = tracer->GetProperty();
    result.usePointNormals = tracer->GetUsePointNormals() != 0;
    result.splitting = tracer->GetSplitting() != 0;
    result.featureAngle = tracer->GetFeatureAngle();
    tracer->GetImageSize(result.imageSize);
    result.ambientModel = tracer->GetAmbientModel() == vtkLambentRayTracer::SCENE
      ? lambent::AmbientModel::Scene
      : lambent::AmbientModel::PerLight;
    result.twoSidedLighting = tracer->GetTwoSidedLighting() != 0;
    result.background = lambent::adapters::vec3FromVTK(tracer->GetBackground());
    result.backgroundTop = lambent::adapters::vec3FromVTK(
      tracer->GetGradientBackground() ? tracer->GetBackground2() : tracer->GetBackground());
    return result;
  }

  FuzzInput Input;
  vtkNew<vtkLambentRayTracer> Tracer;
  ErrorCount Count;
  int Threads;
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;
};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // The library has its own core, which uses vectors. The core that is linked here must be plain.
  lambent::useVectorTarget("plain");
  Session(data, size).run();
  return 0;
}
