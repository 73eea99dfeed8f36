// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polygon meshes as plain lists, and the definition of their corner normals (CornerNormals.h) as
// plain loops over all faces.
#ifndef TestingCorners_h
#define TestingCorners_h

#include "CornerNormals.h"

#include <cstdint>
#include <vector>

using lambent::Vec3;

struct PolygonMesh
{
  std::vector<Vec3> points;
  std::vector<std::vector<std::int64_t>> faces;

  // All faces, and each of them again in reverse order.
  PolygonMesh doubled() const;
  // The mirror image, with reversed faces.
  PolygonMesh mirrored() const;
};

// Polygons of random points close to each other. Some use a point twice, are flat, or are opposite
// to others.
PolygonMesh makeRandomPolygons(unsigned int seed);
// A closed surface of triangles: a ball with random dents of up to this fraction of its radius.
PolygonMesh makeDentedBall(unsigned int seed, double dent);
// A square sheet of n x n quads at height z(x, y) over [-1, 1] x [-1, 1].
PolygonMesh makeSheet(int n, double (*z)(double x, double y));
// The unit cube: point i has the coordinates of the bits of i.
PolygonMesh makeCubeOfQuads();

// The normal at each corner of each face, three floats per corner.
std::vector<float> referenceCornerNormals(const PolygonMesh& mesh, double featureAngle);

enum class MeshStorage
{
  Narrow, // floats and 32-bit ids
  Wide    // doubles and 64-bit ids
};

// The same, from computeCornerNormals().
std::vector<float> computedCornerNormals(const PolygonMesh& mesh, double featureAngle,
  MeshStorage storage, const lambent::Parallel& parallel);

// Rounds the points to floats.
PolygonMesh toFloats(PolygonMesh mesh);

#endif
