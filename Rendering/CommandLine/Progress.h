// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a progress bar on a terminal, for slow stages
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
 * The bar appears half a second after construction at the earliest, and only if standard error is a
 * terminal. The destructor erases it.
 */
class Progress
{
public:
  explicit Progress(bool wanted);
  ~Progress() { this->Erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Start a stage, such as "reading dragon.ply".
  void Begin(const std::string& stage);

  /// Set the fraction of the stage that is done, 0..1. Cheap enough to call often.
  void Update(double fraction);

  /// Show an algorithm's progress during its lifetime.
  void Follow(vtkAlgorithm* algorithm);

  /// Call `sink` with the fraction done instead of drawing the bar. Used in a child process.
  void Redirect(std::function<void(double)> sink);

  /// Erase the bar from the terminal; a later Update() draws it again.
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
