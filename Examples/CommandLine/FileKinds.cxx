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

constexpr std::pair<const char*, MeshKind> Meshes[] = { { ".vtp", MeshKind::Vtp },
  { ".vtk", MeshKind::LegacyVtk }, { ".vtu", MeshKind::Vtu }, { ".ply", MeshKind::Ply },
  { ".stl", MeshKind::Stl }, { ".obj", MeshKind::Obj } };

constexpr std::pair<const char*, PictureKind> Pictures[] = { { ".png", PictureKind::Png },
  { ".jpg", PictureKind::Jpeg }, { ".jpeg", PictureKind::Jpeg }, { ".tif", PictureKind::Tiff },
  { ".tiff", PictureKind::Tiff }, { ".bmp", PictureKind::Bmp }, { ".pnm", PictureKind::Pnm },
  { ".ppm", PictureKind::Pnm }, { ".vti", PictureKind::Vti } };

template <typename Kind, std::size_t N>
std::optional<Kind> Find(const std::pair<const char*, Kind> (&kinds)[N], const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const auto& [name, kind] : kinds)
  {
    if (extension == name)
    {
      return kind;
    }
  }
  return std::nullopt;
}

template <typename Kind, std::size_t N>
std::string List(const std::pair<const char*, Kind> (&kinds)[N])
{
  std::string list;
  for (const auto& [name, kind] : kinds)
  {
    list += (list.empty() ? "" : " ") + std::string(name);
  }
  return list;
}

} // namespace

std::optional<MeshKind> MeshKindOf(const std::string& path)
{
  return Find(Meshes, path);
}

std::optional<PictureKind> PictureKindOf(const std::string& path)
{
  return Find(Pictures, path);
}

std::string MeshExtensions()
{
  return List(Meshes);
}

std::string PictureExtensions()
{
  return List(Pictures);
}

} // namespace lambent::command
