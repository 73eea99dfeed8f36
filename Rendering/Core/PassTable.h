// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the passes that show surface points: their arrays, and their values
 *
 * A new one needs an enumerator of PassContent, a line here, and a setting of vtkLambentAlgorithm.
 */
#ifndef lambent_PassTable_h
#define lambent_PassTable_h

#include "Image.h"
#include "PointBatch.h"
#include "SurfacePoint.h"

namespace lambent
{
struct PassEntry
{
  static constexpr int mostComponents = 3;

  PassContent content;
  const char* name; ///< of the array
  int components;
  bool isDouble;
  /// The definition: component k of the value at a point.
  double (*valueAt)(const SurfacePoint& point, const Vec3& eye, int k);
  /// The same for a batch, by place.
  const double* (*valuesIn)(const PointBatch& points, int k);
};

inline constexpr PassEntry passTable[] = {
  { PassContent::Depth, "Depth", 1, false,
    [](const SurfacePoint& point, const Vec3&, int) { return point.depth; },
    [](const PointBatch& points, int) -> const double* { return points.depth; } },
  { PassContent::Normal, "Normals", 3, false,
    [](const SurfacePoint& point, const Vec3&, int k) { return normalized(point.normal)[k]; },
    [](const PointBatch& points, int k) -> const double* { return points.normal[k]; } },
  { PassContent::Position, "Positions", 3, true,
    [](const SurfacePoint& point, const Vec3& eye, int k) { return (eye + point.position)[k]; },
    [](const PointBatch& points, int k) -> const double* { return points.position[k]; } },
};

/// The entry of a content, or nullptr for an attribute.
inline const PassEntry* entryOf(PassContent content)
{
  for (const PassEntry& entry : passTable)
  {
    if (entry.content == content)
    {
      return &entry;
    }
  }
  return nullptr;
}
}

#endif
