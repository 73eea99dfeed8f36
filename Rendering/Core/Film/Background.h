// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colours of samples that hit nothing
 *
 * Without an image, the colour changes linearly with the height of the sample, from the scene's
 * background at the bottom edge to its backgroundTop at the top edge.
 *
 * An image of w x h pixels is stretched to the picture of W x H pixels. Sample (i, j) of n W x n H
 * lies at
 *
 *     x = (i + 1/2) w / (n W) - 1/2,    y = (j + 1/2) h / (n H) - 1/2
 *
 * between the centres of the image's pixels, clamped to [0, w - 1] and [0, h - 1]. Its colour is
 * interpolated linearly, first along the rows, then between them. So an image of the size of the
 * picture is reproduced exactly if n = 1. A pixel that has alpha is blended with the gradient
 * first. If its alpha is 0, it is the gradient, even if its colour is infinite or NaN.
 *
 * If the picture has alpha, it has no background: all samples are 0.
 */
#ifndef lambent_Background_h
#define lambent_Background_h

#include "Image.h"
#include "Scene.h"

#include <vector>

namespace lambent
{
class Background
{
public:
  Background(const Scene& scene, const Image& image);

  bool hasImage() const { return static_cast<bool>(this->Behind.pixels); }

  /// The colour of a row of samples of the image's part, without the image.
  const Vec3& gradient(int j) const { return this->Gradient[j]; }
  /// The colour of a sample. This is the definition.
  Vec3 at(int i, int j) const;
  /// Stores the colours of `count` samples of a row in three channels.
  void fill(int i, int j, int count, double* const* channels) const;

private:
  /// Two neighbouring rows or columns of the image, and the weight of the second.
  struct Neighbours
  {
    int first, second;
    double fraction;
  };
  static std::vector<Neighbours> neighbours(int begin, int end, int samples, int pixels);
  struct PixelRow;
  Vec3 pixel(int column, int row, const Vec3& base) const;
  void fillFew(int i, int j, int count, double* const* channels) const;
  void read(int column, int row, int count, const Vec3& base, PixelRow& to) const;

  BackgroundImage Behind;
  std::vector<Vec3> Gradient; ///< one per row of samples of the part
  std::vector<Neighbours> Columns, Rows;
  std::vector<double> FromByte; ///< the values of bytes
};
}

#endif
