// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a policy of casting: the nearest hit of each sample
 *
 * Of two hits of a sample the one with the smaller depth is kept, at the same depth the one
 * with the smaller number of its triangle, so that the order in which they come does not
 * matter.
 *
 * A hit has its triangle and its range of nearness. Where two ranges do not overlap they tell
 * which hit is nearer; elsewhere both depths are computed, and remembered.
 *
 * What Casting asks of a policy: reset(), offer() of a hit with a range or with a depth,
 * merge(), and a class of vectors that keeps certain hits (VectorNearest.h).
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
  /// Start anew, with nothing hit.
  void reset(std::size_t size)
  {
    this->Lows.assign(size, noNearness.low);
    this->Highs.assign(size, noNearness.high);
    this->Triangles.assign(size, noTriangle);
    this->Depths.resize(size); // means nothing where nothing is hit
    this->DepthOwners.assign(size, noTriangle);
  }

  /// By sample: ranges of nearness, and triangles.
  float* lows() { return this->Lows.data(); }
  float* highs() { return this->Highs.data(); }
  std::uint32_t* triangles() { return this->Triangles.data(); }
  const float* lows() const { return this->Lows.data(); }
  const std::uint32_t* triangles() const { return this->Triangles.data(); }

  /// A hit that is certain. depthOf(triangle, sample) computes depths.
  template <typename DepthOf>
  void offer(
    std::size_t sample, std::uint32_t triangle, const Nearness& range, const DepthOf& depthOf)
  {
    if (range.low > this->Highs[sample])
    {
      this->set(sample, triangle, range);
    }
    else if (!(range.high < this->Lows[sample]))
    {
      this->findDepth(sample, depthOf);
      this->choose(sample, triangle, range, depthOf(triangle, sample));
    }
  }

  /// A hit of known depth, and the range of that.
  template <typename DepthOf>
  void offer(std::size_t sample, std::uint32_t triangle, const Nearness& range, double depth,
    const DepthOf& depthOf)
  {
    if (!(range.high < this->Lows[sample]))
    {
      this->findDepth(sample, depthOf);
      this->choose(sample, triangle, range, depth);
    }
  }

  /// All hits of the same samples.
  template <typename DepthOf>
  void merge(const Nearest& other, bool parallel, const DepthOf& depthOf)
  {
    for (std::size_t sample = 0; sample < this->Triangles.size(); ++sample)
    {
      const std::uint32_t triangle = other.Triangles[sample];
      if (triangle == noTriangle)
      {
        continue;
      }
      if (other.knowsDepth(sample))
      {
        const double depth = other.Depths[sample];
        this->offer(sample, triangle, nearnessOf(depth, parallel), depth, depthOf);
      }
      else
      {
        this->offer(sample, triangle, { other.Lows[sample], other.Highs[sample] }, depthOf);
      }
    }
  }

private:
  void set(std::size_t sample, std::uint32_t triangle, const Nearness& range)
  {
    this->Lows[sample] = range.low;
    this->Highs[sample] = range.high;
    this->Triangles[sample] = triangle;
  }

  /// Whether the depth of a sample's hit is known. That of no hit is: infinite.
  bool knowsDepth(std::size_t sample) const
  {
    return this->DepthOwners[sample] == this->Triangles[sample];
  }

  template <typename DepthOf>
  void findDepth(std::size_t sample, const DepthOf& depthOf)
  {
    if (!this->knowsDepth(sample))
    {
      this->Depths[sample] = depthOf(this->Triangles[sample], sample);
      this->DepthOwners[sample] = this->Triangles[sample];
    }
  }

  /// By depth, where that of the sample's hit is known.
  void choose(std::size_t sample, std::uint32_t triangle, const Nearness& range, double depth)
  {
    const double nearest = this->Triangles[sample] == noTriangle
      ? std::numeric_limits<double>::infinity()
      : this->Depths[sample];
    if (depth < nearest || (depth == nearest && triangle < this->Triangles[sample]))
    {
      this->set(sample, triangle, range);
      this->Depths[sample] = depth;
      this->DepthOwners[sample] = triangle;
    }
  }

  std::vector<float> Lows, Highs;
  std::vector<std::uint32_t> Triangles;
  std::vector<double> Depths;
  std::vector<std::uint32_t> DepthOwners; ///< the triangles that these are of
};
}

#endif
