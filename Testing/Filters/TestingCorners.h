// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes of polygons as plain lists, and the definition of the normals of their corners
// (CornerNormals.h) as plain loops over all faces.
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

  // All faces once more, the other way round.
  PolygonMesh doubled() const;
  // As in a mirror: the other half of space, with the faces running the other way round.
  PolygonMesh mirrored() const;
};

// Polygons of random points near to each other, some of them named twice, flat, or opposite.
PolygonMesh makeRandomPolygons(unsigned int seed);
// A closed surface: a ball of triangles, dented at random by up to that part of its radius.
PolygonMesh makeDentedBall(unsigned int seed, double dent);
// A square sheet of n x n quads of height z(x, y) over [-1, 1] x [-1, 1].
PolygonMesh makeSheet(int n, double (*z)(double x, double y));
// The unit cube: point i has the coordinates of the bits of i.
PolygonMesh makeCubeOfQuads();

// The normal at each corner of each face, three floats a corner.
std::vector<float> referenceCornerNormals(const PolygonMesh& mesh, double featureAngle);

enum class MeshStorage
{
  Narrow, // floats and 32-bit ids
  Wide    // doubles and 64-bit ids
};

// The same as computed: at corners that have no number of their own, the point's.
std::vector<float> computedCornerNormals(const PolygonMesh& mesh, double featureAngle,
  MeshStorage storage, const lambent::Parallel& parallel);

// Rounds the points to floats.
PolygonMesh toFloats(PolygonMesh mesh);

#endif
