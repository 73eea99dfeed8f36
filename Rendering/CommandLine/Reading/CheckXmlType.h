// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks that the content of a VTK file matches its extension
 */

#ifndef CheckXmlType_h
#define CheckXmlType_h

#include <string>

class vtkXMLDataElement;

namespace lambent::command
{

/// Throws Failure if the root of an XML file has no element of the expected type, such as
/// "PolyData". The message names the type found and the right extension.
void CheckXmlType(vtkXMLDataElement* root, const std::string& expected);

/// Throws Failure if a legacy file has the extension of a VTK XML file, or the other way round.
void CheckVtkStart(const std::string& path, bool expectsXml);

} // namespace lambent::command

#endif
