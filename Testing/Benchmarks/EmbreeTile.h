// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief trace a tile of rays with Embree, and shade it
 *
 * The rays of a tile are divided into blocks of N, four wide; each block is a packet.
 * However Embree receives the rays, the hits end up in packets and are shaded packet by
 * packet, in loops that the compiler vectorizes. The film averages the tile's values.
 */
#ifndef EmbreeTile_h
#define EmbreeTile_h

#include "EmbreeFilm.h"
#include "EmbreePackets.h"
#include "EmbreeRenderer.h"
#include "EmbreeScene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

template <int N>
class EmbreeTile
{
public:
  static constexpr int side = EmbreeFilm::side;

  EmbreeTile(const EmbreeMesh& mesh, const EmbreeView& view, const EmbreeFilm& film)
    : Mesh(mesh)
    , View(view)
    , Film(film)
  {
    rtcInitIntersectContext(&this->Context);
    this->Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    std::fill_n(this->All, N, -1);
    for (RTCRayHit& single : this->Singles)
    {
      single.ray.time = 0.0f;
      single.ray.mask = ~0u;
      single.ray.id = single.ray.flags = 0;
      single.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  /// Render the tile whose lower left ray is (i, j).
  void render(RTCScene tree, RayGrouping grouping, int i, int j)
  {
    for (int block = 0; block < blocks; ++block)
    {
      this->aim(this->Packets[block], i + blockX(block), j + blockY(block));
    }
    this->trace(tree, grouping);
    for (int block = 0; block < blocks; ++block)
    {
      this->finish(this->Packets[block], blockX(block), blockY(block));
    }
    this->Film.write(this->Values, i, j);
  }

private:
  using Packet = typename PacketOf<N>::Type;
  static constexpr int rays = side * side;
  static constexpr int blocks = rays / N;
  static constexpr int blockWidth = 4, blockHeight = N / blockWidth;

  static int blockX(int block) { return blockWidth * (block % (side / blockWidth)); }
  static int blockY(int block) { return blockHeight * (block / (side / blockWidth)); }

  void aim(Packet& packet, int i, int j) const;
  void trace(RTCScene tree, RayGrouping grouping);
  void scatter();
  void gather();
  void finish(const Packet& packet, int i, int j);
  void shade(const Packet& packet, float (&values)[N]) const;

  const EmbreeMesh& Mesh;
  const EmbreeView& View;
  const EmbreeFilm& Film;
  RTCIntersectContext Context;
  alignas(64) int All[N];
  Packet Packets[blocks];
  RTCRayHit Singles[rays];
  alignas(64) float Values[rays]; ///< row by row
};

//------------------------------------------------------------------------------
template <int N>
void EmbreeTile<N>::aim(Packet& packet, int i, int j) const
{
  const float middleX = 0.5f * this->Film.columns(), middleY = 0.5f * this->Film.rows();
  const float step = this->View.pixel / this->Film.samples();
  for (int k = 0; k < N; ++k)
  {
    const float x = (i + k % blockWidth + 0.5f - middleX) * step;
    const float y = (j + k / blockWidth + 0.5f - middleY) * step;
    aimRay(this->View, x, y, packet, k);
  }
}

template <int N>
void EmbreeTile<N>::trace(RTCScene tree, RayGrouping grouping)
{
  switch (grouping)
  {
    case RayGrouping::Packets:
      for (Packet& packet : this->Packets)
      {
        PacketOf<N>::intersect(this->All, tree, &this->Context, &packet);
      }
      break;
    case RayGrouping::PacketStream:
      rtcIntersectNM(tree, &this->Context, reinterpret_cast<RTCRayHitN*>(this->Packets), N, blocks,
        sizeof(Packet));
      break;
    case RayGrouping::Single:
      this->scatter();
      for (RTCRayHit& single : this->Singles)
      {
        rtcIntersect1(tree, &this->Context, &single);
      }
      this->gather();
      break;
    case RayGrouping::Stream:
      this->scatter();
      rtcIntersect1M(tree, &this->Context, this->Singles, rays, sizeof(RTCRayHit));
      this->gather();
      break;
  }
}

/// Copy the rays from packets to single rays.
template <int N>
void EmbreeTile<N>::scatter()
{
  for (int n = 0; n < rays; ++n)
  {
    const auto& from = this->Packets[n / N].ray;
    const int k = n % N;
    RTCRay& to = this->Singles[n].ray;
    to.org_x = from.org_x[k];
    to.org_y = from.org_y[k];
    to.org_z = from.org_z[k];
    to.tnear = 0.0f;
    to.dir_x = from.dir_x[k];
    to.dir_y = from.dir_y[k];
    to.dir_z = from.dir_z[k];
    to.tfar = std::numeric_limits<float>::max();
    this->Singles[n].hit.geomID = RTC_INVALID_GEOMETRY_ID;
  }
}

/// Copy what shading needs back into the packets.
template <int N>
void EmbreeTile<N>::gather()
{
  for (int n = 0; n < rays; ++n)
  {
    Packet& packet = this->Packets[n / N];
    const RTCRayHit& single = this->Singles[n];
    const int k = n % N;
    packet.ray.tfar[k] = single.ray.tfar;
    packet.hit.Ng_x[k] = single.hit.Ng_x;
    packet.hit.Ng_y[k] = single.hit.Ng_y;
    packet.hit.Ng_z[k] = single.hit.Ng_z;
    packet.hit.u[k] = single.hit.u;
    packet.hit.v[k] = single.hit.v;
    packet.hit.primID[k] = single.hit.primID;
    packet.hit.geomID[k] = single.hit.geomID;
  }
}

//------------------------------------------------------------------------------
/// Shade the packet at ray (i, j) of the tile if it has hits.
template <int N>
void EmbreeTile<N>::finish(const Packet& packet, int i, int j)
{
  unsigned int hits = 0;
  for (int k = 0; k < N; ++k)
  {
    hits += packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
  }
  alignas(64) float values[N] = {};
  if (hits > 0)
  {
    this->shade(packet, values);
  }
  for (int row = 0; row < blockHeight; ++row)
  {
    std::copy_n(values + row * blockWidth, blockWidth, this->Values + (j + row) * side + i);
  }
}

/// White, ambient 0, diffuse 1, two-sided, one white point light.
template <int N>
void EmbreeTile<N>::shade(const Packet& packet, float (&values)[N]) const
{
  alignas(64) float weight[N], normal[9][N];
  for (int k = 0; k < N; ++k)
  {
    const bool isHit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    weight[k] = isHit ? 255.0f : 0.0f;
    const std::uint32_t* corners =
      &this->Mesh.corners[isHit ? 3 * static_cast<std::size_t>(packet.hit.primID[k]) : 0];
    for (int c = 0; c < 3; ++c)
    {
      const float* n = &this->Mesh.normals[3 * static_cast<std::size_t>(corners[c])];
      normal[3 * c][k] = n[0];
      normal[3 * c + 1][k] = n[1];
      normal[3 * c + 2][k] = n[2];
    }
  }
  const EmbreeView& view = this->View;
  for (int k = 0; k < N; ++k)
  {
    const float u = weight[k] > 0 ? packet.hit.u[k] : 0.0f;
    const float v = weight[k] > 0 ? packet.hit.v[k] : 0.0f;
    const float w = 1.0f - u - v, t = weight[k] > 0 ? packet.ray.tfar[k] : 0.0f;
    const float nx = w * normal[0][k] + u * normal[3][k] + v * normal[6][k];
    const float ny = w * normal[1][k] + u * normal[4][k] + v * normal[7][k];
    const float nz = w * normal[2][k] + u * normal[5][k] + v * normal[8][k];
    const float dx = packet.ray.dir_x[k], dy = packet.ray.dir_y[k], dz = packet.ray.dir_z[k];
    const float sx = view.light.x - (packet.ray.org_x[k] - view.eye.x) - t * dx;
    const float sy = view.light.y - (packet.ray.org_y[k] - view.eye.y) - t * dy;
    const float sz = view.light.z - (packet.ray.org_z[k] - view.eye.z) - t * dz;
    const float away = packet.hit.Ng_x[k] * dx + packet.hit.Ng_y[k] * dy + packet.hit.Ng_z[k] * dz;
    const float facing = away > 0.0f ? -weight[k] : weight[k];
    const float lengths = (nx * nx + ny * ny + nz * nz) * (sx * sx + sy * sy + sz * sz) + 1e-30f;
    const float value = facing * (nx * sx + ny * sy + nz * sz) / std::sqrt(lengths);
    values[k] = std::min(std::max(value, 0.0f), 255.0f);
  }
}

#endif
