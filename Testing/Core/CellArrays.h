// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellArrays_h
#define CellArrays_h

#include "Spans.h"

#include <cstdint>
#include <vector>

/// Cells, with the memory of their span.
struct CellArrays
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> connectivity;

  void add(const std::vector<std::int64_t>& ids)
  {
    this->connectivity.insert(this->connectivity.end(), ids.begin(), ids.end());
    this->offsets.push_back(static_cast<std::int64_t>(this->connectivity.size()));
  }
  lambent::CellSpan span() const
  {
    return { { this->offsets.data(), true, this->offsets.size() },
      { this->connectivity.data(), true, this->connectivity.size() } };
  }
};

#endif
