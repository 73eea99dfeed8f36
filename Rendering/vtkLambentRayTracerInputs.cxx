// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of single inputs of vtkLambentRayTracer.
#include "RayTracerInternals.h"

#include "InputBlocks.h"
#include "TransformFromVTK.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkExecutive.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <string>

using namespace lambent::adapters;

void vtkLambentRayTracer::Internals::addInput(
  vtkDataObject* data, int connection, SceneSettings& scene) const
{
  const InputSetting& setting = this->Inputs.of(connection);
  SceneSettings::Input input;
  input.property = setting.Property;
  input.connection = connection;
  input.transform = transformFromVTK(setting.Transform, connection);
  input.colors = setting.Colors;
  input.texture = setting.Texture;
  input.spheres = setting.Spheres;
  addBlocks(input, data, setting.BlockAttributes, scene);
}

//------------------------------------------------------------------------------
// Makes a change of a setting of a connection, unless there is no such number.
template <typename Change>
void vtkLambentRayTracer::ChangeInput(int connection, const char* method, const Change& change)
{
  if (connection < 0)
  {
    vtkErrorMacro(<< method << "() was given connection " << connection
                  << "; connections are counted from 0 in the order they were added.");
    return;
  }
  change(this->Internal->Inputs.change(connection));
  this->Modified();
}

void vtkLambentRayTracer::SetInputProperty(int connection, vtkProperty* property)
{
  this->ChangeInput(
    connection, "SetInputProperty", [&](InputSetting& setting) { setting.Property = property; });
}

vtkProperty* vtkLambentRayTracer::GetInputProperty(int connection)
{
  return this->Internal->Inputs.of(connection).Property;
}

void vtkLambentRayTracer::SetInputTransform(int connection, vtkMatrix4x4* matrix)
{
  this->ChangeInput(connection, "SetInputTransform",
    [matrix](InputSetting& setting) { setting.Transform = matrix; });
}

vtkMatrix4x4* vtkLambentRayTracer::GetInputTransform(int connection)
{
  return this->Internal->Inputs.of(connection).Transform;
}

void vtkLambentRayTracer::SetInputBlockAttributes(
  int connection, vtkCompositeDataDisplayAttributes* attributes)
{
  this->ChangeInput(connection, "SetInputBlockAttributes",
    [attributes](InputSetting& setting) { setting.BlockAttributes = attributes; });
}

vtkCompositeDataDisplayAttributes* vtkLambentRayTracer::GetInputBlockAttributes(int connection)
{
  return this->Internal->Inputs.of(connection).BlockAttributes;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputScalarVisibility(int connection, bool visibility)
{
  this->ChangeInput(connection, "SetInputScalarVisibility",
    [&](InputSetting& setting) { setting.Colors.scalarVisibility = visibility; });
}

bool vtkLambentRayTracer::GetInputScalarVisibility(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.scalarVisibility;
}

void vtkLambentRayTracer::SetInputColorArray(int connection, int association, const char* name)
{
  this->ChangeInput(connection, "SetInputColorArray",
    [&](InputSetting& setting)
    {
      setting.Colors.association = association;
      setting.Colors.arrayName = name ? name : "";
    });
}

const char* vtkLambentRayTracer::GetInputColorArrayName(int connection)
{
  const std::string& name = this->Internal->Inputs.of(connection).Colors.arrayName;
  return name.empty() ? nullptr : name.c_str();
}

int vtkLambentRayTracer::GetInputColorArrayAssociation(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.association;
}

void vtkLambentRayTracer::SetInputColorComponent(int connection, int component)
{
  this->ChangeInput(connection, "SetInputColorComponent",
    [&](InputSetting& setting) { setting.Colors.component = component; });
}

int vtkLambentRayTracer::GetInputColorComponent(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.component;
}

void vtkLambentRayTracer::SetInputLookupTable(int connection, vtkScalarsToColors* table)
{
  this->ChangeInput(connection, "SetInputLookupTable",
    [&](InputSetting& setting) { setting.Colors.lookupTable = table; });
}

vtkScalarsToColors* vtkLambentRayTracer::GetInputLookupTable(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.lookupTable;
}

void vtkLambentRayTracer::SetInputScalarRange(int connection, double low, double high)
{
  this->ChangeInput(connection, "SetInputScalarRange",
    [&](InputSetting& setting)
    {
      setting.Colors.hasScalarRange = true;
      setting.Colors.scalarRange[0] = low;
      setting.Colors.scalarRange[1] = high;
    });
}

void vtkLambentRayTracer::ResetInputScalarRange(int connection)
{
  this->ChangeInput(connection, "ResetInputScalarRange",
    [&](InputSetting& setting) { setting.Colors.hasScalarRange = false; });
}

bool vtkLambentRayTracer::GetInputScalarRange(int connection, double range[2])
{
  const InputColors& colors = this->Internal->Inputs.of(connection).Colors;
  std::copy_n(colors.scalarRange, 2, range);
  return colors.hasScalarRange;
}

void vtkLambentRayTracer::SetInputInterpolateScalarsBeforeMapping(int connection, bool before)
{
  this->ChangeInput(connection, "SetInputInterpolateScalarsBeforeMapping",
    [&](InputSetting& setting) { setting.Colors.interpolateScalarsBeforeMapping = before; });
}

bool vtkLambentRayTracer::GetInputInterpolateScalarsBeforeMapping(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.interpolateScalarsBeforeMapping;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputSphereRadius(int connection, double radius)
{
  this->ChangeInput(connection, "SetInputSphereRadius",
    [&](InputSetting& setting) { setting.Spheres.radius = radius; });
}

double vtkLambentRayTracer::GetInputSphereRadius(int connection)
{
  return this->Internal->Inputs.of(connection).Spheres.radius;
}

void vtkLambentRayTracer::SetInputSphereRadiusArray(int connection, const char* name)
{
  this->ChangeInput(connection, "SetInputSphereRadiusArray",
    [&](InputSetting& setting) { setting.Spheres.radiusArray = name ? name : ""; });
}

const char* vtkLambentRayTracer::GetInputSphereRadiusArray(int connection)
{
  const std::string& name = this->Internal->Inputs.of(connection).Spheres.radiusArray;
  return name.empty() ? nullptr : name.c_str();
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputTexture(int connection, vtkTexture* texture)
{
  this->ChangeInput(
    connection, "SetInputTexture", [&](InputSetting& setting) { setting.Texture = texture; });
}

vtkTexture* vtkLambentRayTracer::GetInputTexture(int connection)
{
  return this->Internal->Inputs.of(connection).Texture;
}

// The filters that produce the images of textures are not upstream of this filter. So their
// modification times are added here.
int vtkLambentRayTracer::ComputePipelineMTime(vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  if (!this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time))
  {
    return 0;
  }
  if (this->Internal->IsComputingMTime)
  {
    return 1;
  }
  this->Internal->IsComputingMTime = true;
  bool isDone = true;
  for (const auto& own : this->Internal->Inputs.all())
  {
    vtkTexture* const texture = own.second.Texture;
    if (!texture || texture->GetNumberOfInputConnections(0) == 0)
    {
      continue;
    }
    int producerPort = 0;
    vtkExecutive* const producer = texture->GetInputAlgorithm(0, 0, producerPort)->GetExecutive();
    vtkMTimeType ofImage = 0;
    isDone = isDone &&
      producer->ComputePipelineMTime(request, producer->GetInputInformation(),
        producer->GetOutputInformation(), producerPort, &ofImage);
    *time = std::max(*time, ofImage);
  }
  this->Internal->IsComputingMTime = false;
  return isDone ? 1 : 0;
}

//------------------------------------------------------------------------------
// The settings of a connection stay with it.
void vtkLambentRayTracer::SetInputConnection(int port, vtkAlgorithmOutput* input)
{
  this->Internal->Inputs.followReplacement(
    this, [&]() { this->Superclass::SetInputConnection(port, input); });
}

void vtkLambentRayTracer::RemoveInputConnection(int port, vtkAlgorithmOutput* input)
{
  this->Internal->Inputs.follow(
    this, [&]() { this->Superclass::RemoveInputConnection(port, input); });
}

void vtkLambentRayTracer::RemoveInputConnection(int port, int idx)
{
  this->Internal->Inputs.follow(
    this, [&]() { this->Superclass::RemoveInputConnection(port, idx); }, idx);
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::PrintInputs(ostream& os, vtkIndent indent)
{
  const auto printObject = [&](const std::string& name, vtkObject* object)
  {
    if (object)
    {
      os << indent << name << ":\n";
      object->PrintSelf(os, indent.GetNextIndent());
    }
  };
  for (const auto& own : this->Internal->Inputs.all())
  {
    const std::string number = std::to_string(own.first);
    printObject("InputProperty " + number, own.second.Property);
    const InputColors& colors = own.second.Colors;
    if (colors.scalarVisibility)
    {
      os << indent << "InputScalarVisibility " << number << ": On\n";
      const bool isOfCells = colors.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
      os << indent << "InputColorArray " << number << ": "
         << (colors.arrayName.empty()
                ? "(active scalars)"
                : std::string(isOfCells ? "cell" : "point") + " array " + colors.arrayName)
         << "\n";
      os << indent << "InputColorComponent " << number << ": " << colors.component << "\n";
      printObject("InputLookupTable " + number, colors.lookupTable);
      os << indent << "InputScalarRange " << number << ": ";
      colors.hasScalarRange ? os << colors.scalarRange[0] << " to " << colors.scalarRange[1]
                            : os << "(automatic)";
      os << "\n"
         << indent << "InputInterpolateScalarsBeforeMapping " << number << ": "
         << (colors.interpolateScalarsBeforeMapping ? "On" : "Off") << "\n";
    }
    printObject("InputTexture " + number, own.second.Texture);
    if (own.second.Spheres.areOn())
    {
      const std::string& array = own.second.Spheres.radiusArray;
      os << indent << "InputSphereRadius " << number << ": " << own.second.Spheres.radius << "\n";
      os << indent << "InputSphereRadiusArray " << number << ": "
         << (array.empty() ? "(none)" : array) << "\n";
    }
    printObject("InputTransform " + number, own.second.Transform);
    printObject("InputBlockAttributes " + number, own.second.BlockAttributes);
  }
}
