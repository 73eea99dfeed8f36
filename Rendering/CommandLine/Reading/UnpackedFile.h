// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what is in a .gz file, as a temporary file
 *
 * The file is unpacked piece by piece, so that memory does not matter; every
 * length and check sum in it is checked. Some hundred bytes can unpack to any
 * size: more than 64 MiB and 256 times the packed size is refused. Meshes of
 * numbers pack to a tenth at best, so what exceeds that is not one.
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
  /// Unpacks `path`, whose name ends in ".gz", into the folder for temporary files (TMPDIR), or,
  /// if it names files `beside` it, into its own folder. Throws Failure.
  UnpackedFile(const std::string& path, bool beside);

  const std::string& GetPath() const { return this->File->GetPath(); }

private:
  std::optional<TemporaryFile> File; ///< removed with this object
};

} // namespace lambent::command

#endif
