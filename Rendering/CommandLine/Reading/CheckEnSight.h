// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks that the files of an EnSight case are complete
 *
 * VTK's reader does not report truncated files and fills in arbitrary values. This check walks
 * through each file once, by the counts in it. It covers EnSight Gold files, in text and C binary,
 * that are not numbered by time. A file that ends between two parts or before its elements looks
 * complete. Unknown content is left to VTK's reader.
 *
 * Reference: "EnSight User Manual", chapter 9.1, EnSight Gold Casefile Format, Ansys.
 */

#ifndef CheckEnSight_h
#define CheckEnSight_h

#include <string>
#include <vector>

namespace lambent::command
{

struct BrokenVariable
{
  bool isAtPoints; ///< false: at the elements
  std::string name;
  std::string file;
};

/// Throws Failure if the geometry file of the case is truncated. Returns the variables whose files
/// are truncated.
std::vector<BrokenVariable> CheckEnSight(const std::string& casePath);

} // namespace lambent::command

#endif
