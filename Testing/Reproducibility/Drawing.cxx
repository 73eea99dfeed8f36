// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include <algorithm>
#include <utility>

namespace
{
template <typename Item>
void shuffle(std::vector<Item>& items, RandomNumbers& random)
{
  for (std::size_t k = items.size(); k > 1; --k)
  {
    std::swap(items[k - 1], items[random.below(static_cast<int>(k))]);
  }
}
}

std::vector<lambent::Window> partsOf(const Stage& stage, const Manner& manner)
{
  const int width = stage.width, height = stage.height;
  if (!manner.inParts)
  {
    return { { 0, width, 0, height } };
  }
  std::vector<lambent::Window> parts;
  int rows = 1;
  for (int j = 0; j < height; j += rows, rows = 2 * rows + 1)
  {
    int columns = 3;
    for (int i = 0; i < width; i += columns, columns = 3 * columns - 2)
    {
      parts.push_back({ i, std::min(width, i + columns), j, std::min(height, j + rows) });
    }
  }
  return parts;
}

std::vector<Body> shuffled(const std::vector<Body>& bodies, unsigned int seed)
{
  RandomNumbers random(seed);
  std::vector<Body> result;
  for (const Body& body : bodies)
  {
    std::vector<std::size_t> order(body.shape.cells.size());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      order[k] = k;
    }
    shuffle(order, random);
    const std::size_t shares = 1 + random.below(3);
    for (std::size_t share = 0; share < shares; ++share)
    {
      Body part = body;
      part.shape.cells.clear();
      part.cellNormals.clear();
      for (std::size_t k = share; k < order.size(); k += shares)
      {
        part.shape.cells.push_back(body.shape.cells[order[k]]);
        if (!body.cellNormals.empty())
        {
          part.cellNormals.push_back(body.cellNormals[order[k]]);
        }
      }
      result.push_back(std::move(part));
    }
  }
  shuffle(result, random);
  return result;
}
