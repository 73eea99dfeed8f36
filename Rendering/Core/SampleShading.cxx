// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleShading.h"

#include "EdgeMixing.h"
#include "PointKernel.h"
#include "ShadingKernel.h"
#include "TextureFactors.h"

namespace lambent
{
void SampleShading::shade(SampleBatch& batch, EdgesInTile& edges, PointBatch* points) const
{
  RunRange range;
  while (range.moveOn(this->Points.mesh(), batch))
  {
    this->shadeRange(range, batch, points);
    if (range.hasTextures)
    {
      multiplyByTextures(range, batch);
    }
    if (range.hasEdges)
    {
      mixEdges(this->Edges, range, batch, edges);
    }
  }
}

void SampleShading::shadeRange(const RunRange& range, SampleBatch& batch, PointBatch* points) const
{
  const bool isOfPrimitives = range.colorSource == ColorSource::Primitive;
  if (isOfPrimitives && range.isUnlit && !range.hasTextures)
  {
    this->shadeUnlit(range, batch, points);
    return;
  }
  if (isOfPrimitives && (range.isUnlit || !range.appearance))
  {
    loadColors(range, batch);
  }
  shadeSamples(this->Points, this->Light, range, batch, points);
}

void SampleShading::shadeUnlit(const RunRange& range, SampleBatch& batch, PointBatch* points) const
{
  if (points)
  {
    computePoints(this->Points, range, batch, *points);
  }
  loadColors(range, batch);
  for (int place = range.first; place < range.end; ++place)
  {
    for (int channel = 0; batch.isHit(place) && channel < 3; ++channel)
    {
      batch.colors[channel][place] = batch.diffuse[channel][batch.run[place]];
    }
  }
}
}
