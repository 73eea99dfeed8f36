// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile against lines
 *
 * A line covers a small part of its box. So each row is cast only where LineBounds.h says that the
 * line may be, with the definition, intersectLine().
 */
#ifndef lambent_LineCasting_h
#define lambent_LineCasting_h

#include "Nearest.h"
#include "TileHits.h"
#include "WaitingPrimitives.h"

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

  void cast(const NextPrimitive* lines, int count, TileHits<Policy>& tile) const;

private:
  void cast(const WaitingPrimitive& waiting, const FrameLine& line, TileHits<Policy>& tile) const;

  const FrameMesh& Mesh;
};

extern template class LineCasting<Nearest>;
}

#endif
