// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief look over the sizes in an XML file of VTK before another reads it
 *
 * The checks of CheckedXmlParser.h, and that of the last offset of each list of
 * cells, in a pass of their own. It costs up to twice as much as to read the
 * file. Where a reader can be derived from, CheckedXmlReader.h does the same
 * within the reading.
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
