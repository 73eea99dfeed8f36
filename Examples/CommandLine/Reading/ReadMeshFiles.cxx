// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// The readers of this file run in the command's own process: each has a check of its own.

#include "CheckFile.h"
#include "CheckLegacyVtk.h"
#include "CheckXml.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadPly.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkGenericDataObjectReader.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace lambent::command
{
namespace
{

/// vtkSTLReader takes any bytes for binary triangles and any number of them for all.
void CheckStl(const std::string& path)
{
  constexpr std::size_t headerSize = 84;
  constexpr std::size_t triangleSize = 50;
  std::ifstream file(path, std::ios::binary);
  unsigned char header[headerSize] = {};
  file.read(reinterpret_cast<char*>(header), headerSize);
  const std::string start(reinterpret_cast<char*>(header), headerSize);
  const bool isText = start.compare(start.find_first_not_of(" \t\r\n"), 5, "solid") == 0 &&
    std::all_of(start.begin(), start.begin() + file.gcount(),
      [](char c) { return static_cast<unsigned char>(c) < 128 && c != '\0'; });
  if (isText)
  {
    return; // the reader knows where the text has to end
  }
  std::size_t count = 0;
  for (int i = 3; i >= 0; --i)
  {
    count = 256 * count + header[80 + i];
  }
  if (static_cast<std::size_t>(file.gcount()) < headerSize ||
    std::filesystem::file_size(path) < headerSize + triangleSize * count)
  {
    throw Failure("it is cut short or not an STL file: it is too short for the " +
      std::to_string(count) + " triangles that it promises; get a whole copy of it");
  }
}

/// An OBJ file has no counts and no end: what tells of a cut is a line that is not ended.
void CheckObj(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(-1, std::ios::end);
  CheckLastByte(static_cast<char>(file.get()));
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadVtpFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckXml(path);
  return Read<vtkXMLPolyDataReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadVtuFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckXml(path);
  return Read<vtkXMLUnstructuredGridReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadLegacyVtkFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckLegacyVtk(path);
  return Read<vtkGenericDataObjectReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadObjFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckObj(path);
  return Read<vtkOBJReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadStlFile(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckStl(path);
  return Read<vtkSTLReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadPlyFile(
  const std::string& path, VtkMessages&, Progress& progress)
{
  return ReadPly(path, [&progress](double fraction) { progress.Update(fraction); });
}

} // namespace lambent::command
