// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "HardMeshes.h"
#include "Meshes.h"

#include "vtkMath.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>

namespace
{
constexpr double halfViewAngle = 15.0;

struct Sphere
{
  Triple center;
  double radius;
};

Sphere boundingSphere(vtkPolyData* mesh)
{
  double b[6];
  mesh->GetBounds(b);
  const double dx = b[1] - b[0], dy = b[3] - b[2], dz = b[5] - b[4];
  return { { (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2 },
    std::sqrt(dx * dx + dy * dy + dz * dz) / 2 };
}

Triple beside(const Triple& center, double distance, Triple direction)
{
  vtkMath::Normalize(direction.data());
  return { center[0] + distance * direction[0], center[1] + distance * direction[1],
    center[2] + distance * direction[2] };
}

void lookAt(const Sphere& sphere, BenchmarkScene& scene)
{
  const double distance = sphere.radius / std::sin(vtkMath::RadiansFromDegrees(halfViewAngle));
  scene.camera->SetViewAngle(2 * halfViewAngle);
  scene.camera->SetFocalPoint(sphere.center.data());
  scene.camera->SetPosition(beside(sphere.center, distance, { 0.4, 0.3, 1.0 }).data());
  scene.camera->SetViewUp(0, 1, 0);
  scene.camera->SetParallelScale(sphere.radius);
  scene.light->SetLightTypeToSceneLight();
  scene.light->SetPositional(true);
  scene.light->SetConeAngle(180);
  scene.light->SetPosition(beside(sphere.center, 4 * sphere.radius, { -0.5, 0.8, 1.0 }).data());
}

/// A name of the form "PREFIXnumber".
bool hasNumber(const std::string& name, const char* prefix, std::size_t& number)
{
  const std::string start(prefix);
  if (name.compare(0, start.size(), start) != 0)
  {
    return false;
  }
  number = std::stoul(name.substr(start.size()));
  return true;
}

using Meshes = std::map<std::string, std::function<vtkSmartPointer<vtkPolyData>()>>;

Meshes fixedMeshes(const std::string& data, const std::string& cache)
{
  const auto file = [data](const char* name)
  { return [path = data + "/" + name]() { return readMesh(path); }; };
  const auto wave = [cache](int half) { return [half, cache]() { return makeWave(half, cache); }; };
  return { { "bunny", file("bunny.ply") }, { "dragon", file("dragon.ply") },
    { "dragon-zoom", file("dragon.ply") }, { "dragon-parallel", file("dragon.ply") },
    { "dragon-uhd", file("dragon.ply") }, { "wave-300", wave(300) }, { "wave-600", wave(600) },
    { "layers", makeLayers }, { "needles", makeNeedles }, { "one-pixel", makeOnePixel },
    { "soup", makeSoup }, { "box", makeBox }, { "curtain", makeCurtain }, { "late", makeLate },
    { "facets", makeFacets }, { "spheres", makeSpheres }, { "balls", makeBalls },
    { "lines", makeLines } };
}

void adjust(const std::string& name, BenchmarkScene& scene)
{
  scene.ballRadius = name == "balls" ? 0.006 : 0.0; // of about ten pixels
  scene.pieces = name == "facets" ? 100000 : name == "spheres" ? 3000 : 1;
  if (name == "dragon-zoom")
  {
    scene.camera->Zoom(2);
  }
  else if (name == "dragon-parallel")
  {
    scene.camera->ParallelProjectionOn();
  }
  else if (name == "dragon-uhd")
  {
    scene.width = 3840;
    scene.height = 2160;
  }
  else if (name == "box")
  {
    scene.camera->Zoom(5);
  }
  else if (name == "layers" || name == "needles")
  {
    // From the front, and wider than the image.
    double center[3];
    scene.camera->GetFocalPoint(center);
    scene.camera->SetPosition(center[0], center[1], center[2] + scene.camera->GetDistance());
    scene.camera->Zoom(name == "layers" ? 4 : 2.5);
  }
}
}

//------------------------------------------------------------------------------
View BenchmarkScene::view() const
{
  View view;
  Triple focus;
  this->camera->GetPosition(view.eye.data());
  this->camera->GetFocalPoint(focus.data());
  vtkMath::Subtract(focus.data(), view.eye.data(), view.forward.data());
  vtkMath::Normalize(view.forward.data());
  vtkMath::Cross(view.forward.data(), this->camera->GetViewUp(), view.right.data());
  vtkMath::Normalize(view.right.data());
  vtkMath::Cross(view.right.data(), view.forward.data(), view.up.data());
  view.parallel = this->camera->GetParallelProjection() != 0;
  const double halfHeight = view.parallel
    ? this->camera->GetParallelScale()
    : std::tan(vtkMath::RadiansFromDegrees(this->camera->GetViewAngle() / 2));
  view.pixel = 2 * halfHeight / this->height;
  this->light->GetPosition(view.light.data());
  return view;
}

std::vector<std::string> sceneNames()
{
  std::vector<std::string> names;
  for (const auto& mesh : fixedMeshes("", ""))
  {
    names.push_back(mesh.first);
  }
  return names;
}

void makeScene(
  const std::string& name, const std::string& data, const std::string& cache, BenchmarkScene& scene)
{
  const std::string meshName = name.substr(0, name.find('@'));
  const Meshes meshes = fixedMeshes(data, cache);
  const auto fixed = meshes.find(meshName);
  std::size_t triangles = 0;
  if (fixed != meshes.end())
  {
    scene.mesh = fixed->second();
  }
  else if (hasNumber(meshName, "bumps-", triangles))
  {
    scene.mesh = makeBumps(triangles);
  }
  else
  {
    throw std::invalid_argument("there is no scene '" + name + "'");
  }
  if (!scene.mesh)
  {
    throw SceneMissing{ "its file is not in '" + data + "'" };
  }
  scene.name = name;
  lookAt(boundingSphere(scene.mesh), scene);
  adjust(meshName, scene);
  if (meshName.size() < name.size() &&
    std::sscanf(name.c_str() + meshName.size(), "@%dx%d", &scene.width, &scene.height) != 2)
  {
    throw std::invalid_argument("'" + name + "' does not end in @WIDTHxHEIGHT");
  }
}
