// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the edges that a vtkProperty shows
 *
 * VTK 9.1 and 9.2 have no opacity of edges, and only some versions have a width of edges besides
 * the width of lines. What a version lacks has the default of the others.
 */
#ifndef EdgesFromVTK_h
#define EdgesFromVTK_h

#include "Surface.h"
#include "Vec3FromVTK.h"

#include "vtkProperty.h"

namespace lambent::adapters
{
// Where both overloads fit, the first argument, an int, prefers the first.
template <typename Property>
auto edgeOpacityOf(int, Property* property) -> decltype(property->GetEdgeOpacity())
{
  return property->GetEdgeOpacity();
}
template <typename Property>
double edgeOpacityOf(long, Property*)
{
  return 1.0;
}

template <typename Property>
auto edgeWidthOf(int, Property* property) -> decltype(property->GetEdgeWidth())
{
  return property->GetUseLineWidthForEdgeThickness() ? property->GetLineWidth()
                                                     : property->GetEdgeWidth();
}
template <typename Property>
double edgeWidthOf(long, Property* property)
{
  return property->GetLineWidth();
}

/// Edges are visible on filled faces only. `Property` is vtkProperty, or in tests one of another
/// version.
template <typename Property>
EdgeStyle edgesFromVTK(Property* property)
{
  EdgeStyle result;
  result.color = vec3FromVTK(property->GetEdgeColor());
  result.opacity = edgeOpacityOf(0, property);
  result.width = edgeWidthOf(0, property);
  result.areVisible =
    property->GetEdgeVisibility() != 0 && property->GetRepresentation() == VTK_SURFACE;
  return result;
}
}

#endif
