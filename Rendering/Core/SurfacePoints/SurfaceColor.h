// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colour of a surface at a point: where it comes from is known here and nowhere else
 *
 * The colour of a surface is that of its appearance, or comes from data at its points or cells
 * (ColorArray.h). Colours of points are interpolated with barycentric coordinates, as all data of
 * points is. The specular colour is always that of the appearance. The functions for single points
 * are the definition; loadColors() and VectorSurfaceColor.h give a batch the same colours.
 */
#ifndef lambent_SurfaceColor_h
#define lambent_SurfaceColor_h

#include "SceneMesh.h"

namespace lambent
{
struct PointBatch;
struct RunRange;
struct SampleBatch;

/// What the light model knows of a surface's colour.
struct SurfaceColor
{
  bool isUnlit;
  Vec3 diffuse; ///< rho_d; the plain colour if unlit
  Vec3 ambient; ///< rho_a; not used if unlit
  double opacity = 1.0;
  /// The specular reflection of the appearance, or nullptr if there is none.
  const SpecularStyle* specular = nullptr;
};

/// The colour that an appearance has on its own, and with a colour that replaces those it has, and
/// whose alpha multiplies the opacity.
SurfaceColor colorOf(const Appearance& appearance);
SurfaceColor colorOf(const Appearance& appearance, const Vec3& color, double alpha = 1.0);

/// The colour at a primitive that has one colour, counted in its surface.
SurfaceColor colorOf(const Surface& surface, std::size_t primitive);

/// Fills in SampleBatch::diffuse and ambient of the runs of a range that hit something, if its
/// ColorSource is Primitive.
void loadColors(const RunRange& range, SampleBatch& batch);

/// The opacity of a sample that hits something, from 0 to 1: SurfaceColor::opacity, clamped. The
/// parts of the batch's runs must be filled in, and, where colours of points have alpha, the
/// weights of its surface points.
double opacityAt(const SampleBatch& batch, const PointBatch& points, int place);

/// Whether opacityAt() is the same all over each primitive of a part.
bool hasConstantOpacity(const SceneMesh::Part& part);

/// An opacity, clamped to 0 to 1. NaN gives 0.
inline double clampedOpacity(double opacity)
{
  return opacity > 0.0 ? (opacity < 1.0 ? opacity : 1.0) : 0.0;
}
}

#endif
