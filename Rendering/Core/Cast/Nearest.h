// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a casting policy: keeps the nearest hit of each sample
 *
 * Of two hits of a sample, the one with the smaller depth is kept; at equal depths, the one with
 * the smaller primitive number. So the order of the hits does not matter.
 *
 * A hit has a primitive and a range of nearness. If two ranges do not overlap, they decide which
 * hit is nearer. Otherwise both depths are computed, and that of the nearer hit is stored.
 *
 * A policy for Casting provides reset(), offer() for a hit with a range or with a depth, merge(),
 * and a vector class that keeps certain hits (VectorNearest.h).
 */
#ifndef lambent_Nearest_h
#define lambent_Nearest_h

#include "Nearness.h"
#include "Surface.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace lambent
{
class Nearest
{
public:
  /// Whether the policy is for the transparent surfaces of a scene, or for the opaque ones.
  static constexpr bool isForTransparent = false;

  /// Removes all hits.
  void reset(std::size_t size)
  {
    this->Lows.assign(size, noNearness.low);
    this->Highs.assign(size, noNearness.high);
    this->Primitives.assign(size, noPrimitive);
    this->Depths.resize(size); // undefined where nothing is hit
    this->DepthOwners.assign(size, noPrimitive);
  }

  /// Ranges of nearness and primitives, by sample.
  float* lows() { return this->Lows.data(); }
  float* highs() { return this->Highs.data(); }
  std::uint32_t* primitives() { return this->Primitives.data(); }
  const float* lows() const { return this->Lows.data(); }
  const float* highs() const { return this->Highs.data(); }
  const std::uint32_t* primitives() const { return this->Primitives.data(); }

  /// Offers a certain hit. depthOf(primitive, sample) computes a depth if needed.
  template <typename DepthOf>
  void offer(
    std::size_t sample, std::uint32_t primitive, const Nearness& range, const DepthOf& depthOf)
  {
    if (range.low > this->Highs[sample])
    {
      this->set(sample, primitive, range);
    }
    else if (!(range.high < this->Lows[sample]))
    {
      this->findDepth(sample, depthOf);
      this->choose(sample, primitive, range, depthOf(primitive, sample));
    }
  }

  /// Offers a hit of known depth, with its nearness range.
  template <typename DepthOf>
  void offer(std::size_t sample, std::uint32_t primitive, const Nearness& range, double depth,
    const DepthOf& depthOf)
  {
    if (!(range.high < this->Lows[sample]))
    {
      this->findDepth(sample, depthOf);
      this->choose(sample, primitive, range, depth);
    }
  }

  /// Offers all hits of the same samples.
  template <typename DepthOf>
  void merge(const Nearest& other, bool parallel, const DepthOf& depthOf)
  {
    for (std::size_t sample = 0; sample < this->Primitives.size(); ++sample)
    {
      const std::uint32_t primitive = other.Primitives[sample];
      if (primitive == noPrimitive)
      {
        continue;
      }
      if (other.knowsDepth(sample))
      {
        const double depth = other.Depths[sample];
        this->offer(sample, primitive, nearnessOf(depth, parallel), depth, depthOf);
      }
      else
      {
        this->offer(sample, primitive, { other.Lows[sample], other.Highs[sample] }, depthOf);
      }
    }
  }

  /// The depth of a sample's hit, or NaN if it has not been computed.
  double depth(std::size_t sample) const
  {
    return this->knowsDepth(sample) ? this->Depths[sample]
                                    : std::numeric_limits<double>::quiet_NaN();
  }

private:
  void set(std::size_t sample, std::uint32_t primitive, const Nearness& range)
  {
    this->Lows[sample] = range.low;
    this->Highs[sample] = range.high;
    this->Primitives[sample] = primitive;
  }

  /// Whether the depth of a sample's hit is known. That of no hit is known: infinity.
  bool knowsDepth(std::size_t sample) const
  {
    return this->DepthOwners[sample] == this->Primitives[sample];
  }

  template <typename DepthOf>
  void findDepth(std::size_t sample, const DepthOf& depthOf)
  {
    if (!this->knowsDepth(sample))
    {
      this->Depths[sample] = depthOf(this->Primitives[sample], sample);
      this->DepthOwners[sample] = this->Primitives[sample];
    }
  }

  /// Keeps the nearer hit by depth. The depth of the sample's hit must be known.
  void choose(std::size_t sample, std::uint32_t primitive, const Nearness& range, double depth)
  {
    const double nearest = this->Primitives[sample] == noPrimitive
      ? std::numeric_limits<double>::infinity()
      : this->Depths[sample];
    if (depth < nearest || (depth == nearest && primitive < this->Primitives[sample]))
    {
      this->set(sample, primitive, range);
      this->Depths[sample] = depth;
      this->DepthOwners[sample] = primitive;
    }
  }

  std::vector<float> Lows, Highs;
  std::vector<std::uint32_t> Primitives;
  std::vector<double> Depths;
  std::vector<std::uint32_t> DepthOwners; ///< the primitives that Depths belong to
};
}

#endif
