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

#include "CastingSetup.h"
#include "TileSamples.h"
#include "TriangleBatch.h"
#include "VectorHits.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A triangle in the camera's frame, and the box of samples to test.
struct BoxTriangle
{
  FramePoint a, b, c;
  std::uint32_t number;
  Window box;
  bool cullFront, cullBack;

  BoxTriangle(const Triangles& all, int lane, const TriangleBatch& batch, int k)
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

/// FrameTriangle::isHit() for the rays through (x, row) of the image plane, one per lane.
M intersectRays(const BoxTriangle& t, V x, double row, V& depth)
{
  const auto broadcast = [](const FramePoint& p) {
    return FrameVector{ hn::Set(d, p.x), hn::Set(d, p.y), hn::Set(d, p.z), hn::Set(d, p.w) };
  };
  const FrameVector a = broadcast(t.a), b = broadcast(t.b), c = broadcast(t.c);
  const ShearedTriangle sheared(a, b, c, x, hn::Set(d, row));
  const VectorHit result(sheared, a.z, b.z, c.z);
  depth = result.depth;
  M hit = hn::And(result.isHit(), sheared.spansRay());
  if (t.cullFront)
  {
    hit = hn::And(hit, hn::Le(result.sum, hn::Zero(d)));
  }
  if (t.cullBack)
  {
    hit = hn::And(hit, hn::Ge(result.sum, hn::Zero(d)));
  }
  return hit;
}

/// Appends the hits of the samples of a row, from sample i on, whose bits are set.
void exactRow(const BoxTriangle& t, int row, int i, const std::uint8_t bits[8],
  const TileSamples& samples, std::vector<ExactHit>& hits)
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
    const M hit = intersectRays(t, hn::LoadU(d, samples.xs() + i + from), samples.ys()[row], depth);
    std::uint8_t hitBits[8] = {};
    hn::StoreMaskBits(d, hit, hitBits);
    hn::Store(depth, d, depths);
    for (int lane = 0; lane < static_cast<int>(lanes); ++lane)
    {
      if ((hitBits[0] & wanted) >> lane & 1)
      {
        const int sample = row * samples.stride() + i + from + lane;
        hits.push_back({ static_cast<std::uint32_t>(sample), t.number, depths[lane] });
      }
    }
  }
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
