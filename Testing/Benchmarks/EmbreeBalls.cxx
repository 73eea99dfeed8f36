// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeBalls.h"

#include "EmbreePackets.h"
#include "Stopwatch.h"

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

/// A shader for renderPackets().
class BallShader
{
public:
  explicit BallShader(const EmbreeView& view)
    : View(view)
  {
    rtcInitIntersectContext(&this->Context);
    this->Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  RTCIntersectContext* context() { return &this->Context; }
  void begin() const {}

  template <typename Packet>
  float grey(const Packet& packet, int k) const
  {
    const auto& hit = packet.hit;
    return hit.geomID[k] == RTC_INVALID_GEOMETRY_ID
      ? 0.0f
      : greyOf(
          this->View, packet, k, packet.ray.tfar[k], { hit.Ng_x[k], hit.Ng_y[k], hit.Ng_z[k] });
  }

private:
  const EmbreeView& View;
  RTCIntersectContext Context;
};
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
  const EmbreePicture picture{ internal.view, internal.width, internal.height, bytes };
  const auto makeShader = [&internal]() { return BallShader(internal.view); };
  isWide ? renderPackets<16>(tree, picture, makeShader)
         : renderPackets<8>(tree, picture, makeShader);
  return stopwatch.seconds();
}
