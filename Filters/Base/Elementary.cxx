// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elementary.h"

#include <cmath>
#include <limits>

namespace lambent
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The unevaluated sum high + low; |low| is at most half an ulp of high.
struct Pair
{
  double high, low;
};

constexpr Pair RadiansPerDegree{ 0.017453292519943295, 2.9486522708701687e-19 };
constexpr Pair NaturalLogOf2{ 0.6931471805599453, 2.3190468138462996e-17 };
constexpr Pair InverseLogOf10{ 0.4342944819032518, 1.098319650216765e-17 };
constexpr Pair OneThird{ 0.3333333333333333, 1.850371707708594e-17 };
constexpr Pair OneFifth{ 0.2, -1.1102230246251566e-17 };

/// 1/2!, 1/3!, ... 1/17!
constexpr double InverseFactorial[] = { 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0,
  1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0, 1.0 / 39916800.0, 1.0 / 479001600.0,
  1.0 / 6227020800.0, 1.0 / 87178291200.0, 1.0 / 1307674368000.0, 1.0 / 20922789888000.0,
  1.0 / 355687428096000.0 };

constexpr double inverseFactorial(int n)
{
  return InverseFactorial[n - 2];
}

/// a + b, where |a| >= |b| or a is 0.
Pair fastSum(double a, double b)
{
  const double high = a + b;
  return { high, b - (high - a) };
}

/// a + b, whatever their magnitudes.
Pair sum(double a, double b)
{
  const double high = a + b;
  const double bPart = high - a;
  return { high, (a - (high - bPart)) + (b - bPart) };
}

/// Splits a into a sum of two numbers of at most 26 bits each.
Pair halves(double a)
{
  const double shifted = 134217729.0 * a; // 2^27 + 1
  const double high = shifted - (shifted - a);
  return { high, a - high };
}

/// The exact product a * b.
Pair product(double a, double b)
{
  const Pair u = halves(a);
  const Pair v = halves(b);
  const double high = a * b;
  return { high, ((u.high * v.high - high) + u.high * v.low + u.low * v.high) + u.low * v.low };
}

Pair sum(Pair a, Pair b)
{
  const Pair high = sum(a.high, b.high);
  return fastSum(high.high, high.low + (a.low + b.low));
}

Pair product(Pair a, Pair b)
{
  const Pair high = product(a.high, b.high);
  return fastSum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

Pair product(Pair a, double b)
{
  const Pair high = product(a.high, b);
  return fastSum(high.high, high.low + a.low * b);
}

Pair quotient(Pair a, Pair b)
{
  const double high = a.high / b.high;
  const Pair taken = product(b, high);
  return fastSum(high, ((a.high - taken.high) + (a.low - taken.low)) / b.high);
}

/// An angle of at most 45 degrees either way, and how many right angles were subtracted.
struct ReducedAngle
{
  double degrees;
  int quadrant;
};

/// Every step is exact: fmod() is, and the subtraction loses no digits.
ReducedAngle reduce(double angle)
{
  const double turn = std::fmod(std::fabs(angle), 360.0);
  if (!(turn < 360.0))
  {
    return { NotANumber, 0 };
  }
  const double quadrant = std::floor(turn / 90.0 + 0.5);
  return { turn - 90.0 * quadrant, static_cast<int>(quadrant) & 3 };
}

/// sin(x) for |x| <= pi/4; the low part of x is multiplied by 1 - x^2/2.
Pair sineSeries(Pair x)
{
  const double z = x.high * x.high;
  double tail = 0.0;
  for (int n = 17; n >= 3; n -= 2)
  {
    tail = (n % 4 == 1 ? inverseFactorial(n) : -inverseFactorial(n)) + z * tail;
  }
  return fastSum(x.high, x.low * (1.0 - 0.5 * z) + x.high * (z * tail));
}

/// cos(x) for |x| <= pi/4.
Pair cosineSeries(Pair x)
{
  const Pair z = product(x.high, x.high);
  double tail = 0.0;
  for (int n = 16; n >= 4; n -= 2)
  {
    tail = (n % 4 == 0 ? inverseFactorial(n) : -inverseFactorial(n)) + z.high * tail;
  }
  const Pair head = fastSum(1.0, -0.5 * z.high);
  return fastSum(head.high, head.low + (z.high * z.high * tail - (0.5 * z.low + x.high * x.low)));
}

double sineOf(double degrees)
{
  if (std::fabs(degrees) == 30.0)
  {
    return std::copysign(0.5, degrees);
  }
  return sineSeries(product(RadiansPerDegree, degrees)).high;
}

double cosineOf(double degrees)
{
  return cosineSeries(product(RadiansPerDegree, degrees)).high;
}

/// mantissa^exponent; the mantissa is near 1, so nothing can overflow.
Pair wholePower(double mantissa, int exponent)
{
  Pair result{ 1.0, 0.0 };
  Pair square{ mantissa, 0.0 };
  for (int bits = exponent; bits != 0; bits >>= 1)
  {
    if (bits & 1)
    {
      result = product(result, square);
    }
    square = bits > 1 ? product(square, square) : square;
  }
  return result;
}

/// mantissa 2^exponent, with a mantissa between sqrt(1/2) and sqrt(2).
struct Scaled
{
  double mantissa;
  int exponent;
};

Scaled scale(double x)
{
  constexpr double squareRootOfHalf = 0.7071067811865476;
  Scaled result{};
  result.mantissa = std::frexp(x, &result.exponent);
  if (result.mantissa < squareRootOfHalf)
  {
    result.mantissa *= 2.0;
    --result.exponent;
  }
  return result;
}

/// ln(m) for m between sqrt(1/2) and sqrt(2), by the series for 2 artanh(s).
Pair logarithm(double m)
{
  const Pair s = quotient(Pair{ m - 1.0, 0.0 }, sum(m, 1.0));
  const Pair z = product(s, s);
  double tail = 0.0;
  for (int n = 27; n >= 7; n -= 2)
  {
    tail = 1.0 / n + z.high * tail;
  }
  const Pair fromFifth = sum(OneFifth, product(z, tail));
  const Pair fromThird = sum(OneThird, product(z, fromFifth));
  const Pair series = sum(Pair{ 1.0, 0.0 }, product(z, fromThird));
  return product(product(s, series), 2.0);
}

Pair logarithm(const Scaled& x)
{
  return sum(product(NaturalLogOf2, x.exponent), logarithm(x.mantissa));
}

/// exp(x), for |x| up to 800: beyond the range of a double in both directions.
double exponential(Pair x)
{
  const double steps = std::floor(x.high / NaturalLogOf2.high + 0.5);
  const Pair taken = product(NaturalLogOf2, -steps);
  const Pair r = sum(x, taken);
  double tail = 0.0;
  for (int n = 14; n >= 2; --n)
  {
    tail = inverseFactorial(n) + r.high * tail;
  }
  const double rest = r.low * (1.0 + r.high) + r.high * r.high * tail;
  const Pair head = fastSum(1.0, r.high);
  return std::ldexp(head.high + (head.low + rest), static_cast<int>(steps));
}
}

double sinDegrees(double angle)
{
  const ReducedAngle r = reduce(angle);
  const double magnitude = (r.quadrant & 1) ? cosineOf(r.degrees) : sineOf(r.degrees);
  const double sine = (r.quadrant & 2) ? -magnitude : magnitude;
  return (angle < 0.0 ? -sine : sine) + 0.0; // never -0
}

double cosDegrees(double angle)
{
  const ReducedAngle r = reduce(angle);
  const double magnitude = (r.quadrant & 1) ? sineOf(r.degrees) : cosineOf(r.degrees);
  const bool isNegative = r.quadrant == 1 || r.quadrant == 2;
  return (isNegative ? -magnitude : magnitude) + 0.0;
}

double tanDegrees(double angle)
{
  const ReducedAngle r = reduce(angle);
  const bool isSwapped = (r.quadrant & 1) != 0; // tan(90 + y) = -cos(y) / sin(y)
  double tangent;
  if (std::fabs(r.degrees) == 45.0)
  {
    tangent = (r.degrees < 0.0) != isSwapped ? -1.0 : 1.0;
  }
  else if (r.degrees == 0.0)
  {
    tangent = isSwapped ? Infinity : 0.0;
  }
  else
  {
    const Pair x = product(RadiansPerDegree, r.degrees);
    tangent = isSwapped ? -quotient(cosineSeries(x), sineSeries(x)).high
                        : quotient(sineSeries(x), cosineSeries(x)).high;
  }
  return (angle < 0.0 ? -tangent : tangent) + 0.0;
}

double power(double base, double exponent)
{
  constexpr double largestWholeExponent = 1024.0;
  constexpr double largestLogarithm = 800.0;
  if (exponent == 0.0)
  {
    return 1.0;
  }
  if (exponent == 1.0)
  {
    return base;
  }
  if (!(base >= 0.0 && exponent >= 0.0))
  {
    return NotANumber;
  }
  if (base == 0.0 || base == 1.0 || base == Infinity)
  {
    return base;
  }

  const Scaled scaled = scale(base);
  if (exponent <= largestWholeExponent && std::floor(exponent) == exponent)
  {
    const int whole = static_cast<int>(exponent);
    return std::ldexp(wholePower(scaled.mantissa, whole).high, scaled.exponent * whole);
  }

  const Pair log = logarithm(scaled);
  if (!(std::fabs(log.high * exponent) <= largestLogarithm))
  {
    return log.high < 0.0 ? 0.0 : Infinity;
  }
  return exponential(product(log, exponent));
}

double decimalLogarithm(double x)
{
  if (!(x > 0.0) || x == Infinity)
  {
    return x == 0.0 ? -Infinity : x == Infinity ? Infinity : NotANumber;
  }
  return product(logarithm(scale(x)), InverseLogOf10).high + 0.0;
}
}
