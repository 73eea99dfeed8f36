// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Progress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace lambent::command
{

Progress::Progress(bool wanted)
  : Enabled(wanted && isatty(STDERR_FILENO) == 1)
  , NextDraw(Clock::now() + std::chrono::milliseconds(500))
{
}

void Progress::Begin(const std::string& stage)
{
  this->Stage = stage;
  this->Update(0);
}

void Progress::Update(double fraction)
{
  if (!this->Enabled || Clock::now() < this->NextDraw)
  {
    return;
  }
  this->NextDraw = Clock::now() + std::chrono::milliseconds(50);
  if (this->Sink)
  {
    this->Sink(fraction);
    return;
  }
  this->Visible = true;

  constexpr int width = 30;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(done * width);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, ' ');
  std::fprintf(stderr, "\r\033[K[%s] %3d %% %s", bar.c_str(), static_cast<int>(done * 100),
    this->Stage.c_str());
  std::fflush(stderr);
}

void Progress::Redirect(std::function<void(double)> sink)
{
  this->Sink = std::move(sink);
}

void Progress::Follow(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
    { static_cast<Progress*>(self)->Update(static_cast<vtkAlgorithm*>(caller)->GetProgress()); });
  algorithm->AddObserver(vtkCommand::ProgressEvent, observer);
}

void Progress::Erase()
{
  if (this->Visible)
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    this->Visible = false;
  }
}

} // namespace lambent::command
