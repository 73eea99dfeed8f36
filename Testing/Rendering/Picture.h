// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief pictures for tests, compared pixel by pixel and bit by bit
 */
#ifndef Picture_h
#define Picture_h

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

/// Uses GLM's arithmetic, deliberately different from the module's.
using Vec = glm::dvec3;

class Picture
{
public:
  explicit Picture(vtkImageData* image)
  {
    this->Image->DeepCopy(image);
    this->Image->GetExtent(this->Extent);
  }

  bool empty() const { return this->colors() == nullptr; }
  int width() const { return this->Extent[1] - this->Extent[0] + 1; }
  int height() const { return this->Extent[3] - this->Extent[2] + 1; }
  vtkDataArray* colors() const { return this->Image->GetPointData()->GetScalars(); }

  /// The colour of a pixel of the whole image, i from the left, j from the bottom.
  Vec at(int i, int j) const
  {
    Vec color(std::numeric_limits<double>::quiet_NaN());
    if (!this->empty())
    {
      color = this->colorOf(this->index(i, j));
    }
    return color;
  }

  /// The alpha of a pixel. The picture must have alpha.
  double alpha(int i, int j) const { return this->colors()->GetComponent(this->index(i, j), 3); }

  /// The bits of the pixels [i0, i1) of a row.
  std::string bits(int i0, int i1, int j) const
  {
    const int pixel = this->colors()->GetNumberOfComponents() * this->colors()->GetDataTypeSize();
    const char* data = static_cast<const char*>(this->colors()->GetVoidPointer(0));
    return std::string(data + pixel * this->index(i0, j), pixel * (i1 - i0));
  }
  std::string bits() const
  {
    std::string all;
    for (int j = this->Extent[2]; !this->empty() && j <= this->Extent[3]; ++j)
    {
      all += this->bits(this->Extent[0], this->Extent[1] + 1, j);
    }
    return all;
  }

  /// The number of pixels of a colour; -1 in an empty picture.
  int count(const Vec& color) const
  {
    int pixels = this->empty() ? -1 : 0;
    for (vtkIdType p = 0; !this->empty() && p < this->colors()->GetNumberOfTuples(); ++p)
    {
      pixels += this->colorOf(p) == color;
    }
    return pixels;
  }

private:
  Vec colorOf(vtkIdType pixel) const
  {
    return { this->colors()->GetComponent(pixel, 0), this->colors()->GetComponent(pixel, 1),
      this->colors()->GetComponent(pixel, 2) };
  }
  vtkIdType index(int i, int j) const
  {
    return static_cast<vtkIdType>(j - this->Extent[2]) * this->width() + (i - this->Extent[0]);
  }

  vtkSmartPointer<vtkImageData> Image = vtkSmartPointer<vtkImageData>::New();
  int Extent[6];
};

inline Picture render(vtkLambentRayTracer* tracer)
{
  tracer->Update();
  return Picture(tracer->GetOutput());
}

/// For EXPECT_PRED_FORMAT2: expects the same size and bits, and reports the first pixel that
/// differs.
inline testing::AssertionResult sameBits(
  const char* nameA, const char* nameB, const Picture& a, const Picture& b)
{
  if (a.empty() || b.empty() || a.width() != b.width() || a.height() != b.height())
  {
    return testing::AssertionFailure()
      << nameA << " or " << nameB << " is empty or of another size";
  }
  for (int j = 0; j < a.height(); ++j)
  {
    for (int i = 0; i < a.width(); ++i)
    {
      if (a.bits(i, i + 1, j) != b.bits(i, i + 1, j))
      {
        const Vec left = a.at(i, j), right = b.at(i, j);
        return testing::AssertionFailure()
          << nameA << " and " << nameB << " differ at pixel (" << i << ", " << j << "): " << left.x
          << " " << left.y << " " << left.z << " and " << right.x << " " << right.y << " "
          << right.z;
      }
    }
  }
  return testing::AssertionSuccess();
}

#define EXPECT_SAME_BITS(a, b) EXPECT_PRED_FORMAT2(sameBits, a, b)

inline void expectColor(
  const Vec& found, const Vec& expected, const std::string& where, double tolerance = 1e-6)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(found[channel], expected[channel], tolerance) << where << ", channel " << channel;
  }
}

inline std::string pixelName(int i, int j)
{
  return "pixel (" + std::to_string(i) + ", " + std::to_string(j) + ")";
}

#endif
