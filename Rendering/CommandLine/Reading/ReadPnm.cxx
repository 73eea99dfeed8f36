// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadPnm.h"
#include "FileBytes.h"
#include "Messages.h"

#include "vtkImageData.h"

#include <cctype>
#include <cstdint>
#include <cstring>

namespace lambent::command
{
namespace
{

/// Reads the next number of the header, at most 9 digits. Comments go from # to the end of a line.
std::int64_t TakeNumber(const char*& at)
{
  while (std::isspace(static_cast<unsigned char>(*at)) || *at == '#')
  {
    if (*at == '#')
    {
      at += std::strcspn(at, "\n");
    }
    else
    {
      ++at;
    }
  }
  std::int64_t number = 0;
  int digits = 0;
  for (; std::isdigit(static_cast<unsigned char>(*at)) && digits < 9; ++at, ++digits)
  {
    number = 10 * number + (*at - '0');
  }
  return digits > 0 ? number : throw Failure("its header has no valid size; correct it");
}

} // namespace

vtkSmartPointer<vtkImageData> ReadPnm(const std::string& path)
{
  const FileBytes bytes(path);
  const std::string magic(bytes.view().substr(0, 2));
  if (magic != "P5" && magic != "P6")
  {
    throw Failure("it is not a binary PNM image, grey (P5) or RGB (P6); convert it to .png");
  }
  const char* at = bytes.begin() + 2; // a zero byte follows the file's content
  const std::int64_t width = TakeNumber(at), height = TakeNumber(at), largest = TakeNumber(at);
  if (width < 1 || height < 1 || largest < 1 || largest > 65535)
  {
    throw Failure("its header has no valid size or largest value; correct it");
  }
  at += at < bytes.end(); // one whitespace character
  const int channels = magic == "P6" ? 3 : 1, size = largest > 255 ? 2 : 1;
  if ((bytes.end() - at) / (channels * size) / width < height)
  {
    throw Failure("it is incomplete; use a complete copy");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  image->AllocateScalars(largest == 255 ? VTK_UNSIGNED_CHAR : VTK_FLOAT, channels);
  const auto* value = reinterpret_cast<const unsigned char*>(at);
  for (int j = static_cast<int>(height) - 1; j >= 0; --j) // PNM stores the top row first
  {
    auto* const pixels = image->GetScalarPointer(0, j, 0);
    for (std::int64_t k = 0; k < width * channels; ++k, value += size)
    {
      const int number = size == 2 ? 256 * value[0] + value[1] : value[0];
      if (largest == 255)
      {
        static_cast<unsigned char*>(pixels)[k] = value[0];
      }
      else
      {
        static_cast<float*>(pixels)[k] = static_cast<float>(number) / static_cast<float>(largest);
      }
    }
  }
  return image;
}

} // namespace lambent::command
