// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief seeded random scenes with spheres, alone or among triangles
 */
#ifndef RandomSpheres_h
#define RandomSpheres_h

#include "RandomScenes.h"

/// The number of kinds of spheres; the remainder of the seed selects one.
constexpr int randomSphereKinds = 7;

/// A random scene with one to three surfaces of spheres. Two of three have no triangles. Some radii
/// are 0, negative or NaN.
RandomScene makeRandomSpheres(unsigned int seed);

/// The same, small enough for brute force with many samples.
RandomScene makeFewRandomSpheres(unsigned int seed);

#endif
