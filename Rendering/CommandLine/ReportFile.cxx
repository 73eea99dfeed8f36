// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReportFile.h"
#include "Messages.h"
#include "ReportStyle.h"

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace lambent::command
{
namespace
{

// The first two lines, by which a report is recognised.
const std::string Mark = "<!DOCTYPE html>\n<!-- report of lambent -->\n";

const std::string Head = Mark + R"(<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Pictures and their baselines</title>
<style>
)" +
  ReportStyle + R"(</style>
</head>
<body>
<h1>Pictures and their baselines</h1>
)";

/// An HTML comment in one line that is unique to the name, whatever its characters.
std::string Marker(const char* kind, const std::string& name)
{
  std::string text = std::string("<!-- ") + kind + " ";
  for (const char c : name)
  {
    if (std::isalnum(static_cast<unsigned char>(c)) || std::strchr("._/ ", c))
    {
      text += c;
    }
    else
    {
      char code[4];
      std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
      text += code;
    }
  }
  return text + " -->\n";
}

/// Replaces or appends a section. If the old section has no end, the page was truncated; then it is
/// kept, and the new section appended.
std::string WithSection(std::string page, const std::string& name, const std::string& section)
{
  const std::string begin = Marker("begin", name), end = Marker("end", name);
  const std::string whole = begin + section + "\n" + end;
  const std::size_t from = page.find(begin);
  const std::size_t to = from == std::string::npos ? from : page.find(end, from);
  return to == std::string::npos ? page + whole : page.replace(from, to + end.size() - from, whole);
}

/// A file that is locked for this process during the object's lifetime.
class LockedFile
{
public:
  explicit LockedFile(const std::string& path)
    : Descriptor(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
  {
    if (this->Descriptor < 0)
    {
      throw Failure(std::strerror(errno));
    }
    while (flock(this->Descriptor, LOCK_EX) != 0)
    {
      if (errno != EINTR)
      {
        const int reason = errno;
        close(this->Descriptor);
        throw Failure(std::strerror(reason));
      }
    }
  }
  ~LockedFile() { close(this->Descriptor); }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  std::string Read() const
  {
    std::string text;
    char buffer[65536];
    ssize_t count;
    while ((count = read(this->Descriptor, buffer, sizeof buffer)) > 0)
    {
      text.append(buffer, static_cast<std::size_t>(count));
    }
    return count == 0 ? text : throw Failure(std::strerror(errno));
  }

  void Replace(const std::string& text) const
  {
    off_t at = 0;
    while (at < static_cast<off_t>(text.size()))
    {
      const ssize_t count = pwrite(this->Descriptor, text.data() + at, text.size() - at, at);
      if (count < 0)
      {
        throw Failure(std::strerror(errno));
      }
      at += count;
    }
    if (ftruncate(this->Descriptor, at) != 0)
    {
      throw Failure(std::strerror(errno));
    }
  }

private:
  int Descriptor;
};

} // namespace

std::string EscapeHtml(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

void AddToReport(const std::string& path, const std::string& name, const std::string& section)
{
  try
  {
    const LockedFile file(path);
    std::string page = file.Read();
    if (page.empty())
    {
      page = Head;
    }
    if (page.compare(0, Mark.size(), Mark) != 0)
    {
      throw Failure("it exists and is not a report of lambent; choose another name");
    }
    file.Replace(WithSection(page, name, section));
  }
  catch (const Failure& reason)
  {
    throw Failure("cannot write the report '" + path + "': " + reason.what());
  }
}

} // namespace lambent::command
