// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunRange.h"

namespace lambent
{
namespace
{
bool areSame(const SpecularStyle* a, const SpecularStyle* b)
{
  return a == b || (a && b && a->isSameAs(*b));
}
}

void RunRange::begin(const SceneMesh::Part& first)
{
  this->part = &first;
  this->appearance = first.hasOneColor() ? first.appearance : nullptr;
  this->colorSource = first.colorSource();
  this->kind = first.kind();
  this->hasTextures = first.hasTexture();
  this->isUnlit = first.appearance->shading == Shading::Unlit;
  this->isSmooth = first.isSmooth();
  this->hasEdges = first.hasEdges();
  this->specular = first.isShiny() ? &first.appearance->specular : nullptr;
  this->hasGivenNormals = this->isSmooth || first.hasCellNormals();
}

/// Extends the range to another part. Returns false, and does nothing, if that has another kind of
/// primitive or is shaded in another way.
bool RunRange::join(const SceneMesh::Part& next)
{
  RunRange other;
  other.begin(next);
  if (other.isUnlit != this->isUnlit || (!this->isUnlit && other.isSmooth != this->isSmooth) ||
    other.colorSource != this->colorSource || other.kind != this->kind ||
    other.hasTextures != this->hasTextures || !areSame(other.specular, this->specular))
  {
    return false;
  }
  this->part = nullptr;
  this->appearance = other.appearance == this->appearance ? this->appearance : nullptr;
  this->hasGivenNormals = this->hasGivenNormals || other.hasGivenNormals;
  this->hasEdges = this->hasEdges || other.hasEdges;
  return true;
}

bool RunRange::moveOn(const SceneMesh& mesh, SampleBatch& batch)
{
  if (this->endRun == 0)
  {
    mesh.prefetchPartsOf(batch.primitives, batch.runCount);
  }
  const SceneMesh::Part* current = nullptr;
  int run = this->endRun;
  for (this->firstRun = run; run < batch.runCount; ++run)
  {
    const std::uint32_t primitive = batch.primitives[run];
    if (primitive == noPrimitive)
    {
      continue;
    }
    if (!current || !current->holds(primitive))
    {
      const SceneMesh::Part& next = mesh.partOf(primitive);
      if (!current)
      {
        this->begin(next);
      }
      else if (!this->join(next))
      {
        break;
      }
      current = &next;
    }
    batch.parts[run] = current;
  }
  this->endRun = run;
  const std::int64_t* const runs = batch.run;
  this->first = this->end;
  this->end = static_cast<int>(std::lower_bound(runs + this->first,
                                 runs + batch.pieceCount * SampleBatch::pieceSize, this->endRun) -
    runs);
  return current != nullptr;
}
}
