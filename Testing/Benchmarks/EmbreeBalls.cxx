// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeBalls.h"

#include "EmbreeTile.h"
#include "Stopwatch.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace
{
struct Ball
{
  float x, y, z, radius;
};

std::vector<Ball> ballsOf(const BenchmarkScene& scene)
{
  std::vector<Ball> balls;
  for (vtkIdType k = 0; k < scene.mesh->GetNumberOfPoints(); ++k)
  {
    const double* const p = scene.mesh->GetPoint(k);
    balls.push_back({ static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
      static_cast<float>(scene.ballRadius) });
  }
  return balls;
}

/// Traces and shades blocks of N pixels, four wide.
template <int N>
class Blocks
{
public:
  static constexpr int width = 4, height = N / width;

  Blocks(RTCScene tree, const EmbreeView& view, int columns, int rows, unsigned char* bytes)
    : Tree(tree)
    , View(view)
    , Columns(columns)
    , Rows(rows)
    , Bytes(bytes)
  {
    rtcInitIntersectContext(&this->Context);
    this->Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  void render(int i, int j)
  {
    alignas(64) int valid[N];
    for (int k = 0; k < N; ++k)
    {
      const int x = i + k % width, y = j + k / width;
      valid[k] = x < this->Columns && y < this->Rows ? -1 : 0;
      this->aim(k, x, y);
    }
    PacketOf<N>::intersect(valid, this->Tree, &this->Context, &this->Packet);
    for (int k = 0; k < N; ++k)
    {
      if (valid[k] != 0)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(j + k / width) * this->Columns + i + k % width;
        std::fill_n(this->Bytes + 3 * pixel, 3, static_cast<unsigned char>(this->shade(k) + 0.5f));
      }
    }
  }

private:
  void aim(int k, int i, int j)
  {
    const EmbreeView& view = this->View;
    auto& ray = this->Packet.ray;
    const float x = (i + 0.5f - 0.5f * this->Columns) * view.pixel;
    const float y = (j + 0.5f - 0.5f * this->Rows) * view.pixel;
    ray.org_x[k] = view.eye.x;
    ray.org_y[k] = view.eye.y;
    ray.org_z[k] = view.eye.z;
    ray.dir_x[k] = view.forward.x + x * view.right.x + y * view.up.x;
    ray.dir_y[k] = view.forward.y + x * view.right.y + y * view.up.y;
    ray.dir_z[k] = view.forward.z + x * view.right.z + y * view.up.z;
    ray.tnear[k] = 0.0f;
    ray.tfar[k] = std::numeric_limits<float>::max();
    ray.time[k] = 0.0f;
    ray.mask[k] = ~0u;
    ray.id[k] = ray.flags[k] = 0;
    this->Packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    this->Packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }

  float shade(int k) const
  {
    const auto& ray = this->Packet.ray;
    const auto& hit = this->Packet.hit;
    if (hit.geomID[k] == RTC_INVALID_GEOMETRY_ID)
    {
      return 0.0f;
    }
    const float t = ray.tfar[k];
    const float sx = this->View.light.x - t * ray.dir_x[k];
    const float sy = this->View.light.y - t * ray.dir_y[k];
    const float sz = this->View.light.z - t * ray.dir_z[k];
    const float nx = hit.Ng_x[k], ny = hit.Ng_y[k], nz = hit.Ng_z[k];
    const float lengths = (nx * nx + ny * ny + nz * nz) * (sx * sx + sy * sy + sz * sz) + 1e-30f;
    return 255.0f * std::max((nx * sx + ny * sy + nz * sz) / std::sqrt(lengths), 0.0f);
  }

  RTCScene Tree;
  const EmbreeView& View;
  const int Columns, Rows;
  unsigned char* const Bytes;
  RTCIntersectContext Context;
  alignas(64) typename PacketOf<N>::Type Packet;
};

template <int N>
void traceAll(RTCScene tree, const EmbreeView& view, int columns, int rows, unsigned char* bytes)
{
  constexpr int rowsAtATime = 4;
  const auto traceRows = [&](const tbb::blocked_range<int>& range)
  {
    const FlushDenormals flush;
    Blocks<N> blocks(tree, view, columns, rows, bytes);
    for (int row = range.begin(); row < range.end(); ++row)
    {
      for (int i = 0; i < columns; i += Blocks<N>::width)
      {
        blocks.render(i, row * Blocks<N>::height);
      }
    }
  };
  const int blockRows = (rows + Blocks<N>::height - 1) / Blocks<N>::height;
  tbb::parallel_for(
    tbb::blocked_range<int>(0, blockRows, rowsAtATime), traceRows, tbb::simple_partitioner());
}
}

struct EmbreeBalls::Internals
{
  explicit Internals(const BenchmarkScene& scene)
    : balls(ballsOf(scene))
    , view(scene.view())
    , width(scene.width)
    , height(scene.height)
  {
  }

  const std::vector<Ball> balls;
  const EmbreeView view;
  const int width, height;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene trees[3] = {};
};

EmbreeBalls::EmbreeBalls(const BenchmarkScene& scene)
  : Internal(new Internals(scene))
{
}

EmbreeBalls::~EmbreeBalls()
{
  for (RTCScene tree : this->Internal->trees)
  {
    if (tree)
    {
      rtcReleaseScene(tree);
    }
  }
  rtcReleaseDevice(this->Internal->device);
}

double EmbreeBalls::build(TreeQuality quality)
{
  constexpr RTCBuildQuality qualities[] = { RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_MEDIUM,
    RTC_BUILD_QUALITY_HIGH };
  Internals& internal = *this->Internal;
  RTCScene& tree = internal.trees[static_cast<int>(quality)];
  if (tree)
  {
    rtcReleaseScene(tree);
  }
  const Stopwatch stopwatch;
  RTCGeometry geometry = rtcNewGeometry(internal.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
    internal.balls.data(), 0, sizeof(Ball), internal.balls.size());
  rtcSetGeometryBuildQuality(geometry, qualities[static_cast<int>(quality)]);
  rtcCommitGeometry(geometry);
  tree = rtcNewScene(internal.device);
  rtcSetSceneBuildQuality(tree, qualities[static_cast<int>(quality)]);
  rtcAttachGeometry(tree, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree);
  return stopwatch.seconds();
}

double EmbreeBalls::trace(TreeQuality quality)
{
  const Internals& internal = *this->Internal;
  if (!internal.trees[static_cast<int>(quality)])
  {
    this->build(quality);
  }
  RTCScene tree = internal.trees[static_cast<int>(quality)];
  const bool isWide =
    rtcGetDeviceProperty(internal.device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(internal.width, internal.height, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
  isWide ? traceAll<16>(tree, internal.view, internal.width, internal.height, bytes)
         : traceAll<8>(tree, internal.view, internal.width, internal.height, bytes);
  return stopwatch.seconds();
}
