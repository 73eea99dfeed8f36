// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CornerNormals.h"

#include "CellView.h"
#include "CornerRange.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lambent
{
namespace
{
/// Reallocates the normals if there is not room for `count`.
void grow(CornerNormals& normals, std::size_t room, std::size_t count, const Parallel& parallel)
{
  if (count <= room)
  {
    return;
  }
  std::unique_ptr<float[]> all(new float[3 * count]);
  const float* const few = normals.normals.get();
  forEachChunk<4096>(parallel, normals.count,
    [&](std::size_t begin, std::size_t end)
    { std::copy(few + 3 * begin, few + 3 * end, all.get() + 3 * begin); });
  normals.normals = std::move(all);
}

/// Throws at the first checkpoint at which there are too many normals. If no corner needs a
/// further normal, there may be more points than `most`, since no numbers are needed.
class LimitedWork : public Share
{
public:
  LimitedWork(const Share& whole, std::size_t points, const std::atomic<std::size_t>& further,
    std::size_t most)
    : Share(whole)
    , Points(points)
    , Further(further)
    , Most(most)
  {
  }

  void checkpoint(double done) const override
  {
    if (this->Further > 0 && this->Points + this->Further > this->Most)
    {
      throw std::runtime_error("there would be more than " + std::to_string(this->Most) +
        " normals. Compute them with vtkLambentNormals, or render the mesh in parts.");
    }
    Share::checkpoint(done);
  }

private:
  const std::size_t Points;
  const std::atomic<std::size_t>& Further;
  const std::size_t Most;
};

template <typename Cells>
std::unique_ptr<std::int32_t[]> numberCorners(const Faces& faces, const Cells& cells,
  const std::vector<FurtherNormals>& further, const std::vector<std::size_t>& first,
  const Parallel& parallel)
{
  const auto count = static_cast<std::size_t>(cells.offsets[cellCount(faces.cells)]);
  std::unique_ptr<std::int32_t[]> numbers(new std::int32_t[count]);
  forEachChunk<4096>(parallel, count,
    [&](std::size_t begin, std::size_t end)
    { std::copy(cells.corners + begin, cells.corners + end, numbers.get() + begin); });
  forEach(parallel, 0, further.size(),
    [&](int, std::size_t i)
    {
      for (const FurtherNormals::Use& use : further[i].uses)
      {
        numbers[use.place] = static_cast<std::int32_t>(first[i]) + use.number;
      }
    });
  return numbers;
}
}

CornerNormals computeCornerNormals(
  const Faces& faces, double featureAngle, const Parallel& parallel, std::size_t most)
{
  const double largestAngle = std::min(featureAngle + featureAngleMargin, 180.0);
  CornerNormals result;
  result.count = faces.points.size;
  // Most meshes need few further normals. Untouched memory costs nothing.
  const std::size_t room = result.count + result.count / 8;
  result.normals.reset(new float[3 * room]);
  const PointRanges ranges(faces.blocks, faces.points.size, parallel.workers());
  std::vector<FurtherNormals> further(ranges.count());
  std::atomic<std::size_t> furtherCount{ 0 };
  const LimitedWork work(Share(parallel, 0.0, 0.9), result.count, furtherCount, most);
  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      using Task = CornerRange<decltype(points), decltype(cells)>;
      const Task task(
        faces, points, cells, largestAngle, result.normals.get(), further, furtherCount);
      RangeWalks<Task>(ranges, task, work).run();

      std::vector<std::size_t> first(1, result.count);
      bool areAllOfPoints = true;
      for (const FurtherNormals& some : further)
      {
        first.push_back(first.back() + some.normals.size() / 3);
        areAllOfPoints = areAllOfPoints && some.uses.empty();
      }
      if (areAllOfPoints)
      {
        return;
      }
      grow(result, room, first.back(), Share(parallel, 0.9, 0.93));
      forEach(parallel, 0, further.size(),
        [&](int, std::size_t i)
        {
          std::copy(further[i].normals.begin(), further[i].normals.end(),
            result.normals.get() + 3 * first[i]);
        });
      result.numbers = numberCorners(faces, cells, further, first, Share(parallel, 0.93, 1.0));
      result.count = first.back();
    });
  return result;
}
}
