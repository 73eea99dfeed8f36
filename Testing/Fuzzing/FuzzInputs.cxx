// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzInputs.h"

#include "FuzzArrays.h"
#include "FuzzChanges.h"
#include "FuzzColors.h"
#include "FuzzMesh.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObject.h"
#include "vtkLambentRayTracer.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkTrivialProducer.h"

void FuzzInputs::add(bool hasArrays)
{
  // As an input, nullptr is an error of the executive; as a block it is an empty place.
  this->connect(this->Input.seldom() ? nullptr : this->makeMesh(hasArrays).Get());
}

void FuzzInputs::addTree(bool hasArrays)
{
  this->connect(this->Blocks.makeTree([&]() { return this->makeMesh(hasArrays); }));
}

vtkSmartPointer<vtkDataObject> FuzzInputs::makeMesh(bool hasArrays)
{
  const vtkSmartPointer<vtkPolyData> mesh = makeFuzzMesh(this->Input);
  if (hasArrays)
  {
    addFuzzArrays(this->Input, mesh);
  }
  return mesh;
}

void FuzzInputs::connect(vtkDataObject* data)
{
  this->Objects.emplace_back(data);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  this->Tracer->AddInputConnection(0, producer->GetOutputPort());
}

void FuzzInputs::clear()
{
  this->Tracer->RemoveAllInputConnections(0);
  this->Objects.clear();
}

void FuzzInputs::clearSeldom()
{
  if (static_cast<int>(this->Objects.size()) == most || this->Input.seldom(32))
  {
    this->clear();
  }
}

void FuzzInputs::change()
{
  const int connection = this->Input.choice(most);
  switch (this->Input.choice(8))
  {
    case 0:
    case 1:
      this->changeColors(connection);
      break;
    case 2:
      this->Tracer->SetInputLookupTable(
        connection, this->Input.seldom() ? nullptr : makeFuzzTable(this->Input).Get());
      break;
    case 3:
      this->Tracer->SetInputBlockAttributes(
        connection, this->Input.seldom() ? nullptr : this->Blocks.makeAttributes().Get());
      break;
    case 4:
      this->changeSpheres(connection);
      break;
    case 5:
      this->Tracer->SetInputTexture(
        connection, this->Input.seldom(64) ? nullptr : makeFuzzTexture(this->Input).Get());
      break;
    default:
      this->changeLook(connection);
  }
}

void FuzzInputs::changeColors(int connection)
{
  FuzzInput& input = this->Input;
  const int bits = input.byte();
  this->Tracer->SetInputScalarVisibility(connection, (bits & 3) != 0);
  this->Tracer->SetInputInterpolateScalarsBeforeMapping(connection, (bits & 4) != 0);
  static const char* const names[] = { "", "Heat", "Part", "Radius" };
  const char* const name = names[(bits >> 3) & 3];
  const bool isOfCells = (name[0] == 'P') != input.seldom(4); // seldom the wrong ones
  this->Tracer->SetInputColorArray(connection,
    input.seldom(2) ? 2
      : isOfCells   ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                    : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    name);
  this->Tracer->SetInputColorComponent(
    connection, (bits & 32) != 0 ? input.choice(6) - 2 : 0); // -2 is always wrong
  if ((bits & 64) != 0)
  {
    const double low = input.seldom() ? input.number() : input.within(0.01, 1.0);
    const double high = input.seldom() ? input.number() : input.within(1.0, 3.0);
    this->Tracer->SetInputScalarRange(connection, low, high);
  }
  else if ((bits & 128) != 0)
  {
    this->Tracer->ResetInputScalarRange(connection);
  }
}

void FuzzInputs::changeSpheres(int connection)
{
  static const char* const names[] = { nullptr, "Radius", "Heat", "" };
  this->Tracer->SetInputSphereRadius(connection,
    this->Input.seldom(16) ? this->Input.number()
      : this->Input.flag() ? this->Input.within(0.0, 2.0)
                           : 0.0);
  this->Tracer->SetInputSphereRadiusArray(connection, names[this->Input.choice(4)]);
}

void FuzzInputs::changeLook(int connection)
{
  vtkProperty* property = this->Tracer->GetInputProperty(connection);
  vtkNew<vtkProperty> own;
  if (!property)
  {
    property = own;
    this->Tracer->SetInputProperty(connection, own);
  }
  ::changeLook(this->Input, property);
}

void FuzzInputs::changeTransform()
{
  vtkNew<vtkMatrix4x4> matrix;
  const int count = this->Input.choice(13);
  for (int k = 0; k < count; ++k)
  {
    matrix->SetElement(
      k / 4, k % 4, this->Input.seldom(4) ? this->Input.number() : this->Input.within(-2.0, 2.0));
  }
  if (count == 12 && this->Input.seldom())
  {
    matrix->SetElement(3, this->Input.choice(4), this->Input.number()); // a projection
  }
  this->Tracer->SetInputTransform(this->Input.choice(most), count == 0 ? nullptr : matrix.Get());
}

void FuzzInputs::reset()
{
  for (int connection = 0; connection < most; ++connection)
  {
    this->Tracer->SetInputProperty(connection, nullptr);
    this->Tracer->SetInputTransform(connection, nullptr);
    this->Tracer->SetInputBlockAttributes(connection, nullptr);
    this->Tracer->SetInputScalarVisibility(connection, false);
    this->Tracer->SetInputTexture(connection, nullptr);
    this->Tracer->SetInputSphereRadius(connection, 0.0);
    this->Tracer->SetInputSphereRadiusArray(connection, nullptr);
  }
  this->clear();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  this->connect(mesh);
}
