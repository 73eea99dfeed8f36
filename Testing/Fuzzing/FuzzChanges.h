// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief change a ray tracer's camera, lights, properties and background by the bytes of a fuzzer
 */
#ifndef FuzzChanges_h
#define FuzzChanges_h

#include "FuzzInput.h"

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkImageData;
class vtkLight;
class vtkProperty;

void change(FuzzInput& input, vtkCamera* camera);
void change(FuzzInput& input, vtkLight* light);
void change(FuzzInput& input, vtkProperty* property);

/// Changes opacity, highlights, representation, widths, edges and vertices.
void changeLook(FuzzInput& input, vtkProperty* property);

/// An image for the background, occasionally of an invalid type or size.
vtkSmartPointer<vtkImageData> makeFuzzImage(FuzzInput& input);

#endif
