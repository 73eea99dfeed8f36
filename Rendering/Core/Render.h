// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make the picture of a scene
 *
 * 1. The camera becomes a frame and a lattice of rays (CameraFrame), which are
 *    grouped into tiles (TileGrid).
 * 2. One pass over the points finds where each falls between the rays
 *    (PointLattice).
 * 3. One pass over the triangles drops those between the rays (Binning). Of small
 *    ones, the hits that are certain go into the bins of their tiles (Coverage); of
 *    others, the triangle does (Bins).
 * 4. Each tile casts its rays at its triangles (Casting), finds the nearest of all
 *    hits of each (TileSamples), shades it (Shading) and writes its pixels (Painting).
 *    Only the tile at hand has depths.
 *
 * Should the bins of step 3 fill the memory they are given, step 4 is done for
 * what they hold, the tiles keep their hits, and step 3 goes on.
 *
 * Beside scene and image this takes 4 bytes a point, and 16 bytes for each hit or up
 * to 32 for each larger triangle, at most Settings::binPages pages of them.
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
/// How the work is cut. None of it changes a bit of the picture.
struct Settings
{
  int tileShift = 5;                 ///< tiles are 2^tileShift samples wide, or somewhat less
  std::size_t chunk = 4096;          ///< points or triangles a worker takes at a time
  std::size_t binPages = 128 * 1024; ///< of 1 kB, before the tiles are processed
  bool culling = true;               ///< drop triangles between the rays
  /// Locate, cast and shade with vectors.
  bool kernels = areVectorsInUse();

  /// Every triangle against every ray, one at a time: the definition of the picture. The part
  /// of the image counts in samples.
  static Settings bruteForce(const Window& samplePart)
  {
    Settings settings;
    while (std::max(samplePart.width(), samplePart.height()) > 1 << settings.tileShift)
    {
      ++settings.tileShift;
    }
    settings.chunk = noTriangle;
    settings.culling = false;
    settings.kernels = false;
    return settings;
  }
};

enum class Outcome
{
  Done,
  Aborted,
  BadMesh ///< a corner names a point that does not exist; the image is unfinished
};

struct Report
{
  Outcome outcome = Outcome::Done;
  MeshDefects defects;
};

/// Told how much is done, from 0 to 1, by the calling thread; false aborts.
using Progress = std::function<bool(double)>;

/// The camera must have no defect, the image at least one pixel, the scene fewer
/// than noTriangle triangles. Throws std::bad_alloc.
Report render(const Scene& scene, const Image& image, const Parallel& parallel = Parallel(),
  const Progress& progress = nullptr, const Settings& settings = Settings());
}

#endif
