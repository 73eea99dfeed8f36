// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which faces of a mesh have the same points as one before them, the other way round
 *
 * Thin sheets are often modelled so. Smooth normals of both sides together would
 * cancel down to rounding noise.
 */

#ifndef OppositeFaces_h
#define OppositeFaces_h

#include "CellLists.h"

#include <vector>

namespace lambent::command
{

/// For each face, whether the first face on the same ring of points runs the other way round.
std::vector<bool> FindOppositeFaces(const CellLists& faces);

} // namespace lambent::command

#endif
