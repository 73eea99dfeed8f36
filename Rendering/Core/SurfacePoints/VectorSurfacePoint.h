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

  HWY_INLINE V operator()(const double* values) const
  {
    return hn::TableLookupLanes(hn::LoadU(d, values + this->First), this->Places);
  }
  HWY_INLINE Vector3 operator()(const double (*values)[SampleBatch::room]) const
  {
    return { (*this)(values[0]), (*this)(values[1]), (*this)(values[2]) };
  }

private:
  static constexpr hn::RebindToSigned<D> di{};
  std::int64_t First;
  decltype(hn::IndicesFromVec(d, hn::Zero(di))) Places;
};

/// The samples of a batch that start at a place, one per lane.
class VectorSamples
{
public:
  VectorSamples(const SampleBatch& batch, int place)
    : runs(batch.run + place)
    , isWanted(hn::Gt(runs(batch.isWanted), hn::Zero(d)))
    , Piece(batch.pieces[place / SampleBatch::pieceSize])
    , I(place % SampleBatch::pieceSize)
  {
  }

  /// The first place of the first vector that contains a sample of the range.
  static int begin(const RunRange& range)
  {
    return range.first / static_cast<int>(lanes) * static_cast<int>(lanes);
  }

  bool isEmpty() const { return this->I >= this->Piece.width || hn::AllFalse(d, this->isWanted); }
  V x() const { return hn::LoadU(d, this->Piece.xs + this->I); }
  V y() const { return hn::Set(d, this->Piece.y); }

  const Runs runs;
  const M isWanted;

private:
  const SamplePiece& Piece;
  const int I;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
