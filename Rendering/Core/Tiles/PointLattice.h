// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief where points fall between the samples, in four bytes per point
 *
 * Along each axis, the position of a point is the number k of samples to the left of (or below) its
 * projection. Only the rays of samples from the smallest k of its three points up to, but not
 * including, the largest can hit a triangle. If all three have the same k, the triangle lies
 * between the samples. It is dropped after three small reads, without reading its coordinates
 * again.
 *
 * If a projection is so close to a sample that rounding could put it on either side, its position
 * is k or k + 1. The stored number is 2k, or 2k + 1 for "k or k + 1". The first sample of a
 * triangle is then min >> 1, and the end (max + 1) >> 1. Images too large for 15 bits are counted
 * in groups of 2^shift samples.
 *
 * The lattice may keep too many triangles, never too few: intersect() decides the hits. Its
 * bounding-box condition makes the range exact. The sign of a sheared vertex a.x - x a.w is right
 * except for the rounding of x a.w, which moves a projection by less than the margin below.
 */
#ifndef lambent_PointLattice_h
#define lambent_PointLattice_h

#include "CameraFrame.h"
#include "Nearness.h"
#include "Window.h"

#include <cstdint>

namespace lambent
{
struct LatticePosition
{
  std::uint16_t column, row;

  /// The point is at or behind the eye, or cannot be placed. Its triangles need another test.
  static constexpr std::uint16_t anywhere = 0xFFFF;
  /// A coordinate of the point is not finite. Its cells are not drawn.
  static constexpr std::uint16_t notFinite = 0xFFFE;
};

class PointLattice
{
public:
  struct Axis
  {
    double origin; ///< the image plane's origin, in samples from the first of the window
    double margin; ///< in samples
    int count;     ///< number of samples
  };

  PointLattice(const CameraFrame& frame, const Window& window);

  const CameraFrame& frame() const { return this->Frame; }
  double samplesPerUnit() const { return this->SamplesPerUnit; }
  const Axis& columns() const { return this->Columns; }
  const Axis& rows() const { return this->Rows; }
  int shift() const { return this->Shift; }

  LatticePosition locate(const Vec3& point) const;

  /// The largest difference, in samples, between the exact projection of a point on or near the
  /// image and that projection rounded to float.
  float screenError() const
  {
    const double largest = 64.0 + std::max(this->Columns.count, this->Rows.count);
    return static_cast<float>(std::ldexp(largest, -24) + this->Columns.margin + this->Rows.margin);
  }

  /// Whether positions are meaningful. They are not if the window lies so far from the centre of
  /// the image that rounding could move a position by a sample, or if the size of a pixel makes
  /// products of edge functions underflow or overflow.
  bool isPrecise() const
  {
    return this->Columns.margin < 0.25 && this->Rows.margin < 0.25 &&
      this->SamplesPerUnit > 1e-60 && this->Frame.pixel > smallestPixel;
  }

  /// The samples whose rays can hit a triangle with points at a, b and c, none of which is
  /// "anywhere" or "not finite".
  Window samplesBetween(LatticePosition a, LatticePosition b, LatticePosition c) const
  {
    return this->samplesFrom(
      { static_cast<std::uint16_t>(std::min(a.column, std::min(b.column, c.column)) >> 1),
        static_cast<std::uint16_t>(std::min(a.row, std::min(b.row, c.row)) >> 1) },
      { static_cast<std::uint16_t>((std::max(a.column, std::max(b.column, c.column)) + 1) >> 1),
        static_cast<std::uint16_t>((std::max(a.row, std::max(b.row, c.row)) + 1) >> 1) });
  }

  /// The samples of the groups from first up to, but not including, end.
  Window samplesFrom(LatticePosition first, LatticePosition end) const
  {
    if (this->Shift == 0)
    {
      return { first.column, end.column, first.row, end.row };
    }
    return { first.column << this->Shift, std::min(end.column << this->Shift, this->Columns.count),
      first.row << this->Shift, std::min(end.row << this->Shift, this->Rows.count) };
  }

  /// Whether samplesBetween() gives exactly the samples that pass the box test of intersect(): no
  /// position is "k or k + 1", and samples are not grouped.
  bool isExact(LatticePosition a, LatticePosition b, LatticePosition c) const
  {
    return this->Shift == 0 && !((a.column | b.column | c.column | a.row | b.row | c.row) & 1);
  }

private:
  static std::uint16_t position(const Axis& axis, double u, int shift);

  CameraFrame Frame;
  double SamplesPerUnit;
  Axis Columns, Rows;
  int Shift = 0;
};
}

#endif
