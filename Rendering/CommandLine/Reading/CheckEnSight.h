// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether the files of an EnSight case are all there
 *
 * VTK's reader says nothing of a file that is cut short, and fills in what it likes. Here each is
 * gone through once, by the counts in it: files of EnSight Gold, in text and C binary, that are
 * not numbered by time. A file that ends between two parts or before its elements cannot be told
 * from a whole one. Where something is not understood, it is left to the reader.
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
  bool isAtPoints; ///< not at the elements
  std::string name;
  std::string file;
};

/// Throws Failure if the geometry file of the case is cut short. Returns the variables whose
/// files are.
std::vector<BrokenVariable> CheckEnSight(const std::string& casePath);

} // namespace lambent::command

#endif
