// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellEdgeFlags.h"

#include "CellView.h"
#include "Chunks.h"

#include <algorithm>
#include <vector>

namespace lambent
{
namespace
{
constexpr std::size_t facesPerChunk = 1024;

/// The edges of one polygon.
class Outline
{
public:
  void load(const CellSpan& faces, std::size_t begin, std::size_t size)
  {
    this->Keys.resize(size);
    for (std::size_t k = 0; k < size; ++k)
    {
      this->Keys[k] = keyOf(
        faces.connectivity[begin + k], faces.connectivity[begin + (k + 1 == size ? 0 : k + 1)]);
    }
    if (size > mostUnsorted)
    {
      std::sort(this->Keys.begin(), this->Keys.end());
    }
  }

  bool has(std::int32_t a, std::int32_t b) const
  {
    const std::uint64_t key = keyOf(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
    return this->Keys.size() > mostUnsorted
      ? std::binary_search(this->Keys.begin(), this->Keys.end(), key)
      : std::find(this->Keys.begin(), this->Keys.end(), key) != this->Keys.end();
  }

private:
  static constexpr std::size_t mostUnsorted = 16;

  /// The same for both directions. The points of a polygon that is drawn fit 32 bits.
  static std::uint64_t keyOf(std::uint64_t a, std::uint64_t b)
  {
    return std::min(a, b) << 32 | std::max(a, b);
  }

  std::vector<std::uint64_t> Keys;
};

std::size_t sizeOf(const CellSpan& faces, std::size_t face)
{
  return faces.offsets[face + 1] - faces.offsets[face];
}

/// Writes the flags of the triangles of one face.
void findEdges(const CellSpan& faces, std::size_t face, const std::int32_t* corners,
  Outline& outline, unsigned char* out)
{
  const std::size_t size = sizeOf(faces, face);
  if (size == 3)
  {
    *out = 7;
    return;
  }
  outline.load(faces, faces.offsets[face], size);
  for (std::size_t t = 0; t + 2 < size; ++t, corners += 3)
  {
    const unsigned int first = outline.has(corners[0], corners[1]) ? 1 : 0;
    const unsigned int second = outline.has(corners[1], corners[2]) ? 2 : 0;
    const unsigned int third = outline.has(corners[2], corners[0]) ? 4 : 0;
    out[t] = static_cast<unsigned char>(first | second | third);
  }
}
}

UnwrittenVector<unsigned char> findCellEdges(
  const CellSpan& faces, const TriangleList& triangles, const Parallel& parallel)
{
  const std::size_t count = cellCount(faces);
  const auto trianglesOf = [&](std::size_t face)
  {
    const std::size_t size = sizeOf(faces, face);
    return size < 3 ? 0 : size - 2;
  };
  // Where the triangles of each chunk begin.
  std::vector<std::size_t> first(chunkCount(count, facesPerChunk) + 1, 0);
  forEachChunk<facesPerChunk>(Share(parallel, 0.0, 0.1), count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t face = begin; face < end; ++face)
      {
        first[begin / facesPerChunk + 1] += trianglesOf(face);
      }
    });
  for (std::size_t chunk = 1; chunk < first.size(); ++chunk)
  {
    first[chunk] += first[chunk - 1];
  }
  UnwrittenVector<unsigned char> flags(triangles.cells.size());
  forEachChunk<facesPerChunk>(Share(parallel, 0.1, 1.0), count,
    [&](std::size_t begin, std::size_t end)
    {
      Outline outline;
      std::size_t triangle = first[begin / facesPerChunk];
      for (std::size_t face = begin; face < end; ++face)
      {
        if (trianglesOf(face) > 0)
        {
          findEdges(
            faces, face, triangles.corners.data() + 3 * triangle, outline, flags.data() + triangle);
          triangle += trianglesOf(face);
        }
      }
    });
  return flags;
}
}
