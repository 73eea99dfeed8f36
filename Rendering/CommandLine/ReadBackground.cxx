// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadBackground.h"
#include "CheckBmp.h"
#include "CheckFile.h"
#include "FileKinds.h"
#include "Isolated.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadPicture.h"
#include "ReadPnm.h"
#include "ReadThroughVtk.h"
#include "ReadTiff.h"

#include "vtkBMPReader.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace lambent::command
{
namespace
{

/// Packs an image into a mesh, because the pipe from the child process transfers meshes.
vtkSmartPointer<vtkPolyData> AsMesh(vtkImageData* image)
{
  vtkNew<vtkIntArray> size;
  for (const int n : { image->GetDimensions()[0], image->GetDimensions()[1] })
  {
    size->InsertNextValue(n);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->GetCellData()->AddArray(size);
  mesh->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  return mesh;
}

vtkSmartPointer<vtkImageData> AsImage(vtkPolyData* mesh)
{
  vtkDataArray* const size = mesh->GetCellData()->GetArray(0);
  if (!size || size->GetNumberOfTuples() != 2) // a faulty reader may still exit normally
  {
    throw Failure("its reader failed; check that it is complete");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(
    static_cast<int>(size->GetComponent(0, 0)), static_cast<int>(size->GetComponent(1, 0)), 1);
  image->GetPointData()->SetScalars(mesh->GetPointData()->GetScalars());
  return image;
}

/// Throws Failure unless the image has one slice and a value for each pixel.
void CheckPixels(vtkImageData* image)
{
  const int* const size = image->GetDimensions();
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  if (!pixels || pixels->GetNumberOfTuples() == 0)
  {
    throw Failure("it has no pixels");
  }
  if (size[2] != 1)
  {
    throw Failure("it has " + std::to_string(size[2]) + " slices; a background image has one");
  }
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
  {
    throw Failure("it does not have one value for each pixel; use a complete copy");
  }
  if (pixels->GetNumberOfComponents() > 4)
  {
    throw Failure("it has " + std::to_string(pixels->GetNumberOfComponents()) +
      " numbers per pixel; a background image has 1 to 4: grey, grey and alpha, RGB, or RGBA");
  }
}

template <typename Reader>
vtkSmartPointer<vtkImageData> ReadIn(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  const auto read = [&]
  {
    vtkNew<Reader> reader;
    if (!reader->CanReadFile(path.c_str()))
    {
      throw Failure("its content does not match its extension; check that the file is complete");
    }
    reader->SetFileName(path.c_str());
    const auto image = vtkImageData::SafeDownCast(Run(reader, messages, progress));
    const std::vector<std::string> warnings = messages.TakeWarnings();
    if (!warnings.empty()) // the readers only warn if a file is incomplete
    {
      throw Failure(warnings.front() + "; check that the file is complete");
    }
    return AsMesh(image);
  };
  return AsImage(ReadIsolated(read, LimitsFor(path, false), messages, progress));
}

vtkSmartPointer<vtkImageData> ReadKind(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  CheckFile(path);
  switch (*PictureKindOf(path))
  {
    case PictureKind::Jpeg:
    {
      const auto image = ReadIn<vtkJPEGReader>(path, messages, progress);
      return image->GetNumberOfScalarComponents() < 4
        ? image
        : throw Failure("its colours are CMYK; convert it to RGB");
    }
    case PictureKind::Tiff:
      return AsImage(ReadIsolated(
        [&path] { return AsMesh(ReadTiff(path)); }, LimitsFor(path, false), messages, progress));
    case PictureKind::Bmp:
      CheckBmp(path);
      return ReadIn<vtkBMPReader>(path, messages, progress);
    case PictureKind::Pnm:
      return ReadPnm(path);
    case PictureKind::Png:
    case PictureKind::Vti:
      break;
  }
  return ReadPicture(path, messages);
}

/// Converts pixels that are not bytes to floats.
void ConvertPixels(vtkImageData* image)
{
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  const int type = pixels->GetDataType();
  if (type == VTK_UNSIGNED_CHAR)
  {
    return;
  }
  if (type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    throw Failure(std::string("its pixels are of the type ") + pixels->GetDataTypeAsString() +
      "; a background image has unsigned char, unsigned short, float or double");
  }
  const double white = type == VTK_UNSIGNED_SHORT ? 65535 : 1;
  vtkNew<vtkFloatArray> floats;
  floats->SetNumberOfComponents(pixels->GetNumberOfComponents());
  floats->SetNumberOfTuples(pixels->GetNumberOfTuples());
  for (vtkIdType tuple = 0; tuple < pixels->GetNumberOfTuples(); ++tuple)
  {
    for (int k = 0; k < pixels->GetNumberOfComponents(); ++k)
    {
      const double value = pixels->GetComponent(tuple, k) / white;
      if (!(std::fabs(value) <= std::numeric_limits<float>::max()))
      {
        throw Failure(
          "its pixel " + std::to_string(tuple) + " is not finite as a 32-bit float; correct it");
      }
      floats->SetTypedComponent(tuple, k, static_cast<float>(value));
    }
  }
  image->GetPointData()->SetScalars(floats);
}

} // namespace

vtkSmartPointer<vtkImageData> ReadBackground(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  progress.Begin("reading " + path);
  try
  {
    const vtkSmartPointer<vtkImageData> image = ReadKind(path, messages, progress);
    CheckPixels(image);
    ConvertPixels(image);
    progress.Erase();
    messages.FlushWarnings("'" + path + "': ");
    return image;
  }
  catch (const std::exception& reason) // a Failure, or out of memory
  {
    const std::string about = "cannot read '" + path + "': ";
    const std::string text = reason.what();
    throw Failure(text.compare(0, about.size(), about) == 0 ? text : about + text);
  }
}

} // namespace lambent::command
