// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the policy Layers for certain hits of several samples at a time
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorLayers_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorLayers_h
#undef lambent_VectorLayers_h
#else
#define lambent_VectorLayers_h
#endif

#include "Layers.h"
#include "VectorNearest.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
class VectorLayers
{
public:
  VectorLayers(Layers& layers, const TileSamples& samples)
    : Hits(layers)
    , OpaqueLows(layers.opaque().lows())
    , Least(leastOf(this->OpaqueLows, samples))
  {
  }

  /// Keeps certain hits of the samples from `sample` on, whose nearness lies between `from` and
  /// `to`, in vectors of any size. None is undecided.
  template <typename Tag>
  HWY_INLINE hn::Mask<Tag> keep(Tag tag, std::size_t sample, hn::Mask<Tag> hit, hn::Vec<Tag> from,
    hn::Vec<Tag> to, std::uint32_t primitive) const
  {
    HWY_ALIGN float lows[TileSamples::widestVector], highs[TileSamples::widestVector];
    std::uint8_t bits[8] = {};
    const auto isSeen = hn::AndNot(hn::Lt(to, hn::LoadU(tag, this->OpaqueLows + sample)), hit);
    hn::StoreMaskBits(tag, isSeen, bits);
    hn::Store(from, tag, lows);
    hn::Store(to, tag, highs);
    for (unsigned int lane = 0, left = bits[0] | bits[1] << 8; left != 0; ++lane, left >>= 1)
    {
      if ((left & 1) != 0)
      {
        this->Hits.add(static_cast<std::uint32_t>(sample + lane), primitive,
          { lows[lane], highs[lane] }, std::numeric_limits<double>::quiet_NaN());
      }
    }
    return hn::AndNot(hit, hit);
  }

  /// A lower bound on the nearness of the opaque hits of the tile. Anything farther is hidden.
  float least(const TileSamples&) const { return this->Least; }

private:
  Layers& Hits;
  const float* OpaqueLows;
  const float Least;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
