// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief check a list of cells part by part, while it is read
 *
 * A large list that is checked once it has been read comes from memory a second
 * time, which takes a third of the time that the reading of raw numbers takes.
 * Parts that the processor still has in its cache cost next to nothing. What was
 * found is noted in the list, so that CheckCells() does not look again.
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
  /// How many values to read at once: 128 kB, a small part of second-level caches.
  static constexpr vtkIdType Part = 1 << 14;

  /// The ids have to be less than the number of points.
  explicit ListCheck(vtkIdType numberOfPoints = 0)
    : NumberOfPoints(numberOfPoints)
  {
  }

  /// values[begin .. end) have been read; the first offset, which is 0, is not among them.
  void LookAtOffsets(vtkDataArray* offsets, vtkIdType begin, vtkIdType end);
  void LookAtIds(vtkDataArray* ids, vtkIdType begin, vtkIdType end);

  /// The reader checks the offsets, and makes no list of them unless they increase from 0.
  void TrustOffsets() { this->AreOffsetsTrusted = true; }

  /// Notes in the list made of these arrays that it is right, if all of it was seen and is.
  void Note(vtkCellArray* cells) const;

private:
  vtkIdType NumberOfPoints;
  vtkIdType OffsetsSeen = 0;
  vtkIdType IdsSeen = 0;
  bool AreOffsetsTrusted = false;
  bool IsRight = true;
};

/// Notes in a list that its offsets are right and its ids less than that.
void NoteIdsBelow(vtkCellArray* cells, vtkIdType numberOfPoints);

/// Whether there is such a note, for as many points or less.
bool AreIdsKnownBelow(vtkCellArray* cells, vtkIdType numberOfPoints);

} // namespace lambent::command

#endif
