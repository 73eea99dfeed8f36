// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a scene that both the core and the VTK filters can render
 *
 * Bodies hold cells as polydata does, before triangulation and before normals are
 * computed, so that these steps are compared, too.
 */
#ifndef Stage_h
#define Stage_h

#include "Shapes.h"

#include "Image.h"
#include "NormalContribution.h"
#include "Scene.h"
#include "Transform.h"

#include <optional>
#include <string>

/// An array with one tuple per point or cell of a body, or per pixel of an image.
struct StageArray
{
  std::string name;
  bool isPerCell = false;
  int components = 1;
  lambent::AttributeType type = lambent::AttributeType::Float;
  std::vector<double> values; ///< each can be represented exactly by the type

  /// The values in memory, with the array's type.
  std::vector<unsigned char> memory() const;
};

/// Where the colours of a body come from.
struct StageColors
{
  std::string array; ///< empty: from the appearance
  bool isPerCell = false;
  int component = 0;
  /// A table of four bytes per entry, or none. With special colours, the last three entries are for
  /// NaN, below and above the range.
  std::vector<unsigned char> entries;
  bool hasSpecialColors = false;
  double low = 0.0, high = 1.0;
  bool isLogarithmic = false;
  bool isMappedLast = false;
  bool hasAlpha = false; ///< the array's or the table's is used; VTK's filters find it out

  std::size_t entryCount() const
  {
    return this->entries.size() / 4 - (this->hasSpecialColors ? 3 : 0);
  }
  const unsigned char* special(int k) const { return &this->entries[4 * (this->entryCount() + k)]; }
};

/// The texture of a body.
struct StageTexture
{
  StageArray pixels; ///< without values if there is none
  int width = 0, height = 0;
  lambent::TextureWrap wrap = lambent::TextureWrap::Repeat;
  bool isInterpolated = false;
  bool isSRGB = false;
  Vec3 border{ 0.0 };
  double matrix[2][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  StageArray coordinates; ///< of the points

  bool exists() const { return !this->pixels.values.empty(); }
  StageTexture& wrapped(lambent::TextureWrap how);
  StageTexture& interpolated();
};

/// What the cells of a body are, or how they are shown.
enum class CellShow
{
  Faces,
  Vertices,  ///< cells are vertices
  Polylines, ///< cells are polylines
  Edges,     ///< the wireframe of polygons or strips
  Points     ///< the points of polygons or strips
};

/// One input of the ray tracer. By default smooth, with computed normals.
struct Body
{
  Shape shape;
  bool hasStrips = false; ///< the cells are strips, not polygons
  bool hasFloatPoints = false;
  bool has32BitIds = false;
  double radius = 0.0;       ///< unless 0, the points are spheres
  std::vector<double> radii; ///< times radius, one per point; or none
  CellShow show = CellShow::Faces;
  double width = 1.0;             ///< of lines and points, in pixels
  bool isRounded = false;         ///< lines are tubes, and points spheres
  std::vector<Vec3> pointNormals; ///< one per point, or none
  std::vector<Vec3> cellNormals;  ///< one per cell, or none
  lambent::Weighting weighting = lambent::Weighting::Angle;
  std::vector<StageArray> arrays; ///< attributes
  StageColors colors;
  StageTexture texture;
  lambent::Appearance appearance;
  lambent::Transform transform;
  std::vector<unsigned char> pointGhosts, cellGhosts; ///< VTK's flags, or none
  /// The place in a composite input: the numbers of the children from its root. Consecutive bodies
  /// with places form one input, in the order of the tree. Appearance and transform are those of
  /// its first body. Empty: the body is an input of its own.
  std::vector<int> block;
  std::optional<Vec3> blockColor;
  std::optional<double> blockOpacity;

  /// Sets the diffuse colour, which is also the plain one, and the ambient colour.
  Body& paint(const Vec3& diffuse, const Vec3& ambient = Vec3(0.0));
  Body& flat();
  Body& unlit();
  /// Sets the weighting of computed normals.
  Body& weigh(lambent::Weighting how);
  /// Makes each point its own normal, as on a ball.
  Body& round();
  Body& floats();
  Body& strips();
  /// Makes the points spheres of this radius.
  Body& spheres(double size);
  /// Makes the points spheres of these sizes times a factor.
  Body& spheres(double factor, const std::vector<double>& sizes);
  bool hasSpheres() const { return this->radius > 0.0; }
  /// Shows the cells as lines or points of this width.
  Body& lines(CellShow how, double pixels);
  /// The same, as tubes or spheres.
  Body& tubes(CellShow how, double pixels);
  bool hasFaces() const { return !this->hasSpheres() && this->show == CellShow::Faces; }
  /// Sets the rows of the transform.
  Body& place(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& offset);
  Body& inBlock(const std::vector<int>& path);
  /// Adds a point array whose values are computed from the coordinates.
  Body& pointArray(const std::string& name, int components, lambent::AttributeType type);
  /// Takes the colours from an array that is added before or afterwards.
  StageColors& colorBy(const std::string& name, bool isPerCell);
  /// Sets a texture of so many pixels, with coordinates computed from those of the points.
  StageTexture& cover(int w, int h, int components, lambent::AttributeType type);
  /// Adds a cell array whose values vary from cell to cell.
  Body& cellArray(const std::string& name, int components, lambent::AttributeType type);
};

/// A pass of the picture.
struct StagePass
{
  lambent::PassContent content = lambent::PassContent::Depth;
  std::string name; ///< in the VTK filters' output
  bool isPerCell = false;
};

struct Stage
{
  int width = 96, height = 72;
  int samples = 1; ///< along each axis of a pixel
  bool hasAlpha = false;
  std::vector<StagePass> passes;
  StageArray backgroundImage; ///< without values if there is none
  int backgroundWidth = 0, backgroundHeight = 0;
  std::vector<Body> bodies;
  std::vector<std::vector<int>>
    hiddenBlocks; ///< places of blocks that are hidden, with all in them
  /// Camera, lights and backgrounds; the surfaces are made from the bodies.
  lambent::Scene scene;
  /// Use the default view direction, with all bodies in view.
  bool isFramed = false;
  /// Whether faces coincide, or meet exactly on a ray: then their order decides which of them is
  /// visible.
  bool hasTies = false;

  /// Sets the camera at (2, 1.5, 4), looking at the origin.
  Stage();

  /// The bodies as inputs of their own: without the hidden ones, and those of blocks with what they
  /// have from their input and block.
  std::vector<Body> visibleBodies() const;
  bool isHidden(const Body& body) const;

  /// The reference is valid until the next call.
  Body& add(const Shape& shape);

  void size(int w, int h);
  void look(const Vec3& from, const Vec3& at, const Vec3& up = Vec3(0.0, 1.0, 0.0));
  void lookParallel(double scale);

  // Passes. Bodies may lack an array.
  void showDepth();
  void showNormals();
  void showPositions();
  void showArray(const std::string& name, bool isPerCell);

  /// Sets a random background image.
  void imageBehind(int w, int h, int components, lambent::AttributeType type);

  lambent::Light& sun(const Vec3& direction, const Vec3& color = Vec3(1.0));
  lambent::Light& lamp(const Vec3& position, const Vec3& color = Vec3(1.0));
  /// A cone of light around a direction.
  lambent::Light& spot(const Vec3& position, const Vec3& direction, double angle, double exponent);
  /// Adds a sun and a lamp of different colours.
  void daylight();
};

#endif
