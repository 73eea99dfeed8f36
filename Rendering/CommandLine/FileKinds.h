// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the kinds of picture files, by extension; Reading/Formats.h has those of meshes
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

/// The kind that belongs to a file's extension, in upper or lower case; empty if it is unknown.
std::optional<PictureKind> PictureKindOf(const std::string& path);

/// Returns why a picture at this path cannot have an alpha channel, or an empty string. "-" is a
/// PNG.
std::string WhyNoAlpha(const std::string& path);

/// The extension of a file's name in lower case, such as ".png".
std::string ExtensionOf(const std::string& path);

/// The extensions as listed in messages: ".png .jpg ...".
std::string PictureExtensions();

} // namespace lambent::command

#endif
