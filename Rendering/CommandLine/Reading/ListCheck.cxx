// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ListCheck.h"
#include "IdArrays.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationIdTypeKey.h"

namespace lambent::command
{
namespace
{

/// The key of the note in the information of the array of ids. VTK deletes keys at exit.
vtkInformationIdTypeKey* IdsBelow()
{
  static vtkInformationIdTypeKey* const key =
    vtkInformationIdTypeKey::MakeKey("IDS_BELOW", "LambentListCheck");
  return key;
}

} // namespace

void ListCheck::LookAtOffsets(vtkDataArray* offsets, vtkIdType begin, vtkIdType end)
{
  this->OffsetsSeen += end - begin;
  this->IsRight &= begin > 0 &&
    VisitPlain(offsets,
      [&](const auto* values) { this->IsRight &= DoIncrease(values, begin - 1, end - 1); });
}

void ListCheck::LookAtIds(vtkDataArray* ids, vtkIdType begin, vtkIdType end)
{
  this->IdsSeen += end - begin;
  this->IsRight &= this->NumberOfPoints > 0 &&
    VisitPlain(ids,
      [&](const auto* values)
      { this->IsRight &= AreIdsBelow(this->NumberOfPoints, values, begin, end); });
}

void ListCheck::Note(vtkCellArray* cells) const
{
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  const vtkIdType last = offsets->GetNumberOfTuples() - 1;
  const vtkIdType ids = cells->GetConnectivityArray()->GetNumberOfTuples();
  if (this->IsRight && last > 0 && (this->AreOffsetsTrusted || this->OffsetsSeen == last) &&
    this->IdsSeen == ids && offsets->GetComponent(0, 0) == 0.0 &&
    offsets->GetComponent(last, 0) == static_cast<double>(ids))
  {
    NoteIdsBelow(cells, this->NumberOfPoints);
  }
}

void NoteIdsBelow(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  cells->GetConnectivityArray()->GetInformation()->Set(IdsBelow(), numberOfPoints);
}

bool AreIdsKnownBelow(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  vtkDataArray* const ids = cells->GetConnectivityArray();
  return ids->HasInformation() && ids->GetInformation()->Has(IdsBelow()) &&
    ids->GetInformation()->Get(IdsBelow()) <= numberOfPoints;
}

} // namespace lambent::command
