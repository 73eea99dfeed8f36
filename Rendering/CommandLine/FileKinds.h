// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the kinds of picture files, by the end of their names; Reading/Formats.h has those of
 * meshes
 */

#ifndef FileKinds_h
#define FileKinds_h

#include <optional>
#include <string>

namespace lambent::command
{

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
std::optional<PictureKind> PictureKindOf(const std::string& path);

/// The end of a file's name in lower case, such as ".png".
std::string ExtensionOf(const std::string& path);

/// The extensions as a message lists them: ".png .jpg ...".
std::string PictureExtensions();

} // namespace lambent::command

#endif
