// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether two paths lead to one file, so that writing one changes the other
 *
 * Spellings (./, .., //), symbolic links, hard links, and upper and lower case where the file
 * system ignores it are seen through. A file need not exist yet. Where it does not, two names
 * that only such a file system takes for one count as two.
 */

#ifndef LambentSameFile_h
#define LambentSameFile_h

#include <filesystem>
#include <string>

namespace lambentFiles
{
/// The file that a path leads to, through symbolic links, also those to a missing file.
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
