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

/// The form of a pass in the output of the VTK filters.
lambent::Pass formOf(const StagePass& pass, const Stage& stage, std::size_t attribute)
{
  const bool isVector =
    pass.content == lambent::PassContent::Normal || pass.content == lambent::PassContent::Position;
  lambent::Pass form{ pass.content, isVector ? 3 : 1,
    pass.content == lambent::PassContent::Position, nullptr, attribute };
  if (pass.content != lambent::PassContent::Attribute)
  {
    return form;
  }
  for (const Body& body : stage.bodies)
  {
    for (const StageArray& array : body.arrays)
    {
      if (array.name == pass.name && array.isPerCell == pass.isPerCell)
      {
        form.components = array.components;
        form.isDouble = form.isDouble || array.type == lambent::AttributeType::Int32 ||
          array.type == lambent::AttributeType::Double;
      }
    }
  }
  return form;
}

/// Keeps the tuples with these numbers, in this order, in arrays of cells or of points.
void takeTuples(
  const std::vector<std::size_t>& numbers, bool arePerCell, std::vector<StageArray>& arrays)
{
  for (StageArray& array : arrays)
  {
    if (array.isPerCell == arePerCell)
    {
      const std::vector<double> values = array.values;
      const auto size = static_cast<std::size_t>(array.components);
      array.values.clear();
      for (const std::size_t number : numbers)
      {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(number * size);
        array.values.insert(array.values.end(), first, first + array.components);
      }
    }
  }
}

/// Cell k of the result is cell cells[k] of the body.
Body withCells(const Body& body, const std::vector<std::size_t>& cells)
{
  Body part = body;
  part.shape.cells.clear();
  part.cellNormals.clear();
  part.cellGhosts.clear();
  for (const std::size_t cell : cells)
  {
    part.shape.cells.push_back(body.shape.cells[cell]);
    if (!body.cellNormals.empty())
    {
      part.cellNormals.push_back(body.cellNormals[cell]);
    }
    if (!body.cellGhosts.empty())
    {
      part.cellGhosts.push_back(body.cellGhosts[cell]);
    }
  }
  takeTuples(cells, true, part.arrays);
  return part;
}

/// Sphere k of the result is sphere points[k] of the body.
Body withPoints(const Body& body, const std::vector<std::size_t>& points)
{
  Body part = body;
  part.shape.points.clear();
  part.radii.clear();
  for (const std::size_t point : points)
  {
    part.shape.points.push_back(body.shape.points[point]);
    if (!body.radii.empty())
    {
      part.radii.push_back(body.radii[point]);
    }
  }
  takeTuples(points, false, part.arrays);
  return part;
}
}

Picture::Picture(const Stage& stage)
  : width(stage.width)
  , height(stage.height)
  , channels(stage.hasAlpha ? 4 : 3)
  , floats(static_cast<std::size_t>(channels) * stage.width * stage.height)
  , bytes(floats.size())
{
  std::size_t attributes = 0;
  for (const StagePass& pass : stage.passes)
  {
    PassPicture picture{ pass.name, pass.isPerCell, formOf(pass, stage, attributes), {}, {} };
    attributes += pass.content == lambent::PassContent::Attribute;
    const std::size_t size =
      static_cast<std::size_t>(picture.form.components) * stage.width * stage.height;
    picture.form.isDouble ? picture.doubles.resize(size) : picture.floats.resize(size);
    this->passes.push_back(picture);
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
    std::vector<std::size_t> order(
      body.hasSpheres() ? body.shape.points.size() : body.shape.cells.size());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      order[k] = k;
    }
    shuffle(order, random);
    const std::size_t shares = 1 + random.below(3);
    for (std::size_t share = 0; share < shares; ++share)
    {
      std::vector<std::size_t> items; // of this share
      for (std::size_t k = share; k < order.size(); k += shares)
      {
        items.push_back(order[k]);
      }
      result.push_back(body.hasSpheres() ? withPoints(body, items) : withCells(body, items));
    }
  }
  shuffle(result, random);
  return result;
}
