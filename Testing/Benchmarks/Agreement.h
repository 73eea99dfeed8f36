// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief check that the peers render the same picture
 */
#ifndef Agreement_h
#define Agreement_h

#include "Peers.h"

#include <map>
#include <vector>

/// The pictures to compare with Lambent's.
struct Compared
{
  std::vector<int> embree; ///< the supersampling of each of Embree's pictures
  bool layers = false;     ///< with transparent surfaces, by Embree
  bool balls = false;
  bool openGL = false;
};

/// The fraction of bytes that differ from Lambent's picture by more than 2, for each peer
/// ("embree/single" and so on). Writes the pictures as PNG files if a folder is given.
std::map<std::string, double> comparePictures(
  Peers& peers, const Compared& compared, const std::string& folder);

#endif
