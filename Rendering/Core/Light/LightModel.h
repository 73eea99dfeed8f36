// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the light model: Lambert's diffuse reflection, an ambient term, and Phong's highlights
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
 * A surface with a specular coefficient also reflects, once all of that is added up, the sum over
 * the lights in order of
 *
 *     rho_s L' max(0, r.v)^p    where s.m > 0
 *
 * B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM 18(6),
 * 1975. Here r is the unit vector s / |s| mirrored at the normal, and v the unit vector to the
 * viewer: against the ray. L' is the light that arrives with the light's specular colour instead of
 * its colour, rho_s the specular coefficient times the specular colour, and p the specular power.
 * With V, a vector of any length to the viewer,
 *
 *     r.v = (2 (s.m) / (m.m) (m.V) - s.V) / sqrt((s.s) (V.V))
 *
 * VTK's OpenGL renderer has the same formula, but: it uses the diffuse colour of the light, which
 * differs only after vtkLight::SetSpecularColor(); it takes at least 1e-5 for r.v; for a single
 * headlight it takes the cosine between normal and view direction for r.v; and in a parallel view
 * it takes the direction to the camera's position for v.
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
  Vec3 specularColor;
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

  /// The highlights of all lights at a point.
  Vec3 highlights(const SurfacePoint& point, const SpecularStyle& style) const;

  /// In a parallel view the direction to the viewer, of length 1. In a perspective view it is
  /// opposite to the position of a point relative to the eye.
  bool isParallel() const { return this->Parallel; }
  const Vec3& towardsViewer() const { return this->TowardsViewer; }
  const std::vector<LightSource>& sources() const { return this->Sources; }
  AmbientModel ambientModel() const { return this->Ambient; }

private:
  static double arriving(const LightSource& source, const Vec3& toLight, double distance);

  std::vector<LightSource> Sources;
  AmbientModel Ambient;
  bool Parallel;
  Vec3 TowardsViewer;
};
}

#endif
