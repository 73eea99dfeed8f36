// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which kinds of files there are, by the end of their names
 */

#ifndef FileKinds_h
#define FileKinds_h

#include <optional>
#include <string>

namespace lambent::command
{

enum class MeshKind
{
  Vtp,
  Vtu,
  LegacyVtk,
  Ply,
  Stl,
  Obj
};

enum class PictureKind
{
  Png,
  Jpeg,
  Tiff,
  Bmp,
  Pnm,
  Vti
};

/// The kind that a file's name tells, in upper or lower case; nothing if it is not known.
std::optional<MeshKind> MeshKindOf(const std::string& path);
std::optional<PictureKind> PictureKindOf(const std::string& path);

/// The extensions as a message lists them: ".png .jpg ...".
std::string MeshExtensions();
std::string PictureExtensions();

} // namespace lambent::command

#endif
