// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief small images with known differences, and their comparison
 */
#ifndef ComparedImages_h
#define ComparedImages_h

#include "vtkLambentImageComparison.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTypeTraits.h"

#include <algorithm>
#include <string>
#include <vector>

/// An image with these values, padded with zeros.
template <typename T>
vtkSmartPointer<vtkImageData> values(
  int width, int height, int components, const std::vector<double>& list = {})
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(vtkTypeTraits<T>::VTK_TYPE_ID, components);
  auto* data = static_cast<T*>(image->GetScalarPointer());
  std::fill_n(data, static_cast<std::size_t>(width) * height * components, T(0));
  std::transform(
    list.begin(), list.end(), data, [](double value) { return static_cast<T>(value); });
  return image;
}

struct Change
{
  int x, y, channel, value;
};

/// A picture in which all channels are 100, except for these changes.
inline vtkSmartPointer<vtkImageData> grey(
  int width, int height, const std::vector<Change>& changes = {})
{
  auto image = values<unsigned char>(
    width, height, 3, std::vector<double>(static_cast<std::size_t>(3) * width * height, 100.0));
  for (const Change& change : changes)
  {
    image->SetScalarComponentFromDouble(change.x, change.y, 0, change.channel, change.value);
  }
  return image;
}

inline void compareIn(vtkLambentImageComparison* comparison, vtkImageData* picture,
  vtkImageData* baseline, double tolerance = 0.0, int metric = 0)
{
  comparison->SetPictureData(picture);
  comparison->SetBaselineData(baseline);
  comparison->SetTolerance(tolerance);
  comparison->SetMetric(metric);
  comparison->Update();
}

inline vtkSmartPointer<vtkLambentImageComparison> compare(
  vtkImageData* picture, vtkImageData* baseline, double tolerance = 0.0, int metric = 0)
{
  auto comparison = vtkSmartPointer<vtkLambentImageComparison>::New();
  compareIn(comparison, picture, baseline, tolerance, metric);
  return comparison;
}

#endif
