// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a scene whose picture has every pass, and the values of passes where no surface is hit
 */
#ifndef PassScene_h
#define PassScene_h

#include "PassRays.h"

constexpr int passWidth = 61, passHeight = 45;

inline void wantAll(Studio& studio)
{
  studio.tracer->GenerateDepthOn();
  studio.tracer->GenerateNormalsOn();
  studio.tracer->GeneratePositionsOn();
  studio.tracer->GenerateIdsOn();
}

inline Mesh moved(const Mesh& mesh, const Vec& by)
{
  std::vector<Vec> points = pointsOf(mesh);
  for (Vec& point : points)
  {
    point += by;
  }
  Mesh result = Mesh::New();
  result->ShallowCopy(mesh);
  result->SetPoints(makeMesh(points, {})->GetPoints());
  return result;
}

/// A ball in front of a box at a given place.
struct BallAndBox
{
  Studio studio{ passWidth, passHeight };
  std::vector<Mesh> meshes;
  LongRays rays;

  BallAndBox(const Vec& place, bool isParallel)
  {
    this->studio.look(place + Vec(2.0, 3.0, 4.0), place, { 0.25, 1.0, 0.0 });
    this->studio.camera->SetParallelProjection(isParallel);
    this->studio.camera->SetParallelScale(1.75);
    this->meshes = { moved(makeSphere(12), place), moved(makeBox(0.9, 0.8, 1.3), place) };
    for (const Mesh& mesh : this->meshes)
    {
      this->studio.tracer->AddInputDataObject(mesh);
      this->rays.add(mesh);
    }
    wantAll(this->studio);
    this->studio.tracer->Update();
  }
  vtkImageData* image() const { return this->studio.tracer->GetOutput(); }
  Vec tuple(const char* name, vtkIdType pixel) const
  {
    Vec result(0.0);
    passOf(this->image(), name)->GetTuple(pixel, &result.x);
    return result;
  }
};

template <typename Value>
std::string bitsOfNan(int components)
{
  const Value nan = std::numeric_limits<Value>::quiet_NaN();
  std::string bits;
  for (int k = 0; k < components; ++k)
  {
    bits.append(reinterpret_cast<const char*>(&nan), sizeof(nan));
  }
  return bits;
}

inline void expectNothing(vtkImageData* image, vtkIdType pixel)
{
  EXPECT_EQ(tupleBits(passOf(image, "Depth"), pixel), bitsOfNan<float>(1));
  EXPECT_EQ(tupleBits(passOf(image, "Normals"), pixel), bitsOfNan<float>(3));
  EXPECT_EQ(tupleBits(passOf(image, "Positions"), pixel), bitsOfNan<double>(3));
  EXPECT_EQ(passOf(image, "CellIds")->GetComponent(pixel, 0), -1.0);
  EXPECT_EQ(passOf(image, "InputIds")->GetComponent(pixel, 0), -1.0);
}

#endif
