// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which instruction set the kernels use
 *
 * By default the best one that the processor supports, chosen on first use. The bits of a
 * picture do not depend on it, and tests select each one to verify that. The environment
 * variable LAMBENT_SIMD overrides the choice: "plain" selects the scalar code that defines
 * the picture; any other name in vectorTargets(), such as "SSE4" or "AVX2", selects that
 * target. Unknown names are ignored.
 */
#ifndef lambent_VectorTarget_h
#define lambent_VectorTarget_h

#include <string>
#include <vector>

namespace lambent
{
/// "plain", then the targets that the kernels are compiled for and this processor supports.
std::vector<std::string> vectorTargets();

/// Selects a target by name. Returns false, and changes nothing, if the name is unknown. Do not
/// call this during rendering.
bool useVectorTarget(const std::string& name);

/// The name of the target in use. Queries the processor, which can be slow.
std::string vectorTargetInUse();

/// Whether the target in use is not "plain".
bool areVectorsInUse();
}

#endif
