// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

#include "LoadTriangles.h"
#include "ShadingKernel.h"

namespace lambent
{
namespace
{
void begin(RunRange& range, const SceneMesh::Part& part)
{
  range.part = &part;
  range.appearance = part.appearance;
  range.isUnlit = part.appearance->shading == Shading::Unlit;
  range.isSmooth = part.isSmooth();
  range.hasGivenNormals = range.isSmooth || part.hasCellNormals();
}

/// Whether triangles of another part can be shaded together with those of the range.
bool join(RunRange& range, const SceneMesh::Part& part)
{
  RunRange other;
  begin(other, part);
  if (other.isUnlit != range.isUnlit || (!range.isUnlit && other.isSmooth != range.isSmooth))
  {
    return false;
  }
  range.part = nullptr;
  range.appearance = other.appearance == range.appearance ? range.appearance : nullptr;
  range.hasGivenNormals = range.hasGivenNormals || other.hasGivenNormals;
  return true;
}
}

void Painting::paintPlainly(const TileSamples& samples, const std::uint32_t* triangles) const
{
  const Window& window = samples.window();
  for (int j = 0; j < window.height(); ++j)
  {
    for (int i = 0; i < window.width(); ++i)
    {
      const std::uint32_t triangle = triangles[static_cast<std::size_t>(j) * samples.stride() + i];
      this->Target.storeColor(window.i0 + i, window.j0 + j,
        triangle == noTriangle
          ? this->Target.background(window.j0 + j)
          : this->Light.color(this->Points.at(triangle, samples.xs()[i], samples.ys()[j])));
    }
  }
  this->Target.storeTriangles(window, triangles, samples.stride());
}

void Painting::paint(
  const TileSamples& samples, const std::uint32_t* triangles, SampleBatch& batch) const
{
  const Window& window = samples.window();
  for (int row = 0; row < window.height(); ++row)
  {
    const int j = window.j0 + row;
    const std::uint32_t* const hits = triangles + static_cast<std::size_t>(row) * samples.stride();
    for (int begin = 0; begin < window.width(); begin += SampleBatch::pieceSize)
    {
      const int i = window.i0 + begin;
      const int width = std::min(SampleBatch::pieceSize, window.width() - begin);
      if (!batch.add({ i, j, width, samples.xs() + begin, samples.ys()[row] }, hits + begin))
      {
        this->paintBackground({ i, i + width, j, j + 1 });
      }
      else if (batch.isFull())
      {
        this->shade(batch);
      }
    }
  }
  this->shade(batch);
  this->Target.storeTriangles(window, triangles, samples.stride());
}

void Painting::shade(SampleBatch& batch) const
{
  constexpr int size = SampleBatch::pieceSize;
  for (int piece = 0; piece < batch.pieceCount; ++piece)
  {
    const Vec3& color = this->Target.background(batch.pieces[piece].j);
    for (int channel = 0; channel < 3; ++channel)
    {
      std::fill_n(batch.colors[channel] + piece * size, size, color[channel]);
    }
  }
  RunRange range;
  while (this->nextRange(batch, range))
  {
    if (range.isUnlit)
    {
      shadeUnlit(range, batch);
      continue;
    }
    loadTriangles(range, batch);
    if (!range.appearance)
    {
      loadReflection(range, batch);
    }
    shadeTriangles(this->Points, this->Light, range, batch);
  }
  for (int piece = 0; piece < batch.pieceCount; ++piece)
  {
    const SamplePiece& samples = batch.pieces[piece];
    this->Target.storeColors(samples.i, samples.j, samples.width, batch.colors[0] + piece * size,
      batch.colors[1] + piece * size, batch.colors[2] + piece * size);
  }
  batch.clear();
}

/// Moves the range on to the runs after it, up to one that is shaded in another way. Runs that
/// hit nothing go with those before them. False where none is left that hits anything.
bool Painting::nextRange(SampleBatch& batch, RunRange& range) const
{
  const SceneMesh::Part* part = nullptr;
  int run = range.endRun;
  for (range.firstRun = run; run < batch.runCount; ++run)
  {
    const std::uint32_t triangle = batch.triangles[run];
    if (triangle == noTriangle)
    {
      continue;
    }
    if (!part || !part->holds(triangle))
    {
      const SceneMesh::Part& next = this->Points.mesh().mesh().partOf(triangle);
      if (!part)
      {
        begin(range, next);
      }
      else if (!join(range, next))
      {
        break;
      }
      part = &next;
    }
    batch.parts[run] = part;
  }
  range.endRun = run;
  const std::int64_t* const runs = batch.run;
  range.first = range.end;
  range.end = static_cast<int>(std::lower_bound(runs + range.first,
                                 runs + batch.pieceCount * SampleBatch::pieceSize, range.endRun) -
    runs);
  return part != nullptr;
}

void Painting::shadeUnlit(const RunRange& range, SampleBatch& batch)
{
  for (int place = range.first; place < range.end; ++place)
  {
    const std::int64_t run = batch.run[place];
    if (batch.triangles[run] != noTriangle)
    {
      const Vec3& color = batch.parts[run]->appearance->diffuseColor;
      for (int channel = 0; channel < 3; ++channel)
      {
        batch.colors[channel][place] = color[channel];
      }
    }
  }
}

void Painting::loadReflection(const RunRange& range, SampleBatch& batch)
{
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.triangles[run] != noTriangle)
    {
      const Vec3 diffuse = batch.parts[run]->appearance->diffuseReflection();
      const Vec3 ambient = batch.parts[run]->appearance->ambientReflection();
      for (int channel = 0; channel < 3; ++channel)
      {
        batch.reflection[channel][run] = diffuse[channel];
        batch.reflection[3 + channel][run] = ambient[channel];
      }
    }
  }
}
}
