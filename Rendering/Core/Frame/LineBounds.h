// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief where on the image plane rays can hit a line
 *
 * Coordinates e are those of intersectLine(): from the first end, in half widths. A ray that hits
 * is at most 1 away from a point t d of the segment, except for rounding: with u = 2^-53, e errs by
 * 3 u |e|, t d by u |d| and the squares by 3 u. Since |e| is not more than |d| + 1, all that is
 * less than
 *
 *     slack = 2^-46 (1 + |dx| + |dy|)
 *
 * on each axis. So the ray lies in the box of the segment, 1 + slack larger on each side, and in
 * the strip |ex dy - ey dx| <= |d| (1 + slack) + slack, which bounds ex in each row.
 */
#ifndef lambent_LineBounds_h
#define lambent_LineBounds_h

#include "LineContract.h"

namespace lambent
{
struct Interval
{
  double low, high;
};

class LineBounds
{
public:
  explicit LineBounds(const Line& line)
    : Ends(line)
    , Slack((1.0 + std::fabs(line.dx) + std::fabs(line.dy)) * (1.0 / (std::int64_t(1) << 46)))
    , Columns(this->around(line.dx))
    , Rows(this->around(line.dy))
    , Reach(std::sqrt(line.dx * line.dx + line.dy * line.dy) * (1.0 + this->Slack) + this->Slack)
    , PerRow(1.0 / line.dy)
  {
  }

  /// The bounds on the image plane.
  Interval x() const { return this->onPlane(this->Ends.x, this->Columns); }
  Interval y() const { return this->onPlane(this->Ends.y, this->Rows); }

  /// The bounds along the row y of the image plane, without those of x(). Infinite or NaN if they
  /// are none.
  Interval inRow(double y) const
  {
    const double middle = (y - this->Ends.y) * this->Ends.perHalf * this->Ends.dx;
    const double one = (middle - this->Reach) * this->PerRow;
    const double other = (middle + this->Reach) * this->PerRow;
    return this->onPlane(
      this->Ends.x, { std::min(one, other) - this->Slack, std::max(one, other) + this->Slack });
  }
  /// How far they move along x from row to row, for each unit of y.
  double slope() const { return this->Ends.dx * this->PerRow; }

  /// Whether no ray through the rectangle can hit.
  bool misses(const Interval& x, const Interval& y) const
  {
    const double ex = (0.5 * (x.low + x.high) - this->Ends.x) * this->Ends.perHalf;
    const double ey = (0.5 * (y.low + y.high) - this->Ends.y) * this->Ends.perHalf;
    const double width = (1.0 + this->Slack) + 0.5 * (x.high - x.low) * this->Ends.perHalf;
    const double height = (1.0 + this->Slack) + 0.5 * (y.high - y.low) * this->Ends.perHalf;
    const double dx = std::fabs(this->Ends.dx), dy = std::fabs(this->Ends.dy);
    return std::fabs(ex * this->Ends.dy - ey * this->Ends.dx) >
      this->Reach + (dx * height + dy * width);
  }

  /// Not more than the depth of any hit.
  double nearest() const
  {
    constexpr double margin = 1.0 / (std::int64_t(1) << 40);
    const double z = std::min(this->Ends.az, this->Ends.bz), bulge = this->Ends.bulge;
    return this->Ends.parallel ? (z - bulge) - margin * (std::fabs(z) + bulge)
                               : z * (1.0 - bulge) * (1.0 - margin);
  }

private:
  Interval around(double d) const
  {
    const double more = 1.0 + this->Slack;
    return { std::min(d, 0.0) - more, std::max(d, 0.0) + more };
  }

  Interval onPlane(double first, const Interval& e) const
  {
    const auto error = [first](double offset)
    { return (std::fabs(first) + std::fabs(offset)) * (1.0 / (std::int64_t(1) << 50)); };
    const double low = e.low * this->Ends.half, high = e.high * this->Ends.half;
    return { (first + low) - error(low), (first + high) + error(high) };
  }

  const Line& Ends;
  double Slack;
  Interval Columns, Rows; ///< in half widths
  double Reach;           ///< half the width of the strip, times |d|
  double PerRow;
};
}

#endif
