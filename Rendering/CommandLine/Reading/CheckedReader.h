// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief base of the readers that check a file while VTK reads it
 *
 * VTK's readers trust the counts and indices in a file and crash if they are wrong. Checking a file
 * before it is read would parse it twice. Therefore readers derived from VTK's check each count
 * just before it is used. A Failure must not propagate through VTK's pipeline, so its text is kept
 * here.
 */

#ifndef CheckedReader_h
#define CheckedReader_h

#include <exception>
#include <string>

namespace lambent::command
{

class CheckedReader
{
public:
  virtual ~CheckedReader() = default;

  /// Why the reader stopped; empty if all checks passed.
  const std::string& GetFailure() const { return this->FailureText; }

protected:
  /// Runs a check; returns whether it passed.
  template <typename Check>
  bool Passes(const Check& check)
  {
    try
    {
      check();
      return true;
    }
    catch (const std::exception& reason) // a Failure, or out of memory
    {
      if (this->FailureText.empty())
      {
        this->FailureText = reason.what();
      }
      return false;
    }
  }

private:
  std::string FailureText;
};

} // namespace lambent::command

#endif
