// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadPicture.h"
#include "CheckFile.h"
#include "CheckXml.h"
#include "FileKinds.h"
#include "Messages.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkLambentPNGReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

namespace lambent::command
{
namespace
{

vtkSmartPointer<vtkImageData> ReadPng(const std::string& path)
{
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName(path.c_str());
  if (!reader->Read())
  {
    throw Failure(reader->GetMessage());
  }
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> ReadVti(const std::string& path, VtkMessages& messages)
{
  CheckFile(path);
  CheckXml(path);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const std::string error = messages.TakeError();
  if (!error.empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(
      error.empty() ? vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()) : error);
  }
  return reader->GetOutput();
}

} // namespace

vtkSmartPointer<vtkImageData> ReadPicture(const std::string& path, VtkMessages& messages)
{
  try
  {
    const vtkSmartPointer<vtkImageData> image =
      PictureKindOf(path) == PictureKind::Vti ? ReadVti(path, messages) : ReadPng(path);
    if (!image->GetPointData()->GetScalars())
    {
      throw Failure("it has no point scalars");
    }
    return image;
  }
  catch (const std::exception& reason) // a Failure, or out of memory
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
