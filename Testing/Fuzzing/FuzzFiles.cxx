// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The command's own readers, for PLY, STL, OBJ with MTL, and PNM, and for TIFF with libtiff: the
// result is a Failure, or a valid mesh, image or list of materials. Its check of BMP images either
// throws a Failure or accepts the file.
#include "FuzzInput.h"
#include "NamelessFile.h"

#include "CheckBmp.h"
#include "CheckCells.h"
#include "FileBytes.h"
#include "Messages.h"
#include "ParseMtl.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadPnm.h"
#include "ReadStl.h"
#include "ReadTiff.h"
#include "TiffErrors.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <memory>
#include <string>

using namespace lambent::command;

namespace
{
void check(vtkCellArray* cells)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  double before = 0;
  for (vtkIdType k = 0; k < offsets->GetNumberOfTuples(); ++k)
  {
    const double offset = offsets->GetTuple1(k);
    require(offset >= before && offset <= cells->GetNumberOfConnectivityIds(),
      "offsets increase up to the end");
    before = offset;
  }
}

void check(vtkPolyData* mesh)
{
  require(mesh->GetPoints() && mesh->GetPoints()->GetData()->GetNumberOfComponents() == 3,
    "there are points");
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    require(mesh->GetPointData()->GetArray(i)->GetNumberOfTuples() == mesh->GetNumberOfPoints(),
      "point data has the length of the points");
  }
  check(mesh->GetPolys());
  check(mesh->GetStrips());
}

/// The readers of STL and OBJ check every index while they read.
void checkIds(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPoints() == 0)
  {
    return; // the file has none
  }
  check(mesh);
  for (vtkCellArray* const cells : { mesh->GetPolys(), mesh->GetLines(), mesh->GetVerts() })
  {
    try
    {
      CheckCells(cells, mesh->GetNumberOfPoints());
    }
    catch (const Failure&)
    {
      require(false, "cells use points that exist");
    }
  }
}

void check(vtkImageData* image)
{
  const int* const size = image->GetDimensions();
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  require(size[0] > 0 && size[1] > 0 && size[2] == 1 &&
      pixels->GetNumberOfTuples() == static_cast<vtkIdType>(size[0]) * size[1],
    "there is a value for each pixel");
}

void checkPnm(vtkImageData* image)
{
  check(image);
  double range[2];
  image->GetPointData()->GetScalars()->GetRange(range, -1);
  require(range[0] >= 0, "no pixel is below black");
}

void check(const std::vector<Material>& materials)
{
  for (const Material& material : materials)
  {
    for (const double channel : material.diffuse.value_or(std::array<double, 3>{ 0, 0, 0 }))
    {
      require(channel >= 0 && channel <= 1, "colours are from 0 to 1");
    }
    require(
      std::isfinite(material.scale[0]) && std::isfinite(material.offset[1]), "numbers are finite");
  }
}

/// Whether libtiff needs little memory for the file. The command limits that of its child process.
bool isSmall(const std::string& path)
{
  const TiffErrors errors;
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(path.c_str(), "r"), TIFFClose);
  if (!tiff)
  {
    return true;
  }
  std::uint32_t width = 0, height = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  const tmsize_t block =
    TIFFIsTiled(tiff.get()) ? TIFFTileSize(tiff.get()) : TIFFStripSize(tiff.get());
  return std::uint64_t{ width } * height < 1 << 20 && block < 1 << 24;
}

void read(std::string_view text, const std::string& path)
{
  const auto progress = [](double) {};
  const std::string_view start = text.substr(0, 2);
  if (start == "P5" || start == "P6")
  {
    checkPnm(ReadPnm(path));
  }
  else if (start == "II" || start == "MM")
  {
    if (isSmall(path))
    {
      check(ReadTiff(path));
    }
  }
  else if (start == "BM")
  {
    CheckBmp(path);
  }
  else if (text.substr(0, 6) == "newmtl")
  {
    const FileBytes file(path); // a zero byte follows them
    check(ParseMtl(file.view()));
  }
  else if (text.substr(0, 3) == "ply")
  {
    check(ReadPly(path, progress));
  }
  else if (text.substr(0, 4) == "#stl" || (!text.empty() && (text[0] == 's' || text[0] == 'S')))
  {
    checkIds(ReadStl(path, progress));
  }
  else
  {
    checkIds(ReadObj(path, progress));
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // Most of these texts lack the end of their last line, which causes a warning.
  vtkObject::GlobalWarningDisplayOff();
  const NamelessFile file(data, size);
  try
  {
    read({ reinterpret_cast<const char*>(data), size }, file.path());
  }
  catch (const Failure& failure)
  {
    require(*failure.what() != '\0', "a failure says why");
  }
  return 0;
}
