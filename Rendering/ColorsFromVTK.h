// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an array and a lookup table of VTK as the colours of a surface
 *
 * What vtkMapper does in its default colour mode. Arrays of unsigned char are colours. Other arrays
 * are mapped: a vtkLookupTable becomes a table of the core. Other classes, and tables of
 * categories, map the whole array here, since only they know how; if scalars are interpolated
 * before mapping, they are sampled instead.
 */
#ifndef ColorsFromVTK_h
#define ColorsFromVTK_h

#include "ColorArray.h"
#include "InputColors.h"
#include "LookupTableFromVTK.h"
#include "SpansFromVTK.h"

#include <optional>
#include <vector>

class vtkPolyData;
class vtkUnsignedCharArray;

namespace lambent::adapters
{
struct FoundColorArray
{
  vtkDataArray* array = nullptr; ///< or none
  bool isOfCells = false;
};

/// The array of the input that the settings choose. Throws std::runtime_error if the association is
/// neither points nor cells.
FoundColorArray findColorArray(vtkPolyData* input, const InputColors& settings);

class ColorsFromVTK
{
public:
  /// The input and its arrays must outlive this object. Throws std::runtime_error with a message
  /// for the user.
  ColorsFromVTK(vtkPolyData* input, const InputColors& settings, SpansFromVTK& spans);
  ColorsFromVTK(const ColorsFromVTK&) = delete;

  /// nullptr if the input has no such scalars.
  const ColorArray* colors() const { return this->Result.values ? &this->Result : nullptr; }

private:
  void findArray(vtkPolyData* input, SpansFromVTK& spans);
  void findRange(vtkScalarsToColors* own);
  void map(vtkScalarsToColors* table, SpansFromVTK& spans);
  void sample(vtkScalarsToColors* table);
  void mapAll(vtkScalarsToColors* table, SpansFromVTK& spans);
  void findAlpha();
  void addEntry(const unsigned char color[4]);

  const InputColors& Settings;
  vtkDataArray* Array = nullptr;
  double Range[2] = { 0.0, 1.0 };
  vtkSmartPointer<vtkUnsignedCharArray> Mapped; ///< if the whole array was mapped
  std::optional<LookupTableFromVTK> Plain;
  std::vector<unsigned char> Entries;
  std::optional<ColorTable> Table; ///< if a table is sampled
  ColorArray Result;
};
}

#endif
