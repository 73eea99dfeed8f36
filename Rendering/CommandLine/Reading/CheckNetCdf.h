// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief rejects truncated NetCDF files before the Exodus reader reads them
 *
 * The NetCDF library reads zeros past the end of a truncated file in the classic format. The header
 * says where each variable begins and how large it is. Files in the newer format, HDF5, are checked
 * by the HDF5 library.
 *
 * Reference: "The NetCDF Classic Format Specification", Unidata.
 */

#ifndef CheckNetCdf_h
#define CheckNetCdf_h

#include <string>

namespace lambent::command
{

/// Throws Failure if the file is a classic NetCDF file and is shorter than its header declares or
/// has an invalid header.
void CheckNetCdf(const std::string& path);

} // namespace lambent::command

#endif
