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

/// LightModel::color() for points that are not unlit.
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
