// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether an upstream reader has set an error code
 *
 * Some of VTK's readers, vtkPNGReader among them, report success to the pipeline when they cannot
 * read their file, and output uninitialized memory. With luck that is the previous picture.
 * Their error code is the only trace.
 */
#ifndef InputErrors_h
#define InputErrors_h

#include <string>

class vtkAlgorithm;

/// A message for the first error code that is set anywhere upstream of picture or baseline, such as
/// "The baseline could not be produced: vtkJPEGReader reports: FileNotFoundError". Empty if none is
/// set.
std::string findInputError(vtkAlgorithm* comparison);

#endif
