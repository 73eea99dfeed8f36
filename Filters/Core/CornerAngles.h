// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the angles at corners, from scalar and vector products
 *
 * The angle between two edges u and v has the tangent |u x v| / (u . v), so it is computed
 * as an arctangent. This is accurate even near 0 and pi, where an arc cosine is not, and
 * needs neither the edges' lengths nor their square roots.
 *
 * In a triangle |u x v| is the same at each corner. The smaller u . v, the larger the
 * angle. The two corners with the larger products have angles of at most pi / 2. The third
 * angle is pi minus their sum, and at least pi / 3. The two arctangents share one division,
 * of 1 by the product of their denominators.
 *
 * For the arctangent, (x, y) is first rotated back by the nearest of 0, pi/4 and pi/2.
 * A polynomial gives the remaining angle, at most pi/8.
 *
 * Accuracy: for exact x and y, 4 ulp for each angle of a triangle, 2 ulp for a single one.
 * The tests compare with 80-bit arithmetic.
 */
#ifndef lambent_CornerAngles_h
#define lambent_CornerAngles_h

#include <limits>

namespace lambent
{
constexpr double piHigh = 3.141592653589793;
constexpr double piLow = 1.2246467991473532e-16;
constexpr double tangentOfEighth = 0.41421356237309503; ///< tan(pi / 8)

/**
 * The coefficients of P in (atan(t) - t) / t^3 = P(t^2), for |t| <= tan(pi/8). P interpolates
 * the function at the 11 Chebyshev nodes of that range of t^2 (solved with 60 digits, then
 * rounded to binary64). The relative error of atan(t) is 2^-56.9.
 */
constexpr double arcTangentTail[] = { -0.3333333333333333, 0.1999999999999552, -0.14285714284666542,
  0.11111111015256361, -0.09090904578123903, 0.07692183190826087, -0.06664511447381948,
  0.0585814891280221, -0.0508544973794026, 0.03923165829558719, -0.01917688711906226 };

/// The direction (x, y), rotated back by `quarters` times pi/4 to within pi/8 of (1, 0). Its
/// length is not preserved.
struct TurnedBack
{
  double quarters, y, x;
};

/// Requires y >= 0; x may be slightly negative.
inline TurnedBack turnBack(double y, double x)
{
  if (y <= tangentOfEighth * x)
  {
    return { 0.0, y, x };
  }
  if (x <= tangentOfEighth * y)
  {
    return { 2.0, -x, y };
  }
  return { 1.0, y - x, y + x };
}

/// `quarters` times pi/4, plus the arctangent of t. The terms are paired (Estrin's scheme) so
/// that a processor can overlap them.
inline double turnForth(double quarters, double t)
{
  constexpr const double* c = arcTangentTail;
  const double z = t * t;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double low = ((c[0] + z * c[1]) + z2 * (c[2] + z * c[3])) +
    z4 * ((c[4] + z * c[5]) + z2 * (c[6] + z * c[7]));
  const double tail = low + (z4 * z4) * ((c[8] + z * c[9]) + z2 * c[10]);
  const double rest = t + t * (z * tail);
  return quarters * (0.25 * piHigh) + (rest + quarters * (0.25 * piLow));
}

/// The angle of the direction (x, y), y >= 0, between 0 and pi, as std::atan2(y, x).
inline double angleOf(double y, double x)
{
  if (!(y > 0.0))
  {
    return x < 0.0 ? piHigh : 0.0;
  }
  const TurnedBack r = turnBack(y, x < 0.0 ? -x : x);
  const double angle = turnForth(r.quarters, r.y / r.x);
  return x < 0.0 ? (piHigh - angle) + piLow : angle;
}

struct TriangleAngles
{
  double a, b, c;
};

/**
 * The angles at the corners of a triangle. y is the length of its area vector and must not be
 * zero; xa, xb, xc are the scalar products of the two edges at each corner. All three angles
 * are zero if a product of these numbers overflows.
 */
inline TriangleAngles anglesOf(double y, double xa, double xb, double xc)
{
  const bool isLargestA = xa <= xb && xa <= xc;
  const bool isLargestB = !isLargestA && xb <= xc;
  const bool isLargestC = !isLargestA && !isLargestB;
  const TurnedBack p = turnBack(y, isLargestA ? xb : xa);
  const TurnedBack q = turnBack(y, isLargestC ? xb : xc);
  const double product = p.x * q.x;
  if (!(product <= std::numeric_limits<double>::max()))
  {
    return { 0.0, 0.0, 0.0 };
  }
  const double inverse = 1.0 / product;
  const double first = turnForth(p.quarters, (p.y * q.x) * inverse);
  const double second = turnForth(q.quarters, (q.y * p.x) * inverse);
  const double largest = piHigh - (first + second);
  return { isLargestA ? largest : first, isLargestB ? largest : (isLargestA ? first : second),
    isLargestC ? largest : second };
}
}

#endif
