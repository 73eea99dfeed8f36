// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vectorized checks of long arrays
 *
 * Without vectors these would take a third of the time of the normals of a mesh. Nothing is
 * rounded here, so all instruction sets must give the same results; the tests compare them.
 */
#ifndef lambent_CheckKernel_h
#define lambent_CheckKernel_h

#include <cstddef>
#include <cstdint>

namespace lambent
{
struct OffsetKinds
{
  bool areAscending;   ///< none is smaller than the one before
  bool areOfTriangles; ///< each is 3 more than the one before
};

/// Classifies offsets[0] to offsets[cells].
///@{
OffsetKinds classifyOffsets(const std::int32_t* offsets, std::size_t cells);
OffsetKinds classifyOffsets(const std::int64_t* offsets, std::size_t cells);
///@}

struct IdRange
{
  std::int64_t first, last;
};

/// The smallest and the largest id; there must be at least one.
///@{
IdRange findRange(const std::int32_t* ids, std::size_t count);
IdRange findRange(const std::int64_t* ids, std::size_t count);
///@}

/// Whether no value is infinite or NaN.
///@{
bool areFinite(const float* values, std::size_t count);
bool areFinite(const double* values, std::size_t count);
///@}
}

#endif
