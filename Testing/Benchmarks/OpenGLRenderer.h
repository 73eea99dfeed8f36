// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the same picture by VTK's OpenGL renderer
 *
 * Needs an X server. The pixels are read back, since the peers give an image too.
 */
#ifndef OpenGLRenderer_h
#define OpenGLRenderer_h

#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

class OpenGLRenderer
{
public:
  /// False without an X server.
  static bool isAvailable();

  explicit OpenGLRenderer(const BenchmarkScene& scene);

  /// Seconds for the first picture that a program makes: a window of its own with its
  /// context and shaders, and a mesh that OpenGL has not seen before.
  double first();

  /// Seconds for a mesh that it has not seen before in a window that is there.
  double newMesh();

  /// Seconds for the same mesh again.
  double next();

  vtkImageData* picture() { return this->Picture; }

  /// Who draws: "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string device();

private:
  void open();
  void load();
  void draw();

  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
