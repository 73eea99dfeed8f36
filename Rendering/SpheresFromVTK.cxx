// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpheresFromVTK.h"

#include "PassArrays.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
constexpr const char* remedy = ", or call SetInputSphereRadiusArray() with nullptr.";

bool isRadius(double value)
{
  return value >= 0.0 && std::isfinite(value);
}

vtkDataArray* findRadii(const std::string& name, vtkPolyData* input)
{
  const SceneSettings::PassArray wanted{ vtkDataObject::FIELD_ASSOCIATION_POINTS, name };
  vtkDataArray* const array = findArray(input, wanted);
  if (!array)
  {
    const std::string names = listArrays({ input }, wanted.association);
    throw std::runtime_error("there is no " + describe(wanted) +
      ", which SetInputSphereRadiusArray() names. " +
      (names.empty() ? "Add the array" : "Choose one of " + names) + remedy);
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    std::ostringstream text;
    text << "the " << describe(wanted) << " of SetInputSphereRadiusArray() has "
         << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components, but there are " << input->GetNumberOfPoints()
         << " points, each of which needs one number. Correct the array, choose another one"
         << remedy;
    throw std::runtime_error(text.str());
  }
  return array;
}

void checkRadii(const ScalarSpan& radii, const std::string& name)
{
  for (std::size_t k = 0; k < radii.size; ++k)
  {
    if (!isRadius(radii[k]))
    {
      std::ostringstream text;
      text << "the point array \"" << name << "\" of SetInputSphereRadiusArray() has the value "
           << radii[k] << " at point " << k
           << ", but a radius must be a finite number of 0 or more. Correct the array, choose "
              "another one"
           << remedy;
      throw std::runtime_error(text.str());
    }
  }
}
}

void setSpheres(
  const SphereSettings& settings, vtkPolyData* input, SpansFromVTK& spans, Surface& surface)
{
  if (!isRadius(settings.radius))
  {
    std::ostringstream text;
    text << "the sphere radius is " << settings.radius
         << ", but it must be a finite number of 0 or more. Call SetInputSphereRadius().";
    throw std::runtime_error(text.str());
  }
  surface.radius = settings.radius > 0.0 ? settings.radius : 1.0;
  if (!settings.radiusArray.empty() && surface.points.size > 0)
  {
    surface.radii = spans.scalars(findRadii(settings.radiusArray, input));
    checkRadii(surface.radii, settings.radiusArray);
  }
}
}
