// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief draw a stage
 *
 * Two programs are linked, with one implementation each: the core alone, which also
 * runs where there is no VTK, and the VTK filters. Both must give the same bits.
 */
#ifndef Drawing_h
#define Drawing_h

#include "Stage.h"
#include "Window.h"

#include <string>

/// Ways to make the same picture.
struct Manner
{
  /// 0: as many as there are.
  int threads = 0;
  /// Of vtkSMPTools; empty: its own choice.
  std::string backend;
  /// Each part of the image by itself.
  bool inParts = false;
  /// Not 0: the seed that shuffles cells and inputs, and splits inputs in several.
  unsigned int shuffle = 0;
  /// Every triangle against every ray, without vectors.
  bool byBruteForce = false;
};

/// Rows from the bottom, three channels a pixel.
struct Picture
{
  Picture() = default;
  explicit Picture(const Stage& stage)
    : width(stage.width)
    , height(stage.height)
    , floats(3u * stage.width * stage.height)
    , bytes(floats.size())
  {
  }

  int width = 0, height = 0;
  std::vector<float> floats;
  std::vector<unsigned char> bytes;
};

/// Throws std::runtime_error where this program cannot draw in that manner.
Picture draw(const Stage& stage, const Manner& manner);

/// The backends of threads that this program has.
std::vector<std::string> backendsHere();

/// The windows that the image is drawn in: all of it, or parts of uneven sizes.
std::vector<lambent::Window> partsOf(const Stage& stage, const Manner& manner);

/// Copies a part into its place in the whole.
template <typename Channel>
void paste(
  const Channel* part, const lambent::Window& window, int width, std::vector<Channel>& whole)
{
  for (int j = window.j0; j < window.j1; ++j, part += 3 * window.width())
  {
    std::copy(part, part + 3 * window.width(),
      whole.begin() + 3 * (static_cast<std::ptrdiff_t>(j) * width + window.i0));
  }
}

/// The body with its cells in another order and dealt out to one to three bodies, and
/// the bodies in another order. Computed normals stay those of the whole.
std::vector<Body> shuffled(const std::vector<Body>& bodies, unsigned int seed);

#endif
