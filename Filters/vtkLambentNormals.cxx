// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentNormals.h"

#include "Chunks.h"
#include "FacesFromVTK.h"
#include "PolyDataRewrite.h"
#include "SharpEdges.h"
#include "WatchedParallel.h"

#include "vtkCellData.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <new>
#include <stdexcept>

using lambent::adapters::Aborted;
using lambent::adapters::copyPoints;
using lambent::adapters::FacesFromVTK;
using lambent::adapters::reversePolygons;
using lambent::adapters::setPolygons;
using lambent::adapters::WatchedParallel;

namespace
{
constexpr const char* NormalsName = "Normals";

vtkSmartPointer<vtkFloatArray> makeNormals(vtkIdType count)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName(NormalsName);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  return normals;
}

void setNormals(vtkDataSetAttributes* data, vtkFloatArray* normals)
{
  data->AddArray(normals);
  data->SetActiveNormals(NormalsName);
}

void addPointNormals(vtkPolyData* output, const lambent::Faces& faces, lambent::Weighting weighting,
  float sign, const lambent::Parallel& parallel)
{
  const auto normals = makeNormals(output->GetNumberOfPoints());
  lambent::computePointNormals(faces, weighting, sign, parallel, normals->GetPointer(0));
  setNormals(output->GetPointData(), normals);
}

// Vertices and lines come before the faces and have no normals.
void addCellNormals(
  vtkPolyData* output, const lambent::Faces& faces, float sign, const lambent::Parallel& parallel)
{
  const auto normals = makeNormals(output->GetNumberOfCells());
  const vtkIdType others = output->GetNumberOfVerts() + output->GetNumberOfLines();
  std::fill_n(normals->GetPointer(0), 3 * others, 0.0f);
  lambent::computeFaceNormals(faces, sign, parallel, normals->GetPointer(0) + 3 * others);
  setNormals(output->GetCellData(), normals);
}
}

vtkStandardNewMacro(vtkLambentNormals);

//------------------------------------------------------------------------------
vtkLambentNormals::vtkLambentNormals()
  : Weighting(ANGLE)
  , ComputePointNormals(true)
  , ComputeCellNormals(false)
  , Splitting(false)
  , FeatureAngle(30.0)
  , FlipNormals(false)
{
}

//------------------------------------------------------------------------------
int vtkLambentNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  try
  {
    this->Execute(vtkPolyData::GetData(inputs[0]), output);
    return 1;
  }
  catch (const Aborted&)
  {
    // The executive must not consider the empty output up to date.
    output->Initialize();
    outputs->GetInformationObject(0)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("There is not enough memory for the normals of "
      << vtkPolyData::GetData(inputs[0])->GetNumberOfPoints()
      << " points and their intermediate data. Process the mesh in parts.");
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< failure.what());
  }
  output->Initialize();
  return 0;
}

//------------------------------------------------------------------------------
// Warns once while the condition lasts, not at each execution.
void vtkLambentNormals::WarnOfFlipping(vtkPolyData* input)
{
  const bool hasNormals = input->GetPointData()->GetNormals() != nullptr;
  const bool isIdle =
    this->FlipNormals && !this->ComputePointNormals && (hasNormals || !this->ComputeCellNormals);
  if (isIdle && !this->HasWarnedOfFlipping)
  {
    vtkWarningMacro("FlipNormals reverses the polygons, but not the point normals, since "
                    "ComputePointNormals is off"
      << (hasNormals ? "; the input's normals are now opposite to the faces" : "")
      << ". Call ComputePointNormalsOn() or FlipNormalsOff().");
  }
  this->HasWarnedOfFlipping = isIdle;
}

//------------------------------------------------------------------------------
void vtkLambentNormals::Execute(vtkPolyData* input, vtkPolyData* output)
{
  const WatchedParallel parallel(this);
  parallel.checkAbort(); // a StartEvent observer may already have aborted

  output->ShallowCopy(input);
  FacesFromVTK mesh(input, lambent::Share(parallel, 0.0, 0.2));
  if (!mesh.warning().empty())
  {
    vtkWarningMacro(<< mesh.warning());
  }
  this->WarnOfFlipping(input);

  if (this->Splitting || this->FlipNormals || (this->ComputeCellNormals && mesh.hasStrips()))
  {
    lambent::SplitMesh split;
    if (this->Splitting)
    {
      split = lambent::splitSharpEdges(
        mesh.faces(), this->FeatureAngle, lambent::Share(parallel, 0.2, 0.4));
      copyPoints(input, split.copiedPoints, output);
    }
    setPolygons(mesh, split.connectivity, output, lambent::Share(parallel, 0.4, 0.45));
    mesh.refer(output, lambent::Share(parallel, 0.45, 0.5));
  }

  const float sign = this->FlipNormals ? -1.0f : 1.0f;
  if (this->ComputePointNormals)
  {
    addPointNormals(output, mesh.faces(), static_cast<lambent::Weighting>(this->Weighting), sign,
      lambent::Share(parallel, 0.5, 0.8));
  }
  if (this->ComputeCellNormals)
  {
    addCellNormals(output, mesh.faces(), sign, lambent::Share(parallel, 0.8, 0.9));
  }
  if (this->FlipNormals)
  {
    reversePolygons(output, lambent::Share(parallel, 0.9, 1.0));
  }
  parallel.checkpoint(1.0);
}

//------------------------------------------------------------------------------
const char* vtkLambentNormals::GetWeightingAsString() const
{
  constexpr const char* names[] = { "Uniform", "Area", "Angle", "Max" };
  return names[this->Weighting];
}

//------------------------------------------------------------------------------
void vtkLambentNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto onOff = [](vtkTypeBool value) { return value ? "On" : "Off"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weighting: " << this->GetWeightingAsString() << "\n";
  os << indent << "ComputePointNormals: " << onOff(this->ComputePointNormals) << "\n";
  os << indent << "ComputeCellNormals: " << onOff(this->ComputeCellNormals) << "\n";
  os << indent << "Splitting: " << onOff(this->Splitting) << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "FlipNormals: " << onOff(this->FlipNormals) << "\n";
}
