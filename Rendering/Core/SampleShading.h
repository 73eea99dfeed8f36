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
#include "TileSamples.h"

namespace lambent
{
class SampleShading
{
public:
  SampleShading(const SurfacePoints& points, const LightModel& light)
    : Points(points)
    , Light(light)
    , Edges(points.triangles().mesh())
  {
  }

  /// The colour of a sample at (x, y) of the image plane that sees this point of a primitive.
  Vec3 color(std::uint32_t primitive, double x, double y, const SurfacePoint& point) const
  {
    return this->Edges.mixed(primitive, x, y, this->Light.color(point) * point.texture.color);
  }

  /// Begins a tile. Edges are kept until the next one.
  static void begin(const TileSamples& samples, EdgesInTile& edges)
  {
    const Window& window = samples.window();
    edges.reset(samples.xs()[0], samples.xs()[window.width() - 1], samples.ys()[0],
      samples.ys()[window.height() - 1]);
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
