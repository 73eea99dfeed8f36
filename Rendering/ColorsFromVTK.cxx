// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorsFromVTK.h"

#include "Elementary.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
std::string nameOf(vtkDataArray* array)
{
  const char* const name = array->GetName();
  return name && *name ? "\"" + std::string(name) + "\"" : "without a name";
}

/// Whether some alpha is not 255. It is the last of an even number of components.
bool isAnyTransparent(const unsigned char* bytes, std::size_t tuples, int components)
{
  const auto step = static_cast<std::size_t>(components);
  bool isAny = false;
  for (std::size_t k = 0; components % 2 == 0 && k < tuples; ++k)
  {
    isAny = isAny || bytes[(k + 1) * step - 1] != 255;
  }
  return isAny;
}

double powerOfTen(double exponent)
{
  return exponent < 0.0 ? 1.0 / power(10.0, -exponent) : power(10.0, exponent);
}
}

FoundColorArray findColorArray(vtkPolyData* input, const InputColors& settings)
{
  const bool isOfCells = settings.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (!isOfCells && settings.association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    throw std::runtime_error("the colours have the association " +
      std::to_string(settings.association) +
      ". Call SetInputColorArray() with vtkDataObject::FIELD_ASSOCIATION_POINTS (0) or "
      "FIELD_ASSOCIATION_CELLS (1).");
  }
  vtkDataSetAttributes *const ofPoints = input->GetPointData(),
                              *const ofCells = input->GetCellData();
  if (!settings.arrayName.empty())
  {
    return { (isOfCells ? ofCells : ofPoints)->GetArray(settings.arrayName.c_str()), isOfCells };
  }
  const bool hasPointScalars = ofPoints->GetScalars() != nullptr;
  return { (hasPointScalars ? ofPoints : ofCells)->GetScalars(), !hasPointScalars };
}

ColorsFromVTK::ColorsFromVTK(vtkPolyData* input, const InputColors& settings, SpansFromVTK& spans)
  : Settings(settings)
{
  this->findArray(input, spans);
  if (!this->Result.values || this->Array->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    this->findAlpha();
    return; // no colours, or colours as they are
  }
  // As in vtkMapper, an array's own table comes first.
  vtkScalarsToColors* const given =
    this->Array->GetLookupTable() ? this->Array->GetLookupTable() : settings.lookupTable.Get();
  this->findRange(given);
  // Not a copy: vtkScalarsToColors::DeepCopy() loses the colours of NaN and beyond the range.
  const auto usual = vtkSmartPointer<vtkLookupTable>::New();
  this->map(given ? given : usual, spans);
  this->findAlpha();
}

/// Alpha costs time, so it is only used where it makes a difference.
void ColorsFromVTK::findAlpha()
{
  const AttributeSpan& values = this->Result.values;
  const std::vector<unsigned char>& entries = this->Plain ? this->Plain->entries() : this->Entries;
  this->Result.hasAlpha = this->Result.table
    ? isAnyTransparent(entries.data(), entries.size() / 4, 4)
    : values.data &&
      isAnyTransparent(static_cast<const unsigned char*>(values.data),
        static_cast<std::size_t>(this->Array->GetNumberOfTuples()), values.components);
}

void ColorsFromVTK::findArray(vtkPolyData* input, SpansFromVTK& spans)
{
  const InputColors& settings = this->Settings;
  const FoundColorArray found = findColorArray(input, settings);
  const bool isOfCells = found.isOfCells;
  this->Array = found.array;
  if (!this->Array && settings.arrayName.empty())
  {
    return;
  }
  const char* const items = isOfCells ? "cell" : "point";
  if (!this->Array)
  {
    throw std::runtime_error("the colours come from the " + std::string(items) + " array \"" +
      settings.arrayName +
      "\", but there is none of that name that holds numbers. Call SetInputColorArray() with "
      "another name, or SetInputScalarVisibility() with false.");
  }
  const vtkIdType expected = isOfCells ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  const int components = this->Array->GetNumberOfComponents();
  if (this->Array->GetNumberOfTuples() != expected || components < 1)
  {
    std::ostringstream text;
    text << "the colours, " << items << " array " << nameOf(this->Array) << ", have "
         << this->Array->GetNumberOfTuples() << " tuples of " << components
         << " components, but there are " << expected << " " << items
         << "s, each of which needs a tuple. Correct the array, or call SetInputScalarVisibility() "
            "with false.";
    throw std::runtime_error(text.str());
  }
  if (settings.component < ColorArray::magnitude || settings.component >= components)
  {
    throw std::runtime_error("the colours come from component " +
      std::to_string(settings.component) + " of the " + items + " array " + nameOf(this->Array) +
      ", which has the components 0 to " + std::to_string(components - 1) +
      ". Call SetInputColorComponent() with one of these, or with -1 for the magnitude.");
  }
  this->Result.values = spans.attribute(this->Array, isOfCells);
  // As in VTK, the magnitude of a single number is the number, also if it is negative.
  this->Result.component = components == 1 ? 0 : settings.component;
}

/// The range of the table, `own`; without a table, that of the array.
void ColorsFromVTK::findRange(vtkScalarsToColors* own)
{
  const char* source = "the colours have";
  if (this->Settings.hasScalarRange)
  {
    std::copy_n(this->Settings.scalarRange, 2, this->Range);
  }
  else if (own)
  {
    std::copy_n(own->GetRange(), 2, this->Range);
    source = "the lookup table has";
  }
  else if (this->Array->GetNumberOfTuples() > 0)
  {
    this->Array->GetFiniteRange(this->Range, this->Settings.component);
    if (this->Range[0] > this->Range[1])
    {
      this->Range[0] = 0.0; // no value is finite
      this->Range[1] = 1.0;
    }
  }
  if (!std::isfinite(this->Range[0]) || !std::isfinite(this->Range[1]) ||
    this->Range[0] > this->Range[1])
  {
    std::ostringstream text;
    text << source << " the range " << this->Range[0] << " to " << this->Range[1]
         << "; both must be finite, and the first must not be greater. Call SetInputScalarRange().";
    throw std::runtime_error(text.str());
  }
}

void ColorsFromVTK::map(vtkScalarsToColors* table, SpansFromVTK& spans)
{
  if (table->UsingLogScale() && !(this->Range[0] > 0.0))
  {
    std::ostringstream text;
    text << "the lookup table has a logarithmic scale and the range " << this->Range[0] << " to "
         << this->Range[1]
         << "; both must be greater than 0. Call SetInputScalarRange(), or SetScaleToLinear().";
    throw std::runtime_error(text.str());
  }
  auto* const plain = vtkLookupTable::SafeDownCast(table);
  auto* const function = vtkColorTransferFunction::SafeDownCast(table);
  if (function && function->GetSize() == 0)
  {
    throw std::runtime_error("the colour transfer function has no colours. Call "
                             "vtkColorTransferFunction::AddRGBPoint().");
  }
  const bool isPlain = plain && !table->GetIndexedLookup();
  const bool isMappedLast = this->Settings.interpolateScalarsBeforeMapping &&
    !this->Result.values.isPerCell && !table->GetIndexedLookup();
  if (!isPlain && !isMappedLast)
  {
    this->mapAll(table, spans);
    return;
  }
  if (isPlain)
  {
    this->Plain.emplace(plain, this->Range);
    this->Result.table = &this->Plain->table();
  }
  else
  {
    this->sample(table);
    this->Result.table = &*this->Table;
  }
  this->Result.isMappedLast = isMappedLast;
}

/// Makes a table of the colours in the middle of many small intervals.
void ColorsFromVTK::sample(vtkScalarsToColors* table)
{
  constexpr int count = 4096;
  table->Build();
  std::copy_n(table->GetRange(), 2, this->Range); // it has its own, whatever is set
  const bool isLogarithmic = table->UsingLogScale() != 0;
  const double low = isLogarithmic ? decimalLogarithm(this->Range[0]) : this->Range[0];
  const double high = isLogarithmic ? decimalLogarithm(this->Range[1]) : this->Range[1];
  for (int k = 0; k < count; ++k)
  {
    const double value = low + (high - low) * ((k + 0.5) / count);
    this->addEntry(table->MapValue(isLogarithmic ? powerOfTen(value) : value));
  }
  for (const double value : { std::nan(""), -HUGE_VAL, HUGE_VAL })
  {
    this->addEntry(table->MapValue(value));
  }
  this->Table.emplace(this->Entries.data(), count, this->Range[0], this->Range[1], isLogarithmic);
  const unsigned char* const special = this->Entries.data() + 4 * count;
  this->Table->setNotANumber(special);
  this->Table->setBelow(special + 4);
  this->Table->setAbove(special + 8);
}

/// Replaces the numbers by their colours.
void ColorsFromVTK::mapAll(vtkScalarsToColors* table, SpansFromVTK& spans)
{
  vtkSmartPointer<vtkDataArray> numbers = this->Array;
  if (this->Array->GetNumberOfComponents() > 1)
  {
    auto chosen = vtkSmartPointer<vtkDoubleArray>::New();
    chosen->SetNumberOfTuples(this->Array->GetNumberOfTuples());
    for (vtkIdType k = 0; k < chosen->GetNumberOfTuples(); ++k)
    {
      chosen->SetValue(k, this->Result.number(static_cast<std::size_t>(k)));
    }
    numbers = chosen;
  }
  table->Build();
  this->Mapped = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(numbers, VTK_COLOR_MODE_MAP_SCALARS, 0));
  this->Result.values = spans.attribute(this->Mapped, this->Result.values.isPerCell);
}

void ColorsFromVTK::addEntry(const unsigned char color[4])
{
  this->Entries.insert(this->Entries.end(), color, color + 4);
}
}
