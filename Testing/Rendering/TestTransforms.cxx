// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of a transformed input is that of a mesh whose points and normals were transformed.
#include "Blocks.h"

#include "vtkMatrix4x4.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>

namespace
{
using Matrix = vtkSmartPointer<vtkMatrix4x4>;

Matrix makeMatrix(const double (&rows)[3][4])
{
  auto matrix = Matrix::New();
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      matrix->SetElement(i, k, rows[i][k]);
    }
  }
  return matrix;
}

Matrix general()
{
  return makeMatrix({ { 0.9, 0.3, -0.2, 0.1 }, { -0.4, 0.5, 0.1, -0.3 }, { 0.2, 0.1, 1.2, 0.4 } });
}

Matrix mirror()
{
  return makeMatrix({ { -0.9, 0.3, -0.2, 0.1 }, { 0.4, 0.5, 0.1, -0.3 }, { -0.2, 0.1, 1.2, 0.4 } });
}

double element(vtkMatrix4x4* m, int i, int k)
{
  return m->GetElement(i, k);
}

bool mirrors(vtkMatrix4x4* matrix)
{
  return matrix->Determinant() < 0.0;
}

/// The mesh with transformed points, computed in the documented order, and, if the matrix mirrors,
/// with the second and third corner of each triangle swapped. Without normals.
Mesh makeTransformed(vtkPolyData* mesh, vtkMatrix4x4* m)
{
  std::vector<Vec> points = pointsOf(mesh);
  for (Vec& p : points)
  {
    const auto row = [&](int i)
    {
      return ((element(m, i, 0) * p.x + element(m, i, 1) * p.y) + element(m, i, 2) * p.z) +
        element(m, i, 3);
    };
    p = Vec(row(0), row(1), row(2));
  }
  Polygons polygons;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    polygons.emplace_back(ids->begin(), ids->end());
    if (mirrors(m))
    {
      std::swap(polygons.back()[1], polygons.back()[2]);
    }
  }
  return makeMesh(points, polygons);
}

/// The inverse transpose, by GLM.
std::vector<Vec> transformNormals(const std::vector<Vec>& normals, vtkMatrix4x4* m)
{
  glm::dmat3 linear;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      linear[k][i] = element(m, i, k);
    }
  }
  std::vector<Vec> result;
  for (const Vec& n : normals)
  {
    result.push_back(glm::transpose(glm::inverse(linear)) * n);
  }
  return result;
}

/// A mesh without normals that is smooth in some places and has edges in others.
Mesh makeBare()
{
  const Mesh mesh = makeSphere(7);
  mesh->GetPointData()->SetNormals(nullptr);
  return mesh;
}

void setUp(Studio& studio)
{
  studio.look({ 2.0, 3.0, 4.0 }, Vec(0.0));
  studio.tracer->AddLight(makeLight({ 3.0, 2.0, 5.0 }, Vec(0.0)));
  studio.tracer->TwoSidedLightingOff(); // so that the side of normals matters
  studio.tracer->GenerateDepthOn();
  studio.tracer->GenerateNormalsOn();
  studio.tracer->GeneratePositionsOn();
  studio.tracer->GenerateIdsOn();
}

/// Expects that both have the same arrays with the same bits.
void expectSameArrays(vtkImageData* a, vtkImageData* b)
{
  ASSERT_EQ(a->GetPointData()->GetNumberOfArrays(), b->GetPointData()->GetNumberOfArrays());
  for (int k = 0; k < a->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const one = a->GetPointData()->GetArray(k);
    vtkDataArray* const other = b->GetPointData()->GetArray(k);
    ASSERT_EQ(one->GetDataSize(), other->GetDataSize());
    const std::size_t bytes = static_cast<std::size_t>(one->GetDataSize()) * one->GetDataTypeSize();
    EXPECT_EQ(std::memcmp(one->GetVoidPointer(0), other->GetVoidPointer(0), bytes), 0)
      << one->GetName();
  }
}

void expectSamePictures(
  vtkPolyData* mesh, vtkMatrix4x4* matrix, vtkPolyData* expected, vtkProperty* property)
{
  Studio transformed(61, 43), plain(61, 43);
  for (Studio* studio : { &transformed, &plain })
  {
    setUp(*studio);
    studio->tracer->SetProperty(property);
  }
  transformed.tracer->SetInputData(mesh);
  transformed.tracer->SetInputTransform(0, matrix);
  plain.tracer->SetInputData(expected);
  EXPECT_SAME_BITS(render(transformed.tracer), render(plain.tracer));
  expectSameArrays(transformed.tracer->GetOutput(), plain.tracer->GetOutput());
}
}

TEST(Transforms, MoveFlatFaces)
{
  vtkNew<vtkProperty> property;
  property->SetInterpolationToFlat();
  for (const Matrix& matrix : { general(), mirror() })
  {
    expectSamePictures(makeBare(), matrix, makeTransformed(makeBare(), matrix), property);
    property->BackfaceCullingOn();
  }
}

TEST(Transforms, PrecedeComputedNormals)
{
  vtkNew<vtkProperty> property;
  for (const Matrix& matrix : { general(), mirror() })
  {
    expectSamePictures(makeBare(), matrix, makeTransformed(makeBare(), matrix), property);
    property->BackfaceCullingOn();
  }
}

// Some edges are sharp, so that corners have normals of their own.
TEST(Transforms, PrecedeSharpEdges)
{
  Mesh prism = makeMesh({ Vec(0.0), { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } });
  vtkNew<vtkProperty> property;
  for (const Matrix& matrix : { general(), mirror() })
  {
    expectSamePictures(prism, matrix, makeTransformed(prism, matrix), property);
  }
}

TEST(Transforms, ConvertFloatsToDoubles)
{
  const Mesh mesh = makeBare();
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(mesh->GetPoints()->GetData());
  mesh->GetPoints()->SetData(floats);
  vtkNew<vtkProperty> property;
  expectSamePictures(mesh, general(), makeTransformed(mesh, general()), property);
}

// Compared with GLM's inverse, up to rounding.
TEST(Transforms, KeepGivenNormalsPerpendicular)
{
  for (const bool isFlat : { false, true })
  {
    for (const Matrix& matrix : { general(), mirror() })
    {
      const Mesh mesh = makeSphere(7);
      std::vector<Vec> normals = pointsOf(mesh);
      normals[5] *= 1e9; // any length will do
      if (isFlat)
      {
        normals.assign(static_cast<std::size_t>(mesh->GetNumberOfCells()), Vec(0.1, 0.5, 1.0));
      }
      const Mesh expected = makeTransformed(mesh, matrix);
      isFlat ? setCellNormals(mesh, normals) : setPointNormals(mesh, normals);
      isFlat ? setCellNormals(expected, transformNormals(normals, matrix))
             : setPointNormals(expected, transformNormals(normals, matrix));
      Studio transformed(61, 43), plain(61, 43);
      for (Studio* studio : { &transformed, &plain })
      {
        setUp(*studio);
        isFlat ? studio->property->SetInterpolationToFlat()
               : studio->property->SetInterpolationToPhong();
        studio->property->BackfaceCullingOn();
      }
      transformed.tracer->SetInputData(mesh);
      transformed.tracer->SetInputTransform(0, matrix);
      plain.tracer->SetInputData(expected);
      const Picture found = render(transformed.tracer), wanted = render(plain.tracer);
      EXPECT_GT(found.count(Studio::background()), 100);
      EXPECT_LT(found.count(Studio::background()), 61 * 43 - 400);
      for (int pixel = 0; pixel < 61 * 43; ++pixel)
      {
        expectColor(found.at(pixel % 61, pixel / 61), wanted.at(pixel % 61, pixel / 61),
          pixelName(pixel % 61, pixel / 61));
      }
    }
  }
}

// A mirrored ball looks the same from outside as the ball, if the light is mirrored as well.
TEST(Transforms, ThatMirrorKeepTheFront)
{
  const Matrix matrix =
    makeMatrix({ { -1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 } });
  for (int kind = 0; kind < 3; ++kind)
  {
    Studio studio(40, 30);
    studio.tracer->TwoSidedLightingOff();
    studio.property->SetInterpolation(kind == 0 ? VTK_FLAT : VTK_PHONG);
    studio.property->BackfaceCullingOn();
    studio.tracer->SetInputData(kind == 2 ? makeSphere(8) : makeBare());
    const auto light = makeLight({ 3.0, 1.0, 2.0 }, Vec(0.0));
    studio.tracer->AddLight(light);
    const Picture original = render(studio.tracer);
    light->SetPosition(-3.0, 1.0, 2.0);
    studio.tracer->SetInputTransform(0, matrix);
    const Picture mirrored = render(studio.tracer);
    for (int j = 0; j < 30; ++j)
    {
      for (int i = 0; i < 40; ++i)
      {
        expectColor(mirrored.at(i, j), original.at(39 - i, j), pixelName(i, j));
      }
    }
  }
}

TEST(Transforms, AreVTKs)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.5, -0.25, 1.0);
  transform->RotateWXYZ(33.0, 1.0, 2.0, 3.0);
  transform->Scale(0.75, 0.75, 0.75); // of another one, the filter's normals differ in length
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(makeSphere(9));
  filter->SetTransform(transform);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  Studio transformed(61, 43), plain(61, 43);
  transformed.tracer->SetInputData(makeSphere(9));
  transformed.tracer->SetInputTransform(0, transform->GetMatrix());
  plain.tracer->SetInputConnection(filter->GetOutputPort());
  const Picture found = render(transformed.tracer), wanted = render(plain.tracer);
  for (int pixel = 0; pixel < 61 * 43; ++pixel)
  {
    expectColor(found.at(pixel % 61, pixel / 61), wanted.at(pixel % 61, pixel / 61),
      pixelName(pixel % 61, pixel / 61), 1e-5);
  }
}

TEST(Transforms, MovePolygonsAndStrips)
{
  const Mesh mesh = makeRow(0, 4);
  const Mesh strip = makeMesh(pointsOf(mesh), {});
  strip->SetStrips(makeCells({ { 0, 1, 3, 2 }, { 4, 5, 7, 6 } }));
  for (const Mesh& input : { mesh, strip })
  {
    Studio studio(8, 1);
    lookAtRow(studio);
    studio.tracer->SetTwoSidedLighting(false);
    studio.property->BackfaceCullingOn();
    studio.tracer->SetInputData(input);
    const Matrix matrix = makeMatrix(
      { { 1.0, 0.0, 0.0, 3.0 }, { 0.0, -1.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0, 0.0 } }); // from behind
    const vtkIdType end = input == strip ? -1 : 2;
    studio.tracer->SetInputTransform(0, matrix);
    EXPECT_EQ(renderIds(studio, "CellIds"), (Ids(8, -1)));
    matrix->SetElement(2, 2, 1.0); // mirrored, and seen from the front
    EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ -1, -1, -1, 0, 1, end, end < 0 ? end : 3, -1 }));
  }
}

TEST(Transforms, ApplyToAllBlocks)
{
  Studio studio(6, 1);
  lookAtRow(studio);
  studio.tracer->AddInputDataObject(makeBlocks({ makeRow(0, 1), makeBlocks({ makeRow(1, 3) }) }));
  studio.tracer->SetInputTransform(
    0, makeMatrix({ { 1.0, 0.0, 0.0, 2.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 } }));
  EXPECT_EQ(renderIds(studio, "BlockIds"), (Ids{ -1, -1, 1, 3, 3, -1 }));
}

TEST(Transforms, AreFramedByResetCamera)
{
  Studio transformed, plain;
  transformed.tracer->SetInputData(makeBare());
  transformed.tracer->SetInputTransform(0, general());
  plain.tracer->SetInputData(makeTransformed(makeBare(), general()));
  transformed.tracer->ResetCamera();
  plain.tracer->ResetCamera();
  EXPECT_EQ(transformed.position(), plain.position());
}

TEST(Transforms, OfSmallAndLargeScaleKeepThePicture)
{
  const Matrix matrix = Matrix::New();
  for (const double scale : { 0x1p-60, 0x1p60 })
  {
    Studio studio(40, 30), reference(40, 30);
    for (Studio* s : { &studio, &reference })
    {
      s->tracer->SetInputData(makeSphere(8));
    }
    matrix->Identity();
    for (int k = 0; k < 3; ++k)
    {
      matrix->SetElement(k, k, scale);
    }
    studio.tracer->SetInputTransform(0, matrix);
    studio.look(Vec(0.0, 0.0, 5.0) * scale, Vec(0.0));
    EXPECT_SAME_BITS(render(studio.tracer), render(reference.tracer));
  }
}

TEST(Transforms, ByTheIdentityKeepEveryBit)
{
  Studio studio(40, 30);
  studio.tracer->SetInputData(makeSphere(8));
  const Picture expected = render(studio.tracer);
  studio.tracer->SetInputTransform(0, Matrix::New());
  EXPECT_SAME_BITS(render(studio.tracer), expected);
}
