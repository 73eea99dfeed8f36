// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief render spheres with Embree's sphere geometry
 *
 * As EmbreeRenderer does for triangles: build a tree, trace packets, shade the hits. Centres and
 * radii are prepared in advance, in the layout that Embree shares.
 */
#ifndef EmbreeBalls_h
#define EmbreeBalls_h

#include "EmbreeRenderer.h"

class EmbreeBalls
{
public:
  /// The points of the scene's mesh are centres.
  explicit EmbreeBalls(const BenchmarkScene& scene);
  ~EmbreeBalls();

  /// The seconds to build a tree from scratch. It replaces the last one of that quality.
  double build(TreeQuality quality);

  /// The seconds from that tree to the bytes of a newly allocated image.
  double trace(TreeQuality quality);

  vtkImageData* picture() { return this->Picture; }

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  vtkSmartPointer<vtkImageData> Picture;
};

#endif
