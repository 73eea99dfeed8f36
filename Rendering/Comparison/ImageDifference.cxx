// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageDifference.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace
{
template <typename T>
bool areSame(T a, T b)
{
  return a == b || (a != a && b != b);
}

/// |a - b| of two different values; infinity if one is NaN.
template <typename T>
double distance(T a, T b)
{
  if constexpr (std::is_integral_v<T>)
  {
    using Unsigned = std::make_unsigned_t<T>; // the signed difference could overflow
    const auto low = static_cast<Unsigned>(std::min(a, b));
    return static_cast<double>(static_cast<Unsigned>(static_cast<Unsigned>(std::max(a, b)) - low));
  }
  else
  {
    const double d = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return d == d ? d : std::numeric_limits<double>::infinity();
  }
}

/// A difference in the type of the values, clamped to its range.
template <typename T>
T narrowed(double d)
{
  return d < static_cast<double>(std::numeric_limits<T>::max()) || !std::is_integral_v<T>
    ? static_cast<T>(d)
    : std::numeric_limits<T>::max();
}

struct Row
{
  double maximum = 0.0;
  double sumOfSquares = 0.0;
  int changed = 0;
  int first = -1, last = -1;
};

template <typename T>
Row subtractRow(const T* a, const T* b, T* absolute, int width, int components)
{
  Row row;
  for (int i = 0; i < width; ++i)
  {
    bool isChanged = false;
    for (int c = 0; c < components; ++c, ++a, ++b, ++absolute)
    {
      if (areSame(*a, *b))
      {
        *absolute = T(0);
        continue;
      }
      const double d = distance(*a, *b);
      *absolute = narrowed<T>(d);
      row.maximum = std::max(row.maximum, d);
      row.sumOfSquares += d * d;
      isChanged = true;
    }
    if (isChanged)
    {
      row.first = row.changed == 0 ? i : row.first;
      row.last = i;
      ++row.changed;
    }
  }
  return row;
}

ImageDifference addUp(const std::vector<Row>& rows, int width)
{
  ImageDifference all;
  for (std::size_t j = 0; j < rows.size(); ++j)
  {
    const Row& row = rows[j];
    if (row.changed == 0)
    {
      continue;
    }
    const int y = static_cast<int>(j);
    const bool isFirst = all.changed == 0;
    all.first = isFirst ? static_cast<vtkIdType>(j) * width + row.first : all.first;
    all.extent[0] = isFirst ? row.first : std::min(all.extent[0], row.first);
    all.extent[1] = std::max(all.extent[1], row.last);
    all.extent[2] = isFirst ? y : all.extent[2];
    all.extent[3] = y;
    all.maximum = std::max(all.maximum, row.maximum);
    all.sumOfSquares += row.sumOfSquares;
    all.changed += row.changed;
  }
  return all;
}

template <typename T>
ImageDifference subtract(const T* a, const T* b, T* absolute, int width, int height, int components)
{
  std::vector<Row> rows(height);
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType j = begin; j < end; ++j)
      {
        const vtkIdType at = j * width * components;
        rows[j] = subtractRow(a + at, b + at, absolute + at, width, components);
      }
    });
  return addUp(rows, width);
}

/// The array itself, or a copy with contiguous tuples.
vtkSmartPointer<vtkDataArray> inStandardLayout(vtkDataArray* array)
{
  if (array->HasStandardMemoryLayout())
  {
    return array;
  }
  auto copy =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  copy->DeepCopy(array);
  return copy;
}
}

bool subtractImages(vtkDataArray* picture, vtkDataArray* baseline, int width,
  ImageDifference& result, vtkDataArray* absolute)
{
  const auto a = inStandardLayout(picture), b = inStandardLayout(baseline);
  const int height = static_cast<int>(picture->GetNumberOfTuples() / width);
  switch (picture->GetDataType())
  {
    vtkTemplateMacro(result = subtract(static_cast<const VTK_TT*>(a->GetVoidPointer(0)),
                       static_cast<const VTK_TT*>(b->GetVoidPointer(0)),
                       static_cast<VTK_TT*>(absolute->GetVoidPointer(0)), width, height,
                       picture->GetNumberOfComponents()));
    default:
      return false;
  }
  return true;
}

void highlight(vtkDataArray* absolute, double maximum, vtkDataArray* bytes)
{
  const int components = absolute->GetNumberOfComponents();
  const int colors = components < 3 ? 1 : 3;
  const int alpha = components == 2 || components == 4 ? components - 1 : -1;
  const auto shown = [maximum](double d)
  {
    const double fraction = std::isinf(d) ? 1.0 : d / maximum;
    return d > 0.0 ? std::floor(55.5 + 200.0 * std::min(fraction, 1.0)) : 0.0;
  };
  vtkSMPTools::For(0, absolute->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType pixel = begin; pixel < end; ++pixel)
      {
        const double ofAlpha = alpha < 0 ? 0.0 : absolute->GetComponent(pixel, alpha);
        for (int c = 0; c < 3; ++c)
        {
          const double d = absolute->GetComponent(pixel, std::min(c, colors - 1));
          bytes->SetComponent(pixel, c, shown(std::max(d, ofAlpha)));
        }
      }
    });
}
