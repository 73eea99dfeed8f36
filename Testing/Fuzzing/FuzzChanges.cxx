// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzChanges.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <array>

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

void changeLook(FuzzInput& input, vtkProperty* property)
{
  // Usually in the range, seldom any number.
  const auto within = [&](double low, double high)
  { return input.seldom(4) ? input.number() : input.within(low, high); };
  const int bits = input.byte();
  if ((bits & 1) != 0)
  {
    property->SetOpacity(within(0.0, 1.0));
  }
  if ((bits & 2) != 0)
  {
    property->SetSpecular(within(0.0, 1.0));
    property->SetSpecularPower(within(0.0, 40.0));
    property->SetSpecularColor(within(0.0, 1.0), within(0.0, 1.0), within(0.0, 1.0));
  }
  if ((bits & 4) != 0)
  {
    property->SetRepresentation(input.choice(3));
  }
  if ((bits & 8) != 0)
  {
    property->SetLineWidth(static_cast<float>(within(0.0, 8.0)));
    property->SetPointSize(static_cast<float>(within(0.0, 8.0)));
  }
  property->SetRenderLinesAsTubes((bits & 16) != 0);
  property->SetRenderPointsAsSpheres((bits & 32) != 0);
  property->SetEdgeVisibility((bits & 64) != 0);
  property->SetVertexVisibility((bits & 128) != 0);
  property->SetEdgeColor(within(0.0, 1.0), 0.5, 0.0);
  property->SetVertexColor(0.5, within(0.0, 1.0), 1.0);
}

vtkSmartPointer<vtkImageData> makeFuzzImage(FuzzInput& input)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const bool isFloat = input.flag();
  const int components = input.seldom(16) ? 5 : 1 + input.choice(4);
  image->SetDimensions(1 + input.choice(6), 1 + input.choice(6), input.seldom(4) ? 2 : 1);
  image->AllocateScalars(input.seldom(4) ? VTK_SHORT
      : isFloat                          ? VTK_FLOAT
                                         : VTK_UNSIGNED_CHAR,
    components);
  vtkDataArray* const colors = image->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < colors->GetNumberOfValues(); ++k)
  {
    const double byte = input.byte();
    colors->SetComponent(k / components, static_cast<int>(k % components),
      isFloat && byte == 255.0 ? static_cast<double>(input.raw<float>())
        : isFloat              ? byte / 128.0 - 0.25
                               : byte);
  }
  return image;
}
