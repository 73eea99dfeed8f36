// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether two paths name the same file, so that writing to one changes the other
 *
 * Handles spellings (./, .., //), symbolic links, hard links, and upper and lower case where the
 * file system ignores it. Files need not exist yet, but names of missing files that differ only
 * in case count as different.
 */

#ifndef LambentSameFile_h
#define LambentSameFile_h

#include <filesystem>
#include <string>

namespace lambentFiles
{
/// Resolves all symbolic links in a path, even those to a missing file.
inline std::filesystem::path resolve(std::filesystem::path path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  for (int links = 0; links < 40; ++links)
  {
    const fs::path folder = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
    if (error)
    {
      break;
    }
    path = (folder / path.filename()).lexically_normal();
    if (!fs::is_symlink(fs::symlink_status(path, error)))
    {
      break;
    }
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

inline bool isSameFile(const std::string& a, const std::string& b)
{
  if (a.empty() || b.empty())
  {
    return false;
  }
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) || resolve(a) == resolve(b);
}
}

#endif
