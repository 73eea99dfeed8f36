// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the light model: Lambert's diffuse reflection and an ambient term
 *
 * Per light, in order, and colour channel
 *
 *     rho_d L (s.m) / (|s||m|) + rho_a L    where s.m > 0
 *     rho_a L                               elsewhere
 *
 * with s from the hit to the light, m the normal, and L the light's colour times
 * what its attenuation 1 / (a0 + a1 d + a2 d^2) and its cone (the cosine from the
 * axis to the power of the exponent, nothing outside) leave of it at the hit. A
 * light exactly at the hit gives its full ambient term. With AmbientModel::Scene
 * the ambient term is rho_a, once, instead.
 *
 * The cosine (s.m) / (|s||m|) is computed as (s.m) / sqrt((s.s) (m.m)), so that m may
 * have any length.
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
/// A light as the hits see it.
struct LightSource
{
  bool positional;
  bool isConstant; ///< neither attenuated nor in a cone
  bool hasCone;
  Vec3 toLight; ///< position from the eye, or the direction to the light
  Vec3 axis;    ///< of the cone, unit
  Vec3 color;
  double coneCosine;
  double exponent;
  Vec3 attenuation;

  LightSource(const Light& light, const Vec3& eye);
};

class LightModel
{
public:
  /// The lights as seen from the eye.
  LightModel(const Scene& scene, const Vec3& eye);

  /// What a point shows: the light that it reflects, or its plain colour where it is unlit.
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
