// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TemporaryFile.h"
#include "Messages.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace lambent::command
{
namespace
{

// A signal handler may use only plain memory that nothing changes while the handler may run.
char PathToRemove[4096];
volatile std::sig_atomic_t HasPathToRemove = 0;

extern "C" void RemoveAndEnd(int signal)
{
  if (HasPathToRemove)
  {
    unlink(PathToRemove);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void RemoveOnSignal(const std::string& path)
{
  if (path.size() < sizeof(PathToRemove))
  {
    std::strcpy(PathToRemove, path.c_str());
    HasPathToRemove = 1;
  }
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction old;
    // A signal that the caller set to be ignored (nohup) stays ignored.
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_DFL)
    {
      std::signal(signal, RemoveAndEnd);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN); // exceeding the file size limit then fails with an error to report
}

std::filesystem::path FolderOf(const std::filesystem::path& path)
{
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// Follows symbolic links, so that writing replaces the file and not the link.
std::filesystem::path Resolve(const std::string& target)
{
  std::error_code error;
  const std::filesystem::path path = std::filesystem::weakly_canonical(target, error);
  const std::filesystem::path resolved = error ? std::filesystem::path(target) : path;
  if (!std::filesystem::is_directory(FolderOf(resolved), error))
  {
    throw Failure("there is no folder '" + FolderOf(target).string() + "'; create it first");
  }
  const std::filesystem::file_status status = std::filesystem::status(resolved, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    throw Failure("it exists and is not a regular file; choose another name");
  }
  return resolved;
}

} // namespace

TemporaryFile::TemporaryFile(const std::string& target)
{
  const std::filesystem::path resolved = Resolve(target);
  this->Target = resolved.string();
  this->Path =
    (resolved.parent_path() / (".lambent-" + std::to_string(getpid()) + ".part")).string();
  RemoveOnSignal(this->Path);
  const int file = open(this->Path.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (file < 0)
  {
    HasPathToRemove = 0;
    throw Failure(std::string(std::strerror(errno)) + "; choose another folder");
  }
  close(file);
}

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& extension)
{
  this->Path = (std::filesystem::path(folder) / (".lambent-XXXXXX" + extension)).string();
  const int file = mkstemps(this->Path.data(), static_cast<int>(extension.size()));
  if (file < 0)
  {
    throw Failure(std::string(std::strerror(errno)) + " in the folder '" + folder + "'");
  }
  close(file);
  RemoveOnSignal(this->Path);
}

TemporaryFile::~TemporaryFile()
{
  if (!this->Path.empty())
  {
    unlink(this->Path.c_str());
    HasPathToRemove = 0;
  }
}

void TemporaryFile::Write(const void* bytes, std::size_t size)
{
  std::FILE* const file = std::fopen(this->Path.c_str(), "wb");
  bool isWritten = file && std::fwrite(bytes, 1, size, file) == size;
  isWritten &= file && std::fflush(file) == 0;
  const int error = errno;
  isWritten &= file && std::fclose(file) == 0; // a network drive reports here that it is full
  if (!isWritten)
  {
    throw Failure(
      std::string(std::strerror(error)) + "; free some space, or choose another folder");
  }
}

void TemporaryFile::Commit()
{
  struct stat old;
  if (stat(this->Target.c_str(), &old) == 0)
  {
    (void)chmod(this->Path.c_str(), old.st_mode & 07777); // as if the old file had been overwritten
  }
  if (std::rename(this->Path.c_str(), this->Target.c_str()) != 0)
  {
    throw Failure(std::string(std::strerror(errno)) + "; choose another name");
  }
  HasPathToRemove = 0;
  this->Path.clear();
}

} // namespace lambent::command
