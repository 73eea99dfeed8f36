// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomSpheres.h"

#include "RandomNumbers.h"

#include <cmath>
#include <limits>

using namespace lambent;

namespace
{
struct Spheres
{
  std::vector<Vec3> centers;
  std::vector<double> radii;

  void add(const Vec3& center, double radius)
  {
    this->centers.push_back(center);
    this->radii.push_back(radius);
  }
};

/// Where the camera is, and how far from what it looks at.
struct Place
{
  Vec3 eye, focalPoint;
  double size;
};

void addScattered(RandomNumbers& random, const Place& place, int count, double largest, Spheres& to)
{
  for (int k = 0; k < count; ++k)
  {
    to.add(
      place.focalPoint + random.inBox(0.6 * place.size), place.size * random.within(0.0, largest));
  }
}

/// Far larger than the picture. The eye is a little outside or inside, or far inside.
void addHuge(RandomNumbers& random, const Place& place, Spheres& to)
{
  for (int k = 0; k < 10; ++k)
  {
    const double radius = place.size * std::pow(10.0, random.within(-0.5, 6.0));
    const double distance =
      radius * random.within(0.0, 2.0) * (k % 2 ? 1e-3 : 1.0) + (k % 2 ? radius : 0.0);
    to.add(place.eye + normalized(random.inBox(1.0)) * distance, radius);
  }
}

/// From the size of the scene down to nothing, where rounding is all that is left.
void addOfAllSizes(RandomNumbers& random, const Place& place, Spheres& to)
{
  for (int k = 0; k < 300; ++k)
  {
    const double radius = place.size * std::pow(10.0, random.within(-20.0, 0.0));
    to.add(place.focalPoint + random.inBox(0.6 * place.size), radius);
  }
  for (const double radius : { 1e-200, 1e-100, 1e100, 1e153, 1e160, 1e308 })
  {
    to.add(place.eye + random.inBox(0.5) * radius, radius);
  }
}

/// Some twice, and some concentric.
void addTies(RandomNumbers& random, const Place& place, Spheres& to)
{
  addScattered(random, place, 20, 0.3, to);
  for (std::size_t k = 0; k < 20; ++k)
  {
    to.add(to.centers[k], to.radii[k] * (k % 3 == 0 ? 0.5 : 1.0));
  }
}

Spheres makeSpheres(RandomNumbers& random, const Place& place, int kind)
{
  Spheres result;
  switch (kind)
  {
    case 0:
      addScattered(random, place, 30, 0.3, result);
      break;
    case 1:
      addScattered(random, place, 2000, 0.01, result);
      break;
    case 2:
      addHuge(random, place, result);
      break;
    case 3: // around the eye
      addScattered(random, { place.eye, place.eye, place.size }, 60, 0.5, result);
      break;
    case 4:
      addOfAllSizes(random, place, result);
      break;
    case 5:
      addTies(random, place, result);
      break;
    default: // just before, across and behind the plane through the eye
      addScattered(random, { place.eye, place.eye, 0.01 * place.size }, 100, 1.0, result);
  }
  return result;
}

void spoil(RandomNumbers& random, Spheres& spheres)
{
  const double bad[] = { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  for (double& radius : spheres.radii)
  {
    radius = random.below(30) == 0 ? bad[random.below(4)] : radius;
  }
}

void addSurface(RandomNumbers& random, const Spheres& spheres, bool isPrecise, RandomScene& scene)
{
  auto data = std::make_unique<RandomScene::MeshData>();
  for (std::size_t k = 0; k < spheres.centers.size(); ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      data->doublePoints.push_back(spheres.centers[k][axis]);
      data->floatPoints.push_back(static_cast<float>(spheres.centers[k][axis]));
    }
    data->doubleRadii.push_back(spheres.radii[k]);
    data->floatRadii.push_back(static_cast<float>(spheres.radii[k]));
  }
  Surface surface;
  const std::size_t count = spheres.centers.size();
  surface.points = isPrecise || random.below(2) == 0
    ? TupleSpan{ data->doublePoints.data(), true, count }
    : TupleSpan{ data->floatPoints.data(), false, count };
  surface.radii = isPrecise || random.below(2) == 0
    ? ScalarSpan{ data->doubleRadii.data(), true, count }
    : ScalarSpan{ data->floatRadii.data(), false, count };
  surface.radius = random.below(2) == 0 ? 1.0 : random.within(0.5, 1.5);
  if (random.below(4) == 0)
  {
    surface.radius = std::fabs(spheres.radii.front()) + spheres.radii.back();
    surface.radii = ScalarSpan();
  }
  Appearance& appearance = surface.appearance;
  appearance.diffuseColor = { random.within(0.0, 1.0), random.within(0.0, 1.0), 0.5 };
  appearance.ambient = random.within(0.0, 0.3);
  appearance.shading = static_cast<Shading>(random.below(3));
  appearance.cullFront = random.below(6) == 0;
  appearance.cullBack = random.below(6) == 0;
  scene.scene.surfaces.insert(
    scene.scene.surfaces.begin() + random.below(static_cast<int>(scene.scene.surfaces.size()) + 1),
    surface);
  scene.meshes.push_back(std::move(data));
}
}

RandomScene makeRandomSpheres(unsigned int seed)
{
  RandomScene result = makeRandomScene(seed);
  RandomNumbers random(seed);
  const int kind = static_cast<int>(seed % randomSphereKinds);
  if (seed % 3 != 0)
  {
    result.scene.surfaces.clear();
  }
  const Camera& camera = result.scene.camera;
  const Place place{ camera.position, camera.focalPoint,
    length(camera.focalPoint - camera.position) };
  for (int surfaces = 1 + random.below(3); surfaces > 0; --surfaces)
  {
    Spheres spheres = makeSpheres(random, place, kind);
    spoil(random, spheres);
    addSurface(random, spheres, kind == 4 || length(place.eye) > 1e4 * place.size, result);
  }
  result.name += ", spheres of kind " + std::to_string(kind);
  return result;
}

RandomScene makeFewRandomSpheres(unsigned int seed)
{
  RandomScene random = makeRandomSpheres(seed);
  random.width = 1 + static_cast<int>(seed % 23);
  random.height = 1 + static_cast<int>(seed % 17);
  return random;
}
