// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write the pixels of a cell: the colour of what is hit, or the background
 *
 * paintPlainly() asks the Shader pixel by pixel and is the definition. paint() fills
 * rows with the background, collects hits and leaves those on each surface to the kernel
 * of ShadingKernel.h, which gives the same bits. Both also note which triangle each pixel
 * shows, if the image wants to know.
 */
#ifndef lambent_Painting_h
#define lambent_Painting_h

#include "CellRays.h"
#include "Render.h"
#include "ShadeBatch.h"
#include "Shading.h"

namespace lambent
{
class Painting
{
public:
  Painting(const Scene& scene, const Mesh& mesh, const Shader& shader, const Image& image);

  void paintPlainly(const CellRays& rays) const;
  void paint(const CellRays& rays, ShadeBatch& batch) const;
  void paintBackground(const Window& window) const;

private:
  /// The background's colour in a row of the image's part.
  Vec3 background(int j) const;
  void store(std::size_t pixel, const Vec3& color) const;
  void noteTriangles(const CellRays& rays) const;
  void collect(const CellRays& rays, int row, int begin, int end, ShadeBatch& batch) const;
  void shade(ShadeBatch& batch) const;
  ShadeRange rangeFrom(
    const ShadeRange& last, const Mesh::Part& part, const ShadeBatch& batch) const;
  void store(const ShadeRange& range, const ShadeBatch& batch) const;
  static void load(const Mesh::Part& part, const ShadeRange& range, ShadeBatch& batch);

  const Scene& Description;
  const Mesh& Triangles;
  const Shader& Colors;
  const Image Target;
};
}

#endif
