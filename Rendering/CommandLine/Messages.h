// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the command's messages on standard error, each in one line
 *
 * VTK reports through a global output window, in several lines that include the names of its source
 * files. A VtkMessages object replaces that window during its lifetime: it keeps errors until they
 * are asked for and turns each warning into one line.
 */

#ifndef Messages_h
#define Messages_h

#include <stdexcept>
#include <string>
#include <vector>

namespace lambent::command
{

/// The command cannot continue. what() is the line to print: the problem, the file and the remedy.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// An option's value does not fit the files, such as the name of an array that they do not have.
/// The command ends as after any other wrong usage.
struct WrongUsage : Failure
{
  using Failure::Failure;
};

/// Reduces VTK's "ERROR: In file, line n\nclass (0x..): text\n\n" to the text, in one line.
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

  /// Print the warnings since the last call, each once and with a prefix; drop them if
  /// `showWarnings` was false.
  void FlushWarnings(const std::string& about);

  /// The warnings since the last call, each once.
  std::vector<std::string> TakeWarnings();

  /// Discard the warnings since the last call.
  void DropWarnings();

private:
  class Window;
  Window* Listener;
  bool ShowWarnings;
};

} // namespace lambent::command

#endif
