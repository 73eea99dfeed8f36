// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the errors and warnings of a filter, collected instead of printed
 */
#ifndef Messages_h
#define Messages_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

class Messages
{
public:
  /// Observes the filter until this object is destroyed. Also collects the messages of its
  /// executive ("Algorithm ... returned failure").
  explicit Messages(vtkAlgorithm* filter)
  {
    collect(this->OnError, this->Errors);
    collect(this->OnWarning, this->Warnings);
    collect(this->OnExecutive, this->Executive);
    filter->AddObserver(vtkCommand::ErrorEvent, this->OnError);
    filter->AddObserver(vtkCommand::WarningEvent, this->OnWarning);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->OnExecutive);
  }
  ~Messages()
  {
    // The commands can outlive this object.
    this->OnError->SetCallback(nullptr);
    this->OnWarning->SetCallback(nullptr);
    this->OnExecutive->SetCallback(nullptr);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  const std::vector<std::string>& errors() const { return this->Errors; }
  const std::vector<std::string>& warnings() const { return this->Warnings; }
  const std::vector<std::string>& executive() const { return this->Executive; }
  void clear()
  {
    this->Errors.clear();
    this->Warnings.clear();
    this->Executive.clear();
  }

private:
  static void collect(vtkCallbackCommand* command, std::vector<std::string>& texts)
  {
    command->SetClientData(&texts);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* list, void* text) {
        static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text));
      });
  }

  std::vector<std::string> Errors, Warnings, Executive;
  vtkNew<vtkCallbackCommand> OnError, OnWarning, OnExecutive;
};

/// Expects exactly one message, which contains all of these parts.
inline void expectMessage(
  const std::vector<std::string>& messages, const std::vector<std::string>& parts)
{
  ASSERT_EQ(messages.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_NE(messages[0].find(part), std::string::npos)
      << "no \"" << part << "\" in: " << messages[0];
  }
}

#endif
