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

private:
  std::vector<unsigned char> Entries; ///< and the colours of NaN, below and above the range
  ColorTable Table;
};
}

#endif
