// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the light model: Lambert's diffuse reflection and an ambient term
 *
 * The light reflected in each colour channel is the sum, over the lights in order, of
 *
 *     rho_d L (s.m) / (|s||m|) + rho_a L    where s.m > 0
 *     rho_a L                               elsewhere
 *
 * Here s is the vector from the hit to the light, and m the normal. L is the light that arrives at
 * the hit: the light's colour times the attenuation 1 / (a0 + a1 d + a2 d^2) and the effect of its
 * cone (the cosine of the angle to the axis to the power of the exponent, zero outside the cone). A
 * light exactly at the hit gives its full ambient term. With AmbientModel::Scene the ambient term
 * is rho_a, added once, instead.
 *
 * The cosine (s.m) / (|s||m|) is computed as (s.m) / sqrt((s.s) (m.m)), so that m may have any
 * length.
 *
 * LightModel::color() is the definition; VectorLights.h does the same for many points.
 */
#ifndef lambent_LightModel_h
#define lambent_LightModel_h

#include "Scene.h"
#include "SurfacePoint.h"

#include <vector>

namespace lambent
{
/// A light, relative to the eye.
struct LightSource
{
  bool positional;
  bool isConstant; ///< no attenuation and no cone
  bool hasCone;
  Vec3 toLight; ///< position relative to the eye, or direction to the light
  Vec3 axis;    ///< unit axis of the cone
  Vec3 color;
  double coneCosine;
  double exponent;
  Vec3 attenuation;

  LightSource(const Light& light, const Vec3& eye);
};

class LightModel
{
public:
  /// Converts the lights of a scene to positions relative to the eye.
  LightModel(const Scene& scene, const Vec3& eye);

  /// The colour of a point: the light that it reflects, or its plain colour if it is unlit.
  Vec3 color(const SurfacePoint& point) const;

  const std::vector<LightSource>& sources() const { return this->Sources; }
  AmbientModel ambientModel() const { return this->Ambient; }

private:
  static double arriving(const LightSource& source, const Vec3& toLight, double distance);

  std::vector<LightSource> Sources;
  AmbientModel Ambient;
};
}

#endif
