// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "SphereCastingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorLayers.h"
#include "VectorNearest.h"
#include "VectorSpheres.h"

#include "SphereCastingKernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// As many floats as a vector has doubles.
using HalfF = hn::Rebind<float, D>;
constexpr HalfF halfF;

/// Centres in the camera's frame.
struct Centers
{
  double x[SphereBatch::room], y[SphereBatch::room], z[SphereBatch::room];

  Centers(const CameraFrame& camera, const SphereBatch& batch)
  {
    const VectorFrame frame(camera);
    for (int k = 0; k < batch.count; k += static_cast<int>(lanes))
    {
      const FrameVector c = frame.toFrame(hn::LoadU(d, batch.centers[0] + k),
        hn::LoadU(d, batch.centers[1] + k), hn::LoadU(d, batch.centers[2] + k));
      hn::StoreU(c.x, d, this->x + k);
      hn::StoreU(c.y, d, this->y + k);
      hn::StoreU(c.z, d, this->z + k);
    }
  }
};

M maskOf(bool value)
{
  return hn::Gt(hn::Set(d, value ? 1.0 : 0.0), hn::Zero(d));
}

/// Appends the hits in the lanes of a mask.
void append(
  M lanesOf, V depth, std::size_t sample, std::uint32_t sphere, std::vector<ExactHit>& hits)
{
  HWY_ALIGN double depths[lanesAtMost];
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, lanesOf, bits);
  hn::Store(depth, d, depths);
  for (std::size_t lane = 0; lane < lanes; ++lane)
  {
    if (bits[0] >> lane & 1)
    {
      hits.push_back({ static_cast<std::uint32_t>(sample + lane), sphere, depths[lane] });
    }
  }
}

/// Keeps hits of the samples from `sample` on.
template <bool IsParallel, typename VectorPolicy>
HWY_INLINE void keep(const VectorPolicy& policy, M hit, V depth, std::size_t sample,
  std::uint32_t sphere, std::vector<ExactHit>& hits)
{
  const M isRanged = hn::And(hit,
    hn::And(hn::Gt(depth, hn::Set(d, smallestRangedDepth)),
      hn::Lt(depth, hn::Set(d, largestRangedDepth))));
  // Negative where there is no hit, or one without a range.
  const V value = hn::IfThenElse(
    isRanged, IsParallel ? depth : hn::Div(hn::Set(d, 1.0), depth), hn::Set(d, -1.0));
  const auto nearness = hn::DemoteTo(halfF, value);
  const auto less = hn::Mul(nearness, hn::Set(halfF, 1.0f - nearnessSlack));
  const auto more = hn::Mul(nearness, hn::Set(halfF, 1.0f + nearnessSlack));
  const auto open = policy.keep(halfF, sample, hn::Gt(nearness, hn::Zero(halfF)),
    IsParallel ? hn::Neg(more) : less, IsParallel ? hn::Neg(less) : more, sphere);
  const M isUnranged = hn::AndNot(isRanged, hit);
  if (!hn::AllFalse(halfF, open) || !hn::AllFalse(d, isUnranged))
  {
    const V isOpen = hn::PromoteTo(d, hn::IfThenElseZero(open, hn::Set(halfF, 1.0f)));
    append(hn::Or(isUnranged, hn::Gt(isOpen, hn::Zero(d))), depth, sample, sphere, hits);
  }
}

template <bool IsParallel, typename VectorPolicy>
void castSphere(const VectorSphere& sphere, std::uint32_t number, const Window& box,
  const TileSamples& samples, const VectorPolicy& policy, std::vector<ExactHit>& hits)
{
  for (int i = box.i0; i < box.i1; i += static_cast<int>(lanes))
  {
    const V x = hn::LoadU(d, samples.xs() + i);
    const M inside =
      hn::Lt(hn::Iota(d, static_cast<double>(i)), hn::Set(d, static_cast<double>(box.i1)));
    for (int row = box.j0; row < box.j1; ++row)
    {
      const VectorApproach<IsParallel> ray(sphere, x, hn::Set(d, samples.ys()[row]));
      const M crossing = hn::And(inside, ray.isCrossing());
      if (hn::AllFalse(d, crossing))
      {
        continue;
      }
      const VectorSphereHit found(sphere, ray);
      keep<IsParallel>(policy, hn::And(crossing, found.isHit), found.depth,
        static_cast<std::size_t>(row) * samples.stride() + i, number, hits);
    }
  }
}

template <bool IsParallel, typename VectorPolicy>
float castSpheres(const CameraFrame& frame, const TileSamples& samples, const VectorPolicy& policy,
  SphereBatch& batch)
{
  const Window& window = samples.window();
  const float leastBefore = policy.least(samples);
  float least = leastBefore;
  const Centers centers(frame, batch);
  for (int k = 0; k < batch.count; ++k)
  {
    if (batch.nearest[k] < least)
    {
      continue;
    }
    const Window& box = batch.boxes[k];
    const VectorSphere sphere{ hn::Set(d, centers.x[k]), hn::Set(d, centers.y[k]),
      hn::Set(d, centers.z[k]), hn::Set(d, batch.radii[k]), maskOf(batch.hasOutside[k]),
      maskOf(batch.hasInside[k]) };
    castSphere<IsParallel>(sphere, batch.spheres[k], box, samples, policy, batch.hits);
    if (2 * box.width() * box.height() > window.width() * window.height())
    {
      least = policy.least(samples); // the sphere may have covered the tile
    }
  }
  return leastBefore;
}

template <typename VectorPolicy>
float castSpheres(const CameraFrame& frame, const TileSamples& samples, const VectorPolicy& policy,
  SphereBatch& batch)
{
  return frame.parallel ? castSpheres<true>(frame, samples, policy, batch)
                        : castSpheres<false>(frame, samples, policy, batch);
}

float CastNearest(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, SphereBatch& batch)
{
  return castSpheres(frame, samples, VectorNearest(nearest), batch);
}

float CastLayers(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, SphereBatch& batch)
{
  return castSpheres(frame, samples, VectorLayers(layers, samples), batch);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(CastNearest);
HWY_EXPORT(CastLayers);

float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, SphereBatch& batch)
{
  return HWY_DYNAMIC_DISPATCH(CastNearest)(frame, samples, nearest, batch);
}

float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, SphereBatch& batch)
{
  return HWY_DYNAMIC_DISPATCH(CastLayers)(frame, samples, layers, batch);
}
}
#endif
