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
}

void Painting::paint(const CellRays& rays, ShadeBatch& batch) const
{
  const Window& window = rays.window();
  this->paintBackground(window);
  const Mesh::Part* part = nullptr;
  std::uint32_t last = noTriangle; // the triangle of the current run
  for (int j = 0; j < window.height(); ++j)
  {
    const std::uint32_t* const triangles =
      rays.triangles() + static_cast<std::size_t>(j) * rays.stride();
    const double y = rays.ys()[j];
    const std::size_t row =
      static_cast<std::size_t>(window.j0 + j) * this->Target.part.width() + window.i0;
    for (int i = 0; i < window.width(); ++i)
    {
      if (triangles[i] == noTriangle)
      {
        continue;
      }
      if (triangles[i] != last || batch.isFull())
      {
        last = triangles[i];
        if (!part || !part->holds(last) || batch.isFull())
        {
          this->shade(part, batch);
          part = &this->Triangles.partOf(last);
        }
        batch.beginRun(last);
        hwy::Prefetch(part->surface->corners.at(3 * (last - part->firstTriangle)));
      }
      batch.add(row + i, rays.xs()[i], y);
    }
  }
  this->shade(part, batch);
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
      this->Target.floats[3 * pixel + channel] = static_cast<float>(color[channel]);
    }
  }
}

void Painting::shade(const Mesh::Part* part, ShadeBatch& batch) const
{
  if (batch.count == 0)
  {
    return;
  }
  const Material& material = part->surface->material;
  if (material.shading == Shading::Unlit)
  {
    for (int k = 0; k < batch.count; ++k)
    {
      this->store(batch.pixels[k], material.color);
    }
    batch.clear();
    return;
  }
  load(*part, batch);
  shadeBatch(this->Colors, material, part->surface->isSmooth(), batch);
  for (int k = 0; k < batch.count; ++k)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const std::size_t value = 3 * batch.pixels[k] + channel;
      if (this->Target.bytes)
      {
        this->Target.bytes[value] = static_cast<unsigned char>(batch.bytes[channel][k]);
      }
      else
      {
        this->Target.floats[value] = static_cast<float>(batch.colors[channel][k]);
      }
    }
  }
  batch.clear();
}

// Points and normals lie anywhere in memory: first ask for all of them, then read.
void Painting::load(const Mesh::Part& part, ShadeBatch& batch)
{
  const Surface& surface = *part.surface;
  const bool smooth = surface.isSmooth();
  std::uint64_t corners[ShadeBatch::capacity][3];
  for (int k = 0; k < batch.runs; ++k)
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
  const auto put = [](double(*rows)[ShadeBatch::capacity], int k, const Vec3& v)
  {
    rows[0][k] = v.x;
    rows[1][k] = v.y;
    rows[2][k] = v.z;
  };
  for (int k = 0; k < batch.runs; ++k)
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
