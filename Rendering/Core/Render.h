// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief renders a scene into an image
 *
 * 1. The camera becomes a frame and a lattice of rays (CameraFrame), which are grouped into tiles
 *    (TileGrid).
 * 2. One pass over the points of triangles computes where each falls between the samples
 *    (PointLattice).
 * 3. One pass over the primitives drops those between the samples (Binning). Certain hits of small
 *    triangles go into the bins of their tiles (Coverage); other primitives go there whole (Bins).
 * 4. Each tile casts its rays against its primitives (Casting), keeps the nearest hit of each ray
 *    (Nearest), computes its surface point (SurfacePoints) and colour (LightModel), and stores its
 *    pixels (Painting, Film). Only the current tile has depths.
 *
 * If the bins of step 3 exceed their memory, step 4 casts their contents, the tiles keep their
 * hits, and step 3 continues.
 *
 * A picture with several samples per pixel that has more samples than Settings::mostSamples is
 * rendered in bands, one at a time.
 *
 * Besides scene and image, this takes 4 bytes per point, and 16 bytes per hit or up to 48 bytes per
 * larger primitive, in about Settings::binPages pages at most.
 */
#ifndef lambent_Render_h
#define lambent_Render_h

#include "Binning.h"
#include "Image.h"
#include "Parallel.h"
#include "Scene.h"
#include "VectorTarget.h"

#include <functional>

namespace lambent
{
/// How the work is divided. No setting changes a bit of the image.
struct Settings
{
  int tileShift = 5;        ///< tiles are 2^tileShift samples wide, adjusted to whole pixels
  std::size_t chunk = 4096; ///< points or primitives that a worker takes at a time, at least 1
  /// Pages of 1 kB to fill before tiles are processed, at least 1.
  std::size_t binPages = 128 * 1024;
  /// A picture with several samples per pixel is rendered in bands of rows that have at most so
  /// many samples, but at least one row.
  std::size_t mostSamples = 32 * 1024 * 1024;
  bool culling = true; ///< drop triangles between the samples
  /// Use vectors to locate, cast and shade.
  bool kernels = areVectorsInUse();

  /// Tests every primitive against every ray, one at a time: the definition of the image. The part
  /// of the image is in samples.
  static Settings bruteForce(const Window& samplePart)
  {
    Settings settings;
    while (std::max(samplePart.width(), samplePart.height()) > 1 << settings.tileShift)
    {
      ++settings.tileShift;
    }
    settings.chunk = noPrimitive;
    settings.culling = false;
    settings.kernels = false;
    return settings;
  }
};

enum class Outcome
{
  Done,
  Aborted,
  BadMesh ///< the point of a corner does not exist; the image is unfinished
};

struct Report
{
  Outcome outcome = Outcome::Done;
  MeshDefects defects;
};

/// Receives the fraction done, from 0 to 1, in the calling thread. Returning false aborts.
using Progress = std::function<bool(double)>;

/// The camera must have no defect, the image at least one pixel, and the scene fewer than
/// noPrimitive primitives. If the image's part is empty, nothing is read or stored. Throws
/// std::bad_alloc.
Report render(const Scene& scene, const Image& image, const Parallel& parallel = Parallel(),
  const Progress& progress = nullptr, const Settings& settings = Settings());
}

#endif
