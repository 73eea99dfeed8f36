// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what the command says on standard error: a line a matter
 *
 * VTK reports through a global output window, in several lines with the names
 * of its sources. While a VtkMessages lives, it listens there instead: an error
 * is kept until somebody asks for it, a warning becomes one line.
 */

#ifndef Messages_h
#define Messages_h

#include <stdexcept>
#include <string>
#include <vector>

namespace lambent::command
{

/// The command cannot go on; what() is the line to say: what, which file, what to do.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// VTK's "ERROR: In file, line n\nclass (0x..): text\n\n" as the text alone, in one line.
std::string OneLine(const std::string& message);

/// Write "lambent: text" and a line end to standard error.
void Say(const std::string& text);

class VtkMessages
{
public:
  explicit VtkMessages(bool showWarnings);
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// The first error since the last call, as one line; empty if there was none.
  std::string TakeError();

  /// Say the warnings since the last call, each once and prefixed; or drop them if not wanted.
  void FlushWarnings(const std::string& about);

  /// The warnings since the last call, each once.
  std::vector<std::string> TakeWarnings();

  /// Forget the warnings since the last call.
  void DropWarnings();

private:
  class Window;
  Window* Listener;
  bool ShowWarnings;
};

} // namespace lambent::command

#endif
