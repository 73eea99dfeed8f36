// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomLines.h"

#include "RandomNumbers.h"

#include <cmath>
#include <limits>

using namespace lambent;

namespace
{
struct Lines
{
  std::vector<Vec3> points;
  std::vector<std::int32_t> corners;

  void add(const Vec3& a, const Vec3& b)
  {
    for (const Vec3& end : { a, b })
    {
      this->corners.push_back(static_cast<std::int32_t>(this->points.size()));
      this->points.push_back(end);
    }
  }
  void addPoint(const Vec3& p)
  {
    this->corners.insert(this->corners.end(), 2, static_cast<std::int32_t>(this->points.size()));
    this->points.push_back(p);
  }
};

/// What the camera looks at, and how far it is.
struct Place
{
  Vec3 center;
  double size;
};

void addScattered(RandomNumbers& random, const Place& place, int count, double length, Lines& to)
{
  for (int k = 0; k < count; ++k)
  {
    const Vec3 a = place.center + random.inBox(0.6 * place.size);
    to.add(a, a + random.inBox(length * place.size));
  }
}

void addPoints(RandomNumbers& random, const Place& place, int count, Lines& to)
{
  for (int k = 0; k < count; ++k)
  {
    to.addPoint(place.center + random.inBox(0.6 * place.size));
  }
}

/// Lines that share their ends.
void addPolylines(RandomNumbers& random, const Place& place, Lines& to)
{
  for (int k = 0; k < 10; ++k)
  {
    Vec3 end = place.center + random.inBox(0.4 * place.size);
    to.points.push_back(end);
    for (int step = 0; step < 20; ++step)
    {
      const auto last = static_cast<std::int32_t>(to.points.size()) - 1;
      end = end + random.inBox(0.1 * place.size);
      to.points.push_back(end);
      to.corners.push_back(last);
      to.corners.push_back(last + 1);
    }
  }
}

/// From far beyond the picture down to nothing, where rounding is all that is left.
void addOfAllLengths(RandomNumbers& random, const Place& place, Lines& to)
{
  for (int k = 0; k < 100; ++k)
  {
    const Vec3 middle = place.center + random.inBox(0.6 * place.size);
    const double length = place.size * std::pow(10.0, random.within(-20.0, 6.0));
    to.add(middle + random.inBox(length), middle + random.inBox(length));
  }
  for (const double length : { 1e-200, 1e-100, 1e100, 1e160, 1e308 })
  {
    to.add(place.center, random.inBox(0.5) * length);
  }
}

/// Along the axes of the world and of the picture.
void addStraight(RandomNumbers& random, const Place& place, Lines& to)
{
  for (int k = 0; k < 30; ++k)
  {
    const Vec3 a = place.center + random.inBox(0.5 * place.size);
    Vec3 b = a;
    b[k % 3] += random.within(-0.5, 0.5) * place.size;
    to.add(a, b);
  }
}

/// Some twice, and some turned.
void addTies(RandomNumbers& random, const Place& place, Lines& to)
{
  addScattered(random, place, 15, 0.5, to);
  addPoints(random, place, 10, to);
  for (std::size_t k = 0; k < 50; k += 2)
  {
    const std::int32_t a = to.corners[k], b = to.corners[k + 1];
    to.corners.push_back(k % 3 == 0 ? b : a);
    to.corners.push_back(k % 3 == 0 ? a : b);
  }
}

Lines makeLines(RandomNumbers& random, const Camera& camera, int kind)
{
  const Place seen{ camera.focalPoint, length(camera.focalPoint - camera.position) };
  const Place atEye{ camera.position, seen.size };
  Lines result;
  switch (kind)
  {
    case 0:
      addScattered(random, seen, 30, 1.0, result);
      break;
    case 1:
      addScattered(random, seen, 1000, 0.01, result);
      addPoints(random, seen, 200, result);
      break;
    case 2: // through the plane of the eye, in all directions
      addScattered(random, atEye, 60, 2.0, result);
      addPoints(random, atEye, 60, result);
      break;
    case 3:
      addPolylines(random, seen, result);
      break;
    case 4:
      addOfAllLengths(random, seen, result);
      break;
    case 5:
      addTies(random, seen, result);
      break;
    case 6: // just before, across and behind the plane of the eye
      addScattered(random, { camera.position, 0.01 * seen.size }, 60, 1.0, result);
      break;
    default:
      addStraight(random, seen, result);
  }
  return result;
}

void spoil(RandomNumbers& random, Lines& lines)
{
  const double bad[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  for (Vec3& point : lines.points)
  {
    if (random.below(40) == 0)
    {
      point[random.below(3)] = bad[random.below(2)];
    }
  }
}

void addSurface(RandomNumbers& random, const Lines& lines, bool isPrecise, RandomScene& scene)
{
  auto data = std::make_unique<RandomScene::MeshData>();
  data->corners32 = lines.corners;
  data->corners64.assign(lines.corners.begin(), lines.corners.end());
  for (const Vec3& point : lines.points)
  {
    const Vec3 normal = random.inBox(1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      data->doublePoints.push_back(point[axis]);
      data->floatPoints.push_back(static_cast<float>(point[axis]));
      data->normals.push_back(static_cast<float>(normal[axis]));
    }
  }
  Surface surface;
  surface.points = isPrecise || random.below(2) == 0
    ? TupleSpan{ data->doublePoints.data(), true, lines.points.size() }
    : TupleSpan{ data->floatPoints.data(), false, lines.points.size() };
  surface.corners = random.below(2) == 0
    ? IndexSpan{ data->corners32.data(), false, lines.corners.size() }
    : IndexSpan{ data->corners64.data(), true, lines.corners.size() };
  surface.width = random.below(3) == 0 ? random.within(0.5, 50.0) : random.within(0.5, 5.0);
  surface.isRounded = random.below(3) == 0;
  if (random.below(2) == 0)
  {
    surface.pointNormals = { data->normals.data(), false, lines.points.size() };
  }
  Appearance& appearance = surface.appearance;
  appearance.diffuseColor = { random.within(0.0, 1.0), random.within(0.0, 1.0), 0.5 };
  appearance.ambient = random.within(0.0, 0.3);
  appearance.shading = static_cast<Shading>(random.below(3));
  appearance.cullFront = random.below(6) == 0; // changes nothing
  scene.scene.surfaces.insert(
    scene.scene.surfaces.begin() + random.below(static_cast<int>(scene.scene.surfaces.size()) + 1),
    surface);
  scene.meshes.push_back(std::move(data));
}
}

RandomScene makeRandomLines(unsigned int seed)
{
  RandomScene result = makeRandomScene(seed);
  RandomNumbers random(seed);
  const int kind = static_cast<int>(seed % randomLineKinds);
  if (seed % 3 != 0)
  {
    result.scene.surfaces.clear();
  }
  const Camera& camera = result.scene.camera;
  const double distance = length(camera.focalPoint - camera.position);
  for (int surfaces = 1 + random.below(3); surfaces > 0; --surfaces)
  {
    Lines lines = makeLines(random, camera, kind);
    spoil(random, lines);
    addSurface(random, lines, kind == 4 || length(camera.position) > 1e4 * distance, result);
  }
  result.name += ", lines of kind " + std::to_string(kind);
  return result;
}

RandomScene makeFewRandomLines(unsigned int seed)
{
  RandomScene random = makeRandomLines(seed);
  random.width = 1 + static_cast<int>(seed % 23);
  random.height = 1 + static_cast<int>(seed % 17);
  return random;
}
