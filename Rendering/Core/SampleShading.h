// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colours of samples: surface points, then light, textures and edges
 *
 * color() is the definition: the texture multiplies what LightModel::color() gives, and the edges
 * of cells are drawn over it. shade() gives a batch the same colours; a kernel shades the hits on
 * surfaces that are shaded alike.
 */
#ifndef lambent_SampleShading_h
#define lambent_SampleShading_h

#include "CellEdges.h"
#include "LightModel.h"
#include "PointBatch.h"
#include "RunRange.h"
#include "SurfacePoints.h"

namespace lambent
{
class SampleShading
{
public:
  /// samples: the number of samples across a pixel.
  SampleShading(const SurfacePoints& points, const LightModel& light, int samples)
    : Points(points)
    , Light(light)
    , Edges(points.triangles().mesh(), samples)
  {
  }

  /// The colour of a sample at (x, y) of the image plane that sees this point of a primitive.
  Vec3 color(std::uint32_t primitive, double x, double y, const SurfacePoint& point) const
  {
    return this->Edges.mixed(primitive, x, y, this->Light.color(point) * point.texture.color);
  }

  /// Fills in the colours of the samples that hit something, and the parts of their runs. Also
  /// stores the surface points, if there is memory for them. The samples belong to the tile of the
  /// edges.
  void shade(SampleBatch& batch, EdgesInTile& edges, PointBatch* points) const;

private:
  void shadeRange(const RunRange& range, SampleBatch& batch, PointBatch* points) const;
  void shadeUnlit(const RunRange& range, SampleBatch& batch, PointBatch* points) const;

  const SurfacePoints& Points;
  const LightModel& Light;
  const CellEdges Edges;
};
}

#endif
