// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief elementary functions that give the same bits everywhere
 *
 * The trigonometry and the powers of the C library differ in their last bits from
 * one library to the next, and with them pictures would. These are made of
 * + - * / sqrt and of functions that are exact (fabs, floor, fmod, frexp, ldexp),
 * in one written order. Where one rounded operation after the other would not be
 * accurate enough they carry a value as the unevaluated sum of two doubles (T. J.
 * Dekker, "A Floating-Point Technique for Extending the Available Precision",
 * Numerische Mathematik 18, 1971). No fused multiply-add, here or by the compiler.
 *
 * Accuracies are the largest errors that the tests accept, in units in the last
 * place (ulp) of the result, found by comparison with 80-bit arithmetic.
 */
#ifndef lambent_Elementary_h
#define lambent_Elementary_h

#include <algorithm>
#include <cmath>

namespace lambent
{
/**
 * Sine, cosine and tangent of an angle in degrees.
 *
 * Domain: every finite number; an infinite or undefined angle gives NaN. The
 * reduction to 45 degrees is exact however large the angle is. Accuracy: 1 ulp,
 * and exact wherever the result is a multiple of 1/2: sinDegrees(30) is 0.5,
 * cosDegrees(90) is 0, tanDegrees(45) is 1. The tangent of 90 and 270 degrees is
 * infinity, that of -90 and -270 degrees is -infinity.
 *
 * Source: Taylor's series, of an argument that is kept as two doubles.
 */
///@{
double sinDegrees(double angle);
double cosDegrees(double angle);
double tanDegrees(double angle);
///@}

/**
 * base to the power of exponent.
 *
 * Domain: base >= 0, exponent >= 0, infinity included; anything else gives NaN,
 * except that an exponent of 0 always gives 1, also for base 0, and an exponent of
 * 1 always gives base itself. Accuracy: 1 ulp.
 *
 * Source: whole exponents up to 1024 by repeated squaring in two doubles. All
 * others by exp(exponent * ln(base)), with the logarithm and the product in two
 * doubles: ln(m) = 2 artanh((m - 1) / (m + 1)), and Taylor's series for both.
 */
double power(double base, double exponent);

namespace detail
{
/**
 * (asin(s) - s) / s^3 as a polynomial in z = s^2, 0 <= z <= 1/4. It agrees with the
 * function in the 13 Chebyshev nodes of that interval (solved in 60 digits, then
 * rounded to binary64), which leaves a relative error in asin(s) of 2^-57.
 * The terms are paired (Estrin's scheme) so that a processor can overlap them.
 */
inline double arcSineTail(double z)
{
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double p0 = 0.16666666666666669 + z * 0.07499999999998433;
  const double p1 = 0.04464285714635543 + z * 0.030381944138531247;
  const double p2 = 0.02237217294214989 + z * 0.017352392720869973;
  const double p3 = 0.013971212973552933 + z * 0.011479177415184906;
  const double p4 = 0.01032281435018578 + z * 0.005457506718640358;
  const double p5 = 0.01740087944269402 + z * -0.014851887071247204;
  const double p6 = 0.028757851367421566;
  const double low = (p0 + z2 * p1) + z4 * (p2 + z2 * p3);
  const double high = (p4 + z2 * p5) + z4 * p6;
  return low + (z4 * z4) * high;
}
}

/**
 * The angle in radians, between 0 and pi, whose cosine is x.
 *
 * Domain: [-1, 1]; anything else gives NaN. Accuracy: 1.5 ulp; exact (rounded
 * correctly) at -1, 0 and 1. Made to be called in inner loops: one square root, no
 * division and no branch.
 *
 * Source: acos(x) = pi/2 - asin(x) for |x| <= 1/2, and for larger |x| the half
 * angle, acos(|x|) = 2 asin(sqrt((1 - |x|) / 2)).
 */
inline double arcCosine(double x)
{
  constexpr double halfPiHigh = 1.5707963267948966;
  constexpr double halfPiLow = 6.123233995736766e-17;
  const double magnitude = std::fabs(x);
  // The one that is meant is always the smaller; its root, for |x| <= 1/2, is |x|.
  const double z = std::min(x * x, 0.5 * (1.0 - magnitude));
  const double s = std::sqrt(z);
  const double arcSine = s + s * (z * detail::arcSineTail(z));

  // How many quarter turns to start from, and how often to add the arc sine.
  const double sign = std::copysign(1.0, x);
  const double outer = static_cast<double>(magnitude > 0.5);
  const double turns = 1.0 - sign * outer;
  const double times = sign * (3.0 * outer - 1.0);
  return turns * halfPiHigh + (times * arcSine + turns * halfPiLow);
}
}

#endif
