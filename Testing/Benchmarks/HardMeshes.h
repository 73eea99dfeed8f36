// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief meshes that a tree of triangles is good at and a stream of them is not, or
 * whose work is hard to share out; and meshes of many pieces
 */
#ifndef HardMeshes_h
#define HardMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// 64 layers one behind the other, 8192 triangles each, in random order. A tree stops
/// at the first layer it meets.
vtkSmartPointer<vtkPolyData> makeLayers();

/// 2,000 triangles from one side to the other, each narrower than a pixel.
vtkSmartPointer<vtkPolyData> makeNeedles();

/// A million triangles whose projections share one pixel.
vtkSmartPointer<vtkPolyData> makeOnePixel();

/// Ten million small triangles anywhere in a cube, in any order, no point shared.
vtkSmartPointer<vtkPolyData> makeSoup();

/// A million small facets, and one triangle before half of them.
vtkSmartPointer<vtkPolyData> makeCurtain();

/// Two million facets that fall between the rays, and in the end 2,000 large ones.
vtkSmartPointer<vtkPolyData> makeLate();

/// 100,000 triangles in a cube, no point shared.
vtkSmartPointer<vtkPolyData> makeFacets();

/// 3,000 spheres of 384 triangles in a cube.
vtkSmartPointer<vtkPolyData> makeSpheres();

/// Twelve triangles.
vtkSmartPointer<vtkPolyData> makeBox();

#endif
