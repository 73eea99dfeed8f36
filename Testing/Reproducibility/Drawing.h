// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief render a stage
 *
 * Each of two programs links one implementation: the core, which also runs without VTK, or
 * the VTK filters. Both must give the same bits.
 */
#ifndef Drawing_h
#define Drawing_h

#include "Stage.h"
#include "Window.h"

#include <string>

/// A way to render a picture; all must give the same bits.
struct Manner
{
  /// 0: all that the machine has.
  int threads = 0;
  /// The backend of vtkSMPTools; empty: its default.
  std::string backend;
  /// Render each part of the image separately.
  bool inParts = false;
  /// Unless 0: a seed for shuffling cells and inputs, and for splitting inputs.
  unsigned int shuffle = 0;
  /// Test every triangle against every ray, without vectors.
  bool byBruteForce = false;
};

/// A pass of a picture, as floats or doubles.
struct PassPicture
{
  std::string name;
  bool isPerCell = false;
  lambent::Pass form;
  std::vector<float> floats; ///< empty if the values are doubles
  std::vector<double> doubles;
};

/// A picture: the bottom row first, three or four channels per pixel.
struct Picture
{
  Picture() = default;
  explicit Picture(const Stage& stage);

  int width = 0, height = 0;
  int channels = 3;
  std::vector<float> floats;
  std::vector<unsigned char> bytes;
  std::vector<PassPicture> passes;
};

/// Throws std::runtime_error if this program cannot render in that manner.
Picture draw(const Stage& stage, const Manner& manner);

/// The threading backends of this program.
std::vector<std::string> backendsHere();

/// The windows of the image to render: the whole, or parts of uneven sizes.
std::vector<lambent::Window> partsOf(const Stage& stage, const Manner& manner);

/// Copies a part to its place in the whole image.
template <typename Channel>
void paste(const Channel* part, const lambent::Window& window, int width, int channels,
  std::vector<Channel>& whole)
{
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(channels) * window.width();
  for (int j = window.j0; j < window.j1; ++j, part += row)
  {
    std::copy(part, part + row,
      whole.begin() + channels * (static_cast<std::ptrdiff_t>(j) * width + window.i0));
  }
}

/// The bodies in random order, each with its cells shuffled and divided among one to three bodies.
/// Compute normals first, since those of the parts would differ from those of the whole.
std::vector<Body> shuffled(const std::vector<Body>& bodies, unsigned int seed);

#endif
