// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScenes.h"

#include <cstdint>
#include <limits>

using lambent::Vec3;

namespace
{
/// The standard's generators are portable, its distributions are not.
class Random
{
public:
  explicit Random(unsigned int seed)
    : State(seed * 2654435761u + 12345u)
  {
  }
  std::uint32_t bits() // PCG, M. O'Neill 2014
  {
    const std::uint64_t old = this->State;
    this->State = old * 6364136223846793005ull + 1442695040888963407ull;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<unsigned int>(old >> 59);
    return (mixed >> turn) | (mixed << ((32 - turn) & 31));
  }
  int below(int n) { return static_cast<int>(this->bits() % static_cast<std::uint32_t>(n)); }
  bool chance(int oneIn) { return this->below(oneIn) == 0; }
  double unit() { return this->bits() * (1.0 / 4294967296.0); }
  double within(double low, double high) { return low + (high - low) * this->unit(); }
  Vec3 inBox(double r)
  {
    const double x = this->within(-r, r), y = this->within(-r, r), z = this->within(-r, r);
    return { x, y, z };
  }

private:
  std::uint64_t State;
};

struct Triangles
{
  std::vector<Vec3> points;
  std::vector<int> corners;

  void add(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    for (const Vec3& p : { a, b, c })
    {
      this->corners.push_back(static_cast<int>(this->points.size()));
      this->points.push_back(p);
    }
  }
};

Triangles soup(Random& random, int count, double size)
{
  Triangles result;
  for (int k = 0; k < count; ++k)
  {
    const Vec3 center = random.inBox(1.0);
    result.add(
      center + random.inBox(size), center + random.inBox(size), center + random.inBox(size));
  }
  return result;
}

Triangles needles(Random& random, int count)
{
  Triangles result;
  for (int k = 0; k < count; ++k)
  {
    const Vec3 a = random.inBox(1.5), b = random.inBox(1.5);
    // Some have zero width, or a width of a few units in the last place.
    const double width = random.chance(4) ? 0.0 : random.chance(3) ? 1e-15 : 1e-3;
    result.add(a, b, b + random.inBox(width));
  }
  return result;
}

/// A closed surface: an octahedron, subdivided, on a lumpy sphere.
Triangles closed(Random& random, int levels, double radius)
{
  Triangles mesh;
  mesh.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mesh.corners = { 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5 };
  for (int level = 0; level < levels; ++level)
  {
    std::vector<int> finer;
    for (std::size_t t = 0; t < mesh.corners.size(); t += 3)
    {
      // Children of different parents do not share points. The same sum in the same order
      // makes the points equal anyway.
      int middles[3];
      for (int k = 0; k < 3; ++k)
      {
        int p = mesh.corners[t + k], q = mesh.corners[t + (k + 1) % 3];
        const Vec3 sum = mesh.points[p] + mesh.points[q];
        middles[k] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(lambent::normalized(sum));
      }
      const int a = mesh.corners[t], b = mesh.corners[t + 1], c = mesh.corners[t + 2];
      const int children[12] = { a, middles[0], middles[2], middles[0], b, middles[1], middles[2],
        middles[1], c, middles[0], middles[1], middles[2] };
      finer.insert(finer.end(), children, children + 12);
    }
    mesh.corners = finer;
  }
  const Vec3 wave = random.inBox(4.0);
  for (Vec3& p : mesh.points)
  {
    const double bump = lambent::dot(p, wave);
    p = p * (radius * (1.0 + 0.2 * bump * bump / 48.0));
  }
  return mesh;
}

/// Rectangles in a few planes, divided along either diagonal; many of them are equal.
Triangles coplanar(Random& random, int count)
{
  Triangles result;
  for (int k = 0; k < count; ++k)
  {
    const double z = 0.25 * random.below(3), x = 0.125 * random.below(8) - 0.5,
                 y = 0.125 * random.below(8) - 0.5, s = 0.125 * (1 + random.below(4));
    const Vec3 a(x, y, z), b(x + s, y, z), c(x + s, y + s, z), d(x, y + s, z);
    if (random.chance(2))
    {
      result.add(a, b, c);
      result.add(a, c, d);
    }
    else
    {
      result.add(b, a, d);
      result.add(b, d, c);
    }
  }
  return result;
}

/// Large triangles on all sides of the eye. In some, a corner, an edge or the plane goes exactly
/// through the eye.
Triangles throughEye(Random& random, int count, const Vec3& eye)
{
  Triangles result;
  for (int k = 0; k < count; ++k)
  {
    Vec3 a = eye + random.inBox(4.0), b = eye + random.inBox(4.0), c = eye + random.inBox(4.0);
    switch (random.below(5))
    {
      case 0:
        a = eye;
        break;
      case 1:
        b = eye - (a - eye);
        break;
      case 2:
        a.y = b.y = c.y = eye.y;
        break;
      default:
        break;
    }
    result.add(a, b, c);
  }
  return result;
}

/// A grid whose points fall on pixel centres for a camera that looks along an axis.
Triangles grid(int n)
{
  Triangles result;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto at = [n](int x, int y) { return Vec3(x - n / 2, y - n / 2, 0.0); };
      result.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      result.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return result;
}

void place(Triangles& mesh, const Vec3& scale, const Vec3& origin)
{
  for (Vec3& p : mesh.points)
  {
    p = p * scale + origin;
  }
}

void addMesh(Random& random, RandomScene& scene, const Triangles& mesh, bool precise)
{
  auto data = std::make_unique<RandomScene::MeshData>();
  const bool isDouble = precise || random.chance(2), is64Bit = random.chance(2);
  lambent::Surface surface;
  for (const Vec3& p : mesh.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      data->doublePoints.push_back(p[axis]);
      data->floatPoints.push_back(static_cast<float>(p[axis]));
      data->normals.push_back(static_cast<float>(random.within(-1.0, 1.0)));
    }
  }
  data->corners32.assign(mesh.corners.begin(), mesh.corners.end());
  data->corners64.assign(mesh.corners.begin(), mesh.corners.end());
  const void* points = isDouble ? static_cast<const void*>(data->doublePoints.data())
                                : static_cast<const void*>(data->floatPoints.data());
  surface.points = { points, isDouble, mesh.points.size() };
  const void* corners = is64Bit ? static_cast<const void*>(data->corners64.data())
                                : static_cast<const void*>(data->corners32.data());
  surface.corners = { corners, is64Bit, mesh.corners.size() };
  surface.pointNormals = { data->normals.data(), false, mesh.points.size() };

  lambent::Appearance& appearance = surface.appearance;
  appearance.diffuseColor = { random.unit(), random.unit(), random.unit() };
  appearance.ambient = 1.0;
  appearance.ambientColor = appearance.diffuseColor * random.within(0.0, 0.5);
  appearance.shading = random.chance(6) ? lambent::Shading::Unlit
    : random.chance(2)                  ? lambent::Shading::Flat
                                        : lambent::Shading::Smooth;
  appearance.cullFront = random.chance(10);
  appearance.cullBack = random.chance(10);
  const bool hasCellNormals = appearance.shading == lambent::Shading::Flat &&
    scene.meshes.size() % 2 == 1 && surface.triangleCount() <= mesh.points.size();
  if (hasCellNormals)
  {
    surface.cellNormals = { data->normals.data(), false, surface.triangleCount() };
  }
  scene.scene.surfaces.push_back(surface);
  scene.meshes.push_back(std::move(data));
}

void addLights(Random& random, lambent::Scene& scene, double size, const Vec3& origin)
{
  const int count = random.below(4);
  for (int k = 0; k < count; ++k)
  {
    lambent::Light light;
    light.positional = random.chance(2);
    light.position = origin + random.inBox(3.0 * size);
    light.direction = origin + random.inBox(0.5 * size) - light.position;
    light.color = { random.unit(), random.unit(), random.unit() };
    light.coneAngle = random.chance(2) ? 90.0 : random.within(5.0, 60.0);
    light.exponent = random.chance(3) ? random.within(0.0, 5.0) : random.below(4);
    if (random.chance(3))
    {
      light.attenuation = { random.unit(), random.unit() / size, random.unit() / (size * size) };
    }
    scene.lights.push_back(light);
  }
  scene.ambientModel =
    random.chance(3) ? lambent::AmbientModel::Scene : lambent::AmbientModel::PerLight;
  scene.twoSidedLighting = !random.chance(3);
  scene.background = { random.unit(), random.unit(), random.unit() };
  scene.backgroundTop =
    random.chance(2) ? scene.background : Vec3(random.unit(), random.unit(), random.unit());
}

void aim(Random& random, lambent::Camera& camera, double size, const Vec3& origin, bool inside)
{
  camera.focalPoint = origin + random.inBox(0.2 * size);
  camera.position = origin + random.inBox(1.0) * (inside ? 0.4 * size : 4.0 * size);
  camera.viewUp = random.inBox(1.0);
  camera.viewAngle = random.within(10.0, 100.0);
  camera.horizontalViewAngle = random.chance(3);
  camera.parallel = random.chance(3);
  camera.parallelScale = random.within(0.3, 2.0) * size;
  if (random.chance(4))
  {
    camera.windowCenter[0] = random.within(-1.5, 1.5);
    camera.windowCenter[1] = random.within(-1.5, 1.5);
  }
}

/// A camera for grid(n). It uses only whole numbers and halves, so that rays hit points and edges
/// exactly.
void aimAtGrid(Random& random, RandomScene& scene)
{
  lambent::Camera& camera = scene.scene.camera;
  camera.position = { 0.5 * random.below(2), 0.5 * random.below(2), 16.0 };
  camera.focalPoint = camera.position - Vec3(0.0, 0.0, 1.0);
  camera.parallel = true;
  camera.parallelScale = 0.5 * scene.height;
}
}

RandomScene makeRandomScene(unsigned int seed)
{
  static const int sizes[][2] = { { 1, 1 }, { 1, 23 }, { 41, 1 }, { 37, 23 }, { 64, 64 },
    { 97, 33 }, { 33, 65 } };
  Random random(seed);
  RandomScene result;
  const int* size = sizes[random.below(sizeof(sizes) / sizeof(sizes[0]))];
  result.width = size[0];
  result.height = size[1];

  const int kind = static_cast<int>(seed % randomSceneKinds);
  const Vec3 far(1e7 + random.unit(), -3e7, 5e6);
  double extent = 1.0;
  Vec3 origin(0.0);
  if (kind == 7 || kind == 8)
  {
    extent = kind == 7 ? 1e-3 : 1e3;
    origin = far;
  }
  aim(random, result.scene.camera, extent, origin, kind == 3);
  addLights(random, result.scene, extent, origin);

  static const char* const names[randomSceneKinds] = { "soup", "fine soup", "needles",
    "closed, from inside", "closed", "coplanar", "through the eye", "tiny and far", "large and far",
    "grid on rays" };
  result.name = names[kind];
  const int surfaces = 1 + random.below(3);
  for (int k = 0; k < surfaces; ++k)
  {
    Triangles mesh;
    switch (kind)
    {
      case 0:
        mesh = soup(random, 60, 0.6);
        break;
      case 1:
        mesh = soup(random, 3000, 0.03);
        break;
      case 2:
        mesh = needles(random, 300);
        break;
      case 3:
      case 4:
        mesh = closed(random, 4, 1.0 / (k + 1));
        break;
      case 5:
        mesh = coplanar(random, 60);
        break;
      case 6:
        mesh = throughEye(random, 40, result.scene.camera.position);
        break;
      case 9:
        mesh = grid(24);
        break;
      default:
        mesh = random.chance(2) ? soup(random, 200, 0.3) : closed(random, 3, 1.0);
        place(mesh, Vec3(extent), origin);
    }
    addMesh(random, result, mesh, kind == 6 || kind == 7 || kind == 8);
  }
  if (kind == 9)
  {
    aimAtGrid(random, result);
  }
  return result;
}
