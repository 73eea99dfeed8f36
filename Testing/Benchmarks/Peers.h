// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the renderers of a scene, and what is timed
 *
 * The contests of a scene are
 *
 *     lambent                       vtkLambentRayTracer, the whole picture
 *     embree/build/QUALITY          low, medium, high
 *     embree/trace/QUALITY/RAYS     single, packets, stream, packet-stream
 *     supersampling-N/lambent, supersampling-N/embree/trace/QUALITY/RAYS
 *                                   the same with N x N samples per pixel, N = 2 or 4
 *     layers/lambent, layers/embree/trace/QUALITY/packets
 *                                   the same with transparent surfaces: all hits of each ray
 *     balls/lambent, balls/build/QUALITY, balls/trace/QUALITY
 *                                   spheres, by Lambent and by Embree's sphere geometry
 *     looks/colors, looks/texture, looks/edges
 *                                   vtkLambentRayTracer with a point array through a table, with a
 *                                   texture, and with the edges of cells
 *     opengl/first                  the first frame, with its window; needs an X server
 *     opengl/new-mesh               another mesh in the same window
 *     opengl/next                   the same mesh again
 *     layers/opengl                 the same with transparent surfaces, by depth peeling
 *     normals/FILTER                vtkLambentNormals and its peers
 *     surfaces/inputs               vtkLambentRayTracer with each piece of the mesh as an input
 *     surfaces/executive            only VTK's executive, with as many inputs
 *     surfaces/one, surfaces/many   the core with the mesh as one surface, each piece as one
 *
 * and all but those of OpenGL also on one thread, with the prefix "1-thread/".
 */
#ifndef Peers_h
#define Peers_h

#include "EmbreeBalls.h"
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
  std::function<double()> run; ///< runs once and returns the timed seconds
};

/// The values of Supersampling that have separate contests.
constexpr int supersamplings[] = { 2, 4 };

/// The name of a contest or a picture with that Supersampling: "supersampling-2/NAME", or NAME.
std::string withSamples(const std::string& name, int samples);

/// All peers of a scene. Each is created on first use.
class Peers
{
public:
  explicit Peers(const BenchmarkScene& scene);

  /// The contests whose whole name matches a regular expression.
  std::vector<Contest> contests(const std::string& regex);

  LambentRenderer& lambent();
  EmbreeRenderer& embree();
  OpenGLRenderer& opengl();
  EmbreeBalls& balls();
  ManySurfaces& surfaces();

private:
  std::vector<Contest> all();
  void addPictures(std::vector<Contest>& contests, int samples);
  void addBalls(std::vector<Contest>& contests);
  void addLooks(std::vector<Contest>& contests);
  void addLayers(std::vector<Contest>& contests);
  void addSurfaces(std::vector<Contest>& contests);

  const BenchmarkScene& Scene;
  vtkSmartPointer<vtkPolyData> BareMesh;
  std::unique_ptr<LambentRenderer> Lambent;
  std::unique_ptr<EmbreeRenderer> Embree;
  std::unique_ptr<OpenGLRenderer> OpenGL;
  std::unique_ptr<EmbreeBalls> Balls;
  std::unique_ptr<ManySurfaces> Surfaces;
};

#endif
