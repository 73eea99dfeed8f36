// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Images and structured grids of VTK's XML formats. The readers of files in pieces put the pieces
// together by their extents, so that no wall is left between them; but they skip pieces that they
// cannot read, so each piece is looked at first.

#include "CheckXml.h"
#include "Collection.h"
#include "ReadThroughVtk.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace lambent::command
{
namespace
{

template <typename Reader>
vtkSmartPointer<vtkDataObject> ReadGrid(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
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
