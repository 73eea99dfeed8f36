// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "WritePicture.h"
#include "EncodeTiff.h"
#include "FileKinds.h"
#include "Messages.h"
#include "TemporaryFile.h"

#include "vtkBMPWriter.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPNMWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataWriter.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace lambent::command
{
namespace
{

template <typename Writer>
void CheckWriter(Writer* writer, VtkMessages& messages)
{
  const std::string error = messages.TakeError();
  const unsigned long code = writer->GetErrorCode();
  if (code == vtkErrorCode::OutOfDiskSpaceError)
  {
    throw Failure("the disk is full, or the file is too large for it; free some space");
  }
  if (!error.empty() || code != vtkErrorCode::NoError)
  {
    throw Failure(error.empty() ? vtkErrorCode::GetStringFromErrorCode(code) : error);
  }
}

/// Encodes PNG or JPEG in memory. The bytes are written separately, because the writers miss some
/// write errors.
template <typename Writer>
vtkSmartPointer<vtkUnsignedCharArray> Encode(
  Writer* writer, vtkImageData* image, VtkMessages& messages)
{
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  CheckWriter(writer, messages);
  if (!writer->GetResult())
  {
    throw Failure("the picture is too large for this kind of file");
  }
  return writer->GetResult();
}

void WriteBytes(TemporaryFile& file, vtkUnsignedCharArray* bytes)
{
  file.Write(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

template <typename Writer>
void WriteThrough(Writer* writer, TemporaryFile& file, vtkImageData* image, VtkMessages& messages)
{
  writer->SetInputData(image);
  writer->SetFileName(file.GetPath().c_str());
  writer->Write();
  CheckWriter(writer, messages);
}

void WriteTiff(TemporaryFile& file, vtkImageData* image)
{
  const std::vector<unsigned char> bytes = EncodeTiff(image);
  file.Write(bytes.data(), bytes.size());
}

void WriteVti(TemporaryFile& file, vtkImageData* image, VtkMessages& messages)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressorTypeToLZ4();
  writer->EncodeAppendedDataOff();
  writer->WriteToOutputStringOn();
  writer->Write();
  CheckWriter(writer.Get(), messages);
  const std::string text = writer->GetOutputString();
  file.Write(text.data(), text.size());
}

void WriteKind(PictureKind kind, TemporaryFile& file, vtkImageData* image, VtkMessages& messages,
  const PictureText& text)
{
  switch (kind)
  {
    case PictureKind::Png:
      return WriteBytes(file, EncodePng(image, messages, text));
    case PictureKind::Jpeg:
      return WriteBytes(file, Encode(vtkNew<vtkJPEGWriter>().Get(), image, messages));
    case PictureKind::Tiff:
      return WriteTiff(file, image);
    case PictureKind::Bmp:
      return WriteThrough(vtkNew<vtkBMPWriter>().Get(), file, image, messages);
    case PictureKind::Pnm:
      return WriteThrough(vtkNew<vtkPNMWriter>().Get(), file, image, messages);
    case PictureKind::Vti:
      return WriteVti(file, image, messages);
  }
}

void WriteToStandardOutput(vtkImageData* image, VtkMessages& messages, const PictureText& text)
{
  const auto bytes = EncodePng(image, messages, text);
  const auto size = static_cast<std::size_t>(bytes->GetNumberOfValues());
  if (std::fwrite(bytes->GetPointer(0), 1, size, stdout) != size || std::fflush(stdout) != 0)
  {
    throw Failure(std::strerror(errno));
  }
}

std::string WhereTo(const std::string& path)
{
  return path == "-" ? "to standard output" : "'" + path + "'";
}

} // namespace

vtkSmartPointer<vtkUnsignedCharArray> EncodePng(
  vtkImageData* image, VtkMessages& messages, const PictureText& text)
{
  vtkNew<vtkPNGWriter> writer;
  for (const auto& [key, value] : text)
  {
    writer->AddText(key.c_str(), value.c_str());
  }
  writer->SetCompressionLevel(3); // for rendered surfaces about as small as 6, in less time
  return Encode(writer.Get(), image, messages);
}

void CheckPicturePlace(const std::string& path)
{
  try
  {
    if (path != "-")
    {
      const TemporaryFile trial(path);
    }
    else if (isatty(STDOUT_FILENO))
    {
      throw Failure("it is a terminal; send it to a file or a pipe");
    }
  }
  catch (const Failure& reason)
  {
    throw Failure("cannot write " + WhereTo(path) + ": " + reason.what());
  }
}

void WritePicture(
  vtkImageData* image, const std::string& path, VtkMessages& messages, const PictureText& text)
{
  try
  {
    if (path == "-")
    {
      WriteToStandardOutput(image, messages, text);
      return;
    }
    TemporaryFile file(path);
    WriteKind(*PictureKindOf(path), file, image, messages, text);
    file.Commit();
  }
  catch (const std::exception& reason) // a Failure, or out of memory
  {
    throw Failure("cannot write " + WhereTo(path) + ": " + reason.what());
  }
}

} // namespace lambent::command
