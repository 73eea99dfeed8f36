// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief do the peers draw the same picture?
 */
#ifndef Agreement_h
#define Agreement_h

#include "Peers.h"

#include <map>

/// The fraction of bytes by which a peer's picture differs from Lambent's by more than
/// 2, by "embree/single" and so on. Writes the pictures as PNG to a folder, if one is given.
std::map<std::string, double> comparePictures(
  Peers& peers, bool withEmbree, bool withOpenGL, const std::string& folder);

#endif
