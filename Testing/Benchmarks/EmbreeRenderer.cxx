// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeRenderer.h"

#include "EmbreeLayers.h"
#include "EmbreeTile.h"
#include "Stopwatch.h"

#include <type_traits>

const char* nameOf(TreeQuality quality)
{
  constexpr const char* names[] = { "low", "medium", "high" };
  return names[static_cast<int>(quality)];
}

const char* nameOf(RayGrouping grouping)
{
  constexpr const char* names[] = { "single", "packets", "stream", "packet-stream" };
  return names[static_cast<int>(grouping)];
}

struct EmbreeRenderer::Internals
{
  explicit Internals(const BenchmarkScene& scene)
    : mesh(scene.mesh)
    , view(scene.view())
    , width(scene.width)
    , height(scene.height)
  {
  }

  const EmbreeMesh mesh;
  const EmbreeView view;
  const int width, height;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene trees[3] = {};
  RTCScene layerTrees[3] = {}; ///< that call a filter for each hit

  bool hasWidePackets() const
  {
    return rtcGetDeviceProperty(this->device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  }

  RTCScene build(TreeQuality quality, RTCSceneFlags flags) const;
  template <int N>
  void traceTiles(RTCScene tree, RayGrouping grouping, const EmbreeFilm& film) const;
};

namespace
{
RTCBuildQuality embreeQuality(TreeQuality quality)
{
  constexpr RTCBuildQuality qualities[] = { RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_MEDIUM,
    RTC_BUILD_QUALITY_HIGH };
  return qualities[static_cast<int>(quality)];
}
}

//------------------------------------------------------------------------------
EmbreeRenderer::EmbreeRenderer(const BenchmarkScene& scene)
  : Internal(new Internals(scene))
{
}

EmbreeRenderer::~EmbreeRenderer()
{
  for (TreeQuality quality : treeQualities)
  {
    this->release(quality);
    if (this->Internal->layerTrees[static_cast<int>(quality)])
    {
      rtcReleaseScene(this->Internal->layerTrees[static_cast<int>(quality)]);
    }
  }
  rtcReleaseDevice(this->Internal->device);
}

int EmbreeRenderer::raysAtOnce() const
{
  return this->Internal->hasWidePackets() ? 16 : 8;
}

void EmbreeRenderer::release(TreeQuality quality)
{
  RTCScene& tree = this->Internal->trees[static_cast<int>(quality)];
  if (tree)
  {
    rtcReleaseScene(tree);
    tree = nullptr;
  }
}

RTCScene EmbreeRenderer::Internals::build(TreeQuality quality, RTCSceneFlags flags) const
{
  RTCGeometry geometry = rtcNewGeometry(this->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
    this->mesh.points.data(), 0, 3 * sizeof(float), this->mesh.pointCount());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
    this->mesh.corners.data(), 0, 3 * sizeof(std::uint32_t), this->mesh.triangleCount());
  rtcSetGeometryBuildQuality(geometry, embreeQuality(quality));
  rtcCommitGeometry(geometry);
  RTCScene tree = rtcNewScene(this->device);
  rtcSetSceneBuildQuality(tree, embreeQuality(quality));
  rtcSetSceneFlags(tree, flags);
  rtcAttachGeometry(tree, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree);
  return tree;
}

double EmbreeRenderer::build(TreeQuality quality)
{
  this->release(quality);
  const Stopwatch stopwatch;
  this->Internal->trees[static_cast<int>(quality)] =
    this->Internal->build(quality, RTC_SCENE_FLAG_NONE);
  return stopwatch.seconds();
}

//------------------------------------------------------------------------------
template <int N>
void EmbreeRenderer::Internals::traceTiles(
  RTCScene tree, RayGrouping grouping, const EmbreeFilm& film) const
{
  constexpr int side = EmbreeTile<N>::side;
  const int across = (film.columns() + side - 1) / side, up = (film.rows() + side - 1) / side;
  const auto traceRange = [&](const tbb::blocked_range<int>& range)
  {
    const FlushDenormals flush;
    EmbreeTile<N> tile(this->mesh, this->view, film);
    for (int k = range.begin(); k < range.end(); ++k)
    {
      tile.render(tree, grouping, side * (k % across), side * (k / across));
    }
  };
  constexpr int tilesAtATime = 4;
  tbb::parallel_for(
    tbb::blocked_range<int>(0, across * up, tilesAtATime), traceRange, tbb::simple_partitioner());
}

double EmbreeRenderer::trace(TreeQuality quality, RayGrouping grouping, int samples)
{
  const Internals& internal = *this->Internal;
  if (!internal.trees[static_cast<int>(quality)])
  {
    this->build(quality);
  }
  RTCScene tree = internal.trees[static_cast<int>(quality)];
  this->Picture = nullptr; // Freeing the last image does not count.
  const Stopwatch stopwatch;
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(internal.width, internal.height, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const EmbreeFilm film(internal.width, internal.height, samples,
    static_cast<unsigned char*>(this->Picture->GetScalarPointer()));
  if (internal.hasWidePackets())
  {
    internal.traceTiles<16>(tree, grouping, film);
  }
  else
  {
    internal.traceTiles<8>(tree, grouping, film);
  }
  return stopwatch.seconds();
}

//------------------------------------------------------------------------------
double EmbreeRenderer::traceLayers(TreeQuality quality)
{
  Internals& internal = *this->Internal;
  RTCScene& tree = internal.layerTrees[static_cast<int>(quality)];
  if (!tree)
  {
    tree = internal.build(quality, RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  }
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(internal.width, internal.height, 1);
  this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
  const EmbreePicture picture{ internal.view, internal.width, internal.height, bytes };
  const auto render = [&](auto size)
  {
    constexpr int N = decltype(size)::value;
    renderPackets<N>(tree, picture,
      [&]()
      { return EmbreeLayers<N>(internal.mesh, internal.view, static_cast<float>(layerOpacity)); });
  };
  internal.hasWidePackets() ? render(std::integral_constant<int, 16>())
                            : render(std::integral_constant<int, 8>());
  return stopwatch.seconds();
}
