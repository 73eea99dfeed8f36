// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief large meshes in files of every kind and encoding that VTK writes
 */
#ifndef ReadingFiles_h
#define ReadingFiles_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

/// A file, and how VTK alone gets its surface.
struct ReadingFile
{
  std::string name; ///< such as "dragon, .vtp, appended base64"
  std::string path;
  std::function<vtkSmartPointer<vtkPolyData>(const std::string& path)> readWithVtk;
};

/// Writes those files to the folder that are not there yet. The polygons are those of dragon.ply
/// in the folder of data, or of a ball as large if there is none; the tetrahedra, about a million,
/// are those of a box.
std::vector<ReadingFile> makeReadingFiles(const std::string& data, const std::string& cache);

#endif
