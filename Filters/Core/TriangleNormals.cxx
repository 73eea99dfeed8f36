// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleNormals.h"

#include "CellView.h"
#include "Chunks.h"

#include <algorithm>
#include <utility>

namespace lambent
{
namespace
{
/// Maps the points of a face to the numbers of their normals. All corners of a face at the same
/// point have the same normal, so any of them will do.
class FaceNumbers
{
public:
  template <typename Id>
  void reset(const Id* points, std::size_t size, const std::int32_t* numbers)
  {
    this->Numbers.clear();
    for (std::size_t k = 0; k < size; ++k)
    {
      this->Numbers.emplace_back(points[k], numbers[k]);
    }
    std::sort(this->Numbers.begin(), this->Numbers.end());
  }

  std::int32_t operator[](std::int64_t point) const
  {
    const auto found = std::lower_bound(this->Numbers.begin(), this->Numbers.end(), point,
      [](const auto& entry, std::int64_t wanted) { return entry.first < wanted; });
    return found != this->Numbers.end() && found->first == point ? found->second
                                                                 : static_cast<std::int32_t>(point);
  }

private:
  std::vector<std::pair<std::int64_t, std::int32_t>> Numbers;
};
}

UnwrittenVector<std::int32_t> numbersOfTriangles(const CellSpan& faces,
  const CornerNormals& normals, const IndexSpan& corners, const Parallel& parallel)
{
  constexpr std::size_t facesPerChunk = 4096;
  const std::size_t faceCount = cellCount(faces);
  UnwrittenVector<std::int32_t> result(corners.size);
  visit(faces,
    [&](auto cells)
    {
      const auto cornersOf = [&](std::size_t face)
      { return 3 * (std::max<std::size_t>(cells.cellSize(face), 2) - 2); };
      // Where the corners of each chunk of faces begin.
      std::vector<std::size_t> first(chunkCount(faceCount, facesPerChunk) + 1, 0);
      for (std::size_t face = 0; face < faceCount; ++face)
      {
        first[face / facesPerChunk + 1] += cornersOf(face);
      }
      for (std::size_t chunk = 1; chunk < first.size(); ++chunk)
      {
        first[chunk] += first[chunk - 1];
      }
      forEachChunk<facesPerChunk>(parallel, faceCount,
        [&](std::size_t begin, std::size_t end)
        {
          FaceNumbers numbers;
          std::size_t corner = first[begin / facesPerChunk];
          for (std::size_t face = begin; face < end; ++face)
          {
            numbers.reset(
              cells.cell(face), cells.cellSize(face), normals.numbers.get() + cells.offsets[face]);
            for (const std::size_t stop = corner + cornersOf(face); corner < stop; ++corner)
            {
              result[corner] = numbers[static_cast<std::int64_t>(corners[corner])];
            }
          }
        });
    });
  return result;
}
}
