// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// The core computes what its source says: each operation is rounded to binary64, in the written
// order. Functions compiled into the library are compared, bit for bit, with the same operations
// forced through memory one at a time. Compilers that contract, reassociate, multiply by
// reciprocals or assume finite numbers fail here.

#include "CameraFrame.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cfloat>
#include <limits>
#include <random>

namespace
{
using lambent::Camera;
using lambent::CameraFrame;
using lambent::Vec3;

// A binary64 number; the result of each operation goes through memory.
struct Stored
{
  volatile double value;
  Stored(double v)
    : value(v)
  {
  }
  Stored(const Stored& other)
    : value(other.value)
  {
  }
};

Stored operator+(const Stored& a, const Stored& b)
{
  return { a.value + b.value };
}
Stored operator-(const Stored& a, const Stored& b)
{
  return { a.value - b.value };
}
Stored operator*(const Stored& a, const Stored& b)
{
  return { a.value * b.value };
}
Stored operator/(const Stored& a, const Stored& b)
{
  return { a.value / b.value };
}

Vec3 strictlyNormalized(const Vec3& v)
{
  const Stored x(v.x), y(v.y), z(v.z);
  const Stored square = (x * x + y * y) + z * z;
  const Stored length = std::sqrt(square.value);
  return { (x / length).value, (y / length).value, (z / length).value };
}

Vec3 strictCross(const Vec3& a, const Vec3& b)
{
  const Stored ax(a.x), ay(a.y), az(a.z), bx(b.x), by(b.y), bz(b.z);
  return { (ay * bz - az * by).value, (az * bx - ax * bz).value, (ax * by - ay * bx).value };
}
}

TEST(StrictArithmetic, MachineRoundsToNearestBinary64)
{
  EXPECT_EQ(FLT_EVAL_METHOD, 0);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  const Stored smallest = std::numeric_limits<double>::min();
  const double half = (smallest * 0.5).value;
  EXPECT_GT(half, 0.0) << "subnormal numbers are flushed to zero";
}

// 1.5 - 1.5 (1 - 2^-53): the product lies three quarters of the way between two numbers. Rounded,
// the difference is 2^-52; contracted to one operation it is 3/4 of that.
TEST(StrictArithmetic, ProductIsRoundedBeforeTheDifference)
{
  Camera camera;
  camera.position = { 0.0, 0.0, 1.0 };
  camera.focalPoint = { 0.0, 0.0, 0.0 };
  camera.viewUp = { 0.0, 1.0, 0.0 };
  camera.windowCenter[0] = 1.0 - 0x1p-53;
  EXPECT_EQ(CameraFrame(camera, 3, 3).centerX, 0x1p-52);
}

TEST(StrictArithmetic, CameraFrameIsComputedAsWritten)
{
  std::mt19937_64 random(1);
  const auto coordinate = [&random] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int i = 0; i < 1000; ++i)
  {
    Camera camera;
    camera.position = { coordinate(), coordinate(), coordinate() };
    camera.focalPoint = { coordinate(), coordinate(), coordinate() };
    camera.viewUp = { coordinate(), coordinate(), coordinate() };
    const CameraFrame frame(camera, 640, 480);

    const Vec3 forward = strictlyNormalized(camera.focalPoint - camera.position);
    const Vec3 up = strictlyNormalized(camera.viewUp);
    const Vec3 right = strictlyNormalized(strictCross(forward, up));
    EXPECT_EQ(frame.forward, forward);
    EXPECT_EQ(frame.right, right);
    EXPECT_EQ(frame.up, strictCross(right, forward));
  }
}

// The image's centre lies anywhere, so that every operation rounds.
TEST(StrictArithmetic, RaysAreComputedAsWritten)
{
  std::mt19937_64 random(2);
  const auto number = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int k = 0; k < 1000; ++k)
  {
    Camera camera;
    camera.windowCenter[0] = number();
    camera.windowCenter[1] = number();
    camera.viewAngle = 10.0 + 150.0 * number();
    const CameraFrame frame(camera, 641, 479);
    const Stored halfWidth = 0.5 * 641, halfHeight = 0.5 * 479, half = 0.5, pixel = frame.pixel;
    const Stored centerX = halfWidth - halfWidth * camera.windowCenter[0];
    const Stored centerY = halfHeight - halfHeight * camera.windowCenter[1];
    EXPECT_EQ(frame.centerX, centerX.value);
    EXPECT_EQ(frame.centerY, centerY.value);
    for (const int i : { 0, 3, 100, 478 })
    {
      const Stored x = ((Stored(i) + half) - centerX) * pixel;
      const Stored y = ((Stored(i) + half) - centerY) * pixel;
      EXPECT_EQ(frame.x(i), x.value);
      EXPECT_EQ(frame.y(i), y.value);
    }
  }
}

TEST(StrictArithmetic, NaNIsDetected)
{
  Camera camera;
  camera.position = { 0.0, 0.0, 1.0 };
  EXPECT_EQ(findDefect(camera), lambent::CameraDefect::None);
  camera.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(findDefect(camera), lambent::CameraDefect::NotFinite);
}
