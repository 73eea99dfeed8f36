// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerPainting.h"

#include <algorithm>

namespace lambent
{
/// The colour of a sample. Also stores the primitive that it sees.
FilmColor LayerPainting::sampleColor(
  const TileSamples& samples, int i, int j, LayerMemory& memory) const
{
  const std::size_t sample = static_cast<std::size_t>(j) * samples.stride() + i;
  const FilmColor missed = this->Target.missed(samples.window().i0 + i, samples.window().j0 + j);
  std::uint32_t& seen = memory.primitives[sample];
  Vec3 color(0.0);
  double transmittance = 1.0;
  for (std::uint32_t k = 0; transmittance > 0.0 && k < memory.sorted.count(sample); ++k)
  {
    const std::uint32_t primitive = memory.sorted.primitive(sample, k);
    const double x = samples.xs()[i], y = samples.ys()[j];
    const SurfacePoint point = this->Points.at(primitive, x, y);
    const double opacity = point.opacity();
    if (opacity > 0.0)
    {
      seen = seen == noPrimitive ? primitive : seen;
      color += this->Shades.color(primitive, x, y, point) * (transmittance * opacity);
      transmittance = transmittance * (1.0 - opacity);
    }
  }
  if (seen == noPrimitive)
  {
    return missed;
  }
  return { transmittance > 0.0 ? color + missed.color * transmittance : color,
    this->Target.target().hasAlpha ? 1.0 - transmittance : 1.0 };
}

void LayerPainting::paintPlainly(const TileSamples& samples, LayerMemory& memory) const
{
  const Window pixels = this->Target.target().pixelsOf(samples.window());
  const int n = this->Target.target().samples;
  memory.primitives.assign(samples.size(), noPrimitive);
  for (int j = 0; j < pixels.height(); ++j)
  {
    for (int i = 0; i < pixels.width(); ++i)
    {
      this->Target.storeColor(pixels.i0 + i, pixels.j0 + j,
        Film::average(n,
          [&](int column, int row)
          { return this->sampleColor(samples, n * i + column, n * j + row, memory); }));
    }
  }
  this->Target.storePrimitives(pixels, memory.primitives.data(), samples.stride());
  this->Passes.paintPlainly(samples, memory.primitives.data());
}

void LayerPainting::paint(const TileSamples& samples, LayerMemory& memory) const
{
  this->begin(samples, memory);
  for (std::uint32_t layer = 0; this->paintLayer(samples, layer, memory); ++layer)
  {
  }
  this->addBackground(samples, memory);
  this->finish(samples, memory);
}

void LayerPainting::begin(const TileSamples& samples, LayerMemory& memory) const
{
  const Window& window = samples.window();
  SampleShading::begin(samples, memory.edges);
  memory.colors.reset(window.width(), window.height(), 4);
  memory.primitives.assign(samples.size(), noPrimitive);
  memory.rowCounts.assign(window.height(), 0);
  for (int j = 0; j < window.height(); ++j)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      std::fill_n(memory.colors.at(channel, 0, j), window.width(), channel < 3 ? 0.0 : 1.0);
    }
    for (int i = 0; i < window.width(); ++i)
    {
      memory.rowCounts[j] = std::max(memory.rowCounts[j],
        memory.sorted.count(static_cast<std::size_t>(j) * samples.stride() + i));
    }
  }
}

/// Paints the hits with this number of all samples that still let light through. Returns false if
/// there are none.
bool LayerPainting::paintLayer(
  const TileSamples& samples, std::uint32_t layer, LayerMemory& memory) const
{
  constexpr int size = SampleBatch::pieceSize;
  const Window& window = samples.window();
  std::uint32_t hits[size];
  bool isAnyHit = false;
  for (int j = 0; j < window.height(); ++j)
  {
    for (int begin = 0; layer < memory.rowCounts[j] && begin < window.width(); begin += size)
    {
      const int width = std::min(size, window.width() - begin);
      const std::size_t first = static_cast<std::size_t>(j) * samples.stride() + begin;
      const double* const transmittances = memory.colors.at(3, begin, j);
      for (int i = 0; i < width; ++i)
      {
        const bool isHit = layer < memory.sorted.count(first + i) && transmittances[i] > 0.0;
        hits[i] = isHit ? memory.sorted.primitive(first + i, layer) : noPrimitive;
      }
      if (memory.batch.add({ begin, j, width, samples.xs() + begin, samples.ys()[j] }, hits))
      {
        isAnyHit = true;
        if (memory.batch.isFull())
        {
          this->flush(samples, memory);
        }
      }
    }
  }
  this->flush(samples, memory);
  return isAnyHit;
}

/// Shades the batch, and composites its samples.
void LayerPainting::flush(const TileSamples& samples, LayerMemory& memory) const
{
  SampleBatch& batch = memory.batch;
  this->Shades.shade(
    batch, memory.edges, this->Points.mesh().hasVaryingOpacity() ? &memory.points : nullptr);
  for (int k = 0; k < batch.pieceCount; ++k)
  {
    const SamplePiece& piece = batch.pieces[k];
    std::uint32_t* const seen =
      memory.primitives.data() + static_cast<std::size_t>(piece.j) * samples.stride() + piece.i;
    double* channels[4];
    for (int channel = 0; channel < 4; ++channel)
    {
      channels[channel] = memory.colors.at(channel, piece.i, piece.j);
    }
    const int first = k * SampleBatch::pieceSize;
    for (int begin = 0, next = 0; begin < piece.width; begin = next)
    {
      next = batch.endOfRun(first + begin, first + piece.width) - first;
      const std::int64_t run = batch.run[first + begin];
      const std::uint32_t primitive = batch.primitives[run];
      if (primitive == noPrimitive)
      {
        continue;
      }
      const bool isConstant = hasConstantOpacity(*batch.parts[run]);
      double opacity = opacityAt(batch, memory.points, first + begin);
      for (int i = begin; i < next; ++i)
      {
        opacity = isConstant ? opacity : opacityAt(batch, memory.points, first + i);
        // Where it is 0, nothing changes.
        seen[i] = seen[i] == noPrimitive && opacity > 0.0 ? primitive : seen[i];
        const double weight = channels[3][i] * opacity;
        for (int channel = 0; channel < 3 && opacity > 0.0; ++channel)
        {
          channels[channel][i] += batch.colors[channel][first + i] * weight;
        }
        channels[3][i] = channels[3][i] * (1.0 - opacity);
      }
    }
  }
  batch.clear();
}

/// Turns C and T into colours and alpha.
void LayerPainting::addBackground(const TileSamples& samples, LayerMemory& memory) const
{
  constexpr int size = SampleBatch::pieceSize;
  const Window& window = samples.window();
  const bool hasAlpha = this->Target.target().hasAlpha;
  double behind[3][size];
  double* const behindChannels[3] = { behind[0], behind[1], behind[2] };
  for (int j = 0; j < window.height(); ++j)
  {
    for (int begin = 0; begin < window.width(); begin += size)
    {
      const int width = std::min(size, window.width() - begin);
      const std::uint32_t* const seen =
        memory.primitives.data() + static_cast<std::size_t>(j) * samples.stride() + begin;
      double* const transmittances = memory.colors.at(3, begin, j);
      this->Target.background().fill(window.i0 + begin, window.j0 + j, width, behindChannels);
      for (int channel = 0; channel < 3; ++channel)
      {
        double* const colors = memory.colors.at(channel, begin, j);
        for (int i = 0; i < width; ++i)
        {
          const double b = behind[channel][i], t = transmittances[i];
          colors[i] = seen[i] == noPrimitive ? b : t > 0.0 ? colors[i] + b * t : colors[i];
        }
      }
      for (int i = 0; i < width; ++i)
      {
        transmittances[i] = hasAlpha ? 1.0 - transmittances[i] : 1.0;
      }
    }
  }
}

void LayerPainting::finish(const TileSamples& samples, LayerMemory& memory) const
{
  const Window pixels = this->Target.target().pixelsOf(samples.window());
  this->Target.storeAverages(pixels, memory.colors, 0);
  this->Target.storePrimitives(pixels, memory.primitives.data(), samples.stride());
  if (this->Passes.isNeeded())
  {
    this->Passes.paint(samples, memory.primitives.data(), memory.passes);
  }
}
}
