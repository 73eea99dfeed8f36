// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which material each face of an OBJ file has
 */

#ifndef ObjMaterials_h
#define ObjMaterials_h

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace lambent::command
{

struct ObjMaterials
{
  static constexpr std::int32_t none = -1;

  std::vector<std::string> libraries; ///< the rest of each line `mtllib`
  std::vector<std::string> names;     ///< of the lines `usemtl`, each once
  std::vector<std::int32_t> ofFace;   ///< index of the name, or none; empty if no face has one

  bool empty() const { return this->ofFace.empty() || this->libraries.empty(); }
};

/// Stores materials as field data of a mesh with these faces as polygons, unless they are empty.
void StoreMaterials(const ObjMaterials& materials, vtkPolyData* mesh);

/// The materials that were stored, or empty ones.
ObjMaterials StoredMaterials(vtkPolyData* mesh);

} // namespace lambent::command

#endif
