// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestingCorners.h"

#include "CellBlocks.h"
#include "Elementary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

using Polygon = std::vector<std::int64_t>;

PolygonMesh PolygonMesh::doubled() const
{
  PolygonMesh result = *this;
  for (const Polygon& face : this->faces)
  {
    result.faces.emplace_back(face.rbegin(), face.rend());
  }
  return result;
}

PolygonMesh PolygonMesh::mirrored() const
{
  PolygonMesh result = *this;
  for (Vec3& point : result.points)
  {
    point.x = -point.x;
  }
  return result;
}

PolygonMesh toFloats(PolygonMesh mesh)
{
  for (Vec3& point : mesh.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // volatile: GCC 12 omits the rounding when it vectorizes this loop.
      volatile const float rounded = static_cast<float>(point[axis]);
      point[axis] = rounded;
    }
  }
  return mesh;
}

PolygonMesh makeRandomPolygons(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  PolygonMesh mesh;
  const std::int64_t pointCount = 20 + 10 * (seed % 8);
  for (std::int64_t i = 0; i < pointCount; ++i)
  {
    const double height = seed % 2 ? 0.1 : 1.0; // flat meshes also have smooth edges
    mesh.points.emplace_back(uniform(random), uniform(random), height * uniform(random));
  }
  for (std::int64_t i = 0; i < 4 * pointCount; ++i)
  {
    const auto around = static_cast<std::int64_t>(random() % pointCount);
    Polygon face(random() % 3 ? 3 : 1 + random() % 6);
    for (std::int64_t& point : face)
    {
      point = (around + static_cast<std::int64_t>(random() % 5)) % pointCount;
    }
    mesh.faces.push_back(face);
    if (random() % 8 == 0)
    {
      mesh.faces.emplace_back(face.rbegin(), face.rend());
    }
  }
  return mesh;
}

PolygonMesh makeDentedBall(unsigned int seed, double dent)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(1.0 - dent, 1.0);
  PolygonMesh mesh;
  mesh.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mesh.faces = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int level = 0; level < 3; ++level)
  {
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
    const auto middle = [&](std::int64_t a, std::int64_t b)
    {
      const auto [entry, isNew] =
        middles.emplace(std::minmax(a, b), static_cast<std::int64_t>(mesh.points.size()));
      if (isNew)
      {
        mesh.points.push_back(lambent::normalized(mesh.points[a] + mesh.points[b]));
      }
      return entry->second;
    };
    std::vector<Polygon> finer;
    for (const Polygon& f : mesh.faces)
    {
      const std::int64_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
      finer.insert(
        finer.end(), { { f[0], ab, ca }, { ab, f[1], bc }, { ca, bc, f[2] }, { ab, bc, ca } });
    }
    mesh.faces = finer;
  }
  for (Vec3& point : mesh.points)
  {
    point = point * uniform(random);
  }
  return mesh;
}

PolygonMesh makeSheet(int n, double (*z)(double x, double y))
{
  PolygonMesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = 2.0 * i / n - 1.0, y = 2.0 * j / n - 1.0;
      mesh.points.emplace_back(x, y, z(x, y));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const std::int64_t p = j * (n + 1) + i;
      mesh.faces.push_back({ p, p + 1, p + n + 2, p + n + 1 });
    }
  }
  return mesh;
}

PolygonMesh makeCubeOfQuads()
{
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  }
  mesh.faces = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  return mesh;
}

namespace
{
// A face, seen from one of its points.
struct FaceHere
{
  std::size_t face;
  Vec3 area, normal, term;
};

class PointReference
{
public:
  PointReference(const PolygonMesh& mesh, double featureAngle, std::int64_t point)
    : Mesh(mesh)
    , Angle(std::min(featureAngle + 1e-4, 180.0))
    , Point(point)
  {
    std::vector<std::int64_t> scratch;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      const Polygon& face = mesh.faces[f];
      const Vec3 area = lambent::areaVector(mesh.points, face.data(), face.size());
      if (std::count(face.begin(), face.end(), point) == 0 ||
        !lambent::isUsableSquare(lambent::dot(area, area)))
      {
        continue;
      }
      this->Faces.push_back(
        { f, area, lambent::faceNormal(mesh.points, face.data(), face.size()), Vec3(0.0) });
      lambent::contributePolygon<lambent::Weighting::Angle>(mesh.points, face.data(), face.size(),
        scratch,
        [&](std::int64_t corner, const Vec3& term)
        {
          if (corner == point)
          {
            this->Terms.push_back({ this->Faces.size() - 1, term });
          }
        });
    }
  }

  // The normal of the corners of that face at the point.
  std::vector<float> normal(std::size_t face) const
  {
    std::vector<std::size_t> all(this->Faces.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      all[i] = i;
    }
    const std::vector<float> ofPoint = toUnit(this->sum(all));
    const auto here = std::find_if(
      this->Faces.begin(), this->Faces.end(), [face](const FaceHere& f) { return f.face == face; });
    if (here == this->Faces.end()) // a face without area: any normal will do
    {
      return {};
    }
    if (!this->isCreased(ofPoint))
    {
      return ofPoint;
    }
    const auto group = this->group(static_cast<std::size_t>(here - this->Faces.begin()));
    const Vec3 sum = this->sum(group);
    double lengths = 0.0;
    for (const auto& [i, term] : this->Terms)
    {
      lengths += std::count(group.begin(), group.end(), i) ? lambent::length(term) : 0.0;
    }
    const double square = lambent::dot(sum, sum), least = lengths / (1 << 20);
    return lambent::isUsableSquare(square) && square >= least * least ? toUnit(sum)
                                                                      : toUnit(here->normal);
  }

private:
  static std::vector<float> toUnit(const Vec3& v)
  {
    const double square = lambent::dot(v, v);
    std::vector<float> result;
    for (int axis = 0; axis < 3; ++axis)
    {
      result.push_back(lambent::isUsableSquare(square)
          ? static_cast<float>(v[axis] * (1.0 / std::sqrt(square)))
          : 0.0f);
    }
    return result;
  }

  Vec3 sum(const std::vector<std::size_t>& group) const
  {
    Vec3 result(0.0);
    for (const auto& [i, term] : this->Terms)
    {
      result = std::count(group.begin(), group.end(), i) ? result + term : result;
    }
    return result;
  }

  bool isCreased(const std::vector<float>& normal) const
  {
    const double c = std::max(lambent::cosDegrees(0.5 * this->Angle), 1.0 / (1 << 20));
    return std::any_of(this->Faces.begin(), this->Faces.end(),
      [&](const FaceHere& f)
      {
        const double along = lambent::dot(f.area, { normal[0], normal[1], normal[2] });
        return !(along > 0.0 && along * along >= (c * c) * lambent::dot(f.area, f.area));
      });
  }

  // All faces that can be reached from the first.
  std::vector<std::size_t> group(std::size_t first) const
  {
    std::vector<std::size_t> reached{ first };
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      for (std::size_t i = 0; i < this->Faces.size(); ++i)
      {
        if (std::count(reached.begin(), reached.end(), i) == 0 && this->areLinked(reached[next], i))
        {
          reached.push_back(i);
        }
      }
    }
    return reached;
  }

  // The points next to this one in a face: those it runs to, or those it comes from.
  std::vector<std::int64_t> neighbours(std::size_t i, int step) const
  {
    const Polygon& face = this->Mesh.faces[this->Faces[i].face];
    const auto size = static_cast<int>(face.size());
    std::vector<std::int64_t> result;
    for (int k = 0; k < size; ++k)
    {
      const std::int64_t other = face[(k + step + size) % size];
      if (face[k] == this->Point && other != this->Point)
      {
        result.push_back(other);
      }
    }
    return result;
  }

  std::size_t facesAtEdge(std::int64_t other) const
  {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      for (const int step : { 1, -1 })
      {
        const auto ends = this->neighbours(i, step);
        count += std::count(ends.begin(), ends.end(), other);
      }
    }
    return static_cast<std::size_t>(count);
  }

  bool areLinked(std::size_t a, std::size_t b) const
  {
    const double cosine = lambent::dot(this->Faces[a].normal, this->Faces[b].normal);
    if ((this->Angle < 180.0 && cosine < lambent::cosDegrees(this->Angle)) ||
      this->areOpposite(a, b))
    {
      return false;
    }
    for (const int step : { 1, -1 })
    {
      for (const std::int64_t other : this->neighbours(a, step))
      {
        const auto ends = this->neighbours(b, -step);
        if (std::count(ends.begin(), ends.end(), other) && this->facesAtEdge(other) <= 64)
        {
          return true;
        }
      }
    }
    return false;
  }

  bool areOpposite(std::size_t a, std::size_t b) const
  {
    const Polygon& faceA = this->Mesh.faces[this->Faces[a].face];
    Polygon faceB = this->Mesh.faces[this->Faces[b].face];
    std::reverse(faceB.begin(), faceB.end());
    for (std::size_t turn = 0; turn < faceB.size(); ++turn)
    {
      if (faceA == faceB)
      {
        return true;
      }
      std::rotate(faceB.begin(), faceB.begin() + 1, faceB.end());
    }
    return false;
  }

  const PolygonMesh& Mesh;
  const double Angle;
  const std::int64_t Point;
  std::vector<FaceHere> Faces;
  std::vector<std::pair<std::size_t, Vec3>> Terms;
};
}

std::vector<float> referenceCornerNormals(const PolygonMesh& mesh, double featureAngle)
{
  std::vector<PointReference> points;
  for (std::size_t point = 0; point < mesh.points.size(); ++point)
  {
    points.emplace_back(mesh, featureAngle, static_cast<std::int64_t>(point));
  }
  std::vector<float> result;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
  {
    for (const std::int64_t point : mesh.faces[face])
    {
      const auto normal = points[point].normal(face);
      result.insert(result.end(), normal.begin(), normal.end());
    }
  }
  return result;
}

namespace
{
template <typename Coordinate, typename Id>
std::vector<float> computed(
  const PolygonMesh& mesh, double featureAngle, const lambent::Parallel& parallel)
{
  std::vector<Coordinate> points;
  for (const Vec3& p : mesh.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      points.push_back(static_cast<Coordinate>(p[axis]));
    }
  }
  std::vector<Id> offsets(1, 0), corners;
  for (const Polygon& face : mesh.faces)
  {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<Id>(corners.size()));
  }
  lambent::Faces faces;
  faces.points = { points.data(), sizeof(Coordinate) == 8, mesh.points.size() };
  faces.cells = { { offsets.data(), sizeof(Id) == 8, offsets.size() },
    { corners.data(), sizeof(Id) == 8, corners.size() } };
  faces.blocks = checkCells(faces.cells, faces.points.size, parallel).blocks;
  const lambent::CornerNormals normals =
    lambent::computeCornerNormals(faces, featureAngle, parallel);

  std::vector<float> result;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
  {
    const Polygon& ids = mesh.faces[face];
    const Vec3 area = lambent::areaVector(mesh.points, ids.data(), ids.size());
    for (std::size_t k = 0; lambent::isUsableSquare(lambent::dot(area, area)) && k < ids.size();
         ++k)
    {
      const auto place = static_cast<std::size_t>(offsets[face]) + k;
      const auto number =
        normals.numbers ? static_cast<std::size_t>(normals.numbers[place]) : ids[k];
      EXPECT_LT(number, normals.count);
      result.insert(result.end(), &normals.normals[3 * number], &normals.normals[3 * number] + 3);
    }
  }
  return result;
}
}

std::vector<float> computedCornerNormals(const PolygonMesh& mesh, double featureAngle,
  MeshStorage storage, const lambent::Parallel& parallel)
{
  return storage == MeshStorage::Narrow
    ? computed<float, std::int32_t>(mesh, featureAngle, parallel)
    : computed<double, std::int64_t>(mesh, featureAngle, parallel);
}
