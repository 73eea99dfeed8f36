// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the policy Nearest for certain hits of several samples at a time
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorNearest_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorNearest_h
#undef lambent_VectorNearest_h
#else
#define lambent_VectorNearest_h
#endif

#include "Nearest.h"
#include "TileSamples.h"
#include "VectorFloats.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// The smallest of the samples' values.
inline float leastOf(const float* values, const TileSamples& samples)
{
  Floats least = hn::Set(f, std::numeric_limits<float>::infinity());
  const Window& window = samples.window();
  for (int i = 0; i < window.width(); i += step)
  {
    const Floats columns = hn::Add(hn::Iota(f, 0.0f), hn::Set(f, static_cast<float>(i)));
    const FloatMask inside = columnsBefore(columns, window.width());
    for (int row = 0; row < window.height(); ++row)
    {
      const Floats value =
        hn::LoadU(f, values + static_cast<std::size_t>(row) * samples.stride() + i);
      least = hn::IfThenElse(inside, hn::Min(least, value), least);
    }
  }
  return hn::GetLane(hn::MinOfLanes(f, least));
}

class VectorNearest
{
public:
  explicit VectorNearest(Nearest& nearest)
    : Lows(nearest.lows())
    , Highs(nearest.highs())
    , Primitives(nearest.primitives())
  {
  }

  /// Keeps certain hits of the samples from `sample` on, whose nearness lies between `from` and
  /// `to`, in vectors of any size. Returns those whose order with the stored hits is undecided.
  template <typename Tag>
  HWY_INLINE hn::Mask<Tag> keep(Tag tag, std::size_t sample, hn::Mask<Tag> hit, hn::Vec<Tag> from,
    hn::Vec<Tag> to, std::uint32_t primitive) const
  {
    const hn::RebindToUnsigned<Tag> numbers;
    const auto oldFrom = hn::LoadU(tag, this->Lows + sample),
               oldTo = hn::LoadU(tag, this->Highs + sample);
    const auto isNearer = hn::And(hit, hn::Gt(from, oldTo));
    hn::StoreU(hn::IfThenElse(isNearer, from, oldFrom), tag, this->Lows + sample);
    hn::StoreU(hn::IfThenElse(isNearer, to, oldTo), tag, this->Highs + sample);
    hn::StoreU(hn::IfThenElse(hn::RebindMask(numbers, isNearer), hn::Set(numbers, primitive),
                 hn::LoadU(numbers, this->Primitives + sample)),
      numbers, this->Primitives + sample);
    const auto isFarther = hn::Lt(to, oldFrom);
    return hn::AndNot(hn::Or(isNearer, isFarther), hit);
  }

  /// A lower bound on the nearness of all hits of the tile. Anything farther changes nothing.
  float least(const TileSamples& samples) const { return leastOf(this->Lows, samples); }

private:
  float* Lows;
  float* Highs;
  std::uint32_t* Primitives;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
