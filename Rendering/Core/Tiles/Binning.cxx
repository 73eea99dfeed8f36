// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Binning.h"

namespace lambent
{
void Binning::run(std::size_t begin, std::size_t end, BinningMemory& memory) const
{
  this->Mesh.forPrimitives(begin, end,
    [&](const SceneMesh::Part& part, std::size_t from, std::size_t to)
    { this->Triangles.add(part, from, to, memory.triangles, memory.result); });
  this->Triangles.binBoxes(memory.triangles, memory.result);
}

void Binning::flush(BinningMemory& memory) const
{
  this->Triangles.flush(memory.triangles, memory.result);
}
}
