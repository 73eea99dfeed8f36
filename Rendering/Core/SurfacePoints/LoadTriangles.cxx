// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadTriangles.h"

#include "TrianglePoints.h"

#include <hwy/cache_control.h>

namespace lambent
{
namespace
{
void put(double (*rows)[SampleBatch::room], int run, const Vec3& v)
{
  rows[0][run] = v.x;
  rows[1][run] = v.y;
  rows[2][run] = v.z;
}

/// partOf(run): the surface that a run hits. Points and normals are scattered in memory, so all are
/// prefetched before any is read.
template <bool IsSmooth, bool IsColored, typename PartOf>
void load(const RunRange& range, const PartOf& partOf, SampleBatch& batch)
{
  int runs[SampleBatch::places];
  int count = 0;
  std::fill_n(batch.isWanted, batch.runCount, 0.0);
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.primitives[run] != noPrimitive)
    {
      batch.isWanted[run] = 1.0;
      runs[count++] = run;
      const SceneMesh::Part& part = partOf(run);
      const std::size_t corner = 3 * (batch.primitives[run] - part.firstPrimitive);
      hwy::Prefetch(part.corners().at(corner));
      if (IsSmooth && part.hasNormalNumbers())
      {
        hwy::Prefetch(part.surface->normalNumbers.at(corner));
      }
    }
  }
  std::uint64_t corners[SampleBatch::places][3];
  std::uint64_t normals[SampleBatch::places][3];
  for (int k = 0; k < count; ++k)
  {
    const SceneMesh::Part& part = partOf(runs[k]);
    const std::size_t first = 3 * (batch.primitives[runs[k]] - part.firstPrimitive);
    const bool hasNumbers = IsSmooth && part.hasNormalNumbers();
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::uint64_t point = part.corners()[first + corner];
      corners[k][corner] = point;
      hwy::Prefetch(part.points().at(point));
      if (IsColored)
      {
        hwy::Prefetch(part.surface->colors->values.address(point));
      }
      if (IsSmooth)
      {
        const std::uint64_t normal =
          hasNumbers ? part.surface->normalNumbers[first + corner] : point;
        normals[k][corner] = normal;
        hwy::Prefetch(part.pointNormals().at(normal));
      }
    }
  }
  for (int k = 0; k < count; ++k)
  {
    const SceneMesh::Part& part = partOf(runs[k]);
    Vec3 points[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      points[corner] = part.points()[corners[k][corner]];
      put(batch.points + 3 * corner, runs[k], points[corner]);
      if (IsSmooth)
      {
        put(batch.normals + 3 * corner, runs[k], part.pointNormals()[normals[k][corner]]);
      }
    }
    if (!IsSmooth)
    {
      put(batch.normals, runs[k],
        part.hasCellNormals() ? TrianglePoints::faceNormal(
                                  *part.surface, batch.primitives[runs[k]] - part.firstPrimitive)
                              : cross(points[1] - points[0], points[2] - points[0]));
    }
  }
}

/// Loads what the points of a triangle contribute to its colour. `values` are those of the array,
/// with their own type.
template <typename Value>
void loadCornerColors(
  const ColorArray& colors, const Value* values, const RunRange& range, int run, SampleBatch& batch)
{
  const SceneMesh::Part& part = *batch.parts[run];
  const std::size_t first = 3 * (batch.primitives[run] - part.firstPrimitive);
  for (int corner = 0; corner < 3; ++corner)
  {
    const std::size_t point = part.corners()[first + static_cast<std::size_t>(corner)];
    double(*const rows)[SampleBatch::room] = batch.cornerColors + 3 * corner;
    if (range.colorSource == ColorSource::MappedLast)
    {
      rows[0][run] = colors.numberIn(values, point);
    }
    else
    {
      put(rows, run, colors.colorIn(values, point));
    }
  }
  batch.coefficients[0][run] = range.isUnlit ? 1.0 : part.appearance->diffuse;
  batch.coefficients[1][run] = range.isUnlit ? 0.0 : part.appearance->ambient;
}

void loadCornerColors(const RunRange& range, SampleBatch& batch)
{
  const auto forRuns = [&](const auto& body)
  {
    for (int run = range.firstRun; run < range.endRun; ++run)
    {
      if (batch.primitives[run] != noPrimitive)
      {
        body(run);
      }
    }
  };
  if (range.part)
  {
    const ColorArray& colors = *range.part->surface->colors;
    colors.values.visit([&](const auto* values)
      { forRuns([&](int run) { loadCornerColors(colors, values, range, run, batch); }); });
    return;
  }
  forRuns(
    [&](int run)
    {
      const ColorArray& colors = *batch.parts[run]->surface->colors;
      colors.values.visit(
        [&](const auto* values) { loadCornerColors(colors, values, range, run, batch); });
    });
}

template <bool IsSmooth, bool IsColored>
void load(const RunRange& range, SampleBatch& batch)
{
  if (range.part)
  {
    const SceneMesh::Part& part = *range.part;
    load<IsSmooth, IsColored>(
      range, [&part](int) -> const SceneMesh::Part& { return part; }, batch);
  }
  else
  {
    load<IsSmooth, IsColored>(
      range, [&batch](int run) -> const SceneMesh::Part& { return *batch.parts[run]; }, batch);
  }
}
}

void loadTriangles(const RunRange& range, SampleBatch& batch)
{
  if (range.colorSource == ColorSource::Primitive)
  {
    range.isSmooth ? load<true, false>(range, batch) : load<false, false>(range, batch);
    return;
  }
  range.isSmooth ? load<true, true>(range, batch) : load<false, true>(range, batch);
  loadCornerColors(range, batch);
}
}
