// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks a list of cells in parts while it is read
 *
 * Checking a large list after it has been read loads it from memory again, which takes a third of
 * the time of reading raw numbers. Checking parts that are still in the cache costs next to
 * nothing. The result is noted in the list, so that CheckCells() does not check it again.
 */

#ifndef ListCheck_h
#define ListCheck_h

#include "vtkType.h"

class vtkCellArray;
class vtkDataArray;

namespace lambent::command
{

class ListCheck
{
public:
  /// The number of values to read at once: 128 kB, a small part of second-level caches.
  static constexpr vtkIdType Part = 1 << 14;

  /// Every id must be less than the number of points.
  explicit ListCheck(vtkIdType numberOfPoints = 0)
    : NumberOfPoints(numberOfPoints)
  {
  }

  /// Checks values[begin .. end), which have been read. Offsets are checked from the second on,
  /// because the first is 0.
  void LookAtOffsets(vtkDataArray* offsets, vtkIdType begin, vtkIdType end);
  void LookAtIds(vtkDataArray* ids, vtkIdType begin, vtkIdType end);

  /// Call if the reader itself rejects offsets that do not increase from 0.
  void TrustOffsets() { this->AreOffsetsTrusted = true; }

  /// Notes in the list made of these arrays that it is valid, if all of it was checked and is
  /// valid.
  void Note(vtkCellArray* cells) const;

private:
  vtkIdType NumberOfPoints;
  vtkIdType OffsetsSeen = 0;
  vtkIdType IdsSeen = 0;
  bool AreOffsetsTrusted = false;
  bool IsRight = true;
};

/// Notes in a list that its offsets are valid and its ids less than the number of points.
void NoteIdsBelow(vtkCellArray* cells, vtkIdType numberOfPoints);

/// Whether there is such a note, for this number of points or fewer.
bool AreIdsKnownBelow(vtkCellArray* cells, vtkIdType numberOfPoints);

} // namespace lambent::command

#endif
