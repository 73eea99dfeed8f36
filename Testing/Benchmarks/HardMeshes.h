// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief meshes that suit a tree of triangles but not a stream of them, or whose work is hard
 * to balance; and meshes of many pieces
 */
#ifndef HardMeshes_h
#define HardMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// 64 layers behind each other, of 8192 triangles each, in random order. A tree stops at the
/// first layer that a ray hits.
vtkSmartPointer<vtkPolyData> makeLayers();

/// 2,000 triangles from side to side, each narrower than a pixel.
vtkSmartPointer<vtkPolyData> makeNeedles();

/// A million triangles whose projections share one pixel.
vtkSmartPointer<vtkPolyData> makeOnePixel();

/// Ten million small triangles at random places in a cube, without shared points.
vtkSmartPointer<vtkPolyData> makeSoup();

/// A million small facets, half of them behind one large triangle.
vtkSmartPointer<vtkPolyData> makeCurtain();

/// Two million facets that fall between the rays, then 2,000 large ones.
vtkSmartPointer<vtkPolyData> makeLate();

/// 100,000 triangles in a cube, no point shared.
vtkSmartPointer<vtkPolyData> makeFacets();

/// 3,000 spheres of 384 triangles in a cube.
vtkSmartPointer<vtkPolyData> makeSpheres();

/// A million points in a cube, the centres of spheres.
vtkSmartPointer<vtkPolyData> makeBalls();

/// 100,000 lines of about 30 pixels in a cube.
vtkSmartPointer<vtkPolyData> makeLines();

/// Twelve triangles.
vtkSmartPointer<vtkPolyData> makeBox();

#endif
