// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what the examples of the gallery share
 *
 * Most of them are a row of objects of about unit size, seen from the front in
 * parallel projection, on grey so that a black surface shows.
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

/// From one object of a row to the next.
constexpr double Step = 2.5;

/**
 * The output of a source, each coordinate of its points and normals rounded to the
 * nearest multiple of 2^-12.
 *
 * VTK's round sources take sines and cosines from the platform, and these differ
 * in the last bits from one to the next. Rounded, the mesh is the same everywhere,
 * and so is every byte of the picture.
 */
vtkSmartPointer<vtkPolyData> OnGrid(vtkPolyDataAlgorithm* source);

/// A unit sphere about (x, y, 0) with normals of its own.
vtkSmartPointer<vtkPolyData> Sphere(double x, double y = 0, int resolution = 48);

/// A surface of diffuse reflection 1, ambient reflection 0 and this colour.
vtkSmartPointer<vtkProperty> Surface(double red, double green, double blue);

/// One more mesh in the scene, with a property of its own.
void AddSurface(vtkLambentRayTracer* tracer, vtkPolyData* mesh, vtkProperty* property);

/// A light from infinitely far away, coming from the direction of (x, y, z).
void AddLight(vtkLambentRayTracer* tracer, double x, double y, double z, double red = 1,
  double green = 1, double blue = 1);

/// Show columns x rows places, Step apart, the first about the origin, at so many pixels a place.
void ShowPlaces(vtkLambentRayTracer* tracer, int columns, int rows, int pixels);

/// Look at the origin from (x, y, z), 30 degrees high.
void LookFrom(vtkLambentRayTracer* tracer, double x, double y, double z, int width, int height);

/// Write what an algorithm produces to the PNG file that the first argument names, or else to
/// `name`. Returns the exit status of the example.
int Save(vtkImageAlgorithm* picture, const char* name, int argc, char* argv[]);

} // namespace gallery

#endif
