// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write the pixels of a tile: the colour of what is hit, or the background
 *
 * paintPlainly() asks the Shader pixel by pixel and is the definition. paint() takes a
 * row piece by piece, which begin as background, and leaves the hits on each surface to
 * the kernel of ShadingKernel.h, which gives the same bits. Both also note which triangle
 * each pixel shows, if the image wants to know.
 */
#ifndef lambent_Painting_h
#define lambent_Painting_h

#include "Image.h"
#include "ShadeBatch.h"
#include "Shading.h"
#include "TileSamples.h"

#include <vector>

namespace lambent
{
class Painting
{
public:
  Painting(const Scene& scene, const SceneMesh& mesh, const Shader& shader, const Image& image);

  void paintPlainly(const TileSamples& rays) const;
  void paint(const TileSamples& rays, ShadeBatch& batch) const;
  void paintBackground(const Window& window) const;

private:
  /// Where a pixel of the image's part is stored.
  std::size_t pixel(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Target.part.width() + i;
  }
  /// The background's colour in a row of the image's part, as it is and as it is stored.
  struct Background
  {
    Vec3 color;
    unsigned char bytes[3];
    float floats[3];
  };
  Background backgroundOf(int j) const;
  void store(std::size_t pixel, const Vec3& color) const;
  void noteTriangles(const TileSamples& rays) const;
  void shade(ShadeBatch& batch) const;
  const SceneMesh::Part* nextRange(const ShadeBatch& batch, ShadeRange& range) const;
  static void fillHits(const Vec3& color, const ShadeRange& range, ShadeBatch& batch);
  void store(const ShadeBatch& batch, int piece) const;
  static void load(const SceneMesh::Part& part, const ShadeRange& range, ShadeBatch& batch);

  const Scene& Description;
  const SceneMesh& Mesh;
  const Shader& Shades;
  const Image Target;
  std::vector<Background> Backgrounds; ///< of each row of the part
};
}

#endif
