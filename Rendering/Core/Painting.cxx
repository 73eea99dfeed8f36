// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

#include "ShadingKernel.h"

#include <hwy/cache_control.h>

namespace lambent
{
Painting::Painting(const Scene& scene, const Mesh& mesh, const Shader& shader, const Image& image)
  : Description(scene)
  , Triangles(mesh)
  , Colors(shader)
  , Target(image)
{
}

void Painting::paintPlainly(const CellRays& rays) const
{
  const Window& window = rays.window();
  for (int j = 0; j < window.height(); ++j)
  {
    const Vec3 background = this->background(window.j0 + j);
    for (int i = 0; i < window.width(); ++i)
    {
      const std::uint32_t triangle =
        rays.triangles()[static_cast<std::size_t>(j) * rays.stride() + i];
      const std::size_t pixel =
        static_cast<std::size_t>(window.j0 + j) * this->Target.part.width() + window.i0 + i;
      this->store(pixel,
        triangle == noTriangle ? background
                               : this->Colors.color(triangle, rays.xs()[i], rays.ys()[j]));
    }
  }
  this->noteTriangles(rays);
}

void Painting::paint(const CellRays& rays, ShadeBatch& batch) const
{
  constexpr int step = 32; // no more rays at a time than a batch has room for
  const Window& window = rays.window();
  this->paintBackground(window);
  for (int row = 0; row < window.height(); ++row)
  {
    for (int begin = 0; begin < window.width(); begin += step)
    {
      if (!batch.hasRoomFor(step))
      {
        this->shade(batch);
      }
      this->collect(rays, row, begin, std::min(begin + step, window.width()), batch);
    }
  }
  this->shade(batch);
  this->noteTriangles(rays);
}

/// Put the hits of some rays of a row into the batch. Whether a ray hits, and whether the
/// same triangle as the one before, is a toss-up: everything is written, without a branch,
/// and counted only if it is wanted.
void Painting::collect(const CellRays& rays, int row, int begin, int end, ShadeBatch& batch) const
{
  const Window& window = rays.window();
  const std::uint32_t* const triangles =
    rays.triangles() + static_cast<std::size_t>(row) * rays.stride();
  const double* const xs = rays.xs();
  const double y = rays.ys()[row];
  const std::size_t pixel =
    static_cast<std::size_t>(window.j0 + row) * this->Target.part.width() + window.i0;
  int count = batch.count, runs = batch.runs;
  std::uint32_t last = runs > 0 ? batch.triangles[runs - 1] : noTriangle;
  for (int i = begin; i < end; ++i)
  {
    const std::uint32_t triangle = triangles[i];
    const bool isHit = triangle != noTriangle;
    batch.triangles[runs] = triangle;
    runs += isHit && triangle != last;
    batch.pixels[count] = pixel + i;
    batch.run[count] = runs - 1;
    batch.x[count] = xs[i];
    batch.y[count] = y;
    count += isHit;
    last = isHit ? triangle : last;
  }
  batch.count = count;
  batch.runs = runs;
}

void Painting::noteTriangles(const CellRays& rays) const
{
  const Window& window = rays.window();
  for (int row = 0; this->Target.triangles && row < window.height(); ++row)
  {
    std::copy_n(rays.triangles() + static_cast<std::size_t>(row) * rays.stride(), window.width(),
      this->Target.triangles +
        static_cast<std::size_t>(window.j0 + row) * this->Target.part.width() + window.i0);
  }
}

Vec3 Painting::background(int j) const
{
  const Vec3& bottom = this->Description.background;
  const Vec3& top = this->Description.backgroundTop;
  const int row = this->Target.part.j0 + j;
  return bottom + (top - bottom) * ((row + 0.5) / this->Target.height);
}

void Painting::paintBackground(const Window& window) const
{
  for (int j = window.j0; j < window.j1; ++j)
  {
    const std::size_t row = static_cast<std::size_t>(j) * this->Target.part.width();
    if (this->Target.triangles)
    {
      std::fill_n(this->Target.triangles + row + window.i0, window.width(), noTriangle);
    }
    const Vec3 color = this->background(j);
    if (this->Target.bytes && toByte(color.x) == toByte(color.y) &&
      toByte(color.y) == toByte(color.z))
    {
      std::fill_n(this->Target.bytes + 3 * (row + window.i0), 3 * window.width(), toByte(color.x));
      continue;
    }
    for (int i = window.i0; i < window.i1; ++i)
    {
      this->store(row + i, color);
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
  if (batch.count == 0)
  {
    return;
  }
  batch.fillUp();
  for (ShadeRange range; range.end < batch.count;)
  {
    const Mesh::Part& part = this->Triangles.partOf(batch.triangles[range.endRun]);
    range = this->rangeFrom(range, part, batch);
    const Surface& surface = *part.surface;
    if (surface.material.shading == Shading::Unlit)
    {
      for (int k = range.first; k < range.end; ++k)
      {
        this->store(batch.pixels[k], surface.material.color);
      }
      continue;
    }
    load(part, range, batch);
    shadeHits(this->Colors, surface.material, surface.isSmooth(), range, batch);
    this->store(range, batch);
  }
  batch.clear();
}

/// What follows the last range and is on one part.
ShadeRange Painting::rangeFrom(
  const ShadeRange& last, const Mesh::Part& part, const ShadeBatch& batch) const
{
  ShadeRange range{ last.endRun, last.endRun + 1, last.end, batch.count };
  while (range.endRun < batch.runs && part.holds(batch.triangles[range.endRun]))
  {
    ++range.endRun;
  }
  if (range.endRun < batch.runs)
  {
    range.end = static_cast<int>(
      std::lower_bound(batch.run + range.first, batch.run + batch.count, range.endRun) - batch.run);
  }
  return range;
}

void Painting::store(const ShadeRange& range, const ShadeBatch& batch) const
{
  for (int k = range.first; k < range.end && this->Target.bytes; ++k)
  {
    unsigned char* const out = this->Target.bytes + 3 * batch.pixels[k];
    for (int channel = 0; channel < 3; ++channel)
    {
      out[channel] = static_cast<unsigned char>(batch.bytes[channel][k]);
    }
  }
  for (int k = range.first; k < range.end && this->Target.floats; ++k)
  {
    float* const out = this->Target.floats + 3 * batch.pixels[k];
    for (int channel = 0; channel < 3; ++channel)
    {
      out[channel] = toFloat(batch.colors[channel][k]);
    }
  }
}

// Points and normals lie anywhere in memory: first ask for all of them, then read.
void Painting::load(const Mesh::Part& part, const ShadeRange& range, ShadeBatch& batch)
{
  const Surface& surface = *part.surface;
  const bool smooth = surface.isSmooth();
  for (int k = range.firstRun; k < range.endRun; ++k)
  {
    hwy::Prefetch(surface.corners.at(3 * (batch.triangles[k] - part.firstTriangle)));
  }
  std::uint64_t corners[ShadeBatch::capacity][3];
  for (int k = range.firstRun; k < range.endRun; ++k)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t triangle = batch.triangles[k] - part.firstTriangle;
      corners[k][corner] = surface.corners[3 * triangle + corner];
      hwy::Prefetch(surface.points.at(corners[k][corner]));
      if (smooth)
      {
        hwy::Prefetch(surface.pointNormals.at(corners[k][corner]));
      }
    }
  }
  const auto put = [](double(*rows)[ShadeBatch::room], int k, const Vec3& v)
  {
    rows[0][k] = v.x;
    rows[1][k] = v.y;
    rows[2][k] = v.z;
  };
  for (int k = range.firstRun; k < range.endRun; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      put(batch.points + 3 * corner, k, surface.points[corners[k][corner]]);
      if (smooth)
      {
        put(batch.normals + 3 * corner, k, surface.pointNormals[corners[k][corner]]);
      }
    }
    if (!smooth)
    {
      put(batch.normals, k, Shader::faceNormal(surface, batch.triangles[k] - part.firstTriangle));
    }
  }
}
}
