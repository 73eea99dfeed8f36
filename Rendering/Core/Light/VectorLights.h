// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief LightModel::color() for several points at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorLights_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorLights_h
#undef lambent_VectorLights_h
#else
#define lambent_VectorLights_h
#endif

#include "LightModel.h"
#include "VectorSurfaceColor.h"

#include "Elementary.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// LightModel::arriving() in each lane.
inline V arriving(const LightSource& source, const Vector3& toLight, V distance)
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

/// base to the power of exponent, in the lanes of a mask. The other lanes are undefined.
inline V powerWhere(M mask, V base, double exponent)
{
  HWY_ALIGN double powers[lanesAtMost];
  HWY_ALIGN double isWanted[lanesAtMost];
  hn::Store(base, d, powers);
  hn::Store(hn::IfThenElseZero(mask, hn::Set(d, 1.0)), d, isWanted);
  for (std::size_t lane = 0; lane < lanes; ++lane)
  {
    powers[lane] = isWanted[lane] > 0.0 ? power(powers[lane], exponent) : 0.0;
  }
  return hn::Load(d, powers);
}

/// LightModel::highlights() in each lane.
HWY_INLINE Vector3 highlights(
  const LightModel& model, const SpecularStyle& style, const VectorSurfacePoint& point)
{
  const V zero = hn::Zero(d), two = hn::Set(d, 2.0);
  const Vector3& m = point.normal;
  const Vector3& p = point.position;
  const Vector3 v = model.isParallel() ? set(model.towardsViewer())
                                       : Vector3{ hn::Neg(p.x), hn::Neg(p.y), hn::Neg(p.z) };
  const V normalSquare = dot(m, m), viewSquare = dot(v, v);
  const Vector3 reflection = set(style.reflection());
  Vector3 sum = set(Vec3(0.0));
  for (const LightSource& source : model.sources())
  {
    const Vector3 s =
      source.positional ? set(source.toLight) - point.position : set(source.toLight);
    const V facing = dot(s, m);
    const M isLit = hn::Gt(facing, zero);
    if (hn::AllFalse(d, isLit))
    {
      continue;
    }
    const V square = dot(s, s);
    Vector3 light = set(source.specularColor);
    if (!source.isConstant)
    {
      light = light * arriving(source, s, hn::Sqrt(square));
    }
    const V mirrored =
      hn::Sub(hn::Mul(hn::Div(hn::Mul(two, facing), normalSquare), dot(m, v)), dot(s, v));
    const V cosine = hn::Div(mirrored, hn::Sqrt(hn::Mul(square, viewSquare)));
    const V clamped = hn::IfThenElse(hn::Gt(cosine, zero), cosine, zero);
    const Vector3 reflected = (reflection * light) * powerWhere(isLit, clamped, style.power);
    sum = sum +
      Vector3{ hn::IfThenElseZero(isLit, reflected.x), hn::IfThenElseZero(isLit, reflected.y),
        hn::IfThenElseZero(isLit, reflected.z) };
  }
  return sum;
}

/// LightModel::color() for points that are neither unlit nor shiny.
HWY_INLINE Vector3 lit(
  const LightModel& model, const VectorSurfaceColor& reflection, const VectorSurfacePoint& point)
{
  const V zero = hn::Zero(d);
  const V normalSquare = dot(point.normal, point.normal);
  const bool perLight = model.ambientModel() == AmbientModel::PerLight;
  Vector3 sum = perLight ? set(Vec3(0.0)) : reflection.ambient;
  for (const LightSource& source : model.sources())
  {
    const Vector3 s =
      source.positional ? set(source.toLight) - point.position : set(source.toLight);
    const V square = dot(s, s);
    const V facing = dot(s, point.normal);
    const M isLit = hn::Gt(facing, zero);
    const V cosine = hn::Div(facing, hn::Sqrt(hn::Mul(square, normalSquare)));
    Vector3 light = set(source.color);
    if (!source.isConstant)
    {
      light = light * arriving(source, s, hn::Sqrt(square));
    }
    const Vector3 diffuse = (reflection.diffuse * light) * cosine;
    Vector3 reflected{ hn::IfThenElseZero(isLit, diffuse.x), hn::IfThenElseZero(isLit, diffuse.y),
      hn::IfThenElseZero(isLit, diffuse.z) };
    if (perLight)
    {
      reflected = reflected + reflection.ambient * light;
    }
    sum = sum + reflected;
  }
  return sum;
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
