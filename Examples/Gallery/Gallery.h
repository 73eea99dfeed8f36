// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief functions shared by the examples of the gallery
 *
 * Most pictures show a row of objects of about unit size from the front in parallel
 * projection. The background is grey so that black surfaces are visible.
 */

#ifndef Gallery_h
#define Gallery_h

#include "vtkLambentRayTracer.h"

#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

class vtkPolyDataAlgorithm;

namespace gallery
{

/// The distance between neighbouring objects in a row.
constexpr double Step = 2.5;

/**
 * The output of a source, with all coordinates of its points and normals rounded to the
 * nearest multiple of 2^-12.
 *
 * VTK's round sources use the platform's sines and cosines, whose last bits differ between
 * platforms. After rounding, the mesh is the same everywhere, and so is every byte of the
 * picture.
 */
vtkSmartPointer<vtkPolyData> OnGrid(vtkPolyDataAlgorithm* source);

/// A unit sphere about (x, y, 0) with point normals.
vtkSmartPointer<vtkPolyData> Sphere(double x, double y = 0, int resolution = 48);

/// A ring about the y axis, 2.5 wide.
vtkSmartPointer<vtkPolyData> Ring();

/// A property with diffuse reflection 1, ambient reflection 0 and this colour.
vtkSmartPointer<vtkProperty> Surface(double red, double green, double blue);

/// Add a mesh with its own property to the scene.
void AddSurface(vtkLambentRayTracer* tracer, vtkPolyData* mesh, vtkProperty* property);

/// Add an infinitely distant light that shines from the direction (x, y, z).
void AddLight(vtkLambentRayTracer* tracer, double x, double y, double z, double red = 1,
  double green = 1, double blue = 1);

/// Show a grid of columns x rows places, Step apart, the first about the origin, each of
/// pixels x pixels pixels.
void ShowPlaces(vtkLambentRayTracer* tracer, int columns, int rows, int pixels);

/// Look at the origin from (x, y, z), with a view angle of 30 degrees.
void LookFrom(vtkLambentRayTracer* tracer, double x, double y, double z, int width, int height);

/// Write the output of an algorithm to the PNG file that the first argument names, or else to
/// `name`. Returns the exit status of the example.
int Save(vtkImageAlgorithm* picture, const char* name, int argc, char* argv[]);

} // namespace gallery

#endif
