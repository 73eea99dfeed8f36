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

/// Which samples the lanes are: neighbours in a row, or, with two rows, in each half of the lanes.
struct LaneSamples
{
  std::size_t first;  ///< the sample of the first lane
  std::size_t second; ///< with two rows: that of the first lane of the second half

  template <bool HasTwoRows>
  std::size_t at(std::size_t lane) const
  {
    constexpr std::size_t half = lanes / 2;
    return HasTwoRows && lane >= half ? this->second + (lane - half) : this->first + lane;
  }
};

/// Appends the hits in the lanes of a mask.
template <bool HasTwoRows>
void append(
  M lanesOf, V depth, const LaneSamples& samples, std::uint32_t sphere, std::vector<ExactHit>& hits)
{
  HWY_ALIGN double depths[lanesAtMost];
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, lanesOf, bits);
  hn::Store(depth, d, depths);
  for (std::size_t lane = 0; lane < lanes; ++lane)
  {
    if (bits[0] >> lane & 1)
    {
      hits.push_back(
        { static_cast<std::uint32_t>(samples.at<HasTwoRows>(lane)), sphere, depths[lane] });
    }
  }
}

/// Offers ranges of nearness to the policy; a range whose `nearness` is negative is none. Returns 1
/// in the lanes that are undecided, 0 elsewhere.
template <typename Tag, typename VectorPolicy>
HWY_INLINE hn::Vec<Tag> offer(Tag tag, const VectorPolicy& policy, std::size_t sample,
  hn::Vec<Tag> nearness, hn::Vec<Tag> from, hn::Vec<Tag> to, std::uint32_t sphere)
{
  const auto isHit = hn::Gt(nearness, hn::Zero(tag));
  return hn::IfThenElseZero(policy.keep(tag, sample, isHit, from, to, sphere), hn::Set(tag, 1.0f));
}

#if HWY_TARGET != HWY_SCALAR
/// The same for two rows.
template <typename VectorPolicy>
HWY_INLINE hn::Vec<HalfF> offerTwoRows(const VectorPolicy& policy, const LaneSamples& samples,
  hn::Vec<HalfF> nearness, hn::Vec<HalfF> from, hn::Vec<HalfF> to, std::uint32_t sphere)
{
  constexpr hn::Half<HalfF> row;
  const auto first = offer(row, policy, samples.first, hn::LowerHalf(row, nearness),
    hn::LowerHalf(row, from), hn::LowerHalf(row, to), sphere);
  const auto second = offer(row, policy, samples.second, hn::UpperHalf(row, nearness),
    hn::UpperHalf(row, from), hn::UpperHalf(row, to), sphere);
  return hn::Combine(halfF, second, first);
}
#endif

/// Keeps hits.
template <bool IsParallel, bool HasTwoRows, typename VectorPolicy>
HWY_INLINE void keep(const VectorPolicy& policy, M hit, V depth, const LaneSamples& samples,
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
  const auto from = IsParallel ? hn::Neg(more) : less, to = IsParallel ? hn::Neg(less) : more;
  auto open = hn::Zero(halfF);
#if HWY_TARGET != HWY_SCALAR
  if constexpr (HasTwoRows)
  {
    open = offerTwoRows(policy, samples, nearness, from, to, sphere);
  }
#endif
  if constexpr (!HasTwoRows)
  {
    open = offer(halfF, policy, samples.first, nearness, from, to, sphere);
  }
  const V isOpen = hn::PromoteTo(d, open);
  const M left = hn::Or(hn::AndNot(isRanged, hit), hn::Gt(isOpen, hn::Zero(d)));
  if (!hn::AllFalse(d, left))
  {
    append<HasTwoRows>(left, depth, samples, sphere, hits);
  }
}

/// Casts the rays through (x, y) where `inside` is true.
template <bool IsParallel, bool HasTwoRows, typename VectorPolicy>
HWY_INLINE void castRays(const VectorSphere& sphere, std::uint32_t number, V x, V y, M inside,
  const LaneSamples& samples, const VectorPolicy& policy, std::vector<ExactHit>& hits)
{
  const VectorApproach<IsParallel> ray(sphere, x, y);
  const M crossing = hn::And(inside, ray.isCrossing());
  if (!hn::AllFalse(d, crossing))
  {
    const VectorSphereHit found(sphere, ray);
    keep<IsParallel, HasTwoRows>(
      policy, hn::And(crossing, found.isHit), found.depth, samples, number, hits);
  }
}

#if HWY_TARGET != HWY_SCALAR
/// Casts a narrow box, two rows at a time.
template <bool IsParallel, typename VectorPolicy>
void castTwoRows(const VectorSphere& sphere, std::uint32_t number, const Window& box,
  const TileSamples& samples, const VectorPolicy& policy, std::vector<ExactHit>& hits)
{
  constexpr std::size_t half = lanes / 2;
  const auto twice = [](V v) { return hn::ConcatLowerLower(d, v, v); };
  const V x = twice(hn::LoadU(d, samples.xs() + box.i0));
  const M inside = hn::Lt(twice(hn::Iota(d, 0.0)), hn::Set(d, static_cast<double>(box.width())));
  const M insideOne = hn::And(inside, hn::FirstN(d, half));
  for (int row = box.j0; row < box.j1; row += 2)
  {
    const bool isLast = row + 1 == box.j1;
    const V y = hn::ConcatLowerLower(
      d, hn::Set(d, samples.ys()[isLast ? row : row + 1]), hn::Set(d, samples.ys()[row]));
    const std::size_t first = static_cast<std::size_t>(row) * samples.stride() + box.i0;
    // A row that does not exist has no hits, so it may be any.
    const LaneSamples places{ first, isLast ? first : first + samples.stride() };
    castRays<IsParallel, true>(
      sphere, number, x, y, isLast ? insideOne : inside, places, policy, hits);
  }
}
#endif

template <bool IsParallel, typename VectorPolicy>
void castSphere(const VectorSphere& sphere, std::uint32_t number, const Window& box,
  const TileSamples& samples, const VectorPolicy& policy, std::vector<ExactHit>& hits)
{
#if HWY_TARGET != HWY_SCALAR
  if (lanes >= 4 && box.width() <= static_cast<int>(lanes / 2))
  {
    castTwoRows<IsParallel>(sphere, number, box, samples, policy, hits);
    return;
  }
#endif
  for (int i = box.i0; i < box.i1; i += static_cast<int>(lanes))
  {
    const V x = hn::LoadU(d, samples.xs() + i);
    const M inside =
      hn::Lt(hn::Iota(d, static_cast<double>(i)), hn::Set(d, static_cast<double>(box.i1)));
    for (int row = box.j0; row < box.j1; ++row)
    {
      const std::size_t first = static_cast<std::size_t>(row) * samples.stride() + i;
      castRays<IsParallel, false>(
        sphere, number, x, hn::Set(d, samples.ys()[row]), inside, { first, first }, policy, hits);
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
