// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares the elementary functions with the C library's in extended precision, for millions of
// arguments, and checks them at arguments with exact results.

#include "Elementary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

namespace
{
constexpr long double Pi = 3.14159265358979323846264338327950288L;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int Arguments = 2'000'000;

// The error of a value in ulps of the exact value.
double ulps(double value, long double expected)
{
  if (value == static_cast<double>(expected))
  {
    return 0.0;
  }
  int exponent = 0;
  std::frexp(static_cast<double>(expected), &exponent);
  const long double ulp = std::ldexp(1.0L, std::max(exponent, DBL_MIN_EXP) - DBL_MANT_DIG);
  return static_cast<double>(std::fabs(static_cast<long double>(value) - expected) / ulp);
}

// The largest error so far, and its argument.
struct Worst
{
  double error = 0.0;
  double argument = 0.0;
  double argument2 = 0.0;

  void take(double newError, double a, double b = 0.0)
  {
    if (!(newError <= this->error))
    {
      *this = { newError, a, b };
    }
  }
};

::testing::AssertionResult isWithin(const Worst& worst, double bound)
{
  return (worst.error <= bound ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
    << "largest error " << worst.error << " ulp at " << worst.argument << ", " << worst.argument2;
}

class Elementary : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (LDBL_MANT_DIG < 64)
    {
      GTEST_SKIP() << "long double is no more accurate than double here";
    }
  }

  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  std::mt19937_64 Random{ 20240229 };
};

long double radians(long double degrees)
{
  return degrees * Pi / 180.0L;
}
}

TEST_F(Elementary, SineCosineTangentAreAccurate)
{
  Worst sine, cosine, tangent;
  // Each angle is used twice, relative to 0 and to 90 degrees: near a zero of a function the
  // reference must start from the distance to that zero.
  const auto compare = [&](double angle)
  {
    const long double x = radians(angle);
    sine.take(ulps(lambent::sinDegrees(angle), sinl(x)), angle);
    cosine.take(ulps(lambent::cosDegrees(angle), cosl(x)), angle);
    tangent.take(ulps(lambent::tanDegrees(angle), tanl(x)), angle);
    const double up = 90.0 + angle;
    const long double y = radians(static_cast<long double>(up) - 90.0L);
    sine.take(ulps(lambent::sinDegrees(up), cosl(y)), up);
    cosine.take(ulps(lambent::cosDegrees(up), -sinl(y)), up);
    if (y != 0.0L)
    {
      tangent.take(ulps(lambent::tanDegrees(up), -1.0L / tanl(y)), up);
    }
  };
  for (int i = 0; i < Arguments; ++i)
  {
    compare(this->uniform(-45.0, 45.0));
  }
  for (int i = 0; i < Arguments / 10; ++i)
  {
    compare(std::ldexp(this->uniform(-1.0, 1.0), -static_cast<int>(this->uniform(0.0, 900.0))));
  }
  EXPECT_TRUE(isWithin(sine, 1.0));
  EXPECT_TRUE(isWithin(cosine, 1.0));
  EXPECT_TRUE(isWithin(tangent, 1.0));
}

TEST(ElementaryExact, MultiplesOfRightAngles)
{
  using lambent::cosDegrees;
  using lambent::sinDegrees;
  using lambent::tanDegrees;
  const struct
  {
    double angle, sine, cosine;
  } exact[] = { { 0, 0, 1 }, { 90, 1, 0 }, { 180, 0, -1 }, { 270, -1, 0 }, { 360, 0, 1 },
    { 450, 1, 0 }, { 36000000090.0, 1, 0 } };
  for (const auto& e : exact)
  {
    EXPECT_EQ(sinDegrees(e.angle), e.sine) << e.angle;
    EXPECT_EQ(cosDegrees(e.angle), e.cosine) << e.angle;
    EXPECT_EQ(sinDegrees(-e.angle), -e.sine) << e.angle;
    EXPECT_EQ(cosDegrees(-e.angle), e.cosine) << e.angle;
  }
  for (double turn = -720.0; turn <= 720.0; turn += 360.0)
  {
    EXPECT_EQ(sinDegrees(turn + 30.0), 0.5);
    EXPECT_EQ(sinDegrees(turn + 150.0), 0.5);
    EXPECT_EQ(sinDegrees(turn + 210.0), -0.5);
    EXPECT_EQ(sinDegrees(turn + 330.0), -0.5);
    EXPECT_EQ(cosDegrees(turn + 60.0), 0.5);
    EXPECT_EQ(cosDegrees(turn + 120.0), -0.5);
    EXPECT_EQ(cosDegrees(turn + 240.0), -0.5);
    EXPECT_EQ(cosDegrees(turn + 300.0), 0.5);
    EXPECT_EQ(tanDegrees(turn + 45.0), 1.0);
    EXPECT_EQ(tanDegrees(turn + 135.0), -1.0);
    EXPECT_EQ(tanDegrees(turn + 225.0), 1.0);
    EXPECT_EQ(tanDegrees(turn + 315.0), -1.0);
    EXPECT_EQ(tanDegrees(turn), 0.0);
    EXPECT_EQ(tanDegrees(turn + 180.0), 0.0);
  }
  // The double nearest to the square root of one half.
  EXPECT_EQ(sinDegrees(45.0), std::sqrt(0.5));
  EXPECT_EQ(cosDegrees(45.0), std::sqrt(0.5));
  EXPECT_EQ(tanDegrees(90.0), Infinity);
  EXPECT_EQ(tanDegrees(-90.0), -Infinity);
}

TEST(ElementaryExact, NonFiniteAngles)
{
  for (double angle : { Infinity, -Infinity, NotANumber })
  {
    EXPECT_TRUE(std::isnan(lambent::sinDegrees(angle)));
    EXPECT_TRUE(std::isnan(lambent::cosDegrees(angle)));
    EXPECT_TRUE(std::isnan(lambent::tanDegrees(angle)));
  }
}

TEST_F(Elementary, SymmetriesHoldToTheLastBit)
{
  for (int i = 0; i < Arguments / 10; ++i)
  {
    const double angle = std::ldexp(std::floor(this->uniform(0.0, 360.0 * 1024.0)), -10);
    EXPECT_EQ(lambent::sinDegrees(-angle), -lambent::sinDegrees(angle));
    EXPECT_EQ(lambent::cosDegrees(-angle), lambent::cosDegrees(angle));
    EXPECT_EQ(lambent::tanDegrees(-angle), -lambent::tanDegrees(angle));
    EXPECT_EQ(lambent::sinDegrees(180.0 - angle), lambent::sinDegrees(angle));
    EXPECT_EQ(lambent::cosDegrees(angle), lambent::sinDegrees(90.0 + angle));
    EXPECT_EQ(lambent::sinDegrees(angle + 3600.0), lambent::sinDegrees(angle));
  }
}

TEST_F(Elementary, PowerIsAccurate)
{
  Worst whole, fractional, extreme;
  const auto error = [](double base, double exponent)
  {
    return ulps(lambent::power(base, exponent),
      powl(static_cast<long double>(base), static_cast<long double>(exponent)));
  };
  for (int i = 0; i < Arguments / 2; ++i)
  {
    const double base = this->uniform(0.0, 1.0);
    const double n = std::floor(this->uniform(0.0, i % 2 ? 32.0 : 1100.0));
    whole.take(error(base, n), base, n);
    const double exponent = this->uniform(0.0, i % 2 ? 4.0 : 256.0);
    fractional.take(error(base, exponent), base, exponent);
  }
  for (int i = 0; i < Arguments / 10; ++i)
  {
    // Bases of any magnitude, also near 1, and results up to the largest double.
    const double base = i % 2
      ? std::ldexp(this->uniform(0.5, 1.0), static_cast<int>(this->uniform(-1000.0, 1000.0)))
      : 1.0 + std::ldexp(this->uniform(-0.5, 1.0), -static_cast<int>(this->uniform(0.0, 50.0)));
    const double limit = 690.0 / std::fabs(std::log(base));
    const double exponent = this->uniform(0.0, limit);
    extreme.take(error(base, exponent), base, exponent);
  }
  EXPECT_TRUE(isWithin(whole, 1.0));
  EXPECT_TRUE(isWithin(fractional, 1.0));
  EXPECT_TRUE(isWithin(extreme, 1.0));
}

TEST(ElementaryExact, Power)
{
  using lambent::power;
  for (double x : { 0.0, 0.3, 1.0, 17.5, DBL_MAX, DBL_TRUE_MIN, Infinity })
  {
    EXPECT_EQ(power(x, 0.0), 1.0) << x;
    EXPECT_EQ(power(x, 1.0), x) << x;
    EXPECT_EQ(power(1.0, x), 1.0) << x;
  }
  EXPECT_EQ(power(0.0, 0.5), 0.0);
  EXPECT_EQ(power(0.0, Infinity), 0.0);
  EXPECT_EQ(power(0.5, Infinity), 0.0);
  EXPECT_EQ(power(2.0, Infinity), Infinity);
  EXPECT_EQ(power(Infinity, 0.5), Infinity);
  EXPECT_EQ(power(0.5, 10.0), 1.0 / 1024.0);
  EXPECT_EQ(power(3.0, 30.0), 205891132094649.0);
  EXPECT_EQ(power(2.0, 1024.0), Infinity);
  EXPECT_EQ(power(0.5, 1074.0), DBL_TRUE_MIN);
  EXPECT_EQ(power(0.5, 1024.0), std::ldexp(1.0, -1024));
  EXPECT_EQ(power(0.5, 1e300), 0.0);
  EXPECT_EQ(power(1.5, 1e300), Infinity);
  EXPECT_EQ(power(0.25, 0.5), 0.5);
  EXPECT_EQ(power(0.0625, 1.25), 0.03125);
  for (double base : { -1.0, -Infinity, NotANumber })
  {
    EXPECT_TRUE(std::isnan(power(base, 2.0))) << base;
  }
  EXPECT_TRUE(std::isnan(power(0.5, -1.0)));
  EXPECT_TRUE(std::isnan(power(0.5, NotANumber)));
}

TEST_F(Elementary, PowerEqualsSquareRootsAndSquares)
{
  for (int i = 0; i < Arguments / 10; ++i)
  {
    const double x = this->uniform(0.0, 1.0);
    EXPECT_LE(ulps(lambent::power(x, 0.5), std::sqrt(static_cast<long double>(x))), 1.0) << x;
    EXPECT_LE(ulps(lambent::power(x, 2.0), static_cast<long double>(x) * x), 0.5) << x;
  }
}

TEST_F(Elementary, DecimalLogarithmIsAccurate)
{
  Worst worst;
  for (int i = 0; i < Arguments; ++i)
  {
    // Of any magnitude, and near 1, where the logarithm is near 0.
    const double x = i % 2
      ? std::ldexp(this->uniform(0.5, 1.0), int(this->uniform(-1000.0, 1000.0)))
      : 1.0 + std::ldexp(this->uniform(-1.0, 1.0), -int(this->uniform(1.0, 50.0)));
    worst.take(ulps(lambent::decimalLogarithm(x), log10l(static_cast<long double>(x))), x);
  }
  EXPECT_TRUE(isWithin(worst, 1.0));
}

TEST(ElementaryExact, DecimalLogarithm)
{
  double power = 1.0;
  for (int k = 0; k <= 22; ++k, power *= 10.0) // exact in double
  {
    EXPECT_EQ(lambent::decimalLogarithm(power), k);
  }
  EXPECT_EQ(lambent::decimalLogarithm(0.0), -Infinity);
  EXPECT_EQ(lambent::decimalLogarithm(Infinity), Infinity);
  EXPECT_TRUE(std::isnan(lambent::decimalLogarithm(-1.0)));
  EXPECT_TRUE(std::isnan(lambent::decimalLogarithm(NotANumber)));
}
