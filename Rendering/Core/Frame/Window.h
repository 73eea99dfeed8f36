// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief rectangles of pixels
 */
#ifndef lambent_Window_h
#define lambent_Window_h

#include <algorithm>

namespace lambent
{
/// Pixels i in [i0, i1) and j in [j0, j1).
struct Window
{
  int i0 = 0, i1 = 0, j0 = 0, j1 = 0;

  int width() const { return this->i1 - this->i0; }
  int height() const { return this->j1 - this->j0; }
  bool empty() const { return this->i0 >= this->i1 || this->j0 >= this->j1; }
};

inline Window intersection(const Window& a, const Window& b)
{
  return { std::max(a.i0, b.i0), std::min(a.i1, b.i1), std::max(a.j0, b.j0), std::min(a.j1, b.j1) };
}
}

#endif
