// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief all inputs of the ray tracer as the surfaces of one scene
 */
#ifndef InputSurfaces_h
#define InputSurfaces_h

#include "Render.h"
#include "SurfaceFromVTK.h"

#include <memory>
#include <string>
#include <vector>

namespace lambent::adapters
{
class InputSurfaces
{
public:
  /// Surface k shows inputs[k] with appearances[k] and lineStyles[k]: its cells, or spheres at its
  /// points. It may consist of several surfaces of the scene. The inputs must outlive this object.
  /// This and the other functions throw std::runtime_error with a message that names the input.
  InputSurfaces(const std::vector<SceneSettings::Input>& inputs,
    const std::vector<Appearance>& appearances, const std::vector<LineStyle>& lineStyles,
    const Parallel& parallel);

  /// Gives normals to the surfaces with smooth shading: the input's own if it has some and useOwn
  /// is true, otherwise computed ones.
  void addNormals(bool useOwn, double featureAngle, const Parallel& parallel);
  /// Whether addNormals() has computed any.
  bool hasComputedNormals() const { return this->HasComputedNormals; }

  /// Gives surface k the colours of these settings, which must outlive this object.
  void addColors(std::size_t k, const InputColors& settings);

  /// Gives surface k a texture, which must outlive this object, and its texture coordinates.
  void addTexture(std::size_t k, const Texture& texture);

  /// Gives each surface its arrays, in this order. All inputs that have an array must have the same
  /// number of components.
  void addAttributes(const std::vector<SceneSettings::PassArray>& arrays);
  /// An array of the picture for one of them: its components, and whether its numbers are doubles.
  struct ArrayForm
  {
    int components = 1;
    bool isDouble = false;
  };
  ArrayForm formOf(std::size_t attribute) const;

  /// Counts the primitives. To be called after addColors(), since transparent spheres have more.
  void numberPrimitives();
  /// The input and its cell that a primitive belongs to; primitives are counted over all inputs.
  struct Place
  {
    std::size_t input;
    std::int64_t cell;
    int connection;
    vtkIdType block;
  };
  Place find(std::size_t primitive) const;

  std::vector<Surface> surfaces() const;

  /// The message about a corner that names a missing point.
  std::string describeWrongCorner(const MeshDefects& defects) const;
  /// The message about cells with points that are not finite.
  std::string describeNotFinite(const MeshDefects& defects) const;

private:
  /// A surface of the scene.
  struct Piece
  {
    std::size_t firstPrimitive, input;
    const Surface* surface;
  };

  const Piece& pieceOf(std::size_t primitive) const;
  void computeSmallNormals(
    const std::vector<std::size_t>& inputs, double featureAngle, const Parallel& parallel);

  const std::vector<SceneSettings::Input>& Inputs;
  std::vector<std::unique_ptr<SurfaceFromVTK>> Surfaces;
  std::vector<Piece> Pieces;
  bool HasComputedNormals = false;
};
}

#endif
