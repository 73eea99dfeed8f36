// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief splits the runs of a batch into ranges that a kernel processes together
 */
#ifndef lambent_RunRange_h
#define lambent_RunRange_h

#include "SampleBatch.h"

namespace lambent
{
/// Consecutive runs that are shaded together, and the places of their samples.
struct RunRange
{
  int firstRun = 0, endRun = 0;
  int first = 0, end = 0;
  PrimitiveKind kind = PrimitiveKind::Triangle; ///< of all primitives
  bool isUnlit = false;
  bool hasTextures = false;                ///< all runs that hit something have one, or none has
  bool isSmooth = false;                   ///< normals at the corners; otherwise one of the face
  bool hasGivenNormals = false;            ///< some normals are not computed from the geometry
  bool hasEdges = false;                   ///< lines are drawn along some cells
  const SpecularStyle* specular = nullptr; ///< of all runs; nullptr: none have any
  const SceneMesh::Part* part = nullptr;   ///< if all runs have the same
  const Appearance* appearance = nullptr;  ///< if it gives all runs their colour
  ColorSource colorSource = ColorSource::Primitive;

  /// Moves to the runs after the current ones, up to the first that is shaded in another way. Runs
  /// that hit nothing are included. Fills in the parts of the runs. Returns false if none of the
  /// remaining runs hits anything.
  bool moveOn(const SceneMesh& mesh, SampleBatch& batch);

private:
  void begin(const SceneMesh::Part& part);
  bool join(const SceneMesh::Part& part);
};
}

#endif
