// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FileKinds.h"

#include <cctype>
#include <filesystem>
#include <utility>

namespace lambent::command
{
namespace
{

constexpr std::pair<const char*, PictureKind> Pictures[] = { { ".png", PictureKind::Png },
  { ".jpg", PictureKind::Jpeg }, { ".jpeg", PictureKind::Jpeg }, { ".tif", PictureKind::Tiff },
  { ".tiff", PictureKind::Tiff }, { ".bmp", PictureKind::Bmp }, { ".pnm", PictureKind::Pnm },
  { ".ppm", PictureKind::Pnm }, { ".vti", PictureKind::Vti } };

} // namespace

std::string ExtensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return extension;
}

std::optional<PictureKind> PictureKindOf(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  for (const auto& [name, kind] : Pictures)
  {
    if (extension == name)
    {
      return kind;
    }
  }
  return std::nullopt;
}

std::string WhyNoAlpha(const std::string& path)
{
  const auto kind = PictureKindOf(path);
  const bool canHoldAlpha = !kind || kind == PictureKind::Png || kind == PictureKind::Tiff ||
    kind == PictureKind::Vti; // unknown: "-", or no picture is written
  return canHoldAlpha
    ? ""
    : "'" + path + "' cannot hold alpha; choose a name that ends in .png, .tif or .vti";
}

std::string PictureExtensions()
{
  std::string list;
  for (const auto& [name, kind] : Pictures)
  {
    list += (list.empty() ? "" : " ") + std::string(name);
  }
  return list;
}

} // namespace lambent::command
