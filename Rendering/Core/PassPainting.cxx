// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassPainting.h"

#include "FillKernel.h"
#include "PassStore.h"
#include "PassTable.h"
#include "PointKernel.h"

#include <algorithm>

namespace lambent
{
void PassPainting::storeNothing(int i, int j, int count) const
{
  for (const Pass& pass : this->Target.passes)
  {
    lambent::storeNothing(pass, this->pixel(i, j), count);
  }
}

void PassPainting::paintNothing(const Window& samples) const
{
  const int n = this->Target.samples;
  const std::size_t width = samples.width() / n;
  for (const Pass& pass : this->Target.passes)
  {
    for (int j = samples.j0 / n; j < samples.j1 / n; ++j)
    {
      atPixel(pass, this->pixel(samples.i0 / n, j),
        [&](auto* to) { fillWithNaN(to, width * pass.components); });
    }
  }
  finishFilling();
}

/// Component k of a pass at a surface point.
double PassPainting::value(
  const Pass& pass, const SurfacePoint& point, std::uint32_t primitive, int k) const
{
  if (const PassEntry* const entry = entryOf(pass.content))
  {
    return entry->valueAt(point, this->Points.eye(), k);
  }
  return this->Points.attribute(primitive, point.weights, pass.attribute, k);
}

void PassPainting::paintPlainly(const TileSamples& samples, const std::uint32_t* primitives) const
{
  const Window& window = samples.window();
  const int n = this->Target.samples;
  for (int j = n / 2; j < window.height(); j += n)
  {
    for (int i = n / 2; i < window.width(); i += n)
    {
      const int column = (window.i0 + i) / n, row = (window.j0 + j) / n;
      const std::uint32_t primitive =
        primitives[static_cast<std::size_t>(j) * samples.stride() + i];
      if (primitive == noPrimitive)
      {
        this->storeNothing(column, row, 1);
        continue;
      }
      const SurfacePoint point = this->Points.at(primitive, samples.xs()[i], samples.ys()[j]);
      for (const Pass& pass : this->Target.passes)
      {
        for (int k = 0; k < pass.components; ++k)
        {
          storeValue(pass, this->pixel(column, row), k, this->value(pass, point, primitive, k));
        }
      }
    }
  }
}

/// Splits the middle rows of samples into pieces of middle samples.
void PassPainting::paint(
  const TileSamples& samples, const std::uint32_t* primitives, PassMemory& memory) const
{
  constexpr int size = SampleBatch::pieceSize;
  const Window& window = samples.window();
  const int n = this->Target.samples;
  SampleBatch& batch = memory.batch;
  for (int j = n / 2; j < window.height(); j += n)
  {
    const std::uint32_t* const row = primitives + static_cast<std::size_t>(j) * samples.stride();
    const int columns = window.width() / n;
    for (int begin = 0; begin < columns; begin += size)
    {
      const int count = std::min(size, columns - begin);
      double* const xs = memory.xs + batch.pieceCount * size;
      for (int i = 0; i < count; ++i)
      {
        memory.hits[i] = row[(begin + i) * n + n / 2];
        xs[i] = samples.xs()[(begin + i) * n + n / 2];
      }
      const SamplePiece piece{ window.i0 / n + begin, (window.j0 + j) / n, count, xs,
        samples.ys()[j] };
      if (!batch.add(piece, memory.hits))
      {
        this->storeNothing(piece.i, piece.j, count);
      }
      else if (batch.isFull())
      {
        this->flush(memory);
      }
    }
  }
  this->flush(memory);
}

void PassPainting::flush(PassMemory& memory) const
{
  SampleBatch& batch = memory.batch;
  RunRange range;
  while (range.moveOn(this->Points.mesh(), batch))
  {
    computePoints(this->Points, range, batch, memory.points);
  }
  this->store(batch, memory.points);
  batch.clear();
}

void PassPainting::store(const SampleBatch& batch, const PointBatch& points) const
{
  for (const Pass& pass : this->Target.passes)
  {
    for (int piece = 0; piece < batch.pieceCount; ++piece)
    {
      this->store(pass, batch, points, piece);
    }
  }
}

/// Stores a piece of a pass.
void PassPainting::store(
  const Pass& pass, const SampleBatch& batch, const PointBatch& points, int piece) const
{
  if (const PassEntry* const entry = entryOf(pass.content))
  {
    const double* values[PassEntry::mostComponents];
    for (int k = 0; k < entry->components; ++k)
    {
      values[k] = entry->valuesIn(points, k);
    }
    this->store(pass, batch, piece, [&](int place, int k) { return values[k][place]; });
    return;
  }
  this->storeAttribute(pass, batch, points, piece);
}

/// Stores a piece of an attribute. Looks up the surface, the corners and the type of the values
/// once for each run.
void PassPainting::storeAttribute(
  const Pass& pass, const SampleBatch& batch, const PointBatch& points, int number) const
{
  const SamplePiece& piece = batch.pieces[number];
  const int first = number * SampleBatch::pieceSize, end = first + piece.width;
  for (int begin = first, next = 0; begin < end; begin = next)
  {
    next = batch.endOfRun(begin, end);
    const std::int64_t run = batch.run[begin];
    const std::size_t pixel = this->pixel(piece.i + begin - first, piece.j);
    const std::uint32_t primitive = batch.primitives[run];
    const AttributeSpan* const values =
      primitive == noPrimitive ? nullptr : batch.parts[run]->surface->attribute(pass.attribute);
    if (!values)
    {
      lambent::storeNothing(pass, pixel, next - begin);
      continue;
    }
    const auto places = [&](const auto& valueOf)
    {
      atPixel(pass, pixel,
        [&](auto* to)
        {
          using Value = std::remove_pointer_t<decltype(to)>;
          for (int place = begin; place < next; ++place)
          {
            for (int k = 0; k < pass.components; ++k)
            {
              *to++ = canonical<Value>(valueOf(place, k));
            }
          }
        });
    };
    this->Points.visitAttribute(*values, *batch.parts[run], primitive, points, places);
  }
}

/// valueOf(place, component): the value at a sample that hits something.
template <typename ValueOf>
void PassPainting::store(
  const Pass& pass, const SampleBatch& batch, int number, const ValueOf& valueOf) const
{
  const SamplePiece& piece = batch.pieces[number];
  atPixel(pass, this->pixel(piece.i, piece.j),
    [&](auto* to)
    {
      using Value = std::remove_pointer_t<decltype(to)>;
      const int first = number * SampleBatch::pieceSize;
      for (int place = first; place < first + piece.width; ++place)
      {
        const bool isHit = batch.isHit(place);
        for (int k = 0; k < pass.components; ++k)
        {
          *to++ =
            isHit ? canonical<Value>(valueOf(place, k)) : std::numeric_limits<Value>::quiet_NaN();
        }
      }
    });
}
}
