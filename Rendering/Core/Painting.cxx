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

/// Extends the range to another part. Returns false, and does nothing, if that is shaded in another
/// way.
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

Vec3 Painting::sampleColor(
  const TileSamples& samples, const std::uint32_t* triangles, int i, int j) const
{
  const std::uint32_t triangle = triangles[static_cast<std::size_t>(j) * samples.stride() + i];
  return triangle == noTriangle
    ? this->Target.background(samples.window().j0 + j)
    : this->Light.color(this->Points.at(triangle, samples.xs()[i], samples.ys()[j]));
}

void Painting::paintPlainly(const TileSamples& samples, const std::uint32_t* triangles) const
{
  const Window pixels = this->pixelsOf(samples.window());
  const int n = this->Target.target().samples;
  for (int j = 0; j < pixels.height(); ++j)
  {
    for (int i = 0; i < pixels.width(); ++i)
    {
      this->Target.storeColor(pixels.i0 + i, pixels.j0 + j,
        Film::average(n,
          [&](int column, int row)
          { return this->sampleColor(samples, triangles, n * i + column, n * j + row); }));
    }
  }
  this->Target.storeTriangles(pixels, triangles, samples.stride());
}

void Painting::paint(
  const TileSamples& samples, const std::uint32_t* triangles, PaintingMemory& memory) const
{
  if (this->Target.target().samples > 1)
  {
    this->paintAverages(samples, triangles, memory);
    return;
  }
  const auto store =
    [this](const SamplePiece& piece, const double* red, const double* green, const double* blue)
  { this->Target.storeColors(piece.i, piece.j, piece.width, red, green, blue); };
  for (int row = 0; row < samples.window().height(); ++row)
  {
    this->paintRow(
      samples, triangles, row, memory.batch,
      [this](int i, int j, int width) {
        this->Target.storeBackground({ i, i + width, j, j + 1 });
      },
      store);
  }
  this->shade(memory.batch, store);
  this->Target.storeTriangles(samples.window(), triangles, samples.stride());
}

/// Computes the colours of the whole tile first, then the averages.
void Painting::paintAverages(
  const TileSamples& samples, const std::uint32_t* triangles, PaintingMemory& memory) const
{
  const Window& window = samples.window();
  const Window pixels = this->pixelsOf(window);
  const int n = this->Target.target().samples;
  TileColors& colors = memory.colors;
  colors.reset(window.width(), window.height());
  memory.isHit.assign(pixels.height(), 0);
  const auto store =
    [&](const SamplePiece& piece, const double* red, const double* green, const double* blue)
  {
    const int row = piece.j - window.j0;
    colors.store(piece.i - window.i0, row, piece.width, red, green, blue);
    memory.isHit[row / n] = 1;
  };
  for (int row = 0; row < window.height(); ++row)
  {
    this->paintRow(
      samples, triangles, row, memory.batch,
      [&](int i, int j, int width)
      { colors.fill(i - window.i0, j - window.j0, width, this->Target.background(j)); },
      store);
  }
  this->shade(memory.batch, store);
  for (int row = 0; row < pixels.height(); ++row)
  {
    const Window inRow{ pixels.i0, pixels.i1, pixels.j0 + row, pixels.j0 + row + 1 };
    memory.isHit[row] ? this->Target.storeAverages(inRow, colors, n * row)
                      : this->Target.storeBackground(inRow);
  }
  this->Target.storeTriangles(pixels, triangles, samples.stride());
}

/// Calls background(i, j, width) for pieces that hit nothing. Other pieces go to the batch.
template <typename BackgroundOf, typename StoreTo>
void Painting::paintRow(const TileSamples& samples, const std::uint32_t* triangles, int row,
  SampleBatch& batch, const BackgroundOf& background, const StoreTo& store) const
{
  const Window& window = samples.window();
  const int j = window.j0 + row;
  const std::uint32_t* const hits = triangles + static_cast<std::size_t>(row) * samples.stride();
  for (int begin = 0; begin < window.width(); begin += SampleBatch::pieceSize)
  {
    const int i = window.i0 + begin;
    const int width = std::min(SampleBatch::pieceSize, window.width() - begin);
    if (!batch.add({ i, j, width, samples.xs() + begin, samples.ys()[row] }, hits + begin))
    {
      background(i, j, width);
    }
    else if (batch.isFull())
    {
      this->shade(batch, store);
    }
  }
}

/// Shades the batch, and calls store(piece, red, green, blue) for each piece.
template <typename StoreTo>
void Painting::shade(SampleBatch& batch, const StoreTo& store) const
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
    store(batch.pieces[piece], batch.colors[0] + piece * size, batch.colors[1] + piece * size,
      batch.colors[2] + piece * size);
  }
  batch.clear();
}

/// Moves the range to the runs after it, up to the first that is shaded in another way. Runs that
/// hit nothing are included. Returns false if none of the remaining runs hits anything.
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
