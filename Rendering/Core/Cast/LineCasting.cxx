// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineCasting.h"

#include "LineCastingKernel.h"

#include <hwy/cache_control.h>

namespace lambent
{
template <typename Policy>
void LineCasting<Policy>::cast(
  const NextPrimitive* lines, int count, TileHits<Policy>& tile, std::vector<ExactHit>& hits) const
{
  for (int k = 0; k < count; ++k)
  {
    const SceneMesh::Part& part = *lines[k].part;
    const std::size_t first = 2 * (lines[k].waiting->number - part.firstPrimitive);
    hwy::Prefetch(part.points().at(part.corners()[first]));
    hwy::Prefetch(part.points().at(part.corners()[first + 1]));
  }
  for (int k = 0; k < count; ++k)
  {
    const WaitingPrimitive& waiting = *lines[k].waiting;
    const FrameLine line = this->Mesh.line(*lines[k].part, waiting.number);
    if (!line.isDrawn)
    {
      continue;
    }
    findLineHits(this->Mesh.frame(), tile.samples, line.line, waiting.number, waiting.box, hits);
    offerHits(this->Mesh, tile, hits);
  }
}

template class LineCasting<Nearest>;
template class LineCasting<Layers>;
}
