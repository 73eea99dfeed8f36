// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageToVTK.h"

#include "vtkLambentNormals.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>

namespace
{
template <typename Array>
vtkSmartPointer<Array> toTuples(const std::vector<Vec3>& tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName("Tuples");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  for (std::size_t k = 0; k < tuples.size(); ++k)
  {
    array->SetTuple(static_cast<vtkIdType>(k), &tuples[k].x);
  }
  return array;
}

vtkSmartPointer<vtkCellArray> toCells(const Body& body)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : body.shape.cells)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(cell.size()));
    for (std::int64_t id : cell)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(id));
    }
  }
  body.has32BitIds ? cells->ConvertTo32BitStorage() : cells->ConvertTo64BitStorage();
  return cells;
}
}

namespace
{
void addGhosts(const std::vector<unsigned char>& flags, vtkDataSetAttributes* attributes)
{
  if (!flags.empty())
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(vtkDataSetAttributes::GhostArrayName());
    array->SetNumberOfTuples(static_cast<vtkIdType>(flags.size()));
    std::copy(flags.begin(), flags.end(), array->GetPointer(0));
    attributes->AddArray(array);
  }
}
}

vtkSmartPointer<vtkMatrix4x4> toMatrix(const lambent::Transform& transform)
{
  if (transform.isIdentity())
  {
    return nullptr;
  }
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      matrix->SetElement(i, k, transform.rows[i][k]);
    }
  }
  return matrix;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Body& body)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(body.hasFloatPoints ? VTK_FLOAT : VTK_DOUBLE);
  if (body.hasFloatPoints)
  {
    points->SetData(toTuples<vtkFloatArray>(body.shape.points));
  }
  else
  {
    points->SetData(toTuples<vtkDoubleArray>(body.shape.points));
  }
  result->SetPoints(points);
  switch (body.show)
  {
    case CellShow::Vertices:
      result->SetVerts(toCells(body));
      break;
    case CellShow::Polylines:
      result->SetLines(toCells(body));
      break;
    default:
      body.hasStrips ? result->SetStrips(toCells(body)) : result->SetPolys(toCells(body));
  }
  if (!body.pointNormals.empty())
  {
    result->GetPointData()->SetNormals(toTuples<vtkDoubleArray>(body.pointNormals));
  }
  if (!body.cellNormals.empty())
  {
    result->GetCellData()->SetNormals(toTuples<vtkDoubleArray>(body.cellNormals));
  }
  if (!body.radii.empty())
  {
    result->GetPointData()->AddArray(toArray({ radiiName, false, 1,
      body.hasFloatPoints ? lambent::AttributeType::Float : lambent::AttributeType::Double,
      body.radii }));
  }
  for (const StageArray& array : body.arrays)
  {
    array.isPerCell ? result->GetCellData()->AddArray(toArray(array))
                    : result->GetPointData()->AddArray(toArray(array));
  }
  if (body.texture.exists())
  {
    result->GetPointData()->SetTCoords(toArray(body.texture.coordinates));
  }
  addGhosts(body.pointGhosts, result->GetPointData());
  addGhosts(body.cellGhosts, result->GetCellData());
  return result;
}

vtkSmartPointer<vtkDataArray> toArray(const StageArray& array)
{
  const int type = array.type == lambent::AttributeType::UInt8 ? VTK_UNSIGNED_CHAR
    : array.type == lambent::AttributeType::Int32              ? VTK_INT
    : array.type == lambent::AttributeType::Double             ? VTK_DOUBLE
                                                               : VTK_FLOAT;
  auto result = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  result->SetName(array.name.c_str());
  result->SetNumberOfComponents(array.components);
  result->SetNumberOfTuples(static_cast<vtkIdType>(array.values.size()) / array.components);
  for (std::size_t k = 0; k < array.values.size(); ++k)
  {
    const auto place = static_cast<vtkIdType>(k);
    result->SetComponent(
      place / array.components, static_cast<int>(place % array.components), array.values[k]);
  }
  return result;
}

vtkSmartPointer<vtkImageData> toBackgroundImage(const Stage& stage)
{
  if (stage.backgroundImage.values.empty())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(stage.backgroundWidth, stage.backgroundHeight, 1);
  image->GetPointData()->SetScalars(toArray(stage.backgroundImage));
  return image;
}

vtkSmartPointer<vtkTexture> toTexture(const StageTexture& texture)
{
  if (!texture.exists())
  {
    return nullptr;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(texture.width, texture.height, 1);
  image->GetPointData()->SetScalars(toArray(texture.pixels));
  auto result = vtkSmartPointer<vtkTexture>::New();
  result->SetInputData(image);
  result->SetColorModeToDirectScalars();
  result->SetInterpolate(texture.isInterpolated);
  result->SetUseSRGBColorSpace(texture.isSRGB);
  result->SetWrap(texture.wrap == lambent::TextureWrap::Repeat ? vtkTexture::Repeat
      : texture.wrap == lambent::TextureWrap::ClampToEdge      ? vtkTexture::ClampToEdge
      : texture.wrap == lambent::TextureWrap::MirroredRepeat   ? vtkTexture::MirroredRepeat
                                                               : vtkTexture::ClampToBorder);
  const auto channel = [&](int k) { return static_cast<float>(texture.border[k]); };
  result->SetBorderColor(channel(0), channel(1), channel(2), 1.0f);
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 2; ++row)
  {
    for (int k = 0; k < 3; ++k)
    {
      matrix->SetElement(row, k == 2 ? 3 : k, texture.matrix[row][k]);
    }
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  result->SetTransform(transform);
  return result;
}

vtkSmartPointer<vtkProperty> toProperty(const Body& body)
{
  const lambent::Appearance& appearance = body.appearance;
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetDiffuse(appearance.diffuse);
  property->SetAmbient(appearance.ambient);
  property->SetDiffuseColor(
    appearance.diffuseColor.x, appearance.diffuseColor.y, appearance.diffuseColor.z);
  property->SetAmbientColor(
    appearance.ambientColor.x, appearance.ambientColor.y, appearance.ambientColor.z);
  property->SetOpacity(appearance.opacity);
  property->SetInterpolation(appearance.shading == lambent::Shading::Flat ? VTK_FLAT : VTK_PHONG);
  property->SetLighting(appearance.shading != lambent::Shading::Unlit);
  const lambent::EdgeStyle& edges = appearance.edges;
  property->SetEdgeVisibility(edges.areVisible);
  property->SetEdgeColor(edges.color.x, edges.color.y, edges.color.z);
  const lambent::SpecularStyle& specular = appearance.specular;
  property->SetSpecular(specular.coefficient);
  property->SetSpecularColor(specular.color.x, specular.color.y, specular.color.z);
  property->SetSpecularPower(specular.power);
  property->SetFrontfaceCulling(appearance.cullFront);
  property->SetBackfaceCulling(appearance.cullBack);
  property->SetRepresentation(body.show == CellShow::Edges ? VTK_WIREFRAME
      : body.show == CellShow::Points                      ? VTK_POINTS
                                                           : VTK_SURFACE);
  property->SetLineWidth(static_cast<float>(edges.areVisible ? edges.width : body.width));
  property->SetPointSize(static_cast<float>(body.width));
  property->SetRenderLinesAsTubes(body.isRounded);
  property->SetRenderPointsAsSpheres(body.isRounded);
  return property;
}

vtkSmartPointer<vtkLookupTable> toTable(const StageColors& colors)
{
  if (colors.entries.empty())
  {
    return nullptr;
  }
  const auto channel = [](unsigned char byte) { return byte / 255.0; };
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colors.entryCount()));
  table->SetRange(colors.low, colors.high);
  table->SetScale(colors.isLogarithmic ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
  table->Build();
  for (std::size_t k = 0; k < colors.entryCount(); ++k)
  {
    const unsigned char* const entry = &colors.entries[4 * k];
    table->SetTableValue(static_cast<vtkIdType>(k), channel(entry[0]), channel(entry[1]),
      channel(entry[2]), channel(entry[3]));
  }
  if (colors.hasSpecialColors)
  {
    const unsigned char *const none = colors.special(0), *const below = colors.special(1),
                               *const above = colors.special(2);
    table->SetNanColor(channel(none[0]), channel(none[1]), channel(none[2]), 1.0);
    table->SetBelowRangeColor(channel(below[0]), channel(below[1]), channel(below[2]), 1.0);
    table->SetAboveRangeColor(channel(above[0]), channel(above[1]), channel(above[2]), 1.0);
    table->UseBelowRangeColorOn();
    table->UseAboveRangeColorOn();
  }
  return table;
}

vtkSmartPointer<vtkCamera> toCamera(const lambent::Camera& camera)
{
  auto result = vtkSmartPointer<vtkCamera>::New();
  result->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  result->SetFocalPoint(camera.focalPoint.x, camera.focalPoint.y, camera.focalPoint.z);
  result->SetViewUp(camera.viewUp.x, camera.viewUp.y, camera.viewUp.z);
  result->SetViewAngle(camera.viewAngle);
  result->SetUseHorizontalViewAngle(camera.horizontalViewAngle);
  result->SetParallelProjection(camera.parallel);
  result->SetParallelScale(camera.parallelScale);
  result->SetWindowCenter(camera.windowCenter[0], camera.windowCenter[1]);
  return result;
}

vtkSmartPointer<vtkLight> toLight(const lambent::Light& light)
{
  // A directional light starts at the origin, so that its direction stays exact.
  const Vec3 from = light.positional ? light.position : Vec3(0.0);
  const bool isCone = light.positional && light.coneAngle < 90.0;
  const Vec3 at = from + light.direction;
  if (isCone && at - from != light.direction)
  {
    throw std::runtime_error("the direction of a cone is lost in rounding; give it and the "
                             "position fewer digits");
  }
  auto result = vtkSmartPointer<vtkLight>::New();
  result->SetLightTypeToSceneLight();
  result->SetPositional(light.positional);
  result->SetPosition(from.x, from.y, from.z);
  result->SetFocalPoint(at.x, at.y, at.z);
  result->SetColor(light.color.x, light.color.y, light.color.z);
  result->SetSpecularColor(light.specularColor.x, light.specularColor.y, light.specularColor.z);
  result->SetConeAngle(light.coneAngle);
  result->SetExponent(light.exponent);
  result->SetAttenuationValues(light.attenuation.x, light.attenuation.y, light.attenuation.z);
  return result;
}

vtkSmartPointer<vtkLight> noLight()
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SwitchOff();
  return light;
}

std::vector<Vec3> computeNormals(const Body& body)
{
  vtkNew<vtkLambentNormals> filter;
  filter->SetInputData(toPolyData(body));
  filter->SetWeighting(static_cast<int>(body.weighting));
  filter->Update();
  vtkDataArray* normals = filter->GetOutput()->GetPointData()->GetNormals();
  if (!normals)
  {
    throw std::runtime_error("the normals refuse the scene");
  }
  std::vector<Vec3> result(body.shape.points.size());
  for (std::size_t k = 0; k < result.size(); ++k)
  {
    normals->GetTuple(static_cast<vtkIdType>(k), &result[k].x);
  }
  return result;
}
