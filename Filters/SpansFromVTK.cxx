// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpansFromVTK.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

namespace lambent::adapters
{
namespace
{
IndexSpan toIndices(vtkDataArray* array)
{
  return { array->GetVoidPointer(0), array->GetDataTypeSize() == 8,
    static_cast<std::size_t>(array->GetNumberOfValues()) };
}

// Whether both are contiguous arrays of signed integers of the same width. VTK 9.6 and later
// also have arrays that compute their values.
bool areStoredPlainly(vtkDataArray* offsets, vtkDataArray* connectivity)
{
  return offsets->HasStandardMemoryLayout() && connectivity->HasStandardMemoryLayout() &&
    offsets->GetDataTypeSize() == connectivity->GetDataTypeSize() &&
    (offsets->GetDataTypeSize() == 4 || offsets->GetDataTypeSize() == 8);
}
}

TupleSpan SpansFromVTK::tuples(vtkDataArray* array)
{
  if (!array || array->GetNumberOfTuples() == 0)
  {
    return {};
  }
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  if (!isReal || !array->HasStandardMemoryLayout())
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(array);
    this->Converted.emplace_back(copy);
    array = copy;
  }
  return { array->GetVoidPointer(0), array->GetDataType() == VTK_DOUBLE,
    static_cast<std::size_t>(array->GetNumberOfTuples()) };
}

CellSpan SpansFromVTK::cells(vtkCellArray* array)
{
  if (!array || array->GetNumberOfCells() == 0)
  {
    return {};
  }
  if (!areStoredPlainly(array->GetOffsetsArray(), array->GetConnectivityArray()))
  {
    vtkNew<vtkCellArray> copy;
    copy->DeepCopy(array);
    copy->ConvertTo64BitStorage();
    this->Converted.emplace_back(copy);
    array = copy;
  }
  return { toIndices(array->GetOffsetsArray()), toIndices(array->GetConnectivityArray()) };
}
}
