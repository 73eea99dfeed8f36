// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadPicture.h"
#include "CheckFile.h"
#include "CheckPng.h"
#include "CheckXml.h"
#include "FileBytes.h"
#include "FileKinds.h"
#include "Messages.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

namespace lambent::command
{
namespace
{

template <typename Reader>
vtkSmartPointer<vtkImageData> ReadWith(const std::string& path, VtkMessages& messages)
{
  vtkNew<Reader> reader;
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
    CheckFile(path);
    const FileBytes bytes(path);
    vtkSmartPointer<vtkImageData> image;
    if (PictureKindOf(path) == PictureKind::Vti)
    {
      CheckXml(path);
      image = ReadWith<vtkXMLImageDataReader>(path, messages);
    }
    else
    {
      CheckPng(bytes.view());
      image = ReadWith<vtkPNGReader>(path, messages);
    }
    if (!image->GetPointData()->GetScalars())
    {
      throw Failure("it has no point scalars");
    }
    return image;
  }
  catch (const std::exception& reason) // a Failure, or memory that is not there
  {
    throw Failure("cannot read '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
