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
  /// `to`. Returns those whose order with the stored hits is undecided.
  FloatMask keep(
    std::size_t sample, FloatMask hit, Floats from, Floats to, std::uint32_t primitive) const
  {
    const Floats oldFrom = hn::LoadU(f, this->Lows + sample),
                 oldTo = hn::LoadU(f, this->Highs + sample);
    const FloatMask isNearer = hn::And(hit, hn::Gt(from, oldTo));
    hn::StoreU(hn::IfThenElse(isNearer, from, oldFrom), f, this->Lows + sample);
    hn::StoreU(hn::IfThenElse(isNearer, to, oldTo), f, this->Highs + sample);
    hn::StoreU(hn::IfThenElse(hn::RebindMask(u, isNearer), hn::Set(u, primitive),
                 hn::LoadU(u, this->Primitives + sample)),
      u, this->Primitives + sample);
    const FloatMask isFarther = hn::Lt(to, oldFrom);
    return hn::AndNot(hn::Or(isNearer, isFarther), hit);
  }

  /// A lower bound on the nearness of all hits of the tile. Anything farther changes nothing.
  float least(const TileSamples& samples) const
  {
    Floats least = hn::Set(f, std::numeric_limits<float>::infinity());
    const Window& window = samples.window();
    for (int i = 0; i < window.width(); i += step)
    {
      const Floats columns = hn::Add(hn::Iota(f, 0.0f), hn::Set(f, static_cast<float>(i)));
      const FloatMask inside = columnsBefore(columns, window.width());
      for (int row = 0; row < window.height(); ++row)
      {
        const Floats low =
          hn::LoadU(f, this->Lows + static_cast<std::size_t>(row) * samples.stride() + i);
        least = hn::IfThenElse(inside, hn::Min(least, low), least);
      }
    }
    return hn::GetLane(hn::MinOfLanes(f, least));
  }

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
