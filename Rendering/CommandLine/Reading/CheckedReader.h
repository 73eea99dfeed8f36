// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what a reader of VTK's that checks what it reads has to say
 *
 * VTK's readers trust counts and indices in a file, and crash where they are
 * wrong. Checking a file before it is read means to parse it twice; so the
 * readers derived from VTK's check each count right before it is used. A
 * Failure must not pass through VTK's pipeline: it is kept here instead.
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

  /// Why the reader has stopped; empty if nothing it checked was wrong.
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
    catch (const std::exception& reason) // a Failure, or too little memory
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
