// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which instruction set the kernels use
 *
 * The best one that the processor has, chosen when the first picture is made. The
 * bits of a picture do not depend on it; tests choose others to show that. The
 * environment variable LAMBENT_SIMD names one from outside: "plain" for the code
 * without vectors that defines the picture, or one that vectorTargets() lists, such
 * as "SSE4" or "AVX2". A name that is not known here is ignored.
 */
#ifndef lambent_VectorTarget_h
#define lambent_VectorTarget_h

#include <string>
#include <vector>

namespace lambent
{
/// "plain", then what kernels are compiled for and this processor has.
std::vector<std::string> vectorTargets();

/// From now on use one of them. False if there is none of that name. Not while
/// pictures are being made.
bool useVectorTarget(const std::string& name);

/// The name of the one in use. Asks the processor, which can take a while.
std::string vectorTargetInUse();

/// Whether that is not "plain".
bool areVectorsInUse();
}

#endif
