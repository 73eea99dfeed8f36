// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief decompresses a .gz file into a temporary file
 *
 * The file is decompressed in small blocks, so that memory use does not depend on its size. Every
 * length and checksum in it is checked. A few hundred bytes can decompress to any size, so more
 * than 64 MiB plus 256 times the compressed size is rejected. Meshes compress to a tenth at best,
 * so no mesh exceeds that limit.
 */

#ifndef UnpackedFile_h
#define UnpackedFile_h

#include "TemporaryFile.h"

#include <optional>
#include <string>

namespace lambent::command
{

class UnpackedFile
{
public:
  /// Unpacks `path`, whose name ends in ".gz", into the folder for temporary files (TMPDIR), or
  /// into its own folder if `beside` is true, because it names files beside it. Throws Failure.
  UnpackedFile(const std::string& path, bool beside);

  const std::string& GetPath() const { return this->File->GetPath(); }

private:
  std::optional<TemporaryFile> File; ///< removed with this object
};

} // namespace lambent::command

#endif
