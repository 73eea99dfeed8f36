// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief elementary functions that give the same bits everywhere
 *
 * The trigonometric functions and powers of C libraries differ in their last bits, so
 * pictures would differ too. The functions here use only + - * / sqrt and exact functions
 * (fabs, floor, fmod, frexp, ldexp), in a fixed order. Where plain rounded operations would
 * not be accurate enough, they represent a value as the unevaluated sum of two doubles (T. J.
 * Dekker, "A Floating-Point Technique for Extending the Available Precision",
 * Numerische Mathematik 18, 1971). Neither this code nor the compiler may fuse multiply-adds.
 *
 * The stated accuracies are the largest errors that the tests accept, in units in the last
 * place (ulp) of the result. The tests compare with 80-bit arithmetic.
 */
#ifndef lambent_Elementary_h
#define lambent_Elementary_h

namespace lambent
{
/**
 * Sine, cosine and tangent of an angle in degrees.
 *
 * Domain: every finite number; an infinite angle or NaN gives NaN. The
 * reduction to 45 degrees is exact for angles of any size. Accuracy: 1 ulp,
 * and exact wherever the result is a multiple of 1/2: sinDegrees(30) is 0.5,
 * cosDegrees(90) is 0, tanDegrees(45) is 1. The tangent of 90 and 270 degrees is
 * infinity, that of -90 and -270 degrees is -infinity.
 *
 * Method: Taylor series; the argument is kept as two doubles.
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
 * Method: integer exponents up to 1024 by repeated squaring in two doubles. All
 * others by exp(exponent * ln(base)), with the logarithm and the product in two
 * doubles: ln(m) = 2 artanh((m - 1) / (m + 1)), and Taylor series for both.
 */
double power(double base, double exponent);

/**
 * Decimal logarithm.
 *
 * Domain: every number greater than 0; 0 gives -infinity, infinity itself, anything
 * else NaN. Accuracy: 1 ulp, and exact for powers of ten that are doubles.
 *
 * Method: ln(x) in two doubles as for power(), times 1 / ln(10) in two doubles.
 */
double decimalLogarithm(double x);
}

#endif
