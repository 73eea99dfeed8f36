// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an image that covers a surface, and its colour at a place
 *
 * 1. A matrix transforms the texture coordinates (u, v) to (s, t).
 * 2. The image covers the unit square, its first pixel in the corner (0, 0): the middle of pixel
 *    (i, j) of a w x h image lies at s = (i + 1/2) / w, t = (j + 1/2) / h, as in OpenGL.
 * 3. Without interpolation, the colour is that of pixel floor(s w), floor(t h). With it, two rows
 * of two pixels around (s w - 1/2, t h - 1/2) are interpolated, first along the rows, then between
 *    them, as a + (b - a) x.
 * 4. Pixels that do not exist are replaced as the wrapping says.
 *
 * There are no smaller versions of the image (mip maps). Where a pixel of the picture covers many
 * pixels of the texture, use several samples per pixel, which are averaged.
 *
 * A coordinate that is NaN or infinite, or becomes it in step 1 or 3, selects the first row or
 * column, or the border if there is one.
 */
#ifndef lambent_Texture_h
#define lambent_Texture_h

#include "Arithmetic.h"
#include "AttributeSpan.h"

namespace lambent
{
/// What is beyond the edges of a texture's image.
enum class TextureWrap : unsigned char
{
  ClampToEdge,    ///< the pixels at the edge
  Repeat,         ///< the image again
  MirroredRepeat, ///< the image again, every other time mirrored
  ClampToBorder   ///< one colour
};

/// The colour of a texture, by which the colour of the surface is multiplied.
struct TextureColor
{
  Vec3 color{ 1.0 };
  double alpha = 1.0; ///< straight
};

struct Texture
{
  /// One tuple per pixel, rows from the bottom: grey, grey and alpha, RGB or RGBA. UInt8 and UInt16
  /// are fractions of 255 and 65535, Float is used as it is; there are no other types.
  AttributeSpan pixels;
  int width = 0, height = 0; ///< at least 1
  TextureWrap wrap = TextureWrap::Repeat;
  bool isInterpolated = false;
  /// Whether bytes of colours, not of alpha, are in sRGB; they are decoded before interpolation.
  bool isSRGB = false;
  TextureColor border{ Vec3(0.0), 0.0 };
  /// Whether alpha multiplies the opacity of the surface. Otherwise it is ignored.
  bool hasAlpha = false;
  /// The rows of the matrix: s = (m0 u + m1 v) + m2, and t accordingly.
  double matrix[2][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };

  /// The colour at texture coordinates.
  TextureColor sample(double u, double v) const;

  /// Whether some pixel has an alpha other than 1. As in VTK, that of the border alone does not
  /// make a texture transparent.
  bool isAnyTransparent() const;
};

/// A texture on a surface of triangles.
struct TextureMap
{
  Texture texture;
  /// Of the points, which are interpolated with barycentric coordinates: u, or u and v, or more, of
  /// which the first two are used. A missing v is 0.
  AttributeSpan coordinates;
};

/// The linear value of a byte in sRGB: x / 12.92 up to x = 0.04045, then ((x + 0.055) / 1.055)^2.4
/// (IEC 61966-2-1), with x = byte / 255 and the power of Elementary.h.
double decodeSRGB(unsigned char byte);
}

#endif
