// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <mutex>
#include <utility>

namespace lambent::command
{

std::string OneLine(const std::string& message)
{
  std::size_t from = 0;
  for (const char* const prefix : { "ERROR: In ", "Warning: In ", "Generic Warning: In " })
  {
    if (message.compare(0, std::string(prefix).size(), prefix) == 0)
    {
      from = std::min(message.find('\n'), message.size());
    }
  }
  // Skip the object's class and address: "vtkPLYReader (0x55d0c8a3): ".
  const std::size_t address = message.find(" (0x", from);
  const std::size_t end = message.find("): ", from);
  if (address != std::string::npos && end != std::string::npos && address < end &&
    message.find('\n', from + 1) > address)
  {
    from = end + 3;
  }

  std::string line;
  for (const char c : message.substr(from))
  {
    if (!std::isspace(static_cast<unsigned char>(c)))
    {
      line += c;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  line.erase(line.find_last_not_of(" .") + 1);
  // vtkExecutive prints its whole request with addresses: "Algorithm vtkPLYReader(0x55d0c8a3) ...".
  const std::string executive = "Algorithm ";
  if (line.compare(0, executive.size(), executive) == 0 &&
    line.find(" returned failure for request") != std::string::npos)
  {
    line.erase(line.find_first_of(" (", executive.size()));
    line = line.substr(executive.size()) + " failed without a reason";
  }
  return line;
}

void Say(const std::string& text)
{
  std::fputs(("lambent: " + text + "\n").c_str(), stderr);
}

/// Keeps VTK's messages. Filters may report from several threads at once.
class VtkMessages::Window : public vtkOutputWindow
{
public:
  static Window* New() { VTK_STANDARD_NEW_BODY(Window); }

  void DisplayText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayErrorText(const char* text) override { this->Keep(this->Errors, text); }
  void DisplayWarningText(const char* text) override
  {
    // vtkDataReader reports "Error reading ascii data" as a warning and continues.
    const bool isError = OneLine(text).compare(0, 5, "Error") == 0;
    this->Keep(isError ? this->Errors : this->Warnings, text);
  }

  std::vector<std::string> TakeErrors() { return this->Take(this->Errors); }
  std::vector<std::string> TakeWarnings() { return this->Take(this->Warnings); }

private:
  void Keep(std::vector<std::string>& list, const char* text)
  {
    const std::lock_guard<std::mutex> guard(this->Mutex);
    std::string line = OneLine(text);
    if (std::find(list.begin(), list.end(), line) == list.end())
    {
      list.push_back(std::move(line));
    }
  }

  std::vector<std::string> Take(std::vector<std::string>& list)
  {
    const std::lock_guard<std::mutex> guard(this->Mutex);
    return std::exchange(list, {});
  }

  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

VtkMessages::VtkMessages(bool showWarnings)
  : Listener(Window::New())
  , ShowWarnings(showWarnings)
{
  vtkOutputWindow::SetInstance(this->Listener);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // or it would print every message again
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(nullptr);
  this->Listener->Delete();
}

std::string VtkMessages::TakeError()
{
  const std::vector<std::string> errors = this->Listener->TakeErrors();
  return errors.empty() ? std::string() : errors.front();
}

void VtkMessages::FlushWarnings(const std::string& about)
{
  for (const std::string& warning : this->Listener->TakeWarnings())
  {
    if (this->ShowWarnings)
    {
      Say("warning: " + about + warning);
    }
  }
}

std::vector<std::string> VtkMessages::TakeWarnings()
{
  return this->Listener->TakeWarnings();
}

void VtkMessages::DropWarnings()
{
  this->Listener->TakeWarnings();
}

} // namespace lambent::command
