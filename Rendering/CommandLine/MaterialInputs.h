// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief meshes with materials as inputs of the ray tracer
 *
 * A mesh becomes one input for each look that its materials have. Each input is the whole mesh, in
 * which the faces of all other materials are marked as duplicates: so cells keep their numbers, and
 * computed normals do not break where materials meet. The first look stays at the mesh's own
 * place; the inputs of the others follow behind all meshes.
 *
 * With a colour or a texture from an option, materials are not used.
 */

#ifndef MaterialInputs_h
#define MaterialInputs_h

#include "Options.h"
#include "ParseMtl.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// A material with its image.
struct Look
{
  Material material;
  vtkSmartPointer<vtkImageData> image; ///< null if it has none, or none that can be used
};

/// The looks of a mesh, and which each polygon has; empty if it has no materials.
struct MeshLooks
{
  std::vector<Look> looks;
  std::vector<std::int32_t> ofPolygon;
};

/// Whether materials are to be read.
bool ShowsMaterials(const Options& options);

/// Reads the materials that a mesh from this file names. A library or image that cannot be read
/// causes a warning; its materials then look as without it.
MeshLooks ReadLooks(
  vtkPolyData* mesh, const std::string& path, VtkMessages& messages, Progress& progress);

class MaterialInputs
{
public:
  using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

  /// `looks` has an entry for each mesh.
  MaterialInputs(const Meshes& meshes, const std::vector<MeshLooks>& looks);

  /// The inputs for MakeScene().
  const Meshes& Inputs() const { return this->All; }
  bool AreColored() const { return this->IsColored; }

  /// Gives the inputs their colours and textures.
  void Apply(const Options& options, vtkLambentRayTracer* tracer) const;
  /// Replaces the numbers of inputs in "InputIds" by those of the meshes.
  void RestoreIds(vtkImageData* picture) const;

private:
  void Add(std::size_t mesh, vtkPolyData* part, const Look& look, bool isFirst);

  Meshes All;
  std::vector<std::size_t> MeshOf; ///< the mesh of each input
  std::vector<Look> LookOf;        ///< of each input
  bool IsColored = false;
};

} // namespace lambent::command

#endif
