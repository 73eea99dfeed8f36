// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief composite all hits of each ray with Embree
 *
 * A filter function, which Embree calls for each hit, stores the hit and rejects it, so that the
 * ray goes on. The hits of a ray are then sorted, shaded and composited, until less than half a
 * grey value is left to see.
 */
#ifndef EmbreeLayers_h
#define EmbreeLayers_h

#include "EmbreeTile.h"

#include <vector>

template <int N>
class EmbreeLayers
{
public:
  EmbreeLayers(const EmbreeMesh& mesh, const EmbreeView& view, int width, int height, float opacity,
    unsigned char* bytes)
    : Mesh(mesh)
    , View(view)
    , Width(width)
    , Height(height)
    , Opacity(opacity)
    , Bytes(bytes)
  {
    rtcInitIntersectContext(&this->Collector.context);
    this->Collector.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    this->Collector.context.filter = collect;
  }

  /// Render the block of N pixels, four wide, whose lower left one is (i, j).
  void render(RTCScene tree, int i, int j)
  {
    alignas(64) typename PacketOf<N>::Type packet;
    alignas(64) int valid[N];
    for (int k = 0; k < N; ++k)
    {
      const int x = i + k % blockWidth, y = j + k / blockWidth;
      valid[k] = x < this->Width && y < this->Height ? -1 : 0;
      this->aim(packet, k, x, y);
      this->Collector.hits[k].clear();
    }
    PacketOf<N>::intersect(valid, tree, &this->Collector.context, &packet);
    for (int k = 0; k < N; ++k)
    {
      if (valid[k] != 0)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(j + k / blockWidth) * this->Width + i + k % blockWidth;
        std::fill_n(this->Bytes + 3 * pixel, 3,
          static_cast<unsigned char>(this->composite(this->Collector.hits[k], packet, k) + 0.5f));
      }
    }
  }

  static constexpr int blockWidth = 4, blockHeight = N / blockWidth;

private:
  struct LayerHit
  {
    float t, u, v, away;
    unsigned int triangle;
  };
  struct Collection
  {
    RTCIntersectContext context; // first, since Embree passes its address to the filter
    std::vector<LayerHit> hits[N];
  };

  static void collect(const RTCFilterFunctionNArguments* args)
  {
    auto* const all = reinterpret_cast<Collection*>(args->context);
    for (unsigned int k = 0; k < args->N; ++k)
    {
      if (args->valid[k] != -1)
      {
        continue;
      }
      RTCRayN* const ray = args->ray;
      RTCHitN* const hit = args->hit;
      const unsigned int n = args->N;
      const float away = RTCHitN_Ng_x(hit, n, k) * RTCRayN_dir_x(ray, n, k) +
        RTCHitN_Ng_y(hit, n, k) * RTCRayN_dir_y(ray, n, k) +
        RTCHitN_Ng_z(hit, n, k) * RTCRayN_dir_z(ray, n, k);
      all->hits[RTCRayN_id(ray, n, k)].push_back({ RTCRayN_tfar(ray, n, k), RTCHitN_u(hit, n, k),
        RTCHitN_v(hit, n, k), away, RTCHitN_primID(hit, n, k) });
      args->valid[k] = 0;
    }
  }

  template <typename Packet>
  void aim(Packet& packet, int k, int i, int j) const
  {
    const EmbreeView& view = this->View;
    const float pan = view.parallel ? 1.0f : 0.0f, tilt = 1.0f - pan;
    const float x = (i + 0.5f - 0.5f * this->Width) * view.pixel;
    const float y = (j + 0.5f - 0.5f * this->Height) * view.pixel;
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
    packet.ray.id[k] = k;
    packet.ray.flags[k] = 0;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }

  template <typename Packet>
  float composite(std::vector<LayerHit>& hits, const Packet& packet, int k) const
  {
    constexpr float invisible = 0.5f / 255.0f;
    std::sort(
      hits.begin(), hits.end(), [](const LayerHit& a, const LayerHit& b) { return a.t < b.t; });
    float value = 0.0f, transmittance = 1.0f;
    unsigned int last = RTC_INVALID_GEOMETRY_ID; // trees with split triangles report some twice
    for (const LayerHit& hit : hits)
    {
      if (hit.triangle != last)
      {
        value += transmittance * this->Opacity * this->shade(hit, packet, k);
        transmittance *= 1.0f - this->Opacity;
      }
      last = hit.triangle;
      if (transmittance < invisible)
      {
        break;
      }
    }
    return value;
  }

  /// As EmbreeTile shades, from 0 to 255.
  template <typename Packet>
  float shade(const LayerHit& hit, const Packet& packet, int k) const
  {
    const EmbreeView& view = this->View;
    const std::uint32_t* const corners =
      &this->Mesh.corners[3 * static_cast<std::size_t>(hit.triangle)];
    const float weights[3] = { 1.0f - hit.u - hit.v, hit.u, hit.v };
    float n[3] = {};
    for (int c = 0; c < 3; ++c)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        n[axis] += weights[c] * this->Mesh.normals[3 * static_cast<std::size_t>(corners[c]) + axis];
      }
    }
    const auto& ray = packet.ray;
    const float sx = view.light.x - (ray.org_x[k] - view.eye.x) - hit.t * ray.dir_x[k];
    const float sy = view.light.y - (ray.org_y[k] - view.eye.y) - hit.t * ray.dir_y[k];
    const float sz = view.light.z - (ray.org_z[k] - view.eye.z) - hit.t * ray.dir_z[k];
    const float facing = hit.away > 0.0f ? -255.0f : 255.0f;
    const float lengths =
      (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) * (sx * sx + sy * sy + sz * sz) + 1e-30f;
    return std::max(facing * (n[0] * sx + n[1] * sy + n[2] * sz) / std::sqrt(lengths), 0.0f);
  }

  const EmbreeMesh& Mesh;
  const EmbreeView& View;
  const int Width, Height;
  const float Opacity;
  unsigned char* const Bytes;
  Collection Collector;
};

#endif
