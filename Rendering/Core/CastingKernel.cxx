// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CastingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorFrame.h"

#include "CastingKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A triangle's sheared vertices along one axis.
struct Sheared
{
  V a, b, c;
};

Sheared shear(V a, V b, V c, V aw, V bw, V cw, V at)
{
  return { hn::Sub(a, hn::Mul(at, aw)), hn::Sub(b, hn::Mul(at, bw)), hn::Sub(c, hn::Mul(at, cw)) };
}

struct VectorHit
{
  M mask;
  V sum, depth;
};

/// The part of intersect() that comes after the box test.
VectorHit edges(const Sheared& x, const Sheared& y, V az, V bz, V cz)
{
  const V zero = hn::Zero(d);
  const V e0 = hn::Sub(hn::Mul(x.b, y.c), hn::Mul(y.b, x.c));
  const V e1 = hn::Sub(hn::Mul(x.c, y.a), hn::Mul(y.c, x.a));
  const V e2 = hn::Sub(hn::Mul(x.a, y.b), hn::Mul(y.a, x.b));
  // What is not a number may pass here; the depth is not a number either then.
  const M front = hn::Ge(hn::Min(hn::Min(e0, e1), e2), zero);
  const M back = hn::Le(hn::Max(hn::Max(e0, e1), e2), zero);
  VectorHit hit;
  hit.mask = hn::Or(front, back);
  hit.sum = hn::Add(hn::Add(e0, e1), e2);
  if (hn::AllFalse(d, hit.mask))
  {
    hit.depth = zero;
    return hit;
  }
  const V weighted = hn::Add(hn::Add(hn::Mul(e0, az), hn::Mul(e1, bz)), hn::Mul(e2, cz));
  hit.depth = hn::Div(weighted, hit.sum);
  hit.mask = hn::And(hit.mask,
    hn::And(hn::Gt(hit.depth, zero),
      hn::Lt(hit.depth, hn::Set(d, std::numeric_limits<double>::infinity()))));
  return hit;
}

M spansZero(const Sheared& s)
{
  const V zero = hn::Zero(d);
  const M below = hn::Or(hn::Or(hn::Le(s.a, zero), hn::Le(s.b, zero)), hn::Le(s.c, zero));
  const M above = hn::Or(hn::Or(hn::Ge(s.a, zero), hn::Ge(s.b, zero)), hn::Ge(s.c, zero));
  return hn::And(below, above);
}

/// The corners of the triangles [k, k + lanes) of a batch, in the camera's frame.
struct Corners
{
  FrameVector a, b, c;
};

Corners corners(const VectorFrame& frame, const CastBatch& batch, std::size_t k)
{
  const auto corner = [&](int first)
  {
    return frame.toFrame(hn::Load(d, batch.points[first] + k),
      hn::Load(d, batch.points[first + 1] + k), hn::Load(d, batch.points[first + 2] + k));
  };
  return { corner(0), corner(3), corner(6) };
}

/// One triangle, in the camera's frame, against the rays of a box.
struct Large
{
  FramePoint a, b, c;
  std::int64_t number;
  Window box;
  bool isBoxExact, cullFront, cullBack;
};

void castColumns(const Large& t, int column, const double* rows[3], CellRays& rays)
{
  const hn::RebindToSigned<D> di;
  using Vi = hn::Vec<decltype(di)>;
  const V zero = hn::Zero(d);
  const V i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(column)));
  const V aw = hn::Set(d, t.a.w), bw = hn::Set(d, t.b.w), cw = hn::Set(d, t.c.w);
  const Sheared x = shear(hn::Set(d, t.a.x), hn::Set(d, t.b.x), hn::Set(d, t.c.x), aw, bw, cw,
    hn::LoadU(d, rays.xs() + column));
  M inside = hn::And(hn::Ge(i, hn::Set(d, static_cast<double>(t.box.i0))),
    hn::Lt(i, hn::Set(d, static_cast<double>(t.box.i1))));
  if (!t.isBoxExact)
  {
    inside = hn::And(inside, spansZero(x));
  }
  const V az = hn::Set(d, t.a.z), bz = hn::Set(d, t.b.z), cz = hn::Set(d, t.c.z);
  const Vi number = hn::Set(di, t.number);
  for (int j = t.box.j0; j < t.box.j1; ++j)
  {
    const Sheared y{ hn::Set(d, rows[0][j]), hn::Set(d, rows[1][j]), hn::Set(d, rows[2][j]) };
    const VectorHit hit = edges(x, y, az, bz, cz);
    M mask = hn::And(hit.mask, inside);
    if (hn::AllFalse(d, mask))
    {
      continue;
    }
    if (!t.isBoxExact)
    {
      mask = hn::And(mask, spansZero(y));
    }
    if (t.cullFront)
    {
      mask = hn::And(mask, hn::Le(hit.sum, zero));
    }
    if (t.cullBack)
    {
      mask = hn::And(mask, hn::Ge(hit.sum, zero));
    }
    const std::size_t index = static_cast<std::size_t>(j) * rays.stride() + column;
    const V nearest = hn::LoadU(d, rays.depths() + index);
    const Vi owner = hn::LoadU(di, rays.triangles() + index);
    const M smaller = hn::RebindMask(d, hn::Lt(number, owner));
    mask = hn::And(
      mask, hn::Or(hn::Lt(hit.depth, nearest), hn::And(hn::Eq(hit.depth, nearest), smaller)));
    hn::StoreU(hn::IfThenElse(mask, hit.depth, nearest), d, rays.depths() + index);
    hn::StoreU(
      hn::IfThenElse(hn::RebindMask(di, mask), number, owner), di, rays.triangles() + index);
  }
}

void castOne(const Large& t, std::vector<double>& rowMemory, CellRays& rays)
{
  // The sheared y of the three vertices, by row.
  const std::size_t stride = rays.stride();
  rowMemory.resize(3 * stride);
  double* rows[3] = { rowMemory.data(), rowMemory.data() + stride, rowMemory.data() + 2 * stride };
  const V aw = hn::Set(d, t.a.w), bw = hn::Set(d, t.b.w), cw = hn::Set(d, t.c.w);
  const auto lane = static_cast<int>(lanes);
  for (int j = t.box.j0 / lane * lane; j < t.box.j1; j += lane)
  {
    const Sheared y = shear(hn::Set(d, t.a.y), hn::Set(d, t.b.y), hn::Set(d, t.c.y), aw, bw, cw,
      hn::LoadU(d, rays.ys() + j));
    hn::StoreU(y.a, d, rows[0] + j);
    hn::StoreU(y.b, d, rows[1] + j);
    hn::StoreU(y.c, d, rows[2] + j);
  }
  const double* constRows[3] = { rows[0], rows[1], rows[2] };
  for (int column = t.box.i0 / lane * lane; column < t.box.i1; column += lane)
  {
    castColumns(t, column, constRows, rays);
  }
}

void CastBatchOfTriangles(const CameraFrame& frame, const CastBatch& batch, CellRays& rays)
{
  const VectorFrame vectorFrame(frame);
  thread_local std::vector<double> rowMemory;
  HWY_ALIGN double coordinates[12][lanesAtMost];
  for (std::size_t k = 0; k < static_cast<std::size_t>(batch.count); k += lanes)
  {
    const Corners t = corners(vectorFrame, batch, k);
    int row = 0;
    for (const FrameVector& p : { t.a, t.b, t.c })
    {
      hn::Store(p.x, d, coordinates[row++]);
      hn::Store(p.y, d, coordinates[row++]);
      hn::Store(p.z, d, coordinates[row++]);
      hn::Store(p.w, d, coordinates[row++]);
    }
    for (std::size_t lane = 0; lane < std::min<std::size_t>(lanes, batch.count - k); ++lane)
    {
      const auto point = [&](int first)
      {
        return FramePoint{ coordinates[first][lane], coordinates[first + 1][lane],
          coordinates[first + 2][lane], coordinates[first + 3][lane] };
      };
      castOne({ point(0), point(4), point(8), batch.triangles[k + lane], batch.boxes[k + lane],
                batch.isBoxExact[k + lane], batch.cullFront[k + lane], batch.cullBack[k + lane] },
        rowMemory, rays);
    }
  }
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(CastBatchOfTriangles);

void castBatch(const CameraFrame& frame, const CastBatch& batch, CellRays& rays)
{
  HWY_DYNAMIC_DISPATCH(CastBatchOfTriangles)(frame, batch, rays);
}
}
#endif
