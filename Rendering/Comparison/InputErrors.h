// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether a reader upstream reports an error
 *
 * Some of VTK's readers, vtkPNGReader among them, tell the pipeline that all is well when they
 * could not read their file, and pass on memory that nobody has written to. With luck that is
 * the picture of the last time. Their error code is the only trace.
 */
#ifndef InputErrors_h
#define InputErrors_h

#include <string>

class vtkAlgorithm;

/// "The baseline could not be made: vtkJPEGReader reports: FileNotFoundError" for the first error
/// code that is set anywhere upstream of the ports of picture and baseline; empty if none is.
std::string findInputError(vtkAlgorithm* comparison);

#endif
