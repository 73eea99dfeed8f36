// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the points, normals, texture coordinates and faces of an OBJ file
 *
 * The text is parsed line by line, and every number and every index is checked. ReadObj.h describes
 * the mesh made from it.
 *
 * Reference: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer
 * manual, appendix B1.
 */

#ifndef ParseObj_h
#define ParseObj_h

#include "CellLists.h"
#include "ObjMaterials.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace lambent::command
{

/// All ids count from 0.
struct ObjContent
{
  std::vector<double> points;            ///< x y z
  std::vector<float> colors;             ///< r g b of each point; empty if no point has a colour
  std::vector<float> textureCoordinates; ///< u v
  std::vector<float> normals;            ///< x y z

  CellLists faces;
  CellLists lines;
  CellLists vertices;

  /// The id named by each corner of the faces, or NoKey; empty if no corner uses any.
  std::vector<std::int32_t> textureOfCorner;
  std::vector<std::int32_t> normalOfCorner;

  /// The smoothing group of each face, 0 if smoothing is off; empty if no 's' precedes any face.
  /// The groups are numbered from 1 in the order of their first occurrence.
  std::vector<std::int32_t> groupOfFace;
  std::int32_t numberOfGroups = 0;

  ObjMaterials materials;

  std::size_t cellsOfTooFewPoints = 0; ///< skipped: faces of 1 or 2 points, lines of 1
  std::size_t freeFormSurfaces = 0;    ///< skipped

  std::size_t numberOfPoints() const { return this->points.size() / 3; }
};

/// Throws Failure with the line if a number is invalid, or an index names an item that does not
/// exist. A zero byte must follow the text.
ObjContent ParseObj(std::string_view text, const std::function<void(double)>& progress);

} // namespace lambent::command

#endif
