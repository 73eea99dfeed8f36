// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ShadingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorHits.h"
#include "VectorTriples.h"

#include "Elementary.h"
#include "ShadingKernel.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// What belongs to the runs of some rays, from arrays with a value for each run. Runs are
/// numbered in a row, so all that the rays of a vector can need is side by side.
class Runs
{
public:
  explicit Runs(const std::int64_t* run)
    : First(run[0])
    , Places(hn::IndicesFromVec(d, hn::Sub(hn::LoadU(di, run), hn::Set(di, run[0]))))
  {
  }

  V operator()(const double* values) const
  {
    return hn::TableLookupLanes(hn::LoadU(d, values + this->First), this->Places);
  }
  Vector3 operator()(const double (*values)[ShadeBatch::room]) const
  {
    return { (*this)(values[0]), (*this)(values[1]), (*this)(values[2]) };
  }

private:
  static constexpr hn::RebindToSigned<D> di{};
  std::int64_t First;
  decltype(hn::IndicesFromVec(d, hn::Zero(di))) Places;
};

/// Shader::arriving().
V arriving(const LightSource& source, const Vector3& toLight, V distance)
{
  const V one = hn::Set(d, 1.0);
  const V constant = hn::Set(d, source.attenuation.x), linear = hn::Set(d, source.attenuation.y),
          quadratic = hn::Set(d, source.attenuation.z);
  V fraction = hn::Div(one,
    hn::Add(hn::Add(constant, hn::Mul(linear, distance)),
      hn::Mul(hn::Mul(quadratic, distance), distance)));
  if (source.hasCone)
  {
    const V cosine = hn::Div(hn::Neg(dot(toLight, set(source.axis))), distance);
    const M inside = hn::Ge(cosine, hn::Set(d, source.coneCosine));
    HWY_ALIGN double powers[lanesAtMost];
    hn::Store(cosine, d, powers);
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      powers[lane] = power(powers[lane], source.exponent);
    }
    fraction = hn::IfThenElseZero(inside, hn::Mul(fraction, hn::Load(d, powers)));
  }
  return hn::IfThenElse(hn::Gt(distance, hn::Zero(d)), fraction, one);
}

/// Shader::lit().
Vector3 lit(
  const Shader& shader, const Material& material, const Vector3& point, const Vector3& normal)
{
  const V zero = hn::Zero(d);
  const V normalSquare = dot(normal, normal);
  const bool perLight = shader.ambientModel() == AmbientModel::PerLight;
  Vector3 sum = set(perLight ? Vec3(0.0) : material.ambient);
  for (const LightSource& source : shader.sources())
  {
    const Vector3 s = source.positional ? set(source.toLight) - point : set(source.toLight);
    const V square = dot(s, s);
    const V facing = dot(s, normal);
    const M isLit = hn::Gt(facing, zero);
    const V cosine = hn::Div(facing, hn::Sqrt(hn::Mul(square, normalSquare)));
    Vector3 light = set(source.color);
    if (!source.isConstant)
    {
      light = light * arriving(source, s, hn::Sqrt(square));
    }
    const Vector3 diffuse = (set(material.diffuse) * light) * cosine;
    Vector3 reflected{ hn::IfThenElseZero(isLit, diffuse.x), hn::IfThenElseZero(isLit, diffuse.y),
      hn::IfThenElseZero(isLit, diffuse.z) };
    if (perLight)
    {
      reflected = reflected + set(material.ambient) * light;
    }
    sum = sum + reflected;
  }
  return sum;
}

/// toByte().
void storeBytes(V value, std::uint8_t* bytes)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V clamped =
    hn::IfThenElseZero(hn::Gt(value, zero), hn::IfThenElse(hn::Lt(value, one), value, one));
  const auto rounded = hn::DemoteTo(
    hn::Rebind<std::int32_t, D>(), hn::Add(hn::Mul(hn::Set(d, 255.0), clamped), hn::Set(d, 0.5)));
  const hn::Rebind<std::uint8_t, D> d8;
  hn::StoreU(hn::DemoteTo(d8, rounded), d8, bytes);
}

Vector3 load(const double (*rows)[ShadeBatch::room], int k)
{
  return { hn::LoadU(d, rows[0] + k), hn::LoadU(d, rows[1] + k), hn::LoadU(d, rows[2] + k) };
}

/// Turn the normals of the runs whose triangles are reversed (Shader::isReversed()).
void turnReversed(bool smooth, const ShadeRange& range, ShadeBatch& batch)
{
  for (int k = range.firstRun; k < range.endRun; k += static_cast<int>(lanes))
  {
    const Vector3 a = load(batch.points, k);
    const Vector3 area = cross(load(batch.points + 3, k) - a, load(batch.points + 6, k) - a);
    Vector3 given = load(batch.normals, k);
    if (smooth)
    {
      given = (given + load(batch.normals + 3, k)) + load(batch.normals + 6, k);
    }
    const M isReversed = hn::Lt(dot(area, given), hn::Zero(d));
    for (int row = 0; !hn::AllFalse(d, isReversed) && row < (smooth ? 9 : 3); ++row)
    {
      const V value = hn::LoadU(d, batch.normals[row] + k);
      hn::StoreU(hn::IfThenElse(isReversed, hn::Neg(value), value), d, batch.normals[row] + k);
    }
  }
}

/// Bring the corners of the runs into the camera's frame.
void toFrame(const VectorFrame& frame, const ShadeRange& range, ShadeBatch& batch)
{
  for (int k = range.firstRun; k < range.endRun; k += static_cast<int>(lanes))
  {
    for (int corner = 0; corner < 9; corner += 3)
    {
      const FrameVector p = frame.toFrame(hn::LoadU(d, batch.points[corner] + k),
        hn::LoadU(d, batch.points[corner + 1] + k), hn::LoadU(d, batch.points[corner + 2] + k));
      hn::StoreU(p.x, d, batch.points[corner] + k);
      hn::StoreU(p.y, d, batch.points[corner + 1] + k);
      hn::StoreU(p.z, d, batch.points[corner + 2] + k);
    }
  }
}

/// The colours of some rays.
Vector3 color(const Shader& shader, const Material& material, bool smooth, const ShadeBatch& batch,
  const Runs& runs, V x, V y)
{
  const CameraFrame& frame = shader.frame();
  const auto corner = [&](int k)
  {
    const Vector3 p = runs(batch.points + 3 * k);
    return FrameVector{ p.x, p.y, p.z, frame.parallel ? hn::Set(d, 1.0) : p.z };
  };
  const FrameVector a = corner(0), b = corner(1), c = corner(2);
  const VectorHit hit(ShearedTriangle(a, b, c, x, y), a.z, b.z, c.z);

  // Shader::normal().
  Vector3 normal = runs(batch.normals);
  if (smooth)
  {
    normal =
      (normal * hit.e0 + runs(batch.normals + 3) * hit.e1) + runs(batch.normals + 6) * hit.e2;
  }
  if (shader.isTwoSided() != smooth)
  {
    const M back = hn::Lt(hit.sum, hn::Zero(d));
    normal = negatedWhere(back, normal);
  }

  const Vector3 across = set(frame.right) * x + set(frame.up) * y;
  const Vector3 forward = set(frame.forward);
  const Vector3 point =
    frame.parallel ? across + forward * hit.depth : (across + forward) * hit.depth;
  return lit(shader, material, point, normal);
}

void ShadeHits(const Shader& shader, const Material& material, bool smooth, const ShadeRange& range,
  ShadeBatch& batch)
{
  constexpr auto step = static_cast<int>(lanes);
  if (shader.isTwoSided())
  {
    turnReversed(smooth, range, batch);
  }
  toFrame(VectorFrame(shader.frame()), range, batch);
  for (int place = range.first / step * step; place < range.end; place += step)
  {
    const RayPiece& piece = batch.pieces[place / ShadeBatch::pieceSize];
    const int i = place % ShadeBatch::pieceSize;
    const Runs runs(batch.run + place);
    const M isWanted = hn::Gt(runs(batch.isWanted), hn::Zero(d));
    if (i >= piece.width || hn::AllFalse(d, isWanted))
    {
      continue;
    }
    const Vector3 result =
      color(shader, material, smooth, batch, runs, hn::LoadU(d, piece.xs + i), hn::Set(d, piece.y));
    hn::BlendedStore(result.x, isWanted, d, batch.colors[0] + place);
    hn::BlendedStore(result.y, isWanted, d, batch.colors[1] + place);
    hn::BlendedStore(result.z, isWanted, d, batch.colors[2] + place);
  }
}

void StoreBytes(const ShadeBatch& batch, int piece, unsigned char* pixels)
{
  constexpr int size = ShadeBatch::pieceSize;
  HWY_ALIGN std::uint8_t channels[3][size];
  for (int i = 0; i < size; i += static_cast<int>(lanes))
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      storeBytes(hn::LoadU(d, batch.colors[channel] + piece * size + i), channels[channel] + i);
    }
  }
  const hn::CappedTag<std::uint8_t, 16> d8;
  HWY_ALIGN std::uint8_t interleaved[3 * size];
  for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(d8)))
  {
    hn::StoreInterleaved3(hn::LoadU(d8, channels[0] + i), hn::LoadU(d8, channels[1] + i),
      hn::LoadU(d8, channels[2] + i), d8, interleaved + 3 * i);
  }
  std::memcpy(pixels, interleaved, static_cast<std::size_t>(3 * batch.pieces[piece].width));
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(ShadeHits);
HWY_EXPORT(StoreBytes);

void shadeHits(const Shader& shader, const Material& material, bool smooth, const ShadeRange& range,
  ShadeBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(ShadeHits)(shader, material, smooth, range, batch);
}

void storeBytes(const ShadeBatch& batch, int piece, unsigned char* pixels)
{
  HWY_DYNAMIC_DISPATCH(StoreBytes)(batch, piece, pixels);
}
}
#endif
