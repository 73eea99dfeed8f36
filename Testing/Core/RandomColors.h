// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random colours for the surfaces of random scenes
 */
#ifndef RandomColors_h
#define RandomColors_h

#include "RandomNumbers.h"
#include "Scene.h"

#include <memory>
#include <vector>

/// Gives most surfaces that have attributes colours from one of them: as they are, or through a
/// table, which may be logarithmic. It must outlive the scene.
class RandomColors
{
public:
  RandomColors(lambent::Scene& scene, unsigned int seed)
    : Random(seed)
  {
    for (lambent::Surface& surface : scene.surfaces)
    {
      if (!surface.attributes.empty() && this->Random.below(5) > 0)
      {
        this->addColors(surface);
      }
    }
  }

private:
  void addColors(lambent::Surface& surface)
  {
    auto colors = std::make_unique<lambent::ColorArray>();
    colors->values = surface.attributes[this->Random.below(int(surface.attributes.size()))];
    if (!colors->values)
    {
      return;
    }
    if (this->Random.below(3) > 0)
    {
      colors->component = this->Random.below(colors->values.components + 1) - 1;
      colors->table = this->addTable();
      colors->isMappedLast = !colors->values.isPerCell && this->Random.below(2) == 0;
    }
    surface.colors = colors.get();
    surface.appearance.diffuse = this->Random.within(0.5, 1.5);
    this->Colors.push_back(std::move(colors));
  }

  const lambent::ColorTable* addTable()
  {
    constexpr int most = 9;
    const int count = 1 + this->Random.below(most);
    auto entries = std::make_unique<unsigned char[]>(4 * (most + 3));
    for (int k = 0; k < 4 * (most + 3); ++k)
    {
      entries[k] = static_cast<unsigned char>(this->Random.below(256));
    }
    const bool isLogarithmic = this->Random.below(3) == 0;
    const double low = isLogarithmic ? 0.25 : this->Random.within(-8.0, 8.0);
    auto table = std::make_unique<lambent::ColorTable>(
      entries.get(), count, low, low + this->Random.within(0.0, 9.0), isLogarithmic);
    if (this->Random.below(2) == 0)
    {
      table->setBelow(entries.get() + 4 * most);
      table->setAbove(entries.get() + 4 * (most + 1));
      table->setNotANumber(entries.get() + 4 * (most + 2));
    }
    this->Entries.push_back(std::move(entries));
    this->Tables.push_back(std::move(table));
    return this->Tables.back().get();
  }

  RandomNumbers Random;
  std::vector<std::unique_ptr<unsigned char[]>> Entries;
  std::vector<std::unique_ptr<lambent::ColorTable>> Tables;
  std::vector<std::unique_ptr<lambent::ColorArray>> Colors;
};

#endif
