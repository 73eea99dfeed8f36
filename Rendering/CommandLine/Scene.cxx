// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"
#include "DataColors.h"
#include "Messages.h"

#include "vtkLambentRayTracer.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>

// Pixels must not depend on a platform's sin or tan. The code here uses only + - * / and sqrt, and
// avoids vtkCamera's trigonometry (Azimuth, Elevation, ...).

namespace lambent::command
{
namespace
{

Triple operator+(const Triple& a, const Triple& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Triple operator-(const Triple& a, const Triple& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Triple operator*(double f, const Triple& a)
{
  return { f * a[0], f * a[1], f * a[2] };
}

Triple UnitVector(const Triple& a)
{
  // Scale first, so that the squares of 1e200 or 1e-200 neither overflow nor underflow.
  const double largest = std::fmax(std::fabs(a[0]), std::fmax(std::fabs(a[1]), std::fabs(a[2])));
  const Triple b = { a[0] / largest, a[1] / largest, a[2] / largest };
  return (1 / std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2])) * b;
}

/// The default view-up: y, or z for a view along y.
Triple UpFor(const Triple& direction)
{
  const bool isAlongY = direction[0] == 0 && direction[2] == 0;
  return isAlongY ? Triple{ 0, 0, 1 } : Triple{ 0, 1, 0 };
}

/// The sine of an angle of 0 to 90 degrees, by its series because math libraries differ.
double SineOfDegrees(double degrees)
{
  const double x = degrees * (3.14159265358979323846 / 180);
  double term = x;
  double sum = x;
  for (int n = 2; n <= 24; n += 2)
  {
    term *= -(x * x) / (n * (n + 1));
    sum += term;
  }
  return sum;
}

/// Radius over distance of a sphere that just fits the narrower side of the view.
double SineInView(double viewAngle, const std::array<int, 2>& size)
{
  const double sine = SineOfDegrees(viewAngle / 2);
  const double aspect = static_cast<double>(size[0]) / size[1];
  const double tangent = sine / std::sqrt(1 - sine * sine) * std::fmin(aspect, 1.0);
  return tangent / std::sqrt(1 + tangent * tangent);
}

Triple Position(vtkCamera* camera)
{
  Triple position;
  camera->GetPosition(position.data());
  return position;
}

Triple FocalPoint(vtkCamera* camera)
{
  Triple point;
  camera->GetFocalPoint(point.data());
  return point;
}

/// Places the camera on the requested side, with everything in view.
void FrameScene(const Options& options, vtkLambentRayTracer* tracer)
{
  vtkCamera* const camera = tracer->GetCamera();
  const Triple side = UnitVector(options.direction.value_or(DefaultDirection));
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(side.data());
  tracer->ResetCamera();
  // After the reset: an invalid view-up must be an error, and ResetCamera() would repair it.
  camera->SetViewUp(options.viewUp.value_or(UpFor(side)).data());

  const Triple center = FocalPoint(camera);
  Triple toEye = Position(camera) - center;
  if (options.viewAngle)
  {
    // ResetCamera() assumed 30 degrees; keep the bounding sphere just in view.
    const double ratio =
      SineInView(30, *options.size) / SineInView(*options.viewAngle, *options.size);
    toEye = ratio * toEye;
  }
  const Triple focus = options.focalPoint.value_or(center);
  camera->SetFocalPoint(focus.data());
  camera->SetPosition((focus + toEye).data());
}

/// Places the camera at the given position. It looks at the given focal point, or at the centre of
/// the scene.
void PlaceCamera(const Options& options, vtkLambentRayTracer* tracer)
{
  vtkCamera* const camera = tracer->GetCamera();
  tracer->ResetCamera(); // for the centre, and the parallel scale
  const Triple focus = options.focalPoint.value_or(FocalPoint(camera));
  if (focus == *options.cameraPosition) // vtkCamera would silently move one of them
  {
    throw Failure("cannot render: the camera is at its focal point; move --camera-position or "
                  "--focal-point");
  }
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(options.cameraPosition->data());
  camera->SetViewUp(options.viewUp.value_or(UpFor(focus - *options.cameraPosition)).data());
}

void SetUpCamera(const Options& options, vtkLambentRayTracer* tracer)
{
  vtkNew<vtkCamera> camera;
  tracer->SetCamera(camera);
  if (options.cameraPosition)
  {
    PlaceCamera(options, tracer);
  }
  else
  {
    FrameScene(options, tracer);
  }
  if (options.viewAngle)
  {
    camera->SetViewAngle(*options.viewAngle);
  }
  if (options.parallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*options.parallelScale);
  }
  camera->SetViewAngle(camera->GetViewAngle() / options.zoom);
  camera->SetParallelScale(camera->GetParallelScale() / options.zoom);
}

vtkSmartPointer<vtkLight> MakeLight(const LightValue& value, const Triple& cameraFocus)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetColor(value.color[0], value.color[1], value.color[2]);
  light->SetIntensity(value.intensity);
  switch (value.kind)
  {
    case LightValue::Kind::Headlight:
      light->SetLightTypeToHeadlight();
      break;
    case LightValue::Kind::Directional:
      // vtkLight shines from its position towards its focal point.
      light->SetLightTypeToSceneLight();
      light->PositionalOff();
      light->SetPosition(-value.place[0], -value.place[1], -value.place[2]);
      light->SetFocalPoint(0, 0, 0);
      break;
    case LightValue::Kind::Positional:
      light->SetLightTypeToSceneLight();
      light->PositionalOn();
      light->SetPosition(value.place.data());
      light->SetFocalPoint((value.hasFocus ? value.focus : cameraFocus).data());
      light->SetConeAngle(value.cone);
      light->SetExponent(value.exponent);
      light->SetAttenuationValues(value.attenuation.data());
      break;
  }
  return light;
}

vtkSmartPointer<vtkProperty> MakeProperty(const Options& options)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  Triple color = options.color.value_or(Triple{ 1, 1, 1 });
  Triple ambientColor = options.ambientColor.value_or(color);
  Triple edgeColor = options.edgeColor.value_or(Triple{ 0, 0, 0 });
  property->SetDiffuse(options.diffuse);
  property->SetDiffuseColor(color.data());
  property->SetAmbient(options.ambient);
  property->SetAmbientColor(ambientColor.data());
  property->SetInterpolation(options.shading == Shading::Flat ? VTK_FLAT : VTK_PHONG);
  property->SetLighting(options.shading != Shading::Unlit);
  property->SetSpecular(options.specular.value_or(0));
  property->SetSpecularPower(options.specularPower.value_or(1));
  property->SetOpacity(options.opacity);
  property->SetRepresentation(options.representation == Representation::Wireframe ? VTK_WIREFRAME
      : options.representation == Representation::Points                          ? VTK_POINTS
                                                                                  : VTK_SURFACE);
  property->SetEdgeVisibility(options.edges || options.edgeColor);
  property->SetEdgeColor(edgeColor.data());
  property->SetLineWidth(static_cast<float>(options.lineWidth));
  property->SetPointSize(static_cast<float>(options.pointSize));
  return property;
}

} // namespace

vtkSmartPointer<vtkLambentRayTracer> MakeScene(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  auto tracer = vtkSmartPointer<vtkLambentRayTracer>::New();
  AddMeshes(options, meshes, tracer);
  tracer->SetImageSize((*options.size)[0], (*options.size)[1]);
  tracer->SetSupersampling(options.supersampling.value_or(FormerSupersampling));
  Triple background = options.background;
  tracer->SetBackground(background.data());
  tracer->SetOutputAlpha(options.alpha);
  tracer->SetAmbientModel(options.ambientModel == AmbientModel::Scene
      ? vtkLambentRayTracer::SCENE
      : vtkLambentRayTracer::PER_LIGHT);
  tracer->SetProperty(MakeProperty(options));
  if (options.featureAngle)
  {
    tracer->SetFeatureAngle(*options.featureAngle);
  }

  SetUpCamera(options, tracer);
  for (const LightValue& value : options.lights)
  {
    tracer->AddLight(MakeLight(value, FocalPoint(tracer->GetCamera())));
  }
  return tracer;
}

} // namespace lambent::command
