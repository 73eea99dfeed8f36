// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LookupTableFromVTK.h"

#include "vtkLookupTable.h"

#include <stdexcept>

namespace lambent::adapters
{
namespace
{
std::vector<unsigned char> entriesOf(vtkLookupTable* table)
{
  table->Build();
  const auto count = static_cast<std::size_t>(table->GetNumberOfTableValues());
  if (count == 0)
  {
    throw std::runtime_error(
      "the lookup table has no colours. Call vtkLookupTable::SetNumberOfTableValues().");
  }
  std::vector<unsigned char> entries(table->GetPointer(0), table->GetPointer(0) + 4 * count);
  for (const double* const special :
    { table->GetNanColor(), table->GetBelowRangeColor(), table->GetAboveRangeColor() })
  {
    unsigned char bytes[4];
    vtkLookupTable::GetColorAsUnsignedChars(special, bytes);
    entries.insert(entries.end(), bytes, bytes + 4);
  }
  return entries;
}
}

LookupTableFromVTK::LookupTableFromVTK(vtkLookupTable* table, const double range[2])
  : Entries(entriesOf(table))
  , Table(this->Entries.data(), this->Entries.size() / 4 - 3, range[0], range[1],
      table->GetScale() == VTK_SCALE_LOG10)
{
  const unsigned char* const special = this->Entries.data() + this->Entries.size() - 12;
  this->Table.setNotANumber(special);
  if (table->GetUseBelowRangeColor())
  {
    this->Table.setBelow(special + 4);
  }
  if (table->GetUseAboveRangeColor())
  {
    this->Table.setAbove(special + 8);
  }
}
}
