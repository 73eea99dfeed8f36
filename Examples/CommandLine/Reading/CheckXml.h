// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keep VTK's XML readers from sizes that would make them crash
 *
 * VTK's readers believe three kinds of sizes in a file. In front of compressed
 * data stands how many blocks there are and how large they are; where these do
 * not fit each other, vtkXMLDataParser reads beyond its list of blocks or divides
 * by zero. For the counts of a piece, and for as many point ids as the last
 * offset of its cells says, memory is taken; if they are so large that the number
 * of bytes overflows, it is too little. Here all of these are looked over first,
 * with the readers' own parser.
 */

#ifndef CheckXml_h
#define CheckXml_h

#include <string>

namespace lambent::command
{

/// Throws Failure if an array in the file is cut short or has sizes that cannot be. What cannot
/// be parsed at all is left to the reader, which says so.
void CheckXml(const std::string& path);

} // namespace lambent::command

#endif
