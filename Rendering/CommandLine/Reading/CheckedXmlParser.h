// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief rejects sizes that would crash VTK's XML readers
 *
 * VTK's readers trust three kinds of sizes in a file:
 * 1. The header of compressed data gives the number and the size of the blocks. If they are
 *    inconsistent, vtkXMLDataParser reads beyond its list of blocks or divides by zero.
 * 2. The counts of a piece determine how much memory is allocated.
 * 3. So does the last offset of its cells, which is the number of point ids.
 * If a count is so large that the number of bytes overflows, too little memory is allocated. This
 * parser checks the first two kinds once the elements are parsed; CheckXmlCells.h checks the
 * offsets.
 */

#ifndef CheckedXmlParser_h
#define CheckedXmlParser_h

#include "vtkXMLDataParser.h"

#include <cstdint>

namespace lambent::command
{

class CheckedXmlParser : public vtkXMLDataParser
{
public:
  static CheckedXmlParser* New();
  vtkTypeMacro(CheckedXmlParser, vtkXMLDataParser)

  /// Throws Failure if an array of the parsed file is truncated or has impossible sizes.
  void Check(std::uint64_t fileSize);

  /// Whether a file of the size given to Check() can hold this many numbers.
  bool CanHold(double count) const;

  /// Whether the array is stored as it is in memory, so that any part of it can be read without the
  /// values before.
  bool IsRaw(vtkXMLDataElement* array) const;

protected:
  CheckedXmlParser() = default;
  ~CheckedXmlParser() override = default;

private:
  void CheckElement(vtkXMLDataElement* element);
  void CheckCounts(vtkXMLDataElement* piece);
  void CheckHeader(vtkXMLDataElement* array);
  template <typename Word>
  bool IsHeaderSound();
  template <typename Words>
  bool ReadWords(Words& words);

  std::uint64_t FileSize = 0;
  bool IsCompressed = false;
};

} // namespace lambent::command

#endif
