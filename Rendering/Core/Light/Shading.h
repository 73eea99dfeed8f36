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
 * have any length: normals are interpolated with the edge functions themselves,
 * which are the barycentric coordinates but for a factor. That factor is negative
 * on the back of a face, where two-sided lighting turns the normal anyway.
 *
 * Two-sided lighting turns the normal to the viewer. The front of a triangle is where its
 * corners run counter-clockwise, or the other side where its normals lie there (isReversed()):
 * in a mirrored mesh the faces run the wrong way round while the normals still point outward.
 * It is judged once for the whole triangle, so that no seam runs through it.
 *
 * Shader::color() is the definition; ShadingKernel.h does the same for many hits.
 */
#ifndef lambent_Shading_h
#define lambent_Shading_h

#include "FrameMesh.h"

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

class Shader
{
public:
  Shader(const Scene& scene, const FrameMesh& mesh);

  /// The colour at the hit of the ray through (x, y) on a triangle.
  Vec3 color(std::uint32_t triangle, double x, double y) const;

  /// The normal of the face: the cell's, if the surface has some.
  static Vec3 faceNormal(const Surface& surface, std::size_t triangle);

  /// Whether the sum of the triangle's three point normals (or the face's normal where it is
  /// shaded flat) lies on the other side of the one that its winding says is its front.
  static bool isReversed(const Surface& surface, std::size_t triangle);

  const CameraFrame& frame() const { return this->Mesh.frame(); }
  const std::vector<LightSource>& sources() const { return this->Sources; }
  AmbientModel ambientModel() const { return this->Ambient; }
  bool isTwoSided() const { return this->TwoSided; }

private:
  Vec3 normal(const Surface& surface, std::size_t triangle, const Hit& hit) const;
  Vec3 lit(const Material& material, const Vec3& point, const Vec3& normal) const;
  static double arriving(const LightSource& source, const Vec3& toLight, double distance);

  const FrameMesh& Mesh;
  std::vector<LightSource> Sources;
  AmbientModel Ambient;
  bool TwoSided;
};
}

#endif
