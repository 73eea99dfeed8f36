// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Complete files from VTK's writers. The writer of PLY is in a separate module.

#include "BrokenFiles.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace
{

/// Two triangles with two-digit point ids, since half of such a number is another number.
const vtkIdType Triangles[2][3] = { { 10, 11, 12 }, { 10, 12, 13 } };
const int PointCount = 14;

vtkSmartPointer<vtkPolyData> MakeMesh()
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k < PointCount; ++k)
  {
    points->InsertNextPoint(0.5 * k, k * k, k % 3);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : Triangles)
  {
    polygons->InsertNextCell(3, triangle);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid()
{
  const auto mesh = MakeMesh();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(mesh->GetPoints());
  grid->SetCells(VTK_TRIANGLE, mesh->GetPolys());
  return grid;
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (vtkIdType k = 0; k < 18; ++k)
  {
    image->GetPointData()->GetScalars()->SetComponent(k / 3, k % 3, 10.0 * k);
  }
  return image;
}

template <typename Writer>
std::string Written(Writer* writer, vtkDataObject* data)
{
  const Scratch scratch("");
  writer->SetInputDataObject(data);
  writer->SetFileName(scratch.path.c_str());
  writer->Write();
  return scratch.read();
}

template <typename Writer>
File Xml(const std::string& extension, vtkDataObject* data, int mode, int compressor, bool encode)
{
  vtkNew<Writer> writer;
  writer->SetDataMode(mode);
  writer->SetCompressorType(compressor);
  writer->SetEncodeAppendedData(encode);
  const std::string name = "mode " + std::to_string(mode) + ", compressor " +
    std::to_string(compressor) + (encode ? ", encoded " : " ");
  return { name, extension, Written(writer.Get(), data) };
}

void AddXml(std::vector<File>& files)
{
  using Mesh = vtkXMLPolyDataWriter;
  files.push_back(Xml<Mesh>(".vtp", MakeMesh(), Mesh::Ascii, Mesh::NONE, false));
  files.push_back(Xml<Mesh>(".vtp", MakeMesh(), Mesh::Binary, Mesh::ZLIB, false));
  files.push_back(Xml<Mesh>(".vtp", MakeMesh(), Mesh::Appended, Mesh::NONE, false));
  files.push_back(Xml<Mesh>(".vtp", MakeMesh(), Mesh::Appended, Mesh::LZ4, false));
  files.push_back(Xml<Mesh>(".vtp", MakeMesh(), Mesh::Appended, Mesh::LZMA, true));
  using Grid = vtkXMLUnstructuredGridWriter;
  files.push_back(Xml<Grid>(".vtu", MakeGrid(), Grid::Binary, Grid::NONE, false));
  files.push_back(Xml<Grid>(".vtu", MakeGrid(), Grid::Appended, Grid::ZLIB, false));
  using Image = vtkXMLImageDataWriter;
  files.push_back(Xml<Image>(".vti", MakeImage(), Image::Ascii, Image::NONE, false));
  files.push_back(Xml<Image>(".vti", MakeImage(), Image::Appended, Image::ZLIB, false));
}

template <typename Writer>
File Legacy(vtkDataObject* data, int version, int fileType)
{
  vtkNew<Writer> writer;
  writer->SetFileType(fileType);
  writer->SetFileVersion(version);
  return { (fileType == VTK_ASCII ? "text " : "binary ") + std::to_string(version) + " ", ".vtk",
    Written(writer.Get(), data) };
}

void AddLegacy(std::vector<File>& files)
{
  for (int fileType : { VTK_ASCII, VTK_BINARY })
  {
    for (int version : { vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2,
           vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_5_1 })
    {
      files.push_back(Legacy<vtkPolyDataWriter>(MakeMesh(), version, fileType));
      files.push_back(Legacy<vtkUnstructuredGridWriter>(MakeGrid(), version, fileType));
    }
  }
}

template <typename Value>
void Append(std::string& bytes, Value value, const std::string& format)
{
  if (format == "ascii")
  {
    std::ostringstream text;
    text << +value << ' ';
    bytes += text.str();
    return;
  }
  std::string raw(sizeof(Value), '\0');
  std::memcpy(raw.data(), &value, sizeof(Value));
  const std::uint16_t one = 1;
  const bool isLittle = *reinterpret_cast<const char*>(&one) == 1;
  if (isLittle == (format == "binary_big_endian"))
  {
    std::reverse(raw.begin(), raw.end());
  }
  bytes += raw;
}

/// Cells of any order (before version 5.1, VTK's reader reorders their nodes), and a polyhedron.
vtkSmartPointer<vtkUnstructuredGrid> MakeSolid(int type, const std::vector<vtkIdType>& ids)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 27; ++k)
  {
    points->InsertNextPoint(k % 3, k / 3 % 3, k / 9);
  }
  grid->SetPoints(points);
  grid->Allocate(1);
  vtkNew<vtkIdList> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextId(id);
  }
  grid->InsertNextCell(type, list);
  return grid;
}

void AddSolids(std::vector<File>& files)
{
  const auto hexahedron = MakeSolid(VTK_LAGRANGE_HEXAHEDRON,
    { 0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22,
      13 });
  const auto polyhedron =
    MakeSolid(VTK_POLYHEDRON, { 4, 3, 0, 1, 3, 3, 0, 3, 9, 3, 0, 9, 1, 3, 1, 9, 3 });
  using Grid = vtkXMLUnstructuredGridWriter;
  using Legacy42 = vtkUnstructuredGridWriter;
  for (vtkUnstructuredGrid* const grid : { hexahedron.Get(), polyhedron.Get() })
  {
    files.push_back(Xml<Grid>(".vtu", grid, Grid::Ascii, Grid::NONE, false));
    files.push_back(Xml<Grid>(".vtu", grid, Grid::Appended, Grid::NONE, false));
    for (int fileType : { VTK_ASCII, VTK_BINARY })
    {
      files.push_back(Legacy<Legacy42>(grid, Legacy42::VTK_LEGACY_READER_VERSION_4_2, fileType));
      files.push_back(Legacy<Legacy42>(grid, Legacy42::VTK_LEGACY_READER_VERSION_5_1, fileType));
    }
  }
  files.push_back({ "list on the line of its keyword ", ".vtk",
    "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
    "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4 3\n0\n1\n2\n" });
}

/// vtkPLYWriter is in a separate module.
File Ply(const std::string& format)
{
  const std::string lineEnd = format == "ascii" ? "\n" : "";
  std::string bytes = "ply\nformat " + format + " 1.0\nelement vertex " +
    std::to_string(PointCount) + "\nproperty float x\nproperty float y\nproperty float z\n" +
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const auto mesh = MakeMesh();
  for (vtkIdType k = 0; k < PointCount; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Append(bytes, static_cast<float>(mesh->GetPoint(k)[axis]), format);
    }
    bytes += lineEnd;
  }
  for (const auto& triangle : Triangles)
  {
    Append(bytes, std::uint8_t{ 3 }, format);
    for (const vtkIdType id : triangle)
    {
      Append(bytes, static_cast<std::int32_t>(id), format);
    }
    bytes += lineEnd;
  }
  return { format + " ", ".ply", bytes };
}

} // namespace

std::vector<File> MakeFiles()
{
  std::vector<File> files;
  AddXml(files);
  AddLegacy(files);
  AddSolids(files);
  for (const char* const format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    files.push_back(Ply(format));
  }
  for (int fileType : { VTK_ASCII, VTK_BINARY })
  {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileType(fileType);
    files.push_back(
      { fileType == VTK_ASCII ? "text " : "binary ", ".stl", Written(writer.Get(), MakeMesh()) });
  }
  files.push_back({ "", ".obj", Written(vtkNew<vtkOBJWriter>().Get(), MakeMesh()) });
  const std::vector<File> byHand = MakeFilesByHand();
  files.insert(files.end(), byHand.begin(), byHand.end());
  files.push_back({ "", ".png", Written(vtkNew<vtkPNGWriter>().Get(), MakeImage()) });
  return files;
}
