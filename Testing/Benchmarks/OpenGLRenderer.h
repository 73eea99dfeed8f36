// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief render the same picture with VTK's OpenGL renderer
 *
 * Needs an X server. The pixels are read back, since the peers output an image, too.
 */
#ifndef OpenGLRenderer_h
#define OpenGLRenderer_h

#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

class OpenGLRenderer
{
public:
  /// Whether there is an X server.
  static bool isAvailable();

  explicit OpenGLRenderer(const BenchmarkScene& scene);

  /// The seconds for the first picture of a program: with a new window, context and shaders, and
  /// a mesh that is new to OpenGL.
  double first();

  /// The seconds for a new mesh in the existing window.
  double newMesh();

  /// The seconds for the same mesh again.
  double next();

  /// The seconds for the same mesh with transparent surfaces, by depth peeling.
  double nextLayers();

  vtkImageData* picture() { return this->Picture; }

  /// The device, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string device();

private:
  void open();
  void load();
  void draw();

  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
