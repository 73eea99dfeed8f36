// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeMixing.h"

namespace lambent
{
namespace
{
/// Some places of one run, and the edges near them.
void mixRun(const std::vector<EdgeLine>& lines, const EdgeStyle& style, double halfWidth, int begin,
  int end, SampleBatch& batch)
{
  const SamplePiece& piece = batch.pieces[begin / SampleBatch::pieceSize];
  for (int place = begin; place < end; ++place)
  {
    const double x = piece.xs[place % SampleBatch::pieceSize];
    if (std::any_of(lines.begin(), lines.end(),
          [&](const EdgeLine& line) { return line.isAt(x, piece.y, halfWidth * halfWidth); }))
    {
      const Vec3 lit(batch.colors[0][place], batch.colors[1][place], batch.colors[2][place]);
      const Vec3 mixed = mixedWithEdge(lit, style.color, style.opacity);
      for (int channel = 0; channel < 3; ++channel)
      {
        batch.colors[channel][place] = mixed[channel];
      }
    }
  }
}
}

void mixEdges(const CellEdges& edges, const RunRange& range, SampleBatch& batch, EdgesInTile& tile)
{
  for (int begin = range.first, next = 0; begin < range.end; begin = next)
  {
    const int number = begin / SampleBatch::pieceSize;
    next = batch.endOfRun(begin, std::min(range.end, (number + 1) * SampleBatch::pieceSize));
    const std::uint32_t primitive = batch.primitives[batch.run[begin]];
    if (primitive == noPrimitive || !batch.parts[batch.run[begin]]->hasEdges())
    {
      continue;
    }
    const SceneMesh::Part& part = *batch.parts[batch.run[begin]];
    const EdgeStyle& style = part.appearance->edges;
    const int end = std::min(next, number * SampleBatch::pieceSize + batch.pieces[number].width);
    mixRun(tile.near(edges, part, primitive), style, edges.halfWidth(style), begin, end, batch);
  }
}
}
