// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether a VTK file holds what its name tells
 */

#ifndef CheckXmlType_h
#define CheckXmlType_h

#include <string>

class vtkXMLDataElement;

namespace lambent::command
{

/// Throws Failure if there is no element of the type that is expected, such as "PolyData", in
/// the root of an XML file. It says which type there is and how such a file has to be named.
void CheckXmlType(vtkXMLDataElement* root, const std::string& expected);

/// Throws Failure if a file that is named like an XML file of VTK's begins as a legacy file, or
/// the other way round.
void CheckVtkStart(const std::string& path, bool expectsXml);

} // namespace lambent::command

#endif
