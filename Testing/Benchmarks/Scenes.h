// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scenes: a mesh, a camera, one point light, a size
 *
 * The camera looks from the direction (0.4, 0.3, 1) at the centre of the mesh; the
 * bounding sphere is just in view. View holds all that a peer needs to render the same
 * picture, as plain numbers.
 */
#ifndef Scenes_h
#define Scenes_h

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

using Triple = std::array<double, 3>;

/// The ray of pixel (i, j) goes through eye + forward + x right + y up with
/// x = (i + 1/2 - width / 2) pixel and y likewise; if parallel it starts at
/// eye + x right + y up and runs along forward.
struct View
{
  Triple eye, right, up, forward;
  double pixel;
  bool parallel;
  Triple light;
};

struct BenchmarkScene
{
  std::string name;
  vtkSmartPointer<vtkPolyData> mesh; ///< triangles, float points, float point normals
  vtkNew<vtkCamera> camera;
  vtkNew<vtkLight> light;
  double ballRadius = 0.0; ///< unless 0, the points are spheres, and there are no triangles
  int pieces = 1; ///< of equally many triangles and points, which follow each other in the mesh
  int width = 1920;
  int height = 1080;

  View view() const;
};

/// The opacity of surfaces in the contests with transparency.
constexpr double layerOpacity = 0.3;

/// The names of the fixed scenes. There is also "bumps-T", a mesh of about T triangles. Any name
/// can be followed by "@WIDTHxHEIGHT" for another size.
std::vector<std::string> sceneNames();

/**
 * Make a scene. data: the folder with bunny.ply and dragon.ply; cache: a folder for
 * meshes that are slow to make. Throws std::invalid_argument if there is no scene
 * of that name, and SceneMissing if a file that it needs is missing.
 */
void makeScene(const std::string& name, const std::string& data, const std::string& cache,
  BenchmarkScene& scene);

/// The message names the file.
struct SceneMissing
{
  std::string message;
};

#endif
