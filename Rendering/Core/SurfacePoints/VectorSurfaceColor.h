// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief colours of several samples at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorSurfaceColor_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorSurfaceColor_h
#undef lambent_VectorSurfaceColor_h
#else
#define lambent_VectorSurfaceColor_h
#endif

#include "VectorSurfacePoint.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A SurfaceColor in each lane. Without light, only `diffuse` is used.
struct VectorSurfaceColor
{
  Vector3 diffuse, ambient;
};

/// The colours of the samples from a place on, in a range whose runs differ in colour.
class VectorColors
{
public:
  VectorColors(const RunRange& range, const SampleBatch& batch)
    : Source(range.colorSource)
    , Batch(batch)
  {
  }

  HWY_INLINE VectorSurfaceColor at(
    const Runs& runs, const VectorSurfacePoint& point, int place) const
  {
    if (this->Source == ColorSource::Primitive)
    {
      return { runs(this->Batch.diffuse), runs(this->Batch.ambient) };
    }
    const auto* const rows = this->Batch.cornerColors;
    const Vector3 color = this->Source == ColorSource::MappedLast
      ? this->mapped(weighted(runs, rows, 0, point.weights), place)
      : Vector3{ weighted(runs, rows, 0, point.weights), weighted(runs, rows, 1, point.weights),
          weighted(runs, rows, 2, point.weights) };
    return { color * runs(this->Batch.coefficients[0]), color * runs(this->Batch.coefficients[1]) };
  }

private:
  /// The interpolated value of the corners' rows k, 3 + k and 6 + k.
  static HWY_INLINE V weighted(
    const Runs& runs, const double (*rows)[SampleBatch::room], int k, const Vector3& weights)
  {
    return hn::Add(
      hn::Add(hn::Mul(runs(rows[k]), weights.x), hn::Mul(runs(rows[3 + k]), weights.y)),
      hn::Mul(runs(rows[6 + k]), weights.z));
  }

  /// Looks up numbers, each in the table of its run's surface.
  Vector3 mapped(V numbers, int place) const
  {
    HWY_ALIGN double number[lanesAtMost];
    HWY_ALIGN double channels[3][lanesAtMost] = {};
    hn::Store(numbers, d, number);
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      const std::int64_t run = this->Batch.run[place + static_cast<int>(lane)];
      if (this->Batch.isWanted[run] > 0.0)
      {
        const Vec3 color = this->Batch.parts[run]->surface->colors->table->color(number[lane]);
        channels[0][lane] = color.x;
        channels[1][lane] = color.y;
        channels[2][lane] = color.z;
      }
    }
    return { hn::Load(d, channels[0]), hn::Load(d, channels[1]), hn::Load(d, channels[2]) };
  }

  const ColorSource Source;
  const SampleBatch& Batch;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
