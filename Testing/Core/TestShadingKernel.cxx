// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernel's colours equal those of LightModel::color() to the last bit of a double. A float
// picture would show a difference in that bit only once in 500 million channels.
#include "InstructionSets.h"
#include "RandomNumbers.h"
#include "SampleBatch.h"
#include "ShadingKernel.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

using namespace lambent;

namespace
{
constexpr int width = 4 * SampleBatch::pieceSize, height = 3;
constexpr double untouched = -7.0;

/// Triangles behind each other, each of which covers the view.
struct Sheets
{
  static constexpr int count = 9;

  RandomNumbers random;
  std::vector<double> points, normals;
  std::vector<std::int32_t> corners;
  Scene scene;
  std::unique_ptr<const CameraFrame> frame;
  std::unique_ptr<const SceneMesh> mesh;
  std::unique_ptr<const FrameMesh> inFrame;

  Sheets(unsigned int seed, bool parallel, Shading shading)
    : random(seed)
  {
    this->scene.camera.position = Vec3(0.0); // so that lights relative to it are not rounded
    this->scene.camera.focalPoint = this->random.inBox(1.0);
    this->scene.camera.parallel = parallel;
    this->scene.camera.parallelScale = 0.3;
    this->frame = std::make_unique<CameraFrame>(this->scene.camera, width, height);
    for (int k = 0; k < count; ++k)
    {
      this->addTriangle(3 * k, parallel);
    }
    Surface surface;
    surface.points = { this->points.data(), true, 3u * count };
    surface.corners = { this->corners.data(), false, 3u * count };
    surface.pointNormals = { this->normals.data(), true, 3u * count };
    surface.appearance.shading = shading;
    surface.appearance.diffuseColor = this->random.inBox(0.5) + Vec3(0.5);
    surface.appearance.ambient = 1.0;
    surface.appearance.ambientColor = this->random.inBox(0.5) + Vec3(0.5);
    if (seed % 2 == 0)
    {
      surface.appearance.specular = { 0.75, this->random.inBox(0.5) + Vec3(0.5),
        seed % 4 == 0 ? 20.0 : this->random.within(0.0, 10.0) };
    }
    this->scene.surfaces.push_back(surface);
    this->mesh = std::make_unique<SceneMesh>(this->scene.surfaces);
    this->inFrame = std::make_unique<FrameMesh>(*this->mesh, *this->frame);
    this->addLights();
  }

  void addTriangle(int first, bool parallel)
  {
    const double onPlane[3][2] = { { -90.0, -90.0 }, { 90.0, -90.0 }, { 0.0, 90.0 } };
    for (const auto& place : onPlane)
    {
      const double depth = this->random.within(1.0, 5.0);
      const double scale = (parallel ? 1.0 : depth) * this->random.within(0.9, 1.1);
      const Vec3 p =
        (this->frame->right * (scale * place[0]) + this->frame->up * (scale * place[1])) +
        this->frame->forward * depth;
      const Vec3 n = this->random.inBox(1.0) - this->frame->forward * this->random.within(0.0, 2.0);
      this->points.insert(this->points.end(), { p.x, p.y, p.z });
      this->normals.insert(this->normals.end(), { n.x, n.y, n.z });
    }
    const bool isFront = this->random.below(2) == 0;
    this->corners.insert(
      this->corners.end(), { first, first + (isFront ? 1 : 2), first + (isFront ? 2 : 1) });
  }

  /// Adds lights of every kind, one of them exactly at the point where a ray hits the first
  /// triangle.
  void addLights()
  {
    Light light;
    light.direction = this->random.inBox(1.0) + this->frame->forward;
    light.color = this->random.inBox(0.5) + Vec3(0.5);
    light.specularColor = this->random.inBox(0.5) + Vec3(0.5);
    this->scene.lights.push_back(light);
    light.positional = true;
    light.position = this->random.inBox(1.0);
    light.attenuation = { 0.3, 0.7, 0.2 };
    this->scene.lights.push_back(light);
    light.coneAngle = 50.0;
    light.exponent = 2.5;
    light.direction = this->frame->forward;
    this->scene.lights.push_back(light);
    const auto corner = [this](std::size_t k)
    {
      const Surface& surface = this->scene.surfaces[0];
      return this->frame->toFrame(surface.points[surface.corners[k]]);
    };
    Hit hit{};
    EXPECT_TRUE(
      intersect(corner(0), corner(1), corner(2), this->frame->x(0), this->frame->y(0), hit));
    light.position = this->frame->fromEye(this->frame->x(0), this->frame->y(0), hit.depth);
    this->scene.lights.push_back(light);
  }
};

/// Pieces of a row. Runs of samples hit one sheet, another one, or nothing.
struct RowSamples
{
  std::vector<double> xs;
  double y;
  SampleBatch batch;

  RowSamples(Sheets& sheets, int row)
    : y(sheets.frame->y(row))
  {
    for (int i = 0; i < width + 16; ++i)
    {
      this->xs.push_back(sheets.frame->x(i));
    }
    std::uint32_t triangle = 0; // the one that a light lies on
    for (int piece = 0; piece < SampleBatch::mostPieces; ++piece)
    {
      const int begin = piece * SampleBatch::pieceSize;
      const int size = SampleBatch::pieceSize - (piece % 2) * sheets.random.below(20);
      std::uint32_t hits[SampleBatch::pieceSize];
      for (int i = 0; i < size; ++i)
      {
        hits[i] = triangle;
        if (sheets.random.below(3) == 0)
        {
          const int next = sheets.random.below(Sheets::count + 2);
          triangle = next < Sheets::count ? static_cast<std::uint32_t>(next) : noPrimitive;
        }
      }
      this->batch.add({ begin, row, size, this->xs.data() + begin, this->y }, hits);
    }
    std::fill_n(this->batch.colors[0], 3 * SampleBatch::places, untouched);
  }
};

void expectColorsOf(const SurfacePoints& points, const LightModel& light, const RowSamples& samples)
{
  const SampleBatch& batch = samples.batch;
  for (int place = 0; place < batch.pieceCount * SampleBatch::pieceSize; ++place)
  {
    const SamplePiece& piece = batch.pieces[place / SampleBatch::pieceSize];
    const int i = place % SampleBatch::pieceSize;
    const std::uint32_t triangle = batch.primitives[batch.run[place]];
    if (i >= piece.width)
    {
      continue;
    }
    const Vec3 expected = triangle == noPrimitive
      ? Vec3(untouched)
      : light.color(points.at(triangle, piece.xs[i], piece.y));
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_EQ(std::memcmp(&batch.colors[channel][place], &expected[channel], sizeof(double)), 0)
        << "place " << place << ", triangle " << triangle << ": "
        << batch.colors[channel][place] - expected[channel];
    }
  }
}

void compare(unsigned int seed, bool parallel, Shading shading)
{
  Sheets sheets(seed, parallel, shading);
  sheets.scene.twoSidedLighting = seed % 2 == 0;
  sheets.scene.ambientModel = seed % 3 == 0 ? AmbientModel::Scene : AmbientModel::PerLight;
  const SurfacePoints points(*sheets.inFrame, sheets.scene.twoSidedLighting);
  const LightModel light(sheets.scene, sheets.frame->eye);
  for (int row = 0; row < height; ++row)
  {
    RowSamples samples(sheets, row);
    RunRange range;
    while (range.moveOn(points.mesh(), samples.batch))
    {
      shadeSamples(points, light, range, samples.batch);
    }
    expectColorsOf(points, light, samples);
  }
}
}

TEST(ShadingKernel, EqualsTheDefinition)
{
  onAllTargets(
    []()
    {
      for (unsigned int seed = 0; seed < 30; ++seed)
      {
        compare(seed, seed % 5 == 0, seed % 4 == 0 ? Shading::Flat : Shading::Smooth);
      }
    });
}
