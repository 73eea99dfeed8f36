// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief packets of rays, and pictures that are rendered packet by packet
 *
 * A packet is a block of N pixels, four wide. Pictures are grey: white surfaces and one light.
 */
#ifndef EmbreePackets_h
#define EmbreePackets_h

#include "EmbreeScene.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

/// While this object exists, its thread treats denormals as zero.
class FlushDenormals
{
public:
  FlushDenormals()
  {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(this->Before); }

private:
  const unsigned int Before = _mm_getcsr();
};

template <int N>
struct PacketOf;
template <>
struct PacketOf<8>
{
  using Type = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
};
template <>
struct PacketOf<16>
{
  using Type = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
};

/// Sets ray k of a packet to that through (x, y) of the image plane.
template <typename Packet>
void aimRay(const EmbreeView& view, float x, float y, Packet& packet, int k)
{
  const float pan = view.parallel ? 1.0f : 0.0f, tilt = 1.0f - pan;
  const float ax = x * view.right.x + y * view.up.x, ay = x * view.right.y + y * view.up.y,
              az = x * view.right.z + y * view.up.z;
  packet.ray.org_x[k] = view.eye.x + pan * ax;
  packet.ray.org_y[k] = view.eye.y + pan * ay;
  packet.ray.org_z[k] = view.eye.z + pan * az;
  packet.ray.dir_x[k] = view.forward.x + tilt * ax;
  packet.ray.dir_y[k] = view.forward.y + tilt * ay;
  packet.ray.dir_z[k] = view.forward.z + tilt * az;
  packet.ray.tnear[k] = 0.0f;
  packet.ray.tfar[k] = std::numeric_limits<float>::max();
  packet.ray.time[k] = 0.0f;
  packet.ray.mask[k] = ~0u;
  packet.ray.id[k] = static_cast<unsigned int>(k);
  packet.ray.flags[k] = 0;
  packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
}

/// The grey value, from 0 to 255, of a white surface at distance t along ray k, whose normal n
/// points to the side that is seen.
template <typename Packet>
float greyOf(const EmbreeView& view, const Packet& packet, int k, float t, const Float3& n)
{
  const auto& ray = packet.ray;
  const float sx = view.light.x - (ray.org_x[k] - view.eye.x) - t * ray.dir_x[k];
  const float sy = view.light.y - (ray.org_y[k] - view.eye.y) - t * ray.dir_y[k];
  const float sz = view.light.z - (ray.org_z[k] - view.eye.z) - t * ray.dir_z[k];
  const float lengths =
    (n.x * n.x + n.y * n.y + n.z * n.z) * (sx * sx + sy * sy + sz * sz) + 1e-30f;
  return 255.0f * std::max((n.x * sx + n.y * sy + n.z * sz) / std::sqrt(lengths), 0.0f);
}

/// A picture with one ray per pixel.
struct EmbreePicture
{
  const EmbreeView& view;
  int width, height;
  unsigned char* bytes; ///< three per pixel
};

/// Renders a picture on Embree's threads. makeShader() makes a shader for some rows; it has the
/// context that the rays are traced with, begin() before each packet, and grey(packet, k) of a ray.
template <int N, typename MakeShader>
void renderPackets(RTCScene tree, const EmbreePicture& picture, const MakeShader& makeShader)
{
  constexpr int blockWidth = 4, blockHeight = N / blockWidth, blockRowsAtATime = 4;
  const auto renderBlock = [&](auto& shader, int i, int j)
  {
    alignas(64) typename PacketOf<N>::Type packet;
    alignas(64) int valid[N];
    for (int k = 0; k < N; ++k)
    {
      const int x = i + k % blockWidth, y = j + k / blockWidth;
      valid[k] = x < picture.width && y < picture.height ? -1 : 0;
      aimRay(picture.view, (x + 0.5f - 0.5f * picture.width) * picture.view.pixel,
        (y + 0.5f - 0.5f * picture.height) * picture.view.pixel, packet, k);
    }
    shader.begin();
    PacketOf<N>::intersect(valid, tree, shader.context(), &packet);
    for (int k = 0; k < N; ++k)
    {
      if (valid[k] != 0)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(j + k / blockWidth) * picture.width + i + k % blockWidth;
        std::fill_n(
          picture.bytes + 3 * pixel, 3, static_cast<unsigned char>(shader.grey(packet, k) + 0.5f));
      }
    }
  };
  const auto renderRows = [&](const tbb::blocked_range<int>& range)
  {
    const FlushDenormals flush;
    auto shader = makeShader();
    for (int row = range.begin(); row < range.end(); ++row)
    {
      for (int i = 0; i < picture.width; i += blockWidth)
      {
        renderBlock(shader, i, row * blockHeight);
      }
    }
  };
  const int blockRows = (picture.height + blockHeight - 1) / blockHeight;
  tbb::parallel_for(
    tbb::blocked_range<int>(0, blockRows, blockRowsAtATime), renderRows, tbb::simple_partitioner());
}

#endif
