// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief large meshes in files of every format and encoding that VTK writes
 */
#ifndef ReadingFiles_h
#define ReadingFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

/// A file, and how to read its surface with VTK only.
struct ReadingFile
{
  std::string name; ///< such as "dragon, .vtp, appended base64"
  std::string path;
  std::function<vtkSmartPointer<vtkPolyData>(const std::string& path)> readWithVtk;
};

/// Writes the files that do not exist yet to the cache folder. The polygons are from dragon.ply in
/// the data folder, or from an equally large ball if it is missing. The tetrahedra, about a
/// million, fill a box.
std::vector<ReadingFile> makeReadingFiles(const std::string& data, const std::string& cache);

#endif
