// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a progress bar on a terminal, for work that takes its time
 */

#ifndef Progress_h
#define Progress_h

#include <chrono>
#include <functional>
#include <string>

class vtkAlgorithm;

namespace lambent::command
{

/**
 * Shows nothing in the first half second of its life, nothing where standard
 * error is not a terminal, and leaves nothing behind.
 */
class Progress
{
public:
  explicit Progress(bool wanted);
  ~Progress() { this->Erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What is being done from now on, such as "reading dragon.ply".
  void Begin(const std::string& stage);

  /// How much of the stage is done, 0..1. Cheap enough to be called often.
  void Update(double fraction);

  /// Follow an algorithm's progress while it lives.
  void Follow(vtkAlgorithm* algorithm);

  /// From now on draw nothing, and call this instead with how much is done: in a child process.
  void Redirect(std::function<void(double)> sink);

  /// Take the bar off the terminal; the next Update() brings it back.
  void Erase();

private:
  using Clock = std::chrono::steady_clock;
  bool Enabled;
  bool Visible = false;
  std::string Stage;
  std::function<void(double)> Sink;
  Clock::time_point NextDraw;
};

} // namespace lambent::command

#endif
