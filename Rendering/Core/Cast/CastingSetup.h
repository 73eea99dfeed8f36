// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief computes the numbers that CastingKernel.h evaluates, for several triangles at a time
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_CastingSetup_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_CastingSetup_h
#undef lambent_CastingSetup_h
#else
#define lambent_CastingSetup_h
#endif

#include "EdgeFunctions.h"
#include "Nearness.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// The numbers of several triangles.
struct Triangles
{
  /// The corners in the camera's frame: ax, ay, az, aw, bx, ...
  double corners[12][lanesAtMost];
  AffineFloats edges[3]; ///< divided by their sizes
  float error[lanesAtMost];
  /// The range of nearness at a sample: nearness - spread to nearness + spread, clipped to the
  /// range from farthest to nearest.
  AffineFloats nearness;
  float spread[lanesAtMost], farthest[lanesAtMost], nearest[lanesAtMost];
  float nearestInBox[lanesAtMost];
  std::uint8_t missed[8], regular[8]; ///< one bit per triangle

  bool isMissed(int lane) const { return this->missed[0] >> lane & 1; }
  /// Whether float suffices for the triangle.
  bool isRegular(int lane) const { return this->regular[0] >> lane & 1; }
};

/// The edge functions of several triangles, and all that is computed from them.
class Setup
{
public:
  Setup(const CameraFrame& frame, const TilePlane& tile, const FrameVector corners[3])
    : Tile(tile)
    , IsParallel(frame.parallel)
    , Depths{ corners[0].z, corners[1].z, corners[2].z }
    , Nearest(smallest(corners[0].z, corners[1].z, corners[2].z))
    , Farthest(largest(corners[0].z, corners[1].z, corners[2].z))
  {
    const auto isZeroOrOrdinary = [](V coordinate)
    {
      return hn::Or(hn::Eq(coordinate, hn::Zero(d)),
        hn::Gt(hn::Abs(coordinate), hn::Set(d, smallestCoordinate)));
    };
    this->AreOrdinary = hn::Gt(hn::Set(d, tile.pixel), hn::Set(d, smallestPixel));
    for (int k = 0; k < 3; ++k)
    {
      this->AreOrdinary = hn::And(
        this->AreOrdinary, hn::And(isZeroOrOrdinary(corners[k].x), isZeroOrOrdinary(corners[k].y)));
      this->Edges[k] =
        edgeFunction(corners[(k + 1) % 3], corners[(k + 2) % 3], tile, this->Errors[k]);
      this->Sizes[k] = this->Edges[k].size(tile);
    }
  }

  /// The triangles that no ray of their box can hit: over the whole box, one edge function
  /// certainly has another sign than the sum of the three.
  M missed(const Boxes& boxes) const
  {
    const V one = hn::Set(d, 1.0);
    const V weights[3] = { one, one, one };
    const Extremes all = boxes.of(weightedSum(this->Edges, weights));
    const V error = scaled(sum(this->Errors[0], this->Errors[1], this->Errors[2]), 2.0);
    const M front = hn::Gt(all.low, error), back = hn::Lt(all.high, hn::Neg(error));
    M missed = hn::Lt(one, one);
    for (int k = 0; k < 3; ++k)
    {
      const Extremes edge = boxes.of(this->Edges[k]);
      missed = hn::Or(missed,
        hn::Or(hn::And(front, hn::Lt(edge.high, hn::Neg(this->Errors[k]))),
          hn::And(back, hn::Gt(edge.low, this->Errors[k]))));
    }
    return missed;
  }

  /// Stores the edge functions. Returns the triangles for which float suffices.
  M storeEdges(Triangles& out) const
  {
    M regular = hn::And(this->AreOrdinary,
      hn::And(hn::Gt(this->Nearest, hn::Set(d, smallestRangedDepth)),
        isBelow(this->Farthest, largestRangedDepth)));
    V error = hn::Zero(d);
    for (int k = 0; k < 3; ++k)
    {
      const V scale = hn::Div(hn::Set(d, 1.0), this->Sizes[k]);
      const V relative = hn::Mul(this->Errors[k], scale);
      regular = hn::And(regular, isBelow(relative, 0.25));
      regular = hn::And(regular, // no depth overflows or underflows
        hn::And(hn::Gt(this->Sizes[k], hn::Set(d, 1e-200)), isBelow(this->Sizes[k], 1e200)));
      error = hn::Max(error, relative);
      this->Edges[k].times(scale).store(out.edges[k]);
    }
    const hn::Rebind<float, D> df;
    hn::StoreU(hn::DemoteTo(df, hn::Add(scaled(error, 1.001), hn::Set(d, std::ldexp(1.0, -20)))),
      df, out.error);
    return regular;
  }

  void storeNearness(const Boxes& boxes, Triangles& out) const
  {
    const V one = hn::Set(d, 1.0);
    V num[3], den[3];
    V numError = hn::Zero(d), denError = hn::Zero(d);
    for (int k = 0; k < 3; ++k)
    {
      num[k] = this->IsParallel ? hn::Neg(this->Depths[k]) : one;
      den[k] = this->IsParallel ? one : this->Depths[k];
      numError = hn::Add(numError, hn::Mul(this->Errors[k], hn::Abs(num[k])));
      denError = hn::Add(denError, hn::Mul(this->Errors[k], hn::Abs(den[k])));
    }
    const V factor = hn::Div(one,
      sum(hn::Mul(this->Edges[0].constant, den[0]), hn::Mul(this->Edges[1].constant, den[1]),
        hn::Mul(this->Edges[2].constant, den[2])));
    Affine nearness = weightedSum(this->Edges, num).times(factor);
    const V size = nearness.size(this->Tile);
    const V relative = hn::Mul(denError, hn::Abs(factor));
    V spread = sum(scaled(size, std::ldexp(1.0, -20)),
      hn::Add(hn::Mul(numError, hn::Abs(factor)), scaled(hn::Mul(size, relative), 1.01)),
      this->depthError());
    // Otherwise only the depths of the corners bound the range.
    const M isSteady = hn::And(isBelow(relative, 0.005), isBelow(hn::Add(size, spread), 1e30));
    nearness = { hn::IfThenElseZero(isSteady, nearness.constant),
      hn::IfThenElseZero(isSteady, nearness.perColumn),
      hn::IfThenElseZero(isSteady, nearness.perRow) };
    spread = hn::IfThenElse(isSteady, scaled(spread, 1.001), hn::Set(d, 1e35));
    nearness.store(out.nearness);
    this->storeRange(spread, boxes.of(nearness).high, out);
  }

private:
  /// A bound on the error in nearness of the depth that intersect() computes.
  V depthError() const
  {
    const V range = hn::Sub(this->Farthest, this->Nearest);
    const V relative = hn::Div(sum(this->Errors[0], this->Errors[1], this->Errors[2]),
      sum(this->Sizes[0], this->Sizes[1], this->Sizes[2]));
    const V depth = scaled(hn::Mul(relative, range), std::ldexp(1.0, 22));
    return this->IsParallel ? depth
                            : scaled(hn::Div(depth, hn::Mul(this->Nearest, this->Nearest)), 1.01);
  }

  void storeRange(V spread, V nearestInBox, Triangles& out) const
  {
    const hn::Rebind<float, D> df;
    const V one = hn::Set(d, 1.0);
    constexpr double less = 1.0 - nearnessSlack, more = 1.0 + nearnessSlack;
    const V farthest = this->IsParallel ? scaled(hn::Neg(this->Farthest), more)
                                        : scaled(hn::Div(one, this->Farthest), less);
    const V nearest = this->IsParallel ? scaled(hn::Neg(this->Nearest), less)
                                       : scaled(hn::Div(one, this->Nearest), more);
    hn::StoreU(hn::DemoteTo(df, spread), df, out.spread);
    hn::StoreU(hn::DemoteTo(df, farthest), df, out.farthest);
    hn::StoreU(hn::DemoteTo(df, nearest), df, out.nearest);
    hn::StoreU(
      hn::DemoteTo(df, hn::Min(hn::Add(nearestInBox, spread), nearest)), df, out.nearestInBox);
  }

  const TilePlane& Tile;
  bool IsParallel;
  V Depths[3];
  V Nearest, Farthest;
  M AreOrdinary; ///< no product of sheared coordinates underflows
  Affine Edges[3] = {};
  V Errors[3], Sizes[3];
};

/// Sets up the triangles [k, k + lanes) of a batch.
void setUp(const CameraFrame& frame, const TilePlane& tile, const TriangleBatch& batch, int k,
  Triangles& out)
{
  const VectorFrame vectorFrame(frame);
  FrameVector corners[3] = {};
  for (int corner = 0; corner < 3; ++corner)
  {
    corners[corner] = vectorFrame.toFrame(hn::Load(d, batch.points[3 * corner] + k),
      hn::Load(d, batch.points[3 * corner + 1] + k), hn::Load(d, batch.points[3 * corner + 2] + k));
    hn::StoreU(corners[corner].x, d, out.corners[4 * corner]);
    hn::StoreU(corners[corner].y, d, out.corners[4 * corner + 1]);
    hn::StoreU(corners[corner].z, d, out.corners[4 * corner + 2]);
    hn::StoreU(corners[corner].w, d, out.corners[4 * corner + 3]);
  }
  const Boxes boxes(batch, k);
  const Setup numbers(frame, tile, corners);
  hn::StoreMaskBits(d, numbers.missed(boxes), out.missed);
  hn::StoreMaskBits(d, numbers.storeEdges(out), out.regular);
  numbers.storeNearness(boxes, out);
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
