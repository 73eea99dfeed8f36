// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile against lines, with the kernel of LineCastingKernel.h
 *
 * 1. Prefetch the ends of many lines.
 * 2. Find the hits of each line.
 * 3. Offer them to the policy, with their depths.
 */
#ifndef lambent_LineCasting_h
#define lambent_LineCasting_h

#include "ExactHit.h"
#include "Layers.h"
#include "TileHits.h"
#include "WaitingPrimitives.h"

#include <vector>

namespace lambent
{
template <typename Policy>
class LineCasting
{
public:
  explicit LineCasting(const FrameMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// `hits` is scratch memory.
  void cast(const NextPrimitive* lines, int count, TileHits<Policy>& tile,
    std::vector<ExactHit>& hits) const;

private:
  const FrameMesh& Mesh;
};

extern template class LineCasting<Nearest>;
extern template class LineCasting<Layers>;
}

#endif
