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

/// The type of an array's values. The array must not be of bits.
AttributeType attributeType(vtkDataArray* array)
{
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    return array->GetDataType() == VTK_FLOAT ? AttributeType::Float : AttributeType::Double;
  }
  const bool isSigned = array->GetDataTypeMin() < 0.0;
  switch (array->GetDataTypeSize())
  {
    case 1:
      return isSigned ? AttributeType::Int8 : AttributeType::UInt8;
    case 2:
      return isSigned ? AttributeType::Int16 : AttributeType::UInt16;
    case 4:
      return isSigned ? AttributeType::Int32 : AttributeType::UInt32;
    default:
      return isSigned ? AttributeType::Int64 : AttributeType::UInt64;
  }
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

/// The array, or a copy, if it is not a contiguous one of float or double.
vtkDataArray* SpansFromVTK::asReals(vtkDataArray* array)
{
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  if (!isReal || !array->HasStandardMemoryLayout())
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(array);
    this->Converted.emplace_back(copy);
    return copy;
  }
  return array;
}

TupleSpan SpansFromVTK::tuples(vtkDataArray* array)
{
  if (!array || array->GetNumberOfTuples() == 0)
  {
    return {};
  }
  array = this->asReals(array);
  return { array->GetVoidPointer(0), array->GetDataType() == VTK_DOUBLE,
    static_cast<std::size_t>(array->GetNumberOfTuples()) };
}

ScalarSpan SpansFromVTK::scalars(vtkDataArray* array)
{
  const TupleSpan span = this->tuples(array);
  return { span.data, span.isDouble, span.size };
}

AttributeSpan SpansFromVTK::attribute(vtkDataArray* array, bool isPerCell)
{
  if (!array)
  {
    return {};
  }
  const bool isBits = array->GetDataType() == VTK_BIT;
  if (isBits || !array->HasStandardMemoryLayout())
  {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(isBits ? VTK_UNSIGNED_CHAR : array->GetDataType()));
    copy->DeepCopy(array);
    this->Converted.emplace_back(copy);
    array = copy;
  }
  const void* const data = array->GetNumberOfTuples() > 0 ? array->GetVoidPointer(0) : nullptr;
  return { data, attributeType(array), array->GetNumberOfComponents(), isPerCell };
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
