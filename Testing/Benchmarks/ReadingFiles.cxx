// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReadingFiles.h"
#include "Meshes.h"

#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkOBJWriter.h"
#include "vtkPLYReader.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridReader.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <cstdio>
#include <filesystem>
#include <iostream>

namespace
{
/// Only geometry, so that nothing else takes time.
vtkSmartPointer<vtkPolyData> makePolygons(const std::string& data)
{
  vtkSmartPointer<vtkPolyData> mesh = readMesh(data + "/dragon.ply");
  if (!mesh)
  {
    mesh = makeBumps(870000);
  }
  mesh->GetPointData()->Initialize();
  return mesh;
}

/// A lattice of cubes, each divided into six tetrahedra around its diagonal.
vtkSmartPointer<vtkUnstructuredGrid> makeTetrahedra()
{
  constexpr int cubes = 55;
  constexpr int side = cubes + 1;
  vtkNew<vtkPoints> points;
  for (int k = 0; k < side * side * side; ++k)
  {
    points->InsertNextPoint(0.01 * (k % side), 0.01 * (k / side % side), 0.01 * (k / side / side));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  constexpr int paths[6][2] = { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } };
  const auto corner = [](vtkIdType cube, int which)
  { return cube + which % 2 + side * (which / 2 % 2) + side * side * (which / 4); };
  vtkNew<vtkCellArray> cells;
  for (int k = 0; k < cubes * cubes * cubes; ++k)
  {
    const vtkIdType cube = k % cubes + side * (k / cubes % cubes + side * (k / cubes / cubes));
    for (const auto& path : paths)
    {
      cells->InsertNextCell(
        { cube, corner(cube, path[0]), corner(cube, path[1]), corner(cube, 7) });
    }
  }
  grid->SetCells(VTK_TETRA, cells);
  return grid;
}

vtkSmartPointer<vtkPolyData> surfaceOf(vtkPolyData* mesh)
{
  return mesh;
}

vtkSmartPointer<vtkPolyData> surfaceOf(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  return surface->GetOutput();
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return surfaceOf(reader->GetOutput());
}

class Files
{
public:
  explicit Files(std::string cache)
    : Cache(std::move(cache))
  {
  }

  template <typename Reader, typename Writer, typename Settings>
  void add(vtkDataObject* data, const std::string& extension, const std::string& encoding,
    const Settings& settings)
  {
    const std::string name = extension + ", " + encoding;
    const std::string path = this->Cache + "/reading " + encoding + extension;
    if (!std::filesystem::exists(path))
    {
      std::cerr << "Writing " << path << " once ...\n";
      const std::string unfinished = this->Cache + "/unfinished" + extension;
      vtkNew<Writer> writer;
      writer->SetInputDataObject(data);
      writer->SetFileName(unfinished.c_str());
      settings(writer.Get());
      writer->Write();
      std::filesystem::rename(unfinished, path);
    }
    this->Result.push_back({ name, path, readWith<Reader> });
  }

  template <typename Reader, typename Writer>
  void addXml(vtkDataObject* data, const std::string& extension)
  {
    const auto add = [&](const char* encoding, int mode, int compressor, bool encode)
    {
      this->add<Reader, Writer>(data, extension, encoding,
        [=](Writer* writer)
        {
          writer->SetDataMode(mode);
          writer->SetCompressorType(compressor);
          writer->SetEncodeAppendedData(encode);
        });
    };
    add("text", Writer::Ascii, Writer::NONE, false);
    add("inline base64", Writer::Binary, Writer::NONE, false);
    add("inline base64, zlib", Writer::Binary, Writer::ZLIB, false);
    add("appended raw", Writer::Appended, Writer::NONE, false);
    add("appended raw, zlib", Writer::Appended, Writer::ZLIB, false);
    add("appended raw, lz4", Writer::Appended, Writer::LZ4, false);
    add("appended base64", Writer::Appended, Writer::NONE, true);
    add("appended base64, zlib", Writer::Appended, Writer::ZLIB, true);
  }

  template <typename Reader, typename Writer>
  void addLegacy(vtkDataObject* data, const std::string& what)
  {
    for (int type : { VTK_ASCII, VTK_BINARY })
    {
      for (int version :
        { Writer::VTK_LEGACY_READER_VERSION_4_2, Writer::VTK_LEGACY_READER_VERSION_5_1 })
      {
        const std::string encoding =
          what + (type == VTK_ASCII ? " text " : " binary ") + std::to_string(version);
        this->add<Reader, Writer>(data, ".vtk", encoding,
          [=](Writer* writer)
          {
            writer->SetFileType(type);
            writer->SetFileVersion(version);
          });
      }
    }
  }

  std::vector<ReadingFile> Result;

private:
  std::string Cache;
};
}

//------------------------------------------------------------------------------
std::vector<ReadingFile> makeReadingFiles(const std::string& data, const std::string& cache)
{
  std::filesystem::create_directories(cache);
  const auto mesh = makePolygons(data);
  const auto grid = makeTetrahedra();
  Files files(cache);
  files.addXml<vtkXMLPolyDataReader, vtkXMLPolyDataWriter>(mesh, ".vtp");
  files.addXml<vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter>(grid, ".vtu");
  files.addLegacy<vtkPolyDataReader, vtkPolyDataWriter>(mesh, "polygons");
  files.addLegacy<vtkUnstructuredGridReader, vtkUnstructuredGridWriter>(grid, "tetrahedra");
  for (int type : { VTK_ASCII, VTK_BINARY })
  {
    const std::string encoding = type == VTK_ASCII ? "text" : "binary";
    const auto settings = [type](auto* writer) { writer->SetFileType(type); };
    files.add<vtkPLYReader, vtkPLYWriter>(mesh, ".ply", encoding, settings);
    files.add<vtkSTLReader, vtkSTLWriter>(mesh, ".stl", encoding, settings);
  }
  files.add<vtkOBJReader, vtkOBJWriter>(mesh, ".obj", "text", [](vtkOBJWriter*) {});
  return files.Result;
}
