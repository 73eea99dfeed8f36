// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief intersect() for several rays of a row at a time
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_ExactRow_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_ExactRow_h
#undef lambent_ExactRow_h
#else
#define lambent_ExactRow_h
#endif

#include "CastBatch.h"
#include "CastingSetup.h"
#include "CellRays.h"
#include "VectorDoubles.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A triangle in the camera's frame, against the rays of a box.
struct BoxTriangle
{
  FramePoint a, b, c;
  std::uint32_t number;
  Window box;
  bool cullFront, cullBack;

  BoxTriangle(const Triangles& all, int lane, const CastBatch& batch, int k)
    : a(corner(all, 0, lane))
    , b(corner(all, 4, lane))
    , c(corner(all, 8, lane))
    , number(batch.triangles[k])
    , box(batch.boxes[k])
    , cullFront(batch.cullFront[k])
    , cullBack(batch.cullBack[k])
  {
  }

private:
  static FramePoint corner(const Triangles& all, int first, int lane)
  {
    return { all.corners[first][lane], all.corners[first + 1][lane], all.corners[first + 2][lane],
      all.corners[first + 3][lane] };
  }
};

M spansZero(V a, V b, V c)
{
  const V zero = hn::Zero(d);
  const M below = hn::Or(hn::Or(hn::Le(a, zero), hn::Le(b, zero)), hn::Le(c, zero));
  const M above = hn::Or(hn::Or(hn::Ge(a, zero), hn::Ge(b, zero)), hn::Ge(c, zero));
  return hn::And(below, above);
}

/// intersect() for the rays through (x, y), as many as there are lanes.
M intersectRays(const BoxTriangle& t, V x, double row, V& depth)
{
  const V y = hn::Set(d, row), zero = hn::Zero(d);
  const auto sheared = [](double v, V at, double w)
  { return hn::Sub(hn::Set(d, v), hn::Mul(at, hn::Set(d, w))); };
  const V ax = sheared(t.a.x, x, t.a.w), ay = sheared(t.a.y, y, t.a.w);
  const V bx = sheared(t.b.x, x, t.b.w), by = sheared(t.b.y, y, t.b.w);
  const V cx = sheared(t.c.x, x, t.c.w), cy = sheared(t.c.y, y, t.c.w);
  const V e0 = hn::Sub(hn::Mul(bx, cy), hn::Mul(by, cx));
  const V e1 = hn::Sub(hn::Mul(cx, ay), hn::Mul(cy, ax));
  const V e2 = hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
  // What is not a number may pass here; the depth is not a number either then.
  const M front = hn::Ge(hn::Min(hn::Min(e0, e1), e2), zero);
  const M back = hn::Le(hn::Max(hn::Max(e0, e1), e2), zero);
  const V total = hn::Add(hn::Add(e0, e1), e2);
  depth = hn::Div(hn::Add(hn::Add(hn::Mul(e0, hn::Set(d, t.a.z)), hn::Mul(e1, hn::Set(d, t.b.z))),
                    hn::Mul(e2, hn::Set(d, t.c.z))),
    total);
  M hit = hn::And(hn::Or(front, back),
    hn::And(
      hn::Gt(depth, zero), hn::Lt(depth, hn::Set(d, std::numeric_limits<double>::infinity()))));
  hit = hn::And(hit, hn::And(spansZero(ax, bx, cx), spansZero(ay, by, cy)));
  if (t.cullFront)
  {
    hit = hn::And(hit, hn::Le(total, zero));
  }
  if (t.cullBack)
  {
    hit = hn::And(hit, hn::Ge(total, zero));
  }
  return hit;
}

/// Append the hits of the rays of a row from ray i on for which bits are set.
void exactRow(const BoxTriangle& t, int row, int i, const std::uint8_t bits[8],
  const CellRays& rays, std::vector<ExactHit>& hits)
{
  HWY_ALIGN double depths[lanesAtMost];
  for (int from = 0; from < 16; from += static_cast<int>(lanes))
  {
    const unsigned wanted = (bits[from / 8] >> from % 8) & ((1u << static_cast<int>(lanes)) - 1u);
    if (wanted == 0)
    {
      continue;
    }
    V depth;
    const M hit = intersectRays(t, hn::LoadU(d, rays.xs() + i + from), rays.ys()[row], depth);
    std::uint8_t hitBits[8] = {};
    hn::StoreMaskBits(d, hit, hitBits);
    hn::Store(depth, d, depths);
    for (int lane = 0; lane < static_cast<int>(lanes); ++lane)
    {
      if ((hitBits[0] & wanted) >> lane & 1)
      {
        const int ray = row * rays.stride() + i + from + lane;
        hits.push_back({ static_cast<std::uint32_t>(ray), t.number, depths[lane] });
      }
    }
  }
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
