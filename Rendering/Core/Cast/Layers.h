// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a casting policy: keeps all hits of each sample on transparent surfaces
 *
 * Opaque surfaces are cast with the policy Nearest. A layer behind the opaque surface of its sample
 * is not seen and may be dropped.
 *
 * Hits are kept in the order in which they come. SortedLayers sorts them.
 */
#ifndef lambent_Layers_h
#define lambent_Layers_h

#include "Nearest.h"

#include <vector>

namespace lambent
{
/// A hit, with its range of nearness. The depth is NaN until it is needed.
struct Layer
{
  float low, high;
  std::uint32_t sample;
  std::uint32_t primitive;
  double depth;
};

class Layers
{
public:
  /// Whether the policy is for the transparent surfaces of a scene, or for the opaque ones.
  static constexpr bool isForTransparent = true;

  /// Removes all hits.
  void reset(std::size_t) { this->Hits.clear(); }

  /// The opaque hits of the same samples, known so far. They must exist while hits are offered.
  void setOpaque(const Nearest& opaque) { this->Opaque = &opaque; }
  const Nearest& opaque() const { return *this->Opaque; }

  void add(std::uint32_t sample, std::uint32_t primitive, const Nearness& range, double depth)
  {
    this->Hits.push_back({ range.low, range.high, sample, primitive, depth });
  }

  template <typename DepthOf>
  void offer(std::size_t sample, std::uint32_t primitive, const Nearness& range, const DepthOf&)
  {
    this->offer(sample, primitive, range, std::numeric_limits<double>::quiet_NaN(), nullptr);
  }
  template <typename DepthOf>
  void offer(std::size_t sample, std::uint32_t primitive, const Nearness& range, double depth,
    const DepthOf&)
  {
    if (!(range.high < this->Opaque->lows()[sample]))
    {
      this->add(static_cast<std::uint32_t>(sample), primitive, range, depth);
    }
  }

  template <typename DepthOf>
  void merge(const Layers& other, bool, const DepthOf&)
  {
    this->Hits.insert(this->Hits.end(), other.Hits.begin(), other.Hits.end());
  }

  const std::vector<Layer>& hits() const { return this->Hits; }

private:
  const Nearest* Opaque = nullptr;
  std::vector<Layer> Hits;
};
}

#endif
