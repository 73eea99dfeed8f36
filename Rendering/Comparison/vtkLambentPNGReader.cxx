// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentPNGReader.h"

#include "DecodePng.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace
{
std::string contentOf(const char* path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw std::runtime_error("there is no such file; check its name");
  }
  if (std::filesystem::is_directory(status))
  {
    throw std::runtime_error("it is a folder; name a file in it");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw std::runtime_error("it is not a regular file; copy it to one");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path, "rb"), std::fclose);
  if (!file)
  {
    throw std::runtime_error(std::string(std::strerror(errno)) + "; check its permissions");
  }
  std::string content;
  char buffer[1 << 16];
  for (std::size_t size; (size = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
  {
    content.append(buffer, size);
  }
  if (std::ferror(file.get()))
  {
    throw std::runtime_error("it cannot be read completely");
  }
  return content.empty() ? throw std::runtime_error("it is empty, so it is not a PNG file")
                         : content;
}

vtkSmartPointer<vtkImageData> imageOf(PngPicture picture)
{
  const vtkIdType values =
    static_cast<vtkIdType>(picture.width) * picture.height * picture.components;
  vtkSmartPointer<vtkDataArray> scalars;
  unsigned char* const pixels = picture.pixels.release();
  if (picture.bytesPerValue == 2)
  {
    vtkNew<vtkUnsignedShortArray> array;
    array->SetNumberOfComponents(picture.components);
    array->SetArray(reinterpret_cast<unsigned short*>(pixels), values, 0,
      vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    array->SetArrayFreeFunction([](void* memory) { delete[] static_cast<unsigned char*>(memory); });
    scalars = array;
  }
  else
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfComponents(picture.components);
    array->SetArray(pixels, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_DELETE);
    scalars = array;
  }
  scalars->SetName("PNGImage");
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.width, picture.height, 1);
  image->GetPointData()->SetScalars(scalars);
  return image;
}
}

vtkStandardNewMacro(vtkLambentPNGReader);

//------------------------------------------------------------------------------
vtkLambentPNGReader::vtkLambentPNGReader()
  : FileName(nullptr)
  , Message("no file has been read yet")
{
  this->SetNumberOfInputPorts(0);
}

vtkLambentPNGReader::~vtkLambentPNGReader()
{
  delete[] this->FileName;
}

bool vtkLambentPNGReader::IsAvailable()
{
  return canDecodePng();
}

bool vtkLambentPNGReader::Read()
{
  this->Modified();
  this->ReadFile();
  return this->Message.empty();
}

const char* vtkLambentPNGReader::GetText(const char* key) const
{
  const auto found = key ? this->Texts.find(key) : this->Texts.end();
  return found == this->Texts.end() ? nullptr : found->second.c_str();
}

void vtkLambentPNGReader::ReadFile()
{
  this->Picture = nullptr;
  this->Texts.clear();
  this->Message.clear();
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw std::runtime_error("there is no file name; call SetFileName()");
    }
    PngPicture picture = decodePng(contentOf(this->FileName));
    this->Texts = std::move(picture.texts);
    this->Picture = imageOf(std::move(picture));
  }
  catch (const std::bad_alloc&)
  {
    this->Message = "there is not enough memory for it";
  }
  catch (const std::exception& problem)
  {
    this->Message = problem.what();
  }
  this->ReadTime.Modified();
}

//------------------------------------------------------------------------------
int vtkLambentPNGReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (this->GetMTime() > this->ReadTime.GetMTime())
  {
    this->ReadFile();
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->Picture)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    this->GetOutput()->Initialize();
    vtkErrorMacro(
      "'" << (this->FileName ? this->FileName : "") << "' cannot be read: " << this->Message);
    return 0;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const double origin[3] = { 0, 0, 0 }, spacing[3] = { 1, 1, 1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Picture->GetExtent(), 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->Picture->GetScalarType(), this->Picture->GetNumberOfScalarComponents());
  return 1;
}

int vtkLambentPNGReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs)->ShallowCopy(this->Picture);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLambentPNGReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Message: " << this->Message << "\n";
}
