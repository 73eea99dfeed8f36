// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds faces with the same points as an earlier face in the opposite orientation
 *
 * Thin sheets are often modelled this way. If both sides were averaged, their smooth normals would
 * cancel to rounding noise.
 */

#ifndef OppositeFaces_h
#define OppositeFaces_h

#include "CellLists.h"

#include <vector>

namespace lambent::command
{

/// For each face, whether the first face on the same ring of points has the opposite orientation.
std::vector<bool> FindOppositeFaces(const CellLists& faces);

} // namespace lambent::command

#endif
