// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a vtkLookupTable as a table of the core
 */
#ifndef LookupTableFromVTK_h
#define LookupTableFromVTK_h

#include "ColorTable.h"

#include <vector>

class vtkLookupTable;

namespace lambent::adapters
{
class LookupTableFromVTK
{
public:
  /// Builds the table and copies its colours. The range must be valid for a ColorTable. Throws
  /// std::runtime_error if the table has no colours.
  LookupTableFromVTK(vtkLookupTable* table, const double range[2]);
  LookupTableFromVTK(const LookupTableFromVTK&) = delete;

  const ColorTable& table() const { return this->Table; }
  /// Four bytes each: the entries, then the colours of NaN, below and above the range.
  const std::vector<unsigned char>& entries() const { return this->Entries; }

private:
  std::vector<unsigned char> Entries;
  ColorTable Table;
};
}

#endif
