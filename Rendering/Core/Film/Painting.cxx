// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

#include "ShadingKernel.h"

#include <hwy/cache_control.h>

#include <cstring>

namespace lambent
{
namespace
{
template <typename Channel>
void repeat(const Channel (&color)[3], int count, Channel* out)
{
  // Bits are compared: 0 equals -0, but is not the same.
  if (std::memcmp(color, color + 1, 2 * sizeof(Channel)) == 0)
  {
    std::fill_n(out, 3 * count, color[0]);
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    std::copy_n(color, 3, out + 3 * i);
  }
}
}

Painting::Painting(
  const Scene& scene, const SceneMesh& mesh, const Shader& shader, const Image& image)
  : Description(scene)
  , Mesh(mesh)
  , Shades(shader)
  , Target(image)
{
  this->Backgrounds.reserve(image.part.height());
  for (int j = 0; j < image.part.height(); ++j)
  {
    this->Backgrounds.push_back(this->backgroundOf(j));
  }
}

void Painting::paintPlainly(const TileSamples& rays) const
{
  const Window& window = rays.window();
  for (int j = 0; j < window.height(); ++j)
  {
    const Vec3& background = this->Backgrounds[window.j0 + j].color;
    for (int i = 0; i < window.width(); ++i)
    {
      const std::uint32_t triangle =
        rays.triangles()[static_cast<std::size_t>(j) * rays.stride() + i];
      this->store(this->pixel(window.i0 + i, window.j0 + j),
        triangle == noTriangle ? background
                               : this->Shades.color(triangle, rays.xs()[i], rays.ys()[j]));
    }
  }
  this->noteTriangles(rays);
}

void Painting::paint(const TileSamples& rays, ShadeBatch& batch) const
{
  const Window& window = rays.window();
  for (int row = 0; row < window.height(); ++row)
  {
    const int j = window.j0 + row;
    const std::uint32_t* const hits =
      rays.triangles() + static_cast<std::size_t>(row) * rays.stride();
    for (int begin = 0; begin < window.width(); begin += ShadeBatch::pieceSize)
    {
      const int i = window.i0 + begin;
      const int width = std::min(ShadeBatch::pieceSize, window.width() - begin);
      if (!batch.add({ i, j, width, rays.xs() + begin, rays.ys()[row] }, hits + begin))
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
  this->noteTriangles(rays);
}

void Painting::noteTriangles(const TileSamples& rays) const
{
  const Window& window = rays.window();
  for (int row = 0; this->Target.triangles && row < window.height(); ++row)
  {
    std::copy_n(rays.triangles() + static_cast<std::size_t>(row) * rays.stride(), window.width(),
      this->Target.triangles + this->pixel(window.i0, window.j0 + row));
  }
}

Painting::Background Painting::backgroundOf(int j) const
{
  const Vec3& bottom = this->Description.background;
  const Vec3& top = this->Description.backgroundTop;
  const int row = this->Target.part.j0 + j;
  Background result;
  result.color = bottom + (top - bottom) * ((row + 0.5) / this->Target.height);
  for (int channel = 0; channel < 3; ++channel)
  {
    result.bytes[channel] = toByte(result.color[channel]);
    result.floats[channel] = toFloat(result.color[channel]);
  }
  return result;
}

void Painting::paintBackground(const Window& window) const
{
  for (int j = window.j0; j < window.j1; ++j)
  {
    const std::size_t first = this->pixel(window.i0, j);
    if (this->Target.triangles)
    {
      std::fill_n(this->Target.triangles + first, window.width(), noTriangle);
    }
    const Background& background = this->Backgrounds[j];
    if (this->Target.bytes)
    {
      repeat(background.bytes, window.width(), this->Target.bytes + 3 * first);
    }
    else
    {
      repeat(background.floats, window.width(), this->Target.floats + 3 * first);
    }
  }
}

void Painting::store(std::size_t pixel, const Vec3& color) const
{
  for (int channel = 0; channel < 3; ++channel)
  {
    if (this->Target.bytes)
    {
      this->Target.bytes[3 * pixel + channel] = toByte(color[channel]);
    }
    else
    {
      this->Target.floats[3 * pixel + channel] = toFloat(color[channel]);
    }
  }
}

void Painting::shade(ShadeBatch& batch) const
{
  for (int piece = 0; piece < batch.pieceCount; ++piece)
  {
    const Vec3& color = this->Backgrounds[batch.pieces[piece].j].color;
    for (int channel = 0; channel < 3; ++channel)
    {
      std::fill_n(batch.colors[channel] + piece * ShadeBatch::pieceSize, ShadeBatch::pieceSize,
        color[channel]);
    }
  }
  ShadeRange range;
  while (const SceneMesh::Part* const part = this->nextRange(batch, range))
  {
    const Surface& surface = *part->surface;
    if (surface.material.shading == Shading::Unlit)
    {
      fillHits(surface.material.color, range, batch);
      continue;
    }
    load(*part, range, batch);
    shadeHits(this->Shades, surface.material, surface.isSmooth(), range, batch);
  }
  for (int piece = 0; piece < batch.pieceCount; ++piece)
  {
    this->store(batch, piece);
  }
  batch.clear();
}

/// Moves the range on to the runs after it up to those that hit another part; gives the
/// part, or none where no run is left that hits anything.
const SceneMesh::Part* Painting::nextRange(const ShadeBatch& batch, ShadeRange& range) const
{
  const SceneMesh::Part* part = nullptr;
  range.firstRun = range.endRun;
  for (; range.endRun < batch.runCount; ++range.endRun)
  {
    const std::uint32_t triangle = batch.triangles[range.endRun];
    if (triangle != noTriangle && !(part && part->holds(triangle)))
    {
      if (part)
      {
        break;
      }
      part = &this->Mesh.partOf(triangle);
    }
  }
  const auto* const places = batch.run + batch.pieceCount * ShadeBatch::pieceSize;
  range.first = range.end;
  range.end =
    static_cast<int>(std::lower_bound(batch.run + range.first, places, range.endRun) - batch.run);
  return part;
}

void Painting::fillHits(const Vec3& color, const ShadeRange& range, ShadeBatch& batch)
{
  for (int place = range.first; place < range.end; ++place)
  {
    if (batch.triangles[batch.run[place]] != noTriangle)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        batch.colors[channel][place] = color[channel];
      }
    }
  }
}

void Painting::store(const ShadeBatch& batch, int piece) const
{
  const RayPiece& rays = batch.pieces[piece];
  const std::size_t first = 3 * this->pixel(rays.i, rays.j);
  if (this->Target.bytes)
  {
    storeBytes(batch, piece, this->Target.bytes + first);
    return;
  }
  float* const out = this->Target.floats + first;
  for (int i = 0; i < rays.width; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      out[3 * i + channel] = toFloat(batch.colors[channel][piece * ShadeBatch::pieceSize + i]);
    }
  }
}

// Points and normals lie anywhere in memory: first ask for all of them, then read.
void Painting::load(const SceneMesh::Part& part, const ShadeRange& range, ShadeBatch& batch)
{
  const Surface& surface = *part.surface;
  const bool smooth = surface.isSmooth();
  const bool hasNumbers = smooth && surface.normalNumbers.data;
  int runs[ShadeBatch::places];
  int count = 0;
  std::fill_n(batch.isWanted, batch.runCount, 0.0);
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.triangles[run] != noTriangle)
    {
      batch.isWanted[run] = 1.0;
      runs[count++] = run;
      hwy::Prefetch(surface.corners.at(3 * (batch.triangles[run] - part.firstTriangle)));
      if (hasNumbers)
      {
        hwy::Prefetch(surface.normalNumbers.at(3 * (batch.triangles[run] - part.firstTriangle)));
      }
    }
  }
  std::uint64_t corners[ShadeBatch::places][3];
  std::uint64_t numbers[ShadeBatch::places][3];
  const auto& normals = hasNumbers ? numbers : corners;
  for (int k = 0; k < count; ++k)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t triangle = batch.triangles[runs[k]] - part.firstTriangle;
      corners[k][corner] = surface.corners[3 * triangle + corner];
      hwy::Prefetch(surface.points.at(corners[k][corner]));
      if (hasNumbers)
      {
        numbers[k][corner] = surface.normalNumbers[3 * triangle + corner];
      }
      if (smooth)
      {
        hwy::Prefetch(surface.pointNormals.at(normals[k][corner]));
      }
    }
  }
  const auto put = [](double(*rows)[ShadeBatch::room], int run, const Vec3& v)
  {
    rows[0][run] = v.x;
    rows[1][run] = v.y;
    rows[2][run] = v.z;
  };
  for (int k = 0; k < count; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      put(batch.points + 3 * corner, runs[k], surface.points[corners[k][corner]]);
      if (smooth)
      {
        put(batch.normals + 3 * corner, runs[k], surface.pointNormals[normals[k][corner]]);
      }
    }
    if (!smooth)
    {
      put(batch.normals, runs[k],
        Shader::faceNormal(surface, batch.triangles[runs[k]] - part.firstTriangle));
    }
  }
}
}
