// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random attributes, cells and cell normals for random scenes
 */
#ifndef RandomAttributes_h
#define RandomAttributes_h

#include "Image.h"
#include "RandomNumbers.h"
#include "RandomScenes.h"

/// Gives the surfaces of a scene two attributes of each type, one per point and one per cell, with
/// 1 to 4 components. Some surfaces lack some of them. Some flat surfaces also get cell normals,
/// and some smooth ones normals that are zero. It must outlive the scene.
class RandomAttributes
{
public:
  RandomAttributes(RandomScene& random, unsigned int seed);

  /// Depth, normals, positions, each attribute, and one that no surface has, as floats or doubles.
  std::vector<lambent::Pass> passes;

  /// The values as doubles, by surface and attribute; empty if the surface lacks the attribute.
  std::vector<std::vector<std::vector<double>>> values;

private:
  void addPasses();
  void addCells(lambent::Surface& surface);
  void addNormals(RandomScene::MeshData& mesh, lambent::Surface& surface, std::size_t cells);
  void addAttribute(lambent::Surface& surface, std::size_t number, std::size_t tuples);
  template <typename Value>
  void fill(lambent::AttributeSpan& span, std::size_t count, std::vector<double>& copy);

  RandomNumbers Random;
  std::vector<int> Components; ///< of each attribute
  std::vector<std::vector<unsigned char>> Memory;
  std::vector<std::vector<std::int64_t>> Cells;
  std::vector<std::vector<double>> CellNormals;
};

#endif
