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
}

// Points and normals lie anywhere in memory: first ask for all of them, then read.
void loadTriangles(const RunRange& range, SampleBatch& batch)
{
  const bool smooth = range.isSmooth;
  struct Triangle
  {
    int run;
    const Surface* surface;
    std::size_t number; ///< within the surface
    std::uint64_t corners[3], normals[3];
  };
  Triangle triangles[SampleBatch::places];
  int count = 0;
  std::fill_n(batch.isWanted, batch.runCount, 0.0);
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.triangles[run] != noTriangle)
    {
      const SceneMesh::Part& part = range.part ? *range.part : *batch.parts[run];
      Triangle& triangle = triangles[count++];
      triangle.run = run;
      triangle.surface = part.surface;
      triangle.number = batch.triangles[run] - part.firstTriangle;
      batch.isWanted[run] = 1.0;
      hwy::Prefetch(part.surface->corners.at(3 * triangle.number));
      if (smooth && part.surface->normalNumbers.data)
      {
        hwy::Prefetch(part.surface->normalNumbers.at(3 * triangle.number));
      }
    }
  }
  for (int k = 0; k < count; ++k)
  {
    Triangle& triangle = triangles[k];
    const Surface& surface = *triangle.surface;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      triangle.corners[corner] = surface.corners[3 * triangle.number + corner];
      hwy::Prefetch(surface.points.at(triangle.corners[corner]));
      if (smooth)
      {
        triangle.normals[corner] = surface.normalNumbers.data
          ? surface.normalNumbers[3 * triangle.number + corner]
          : triangle.corners[corner];
        hwy::Prefetch(surface.pointNormals.at(triangle.normals[corner]));
      }
    }
  }
  for (int k = 0; k < count; ++k)
  {
    const Triangle& triangle = triangles[k];
    const Surface& surface = *triangle.surface;
    for (int corner = 0; corner < 3; ++corner)
    {
      put(batch.points + 3 * corner, triangle.run, surface.points[triangle.corners[corner]]);
      if (smooth)
      {
        put(
          batch.normals + 3 * corner, triangle.run, surface.pointNormals[triangle.normals[corner]]);
      }
    }
    if (!smooth)
    {
      put(batch.normals, triangle.run, TrianglePoints::faceNormal(surface, triangle.number));
    }
  }
}
}
