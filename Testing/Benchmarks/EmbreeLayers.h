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

#include "EmbreePackets.h"

#include <cstdint>
#include <memory>
#include <vector>

/// A shader for renderPackets().
template <int N>
class EmbreeLayers
{
public:
  EmbreeLayers(const EmbreeMesh& mesh, const EmbreeView& view, float opacity)
    : Mesh(mesh)
    , View(view)
    , Opacity(opacity)
    , Collected(new Collection)
  {
    rtcInitIntersectContext(&this->Collected->context);
    this->Collected->context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    this->Collected->context.filter = collect;
  }

  RTCIntersectContext* context() { return &this->Collected->context; }

  void begin()
  {
    for (std::vector<LayerHit>& hits : this->Collected->hits)
    {
      hits.clear();
    }
  }

  template <typename Packet>
  float grey(const Packet& packet, int k)
  {
    constexpr float invisible = 0.5f / 255.0f;
    std::vector<LayerHit>& hits = this->Collected->hits[k];
    std::sort(
      hits.begin(), hits.end(), [](const LayerHit& a, const LayerHit& b) { return a.t < b.t; });
    float value = 0.0f, transmittance = 1.0f;
    unsigned int last = RTC_INVALID_GEOMETRY_ID; // trees with split triangles report some twice
    for (const LayerHit& hit : hits)
    {
      if (hit.triangle != last)
      {
        value +=
          transmittance * this->Opacity * greyOf(this->View, packet, k, hit.t, this->normalAt(hit));
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

  /// Interpolated, on the side that is seen.
  Float3 normalAt(const LayerHit& hit) const
  {
    const std::uint32_t* const corners =
      &this->Mesh.corners[3 * static_cast<std::size_t>(hit.triangle)];
    const float facing = hit.away > 0.0f ? -1.0f : 1.0f;
    const float weights[3] = { facing * (1.0f - hit.u - hit.v), facing * hit.u, facing * hit.v };
    Float3 n{ 0.0f, 0.0f, 0.0f };
    for (int c = 0; c < 3; ++c)
    {
      const float* const m = &this->Mesh.normals[3 * static_cast<std::size_t>(corners[c])];
      n.x += weights[c] * m[0];
      n.y += weights[c] * m[1];
      n.z += weights[c] * m[2];
    }
    return n;
  }

  const EmbreeMesh& Mesh;
  const EmbreeView& View;
  const float Opacity;
  std::unique_ptr<Collection> Collected; ///< whose address stays
};

#endif
