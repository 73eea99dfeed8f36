// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks the sizes in a VTK XML file before it is read
 *
 * A separate pass makes the checks of CheckedXmlParser.h and checks the last offset of each list of
 * cells. It costs up to twice as much as reading the file. For readers that can be derived from,
 * CheckedXmlReader.h makes the same checks while reading.
 */

#ifndef CheckXml_h
#define CheckXml_h

#include <string>

namespace lambent::command
{

/// Throws Failure if an array in the file is truncated or has impossible sizes. The reader reports
/// files that cannot be parsed.
void CheckXml(const std::string& path);

} // namespace lambent::command

#endif
