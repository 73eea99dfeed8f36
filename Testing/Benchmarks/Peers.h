// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief who draws a scene, and what of it is timed
 *
 * The contests of a scene are
 *
 *     lambent                       vtkLambentRayTracer, the whole picture
 *     embree/build/QUALITY          low, medium, high
 *     embree/trace/QUALITY/RAYS     single, packets, stream, packet-stream
 *     opengl/first                  the first frame, with its window; needs an X server
 *     opengl/new-mesh               that of another mesh in the same window
 *     opengl/next                   the same mesh again
 *     normals/FILTER                vtkLambentNormals and its peers
 *     surfaces/inputs               vtkLambentRayTracer with each piece of the mesh as an input
 *     surfaces/one, surfaces/many   the core with the mesh as one surface, each piece as one
 *
 * and all but those of OpenGL once more on one thread, "1-thread/" before the name.
 */
#ifndef Peers_h
#define Peers_h

#include "EmbreeRenderer.h"
#include "LambentRenderer.h"
#include "ManySurfaces.h"
#include "OpenGLRenderer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

struct Contest
{
  std::string name;
  std::function<double()> run; ///< once; gives the seconds that count
};

/// All peers of a scene. A peer is made when it is first asked for.
class Peers
{
public:
  explicit Peers(const BenchmarkScene& scene);

  /// Those whose names match a regular expression as a whole.
  std::vector<Contest> contests(const std::string& regex);

  LambentRenderer& lambent();
  EmbreeRenderer& embree();
  OpenGLRenderer& opengl();
  ManySurfaces& surfaces();

private:
  std::vector<Contest> all();

  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkPolyData> BareMesh;
  std::unique_ptr<LambentRenderer> Lambent;
  std::unique_ptr<EmbreeRenderer> Embree;
  std::unique_ptr<OpenGLRenderer> OpenGL;
  std::unique_ptr<ManySurfaces> Surfaces;
};

#endif
