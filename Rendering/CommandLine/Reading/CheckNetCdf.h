// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keep the Exodus reader from NetCDF files that are cut short
 *
 * The NetCDF library reads zeros where a file of the classic format ends too
 * early. But its header says where each variable begins and how large it is.
 * Files of the newer format, which is HDF5, are checked by that library.
 *
 * Reference: "The NetCDF Classic Format Specification", Unidata.
 */

#ifndef CheckNetCdf_h
#define CheckNetCdf_h

#include <string>

namespace lambent::command
{

/// Throws Failure if the file is a classic NetCDF file and shorter than its header says, or if the
/// header makes no sense.
void CheckNetCdf(const std::string& path);

} // namespace lambent::command

#endif
