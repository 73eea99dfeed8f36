// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the tests of vtkLambentNormals: meshes, the definition of the normals
// as a plain serial loop, and a listener for messages.
#ifndef TestingNormals_h
#define TestingNormals_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkIntArray;
class vtkPolyData;

using Face = std::vector<vtkIdType>;
using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const Vector& a, double factor);
double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector unit(const Vector& a);

// A mesh of polygons with double points.
vtkSmartPointer<vtkPolyData> makeMesh(
  const std::vector<Vector>& points, const std::vector<Face>& polygons);

// The unit cube: six quads that share eight points and face outwards.
vtkSmartPointer<vtkPolyData> makeCube();

struct RandomMeshOptions
{
  unsigned int seed = 1;
  int points = 3000;
  int cells = 4000; // of each kind
  bool floatPoints = true;
  bool use64BitCells = true;
};

// Vertices, lines, triangles, quads, polygons and strips of random points, some of
// which appear twice in a cell.
vtkSmartPointer<vtkPolyData> makeRandomMesh(const RandomMeshOptions& options);

// The polygons, then the triangles of the strips.
std::vector<Face> facesOf(vtkPolyData* mesh);

Vector pointOf(vtkPolyData* mesh, vtkIdType point);

// The unit normal of a face with at least three corners; zero if it has no area.
Vector faceNormal(vtkPolyData* mesh, const Face& face);

// An array of 0, 1, 2 and so on.
vtkSmartPointer<vtkIntArray> makeNumbers(const char* name, vtkIdType count);

// Three floats per point, by the definition in vtkLambentNormals.h.
std::vector<float> referenceNormals(vtkPolyData* mesh, int weighting);

std::vector<float> valuesOf(vtkDataArray* array);
Vector tupleOf(vtkDataArray* array, vtkIdType i);

// Compares to within an absolute tolerance.
void expectNear(const Vector& value, const Vector& expected, double tolerance);

// Collects the errors and warnings of an algorithm instead of printing them. Must
// outlive all updates of the algorithm.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* algorithm);

  std::vector<std::string> errors;
  std::vector<std::string> warnings;

private:
  class Listener;
};

#endif
