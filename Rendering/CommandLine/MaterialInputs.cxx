// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MaterialInputs.h"

#include "vtkLambentRayTracer.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace lambent::command
{
namespace
{

/// The mesh, in which only the polygons that have this look are drawn.
vtkSmartPointer<vtkPolyData> PartOf(
  vtkPolyData* mesh, const std::vector<std::int32_t>& ofPolygon, std::int32_t look)
{
  const vtkIdType firstPolygon = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(mesh->GetNumberOfCells());
  ghosts->FillValue(0);
  for (std::size_t k = 0; k < ofPolygon.size(); ++k)
  {
    ghosts->SetValue(firstPolygon + static_cast<vtkIdType>(k),
      ofPolygon[k] == look ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->ShallowCopy(mesh);
  part->GetCellData()->AddArray(ghosts);
  return part;
}

vtkSmartPointer<vtkTexture> TextureOf(const Look& look)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(look.image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->SetWrap(look.material.isClamped ? vtkTexture::ClampToEdge : vtkTexture::Repeat);
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkTransform> transform;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto k = static_cast<std::size_t>(axis);
    matrix->SetElement(axis, axis, look.material.scale[k]);
    matrix->SetElement(axis, 3, look.material.offset[k]);
  }
  transform->SetMatrix(matrix);
  texture->SetTransform(transform);
  return texture;
}

/// The colours, the opacity and the highlights of a material, with those options that override it.
void ApplyMaterial(const Material& material, const Options& options, vtkProperty* property)
{
  if (material.diffuse || material.ambient)
  {
    const Triple diffuse = material.diffuse.value_or(Triple{ 1, 1, 1 });
    const Triple ambient = options.ambientColor.value_or(material.ambient.value_or(diffuse));
    property->SetDiffuseColor(diffuse.data());
    property->SetAmbientColor(ambient.data());
  }
  const double opacity = material.opacity.value_or(1 - material.transparency.value_or(0));
  property->SetOpacity(opacity * options.opacity);
  // Without an exponent, the highlight would cover the whole surface.
  const double power = options.specularPower.value_or(material.specularPower.value_or(0));
  if (material.specular && material.hasHighlights && power > 0 && !options.specular)
  {
    Triple specular = *material.specular;
    property->SetSpecular(1);
    property->SetSpecularColor(specular.data());
    property->SetSpecularPower(power);
  }
}

} // namespace

bool ShowsMaterials(const Options& options)
{
  return !options.color && options.colors.array.empty() && options.texture.empty();
}

MaterialInputs::MaterialInputs(const Meshes& meshes, const std::vector<MeshLooks>& looks)
  : All(meshes)
  , LookOf(meshes.size())
{
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    this->MeshOf.push_back(mesh);
  }
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    const MeshLooks& all = looks[mesh];
    bool isFirst = true;
    for (std::size_t k = 0; k < all.looks.size(); ++k)
    {
      const auto number = static_cast<std::int32_t>(k);
      const auto uses = std::count(all.ofPolygon.begin(), all.ofPolygon.end(), number);
      if (uses > 0)
      {
        const bool isWhole = static_cast<std::size_t>(uses) == all.ofPolygon.size();
        this->Add(mesh, isWhole ? meshes[mesh] : PartOf(meshes[mesh], all.ofPolygon, number),
          all.looks[k], isFirst);
        isFirst = false;
      }
    }
    this->IsColored = this->IsColored || !isFirst;
  }
}

void MaterialInputs::Add(std::size_t mesh, vtkPolyData* part, const Look& look, bool isFirst)
{
  if (isFirst)
  {
    this->All[mesh] = part;
    this->LookOf[mesh] = look;
    return;
  }
  this->All.emplace_back(part);
  this->MeshOf.push_back(mesh);
  this->LookOf.push_back(look);
}

void MaterialInputs::Apply(const Options& options, vtkLambentRayTracer* tracer) const
{
  for (std::size_t k = 0; k < this->LookOf.size(); ++k)
  {
    const auto input = static_cast<int>(k);
    const Material& material = this->LookOf[k].material;
    if (material.diffuse || material.ambient || material.specular || material.opacity ||
      material.transparency)
    {
      vtkNew<vtkProperty> property;
      property->DeepCopy(tracer->GetProperty());
      ApplyMaterial(material, options, property);
      tracer->SetInputProperty(input, property);
    }
    if (this->LookOf[k].image)
    {
      tracer->SetInputTexture(input, TextureOf(this->LookOf[k]));
    }
  }
}

void MaterialInputs::RestoreIds(vtkImageData* picture) const
{
  auto* const ids = vtkIdTypeArray::SafeDownCast(picture->GetPointData()->GetArray("InputIds"));
  for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
  {
    const vtkIdType input = ids->GetValue(k);
    if (input >= 0)
    {
      ids->SetValue(k, static_cast<vtkIdType>(this->MeshOf[static_cast<std::size_t>(input)]));
    }
  }
}

} // namespace lambent::command
