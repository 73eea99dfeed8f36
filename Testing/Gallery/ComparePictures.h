// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief compare a PNG picture with its baseline, byte by byte
 *
 * There is no threshold: the image contract promises the same bits everywhere, so
 * a single byte that differs is a failure.
 *
 * The environment variable LAMBENT_UPDATE_BASELINES=1 accepts the picture instead:
 * it becomes the baseline. Look at it before you commit it.
 */

#ifndef ComparePictures_h
#define ComparePictures_h

#include <string>

/**
 * Empty if the two files show the same picture: the same size and type, the same
 * bytes. Otherwise what is wrong and what to do.
 *
 * Where two pictures of one size differ, a third is written into `folder`: the
 * picture, the baseline and their difference side by side. In the difference a
 * channel is 255 where the bytes differ, however little, and 0 where they do not.
 */
std::string ComparePictures(
  const std::string& picture, const std::string& baseline, const std::string& folder);

#endif
