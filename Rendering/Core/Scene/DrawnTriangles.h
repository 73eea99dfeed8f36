// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which triangles of a mesh are drawn, and in which order of their corners
 *
 * Ghost flags exclude cells. A transform that mirrors swaps the second and the third corner of each
 * triangle (Transform.h). Both make a new list of corners; without either, the original one is
 * used.
 *
 * The flags have VTK's bits:
 *
 * - A cell that is hidden or refined (other cells are there instead), or that has a hidden point,
 * is not part of the surface: it is neither drawn nor does it contribute to computed normals.
 * - A duplicate cell, which another piece draws, is not drawn, but contributes to computed normals.
 *   That is what ghost cells are for: the normals at the border of a piece are those of the whole.
 */
#ifndef lambent_DrawnTriangles_h
#define lambent_DrawnTriangles_h

#include "Parallel.h"
#include "Spans.h"
#include "UnwrittenVector.h"

#include <cstdint>

namespace lambent
{
struct CheckedFaces;

/// One byte for each point, and one for each cell: first the polygons, then the strips. nullptr: no
/// flags.
struct GhostFlags
{
  static constexpr unsigned char duplicateCell = 1, refinedCell = 8, hiddenCell = 32;
  static constexpr unsigned char hiddenPoint = 2;

  const unsigned char* points = nullptr;
  const unsigned char* cells = nullptr;
};

enum class CellUse : unsigned char
{
  Drawn,
  ForNormals, ///< not drawn, but contributes to computed normals
  None
};

/// The use of each polygon, then of each strip; empty if all are drawn. The offsets must not be
/// broken. Points that do not exist have no flags.
UnwrittenVector<CellUse> findCellUses(const CellSpan& polygons, const CellSpan& strips,
  std::size_t pointCount, const GhostFlags& ghosts, const Parallel& parallel);

/// Makes computed normals ignore the faces of cells without use.
void skipUnused(const UnwrittenVector<CellUse>& uses, CheckedFaces& faces);

class DrawnTriangles
{
public:
  /// All triangles, unchanged.
  DrawnTriangles() = default;
  /// `cells` has the cell of each triangle, counted from firstCell; if nullptr, triangle t is cell
  /// t. Uses may be empty.
  DrawnTriangles(std::size_t triangleCount, const std::int64_t* cells, std::int64_t firstCell,
    const UnwrittenVector<CellUse>& uses, bool isMirrored, const Parallel& parallel);

  bool areUnchanged() const { return this->AreAll && !this->AreMirrored; }

  /// Picks their indices from a list of three for each triangle.
  class Indices
  {
  public:
    IndexSpan span() const;

  private:
    friend class DrawnTriangles;
    UnwrittenVector<std::int32_t> Narrow;
    UnwrittenVector<std::int64_t> Wide;
  };
  Indices pick(const IndexSpan& all, const Parallel& parallel) const;

  /// Picks their flags of edges (Surface::cellEdges) from those of all triangles.
  UnwrittenVector<unsigned char> pickEdges(
    const UnwrittenVector<unsigned char>& all, const Parallel& parallel) const;

  /// The cell of each, counted as in the constructor. Empty if all triangles are drawn.
  const UnwrittenVector<std::int64_t>& cells() const { return this->Cells; }

private:
  template <typename Index>
  void pick(const void* all, const Parallel& parallel, UnwrittenVector<Index>& picked) const;

  bool AreAll = true;
  bool AreMirrored = false;
  std::size_t Count = 0;
  UnwrittenVector<std::size_t> Kept; ///< unless all are
  UnwrittenVector<std::int64_t> Cells;
};
}

#endif
