// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

namespace lambent
{
static_assert(SampleBatch::pieceSize == Film::mostPixels, "a piece is stored at a time");

FilmColor Painting::sampleColor(
  const TileSamples& samples, const std::uint32_t* primitives, int i, int j) const
{
  const std::uint32_t primitive = primitives[static_cast<std::size_t>(j) * samples.stride() + i];
  if (primitive == noPrimitive)
  {
    return this->Target.missed(samples.window().i0 + i, samples.window().j0 + j);
  }
  const double x = samples.xs()[i], y = samples.ys()[j];
  return { this->Shades.color(primitive, x, y, this->Points.at(primitive, x, y)), 1.0 };
}

void Painting::paintPlainly(const TileSamples& samples, const std::uint32_t* primitives) const
{
  const Window pixels = this->Target.target().pixelsOf(samples.window());
  const int n = this->Target.target().samples;
  for (int j = 0; j < pixels.height(); ++j)
  {
    for (int i = 0; i < pixels.width(); ++i)
    {
      this->Target.storeColor(pixels.i0 + i, pixels.j0 + j,
        Film::average(n,
          [&](int column, int row)
          { return this->sampleColor(samples, primitives, n * i + column, n * j + row); }));
    }
  }
  this->Target.storePrimitives(pixels, primitives, samples.stride());
  this->Passes.paintPlainly(samples, primitives);
}

void Painting::paint(
  const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const
{
  if (this->Passes.isNeeded() && !memory.passes)
  {
    memory.passes = std::make_unique<PassMemory>();
  }
  SampleShading::begin(samples, memory.edges);
  if (this->Target.target().samples == 1)
  {
    this->paintSamples(samples, primitives, memory);
  }
  else
  {
    this->paintAverages(samples, primitives, memory);
    if (this->Passes.isNeeded())
    {
      this->Passes.paint(samples, primitives, *memory.passes);
    }
  }
  this->Target.storePrimitives(
    this->Target.target().pixelsOf(samples.window()), primitives, samples.stride());
}

/// Each sample is a pixel.
void Painting::paintSamples(
  const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const
{
  PointBatch* const points = memory.passes ? &memory.passes->points : nullptr;
  const auto store = [this](const SamplePiece& piece, const ChannelSpan& channels)
  { this->Target.storeColors(piece.i, piece.j, piece.width, channels); };
  const auto background = [this](int i, int j, int width)
  {
    this->Target.storeBackground({ i, i + width, j, j + 1 });
    this->Passes.storeNothing(i, j, width);
  };
  for (int row = 0; row < samples.window().height(); ++row)
  {
    this->paintRow(samples, primitives, row, memory, background, store, points);
  }
  this->shade(memory, store, points);
}

/// Computes the colours of the whole tile first, then the averages.
void Painting::paintAverages(
  const TileSamples& samples, const std::uint32_t* primitives, PaintingMemory& memory) const
{
  const Window& window = samples.window();
  const Window pixels = this->Target.target().pixelsOf(window);
  const int n = this->Target.target().samples;
  const int channelCount = this->Target.target().channels();
  TileColors& colors = memory.colors;
  colors.reset(window.width(), window.height(), channelCount);
  memory.isHit.assign(pixels.height(), 0);
  const auto store = [&](const SamplePiece& piece, const ChannelSpan& channels)
  {
    const int row = piece.j - window.j0;
    for (int channel = 0; channel < channelCount; ++channel)
    {
      std::copy_n(channels[channel], piece.width, colors.at(channel, piece.i - window.i0, row));
    }
    memory.isHit[row / n] = 1;
  };
  const auto background = [&](int i, int j, int width)
  {
    double* channels[4];
    for (int channel = 0; channel < channelCount; ++channel)
    {
      channels[channel] = colors.at(channel, i - window.i0, j - window.j0);
    }
    this->Target.background().fill(i, j, width, channels);
    if (channelCount == 4)
    {
      std::fill_n(channels[3], width, 0.0);
    }
  };
  for (int row = 0; row < window.height(); ++row)
  {
    this->paintRow(samples, primitives, row, memory, background, store);
  }
  this->shade(memory, store);
  for (int row = 0; row < pixels.height(); ++row)
  {
    const Window inRow{ pixels.i0, pixels.i1, pixels.j0 + row, pixels.j0 + row + 1 };
    memory.isHit[row] || this->Target.background().hasImage()
      ? this->Target.storeAverages(inRow, colors, n * row)
      : this->Target.storeBackground(inRow);
  }
}

/// Calls background(i, j, width) for pieces that hit nothing. Other pieces go to the batch.
template <typename BackgroundOf, typename StoreTo>
void Painting::paintRow(const TileSamples& samples, const std::uint32_t* primitives, int row,
  PaintingMemory& memory, const BackgroundOf& background, const StoreTo& store,
  PointBatch* points) const
{
  const Window& window = samples.window();
  const int j = window.j0 + row;
  const std::uint32_t* const hits = primitives + static_cast<std::size_t>(row) * samples.stride();
  for (int begin = 0; begin < window.width(); begin += SampleBatch::pieceSize)
  {
    const int i = window.i0 + begin;
    const int width = std::min(SampleBatch::pieceSize, window.width() - begin);
    if (!memory.batch.add({ i, j, width, samples.xs() + begin, samples.ys()[row] }, hits + begin))
    {
      background(i, j, width);
    }
    else if (memory.batch.isFull())
    {
      this->shade(memory, store, points);
    }
  }
}

/// Shades the batch, and calls store(piece, channels) for each piece. Stores passes, too, if there
/// is memory for surface points.
template <typename StoreTo>
void Painting::shade(PaintingMemory& memory, const StoreTo& store, PointBatch* points) const
{
  SampleBatch& batch = memory.batch;
  this->fillBackground(batch);
  this->Shades.shade(batch, memory.edges, points);
  for (int piece = 0; piece < batch.pieceCount; ++piece)
  {
    store(batch.pieces[piece],
      ChannelSpan{ batch.colors[0] + piece * SampleBatch::pieceSize, SampleBatch::places });
  }
  if (points)
  {
    this->Passes.store(batch, *points);
  }
  batch.clear();
}

/// Gives the samples of a piece that hit nothing the colour of the background.
void Painting::fillMissed(SampleBatch& batch, int number) const
{
  const SamplePiece& piece = batch.pieces[number];
  const int first = number * SampleBatch::pieceSize, end = first + piece.width;
  for (int begin = first, next = 0; begin < end; begin = next)
  {
    next = batch.endOfRun(begin, end);
    if (batch.primitives[batch.run[begin]] == noPrimitive)
    {
      double* const channels[3] = { batch.colors[0] + begin, batch.colors[1] + begin,
        batch.colors[2] + begin };
      this->Target.background().fill(piece.i + begin - first, piece.j, next - begin, channels);
    }
  }
}

/// Gives samples the colour of the background, and those that hit something alpha 1. A colour is
/// stored even where something is hit, if that is faster; an image's is not.
void Painting::fillBackground(SampleBatch& batch) const
{
  const Background& background = this->Target.background();
  for (int k = 0; k < batch.pieceCount; ++k)
  {
    if (!batch.hasMisses[k])
    {
      continue;
    }
    const SamplePiece& piece = batch.pieces[k];
    const int first = k * SampleBatch::pieceSize;
    if (background.hasImage())
    {
      this->fillMissed(batch, k);
      continue;
    }
    const Vec3& color = background.gradient(piece.j);
    for (int channel = 0; channel < 3; ++channel)
    {
      std::fill_n(
        batch.colors[channel] + first, SampleBatch::pieceSize, color[channel]); // of fixed size
    }
  }
  const int places = batch.pieceCount * SampleBatch::pieceSize;
  for (int place = 0; this->Target.target().hasAlpha && place < places; ++place)
  {
    batch.colors[3][place] = batch.isHit(place) ? 1.0 : 0.0;
  }
}
}
