// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a scene as it is written down once and drawn by either face, core and VTK
 *
 * Bodies hold cells as polydata does, before anything is cut into triangles and
 * before normals are computed, so that this work is a part of what is compared.
 */
#ifndef Stage_h
#define Stage_h

#include "Shapes.h"

#include "NormalContribution.h"
#include "Scene.h"

/// One input of the ray tracer. Smooth, with computed normals, unless told otherwise.
struct Body
{
  Shape shape;
  bool hasStrips = false; ///< the cells are strips, not polygons
  bool hasFloatPoints = false;
  bool has32BitIds = false;
  std::vector<Vec3> pointNormals; ///< one a point, or none
  std::vector<Vec3> cellNormals;  ///< one a cell, or none
  lambent::Weighting weighting = lambent::Weighting::Angle;
  lambent::Appearance appearance;

  /// Diffuse colour, which is also the plain one, and ambient colour.
  Body& paint(const Vec3& diffuse, const Vec3& ambient = Vec3(0.0));
  Body& flat();
  Body& unlit();
  /// As shaded by angle, area, ... when the normals are computed.
  Body& weigh(lambent::Weighting how);
  /// The points themselves are the normals, as on a ball.
  Body& round();
  Body& floats();
  Body& strips();
};

struct Stage
{
  int width = 96, height = 72;
  std::vector<Body> bodies;
  /// Camera, lights and backgrounds; its surfaces are made of the bodies.
  lambent::Scene scene;
  /// Draw with the default view direction and all bodies in view.
  bool isFramed = false;
  /// Faces lie in the same place, or meet exactly on a ray: which of them is seen is
  /// a matter of their order.
  bool hasTies = false;

  /// The camera at (2, 1.5, 4), looking at the origin.
  Stage();

  /// The reference is good until the next one is added.
  Body& add(const Shape& shape);

  void size(int w, int h);
  void look(const Vec3& from, const Vec3& at, const Vec3& up = Vec3(0.0, 1.0, 0.0));
  void lookParallel(double scale);

  lambent::Light& sun(const Vec3& direction, const Vec3& color = Vec3(1.0));
  lambent::Light& lamp(const Vec3& position, const Vec3& color = Vec3(1.0));
  /// A cone of light round a direction.
  lambent::Light& spot(const Vec3& position, const Vec3& direction, double angle, double exponent);
  /// A sun and a lamp, of two colours.
  void daylight();
};

#endif
