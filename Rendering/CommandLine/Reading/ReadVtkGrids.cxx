// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads images and structured grids in VTK's XML formats. The readers of files in pieces join the
// pieces by their extents, so that no wall is left between them. But they skip pieces that they
// cannot read, so each piece is read separately first.

#include "CheckXml.h"
#include "Collection.h"
#include "Messages.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace lambent::command
{
namespace
{

/// Rejects truncated files: not all of these readers report that the last array is incomplete.
void CheckEnd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
  std::string end(static_cast<std::size_t>(std::min<std::streamoff>(size, 256)), '\0');
  file.seekg(size - static_cast<std::streamoff>(end.size()));
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  if (end.find("</VTKFile>") == std::string::npos)
  {
    throw Failure("it is incomplete: it does not end with </VTKFile>; use a complete copy");
  }
}

template <typename Reader>
vtkSmartPointer<vtkDataObject> ReadGrid(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckEnd(path);
  CheckXml(path);
  return Read<Reader>(path, messages, progress);
}

template <typename PieceReader, typename Reader>
vtkSmartPointer<vtkDataObject> ReadGridInPieces(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  for (const std::string& piece : PiecesIn(path, messages))
  {
    ReadPart(path, piece, ReadGrid<PieceReader>, messages, progress);
  }
  return Read<Reader>(path, messages, progress);
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadVti(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGrid<vtkXMLImageDataReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadVtr(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGrid<vtkXMLRectilinearGridReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadVts(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGrid<vtkXMLStructuredGridReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadPvti(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGridInPieces<vtkXMLImageDataReader, vtkXMLPImageDataReader>(path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadPvtr(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGridInPieces<vtkXMLRectilinearGridReader, vtkXMLPRectilinearGridReader>(
    path, messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadPvts(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadGridInPieces<vtkXMLStructuredGridReader, vtkXMLPStructuredGridReader>(
    path, messages, progress);
}

} // namespace lambent::command
