// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random edges and highlights for the surfaces of random scenes
 */
#ifndef RandomStyles_h
#define RandomStyles_h

#include "RandomNumbers.h"
#include "Scene.h"

#include <memory>
#include <vector>

/// Gives most surfaces edges, highlights, or both. Cells have one, some, or all triangles of their
/// surface, and some of their edges. It must outlive the scene.
class RandomStyles
{
public:
  RandomStyles(lambent::Scene& scene, unsigned int seed)
    : Random(seed)
  {
    for (lambent::Surface& surface : scene.surfaces)
    {
      if (this->Random.below(3) > 0)
      {
        this->addEdges(surface);
      }
      if (this->Random.below(3) > 0)
      {
        this->addHighlights(surface.appearance.specular);
      }
    }
    for (lambent::Light& light : scene.lights)
    {
      light.specularColor = this->color();
    }
  }

private:
  lambent::Vec3 color() { return this->Random.inBox(0.5) + lambent::Vec3(0.5); }

  void addEdges(lambent::Surface& surface)
  {
    lambent::EdgeStyle& style = surface.appearance.edges;
    style.areVisible = true;
    style.color = this->color();
    style.opacity = this->Random.below(2) == 0 ? 1.0 : this->Random.within(0.0, 1.0);
    style.width = this->Random.below(5) == 0 ? 0.0 : this->Random.within(0.5, 6.0);
    const std::size_t count = surface.triangleCount();
    constexpr std::size_t largeMesh = 10000; // whose cells must be small for brute force
    const int kind = count > largeMesh ? this->Random.below(2) : this->Random.below(4);
    if (kind > 0 && count > 0 && !surface.colors && !surface.cellNormals)
    {
      const std::size_t size = kind == 3 ? count : kind == 2 ? 20 : 2;
      this->Cells.push_back(std::make_unique<std::vector<std::int64_t>>());
      for (std::size_t t = 0; t < count; ++t)
      {
        this->Cells.back()->push_back(static_cast<std::int64_t>(t / size % 3));
      }
      surface.cells = this->Cells.back()->data();
    }
    if (this->Random.below(3) > 0)
    {
      this->Edges.push_back(std::make_unique<std::vector<unsigned char>>());
      for (std::size_t t = 0; t < count; ++t)
      {
        this->Edges.back()->push_back(static_cast<unsigned char>(this->Random.below(8)));
      }
      surface.cellEdges = this->Edges.back()->data();
    }
  }

  void addHighlights(lambent::SpecularStyle& style)
  {
    style.coefficient = this->Random.within(0.0, 1.0);
    style.color = this->color();
    const double powers[] = { 0.0, 1.0, 0.5, 8.0, 77.25, 128.0 };
    style.power = powers[this->Random.below(6)];
  }

  RandomNumbers Random;
  std::vector<std::unique_ptr<std::vector<std::int64_t>>> Cells;
  std::vector<std::unique_ptr<std::vector<unsigned char>>> Edges;
};

#endif
