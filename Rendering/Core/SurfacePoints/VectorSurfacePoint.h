// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief surface points of several samples, and the values of their runs
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorSurfacePoint_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorSurfacePoint_h
#undef lambent_VectorSurfacePoint_h
#else
#define lambent_VectorSurfacePoint_h
#endif

#include "RunRange.h"
#include "SampleBatch.h"
#include "VectorTriples.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A SurfacePoint in each lane.
struct VectorSurfacePoint
{
  Vector3 position;
  V depth;
  Vector3 normal;
  Vector3 weights;
};

/// Looks up values of the runs of some samples, in arrays with one value per run. Runs are numbered
/// consecutively, so all values that the samples of a vector can need are adjacent.
class Runs
{
public:
  explicit Runs(const std::int64_t* run)
    : First(run[0])
    , Places(hn::IndicesFromVec(d, hn::Sub(hn::LoadU(di, run), hn::Set(di, run[0]))))
  {
  }

  V operator()(const double* values) const
  {
    return hn::TableLookupLanes(hn::LoadU(d, values + this->First), this->Places);
  }
  Vector3 operator()(const double (*values)[SampleBatch::room]) const
  {
    return { (*this)(values[0]), (*this)(values[1]), (*this)(values[2]) };
  }

private:
  static constexpr hn::RebindToSigned<D> di{};
  std::int64_t First;
  decltype(hn::IndicesFromVec(d, hn::Zero(di))) Places;
};

/// Calls body(place, runs, isWanted, x, y) for each vector of samples of a range, unless none of
/// their runs is wanted.
template <typename Body>
HWY_INLINE void forSamples(const RunRange& range, const SampleBatch& batch, const Body& body)
{
  constexpr auto step = static_cast<int>(lanes);
  for (int place = range.first / step * step; place < range.end; place += step)
  {
    const SamplePiece& piece = batch.pieces[place / SampleBatch::pieceSize];
    const int i = place % SampleBatch::pieceSize;
    const Runs runs(batch.run + place);
    const M isWanted = hn::Gt(runs(batch.isWanted), hn::Zero(d));
    if (i < piece.width && !hn::AllFalse(d, isWanted))
    {
      body(place, runs, isWanted, hn::LoadU(d, piece.xs + i), hn::Set(d, piece.y));
    }
  }
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
