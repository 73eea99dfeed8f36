// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keep VTK's XML readers from sizes that would make them crash
 *
 * VTK's readers believe three kinds of sizes in a file. In front of compressed
 * data stands how many blocks there are and how large they are; where these do
 * not fit each other, vtkXMLDataParser reads beyond its list of blocks or divides
 * by zero. For the counts of a piece, and for as many point ids as the last
 * offset of its cells says, memory is allocated; if they are so large that the
 * number of bytes overflows, it is too little. This parser checks the first two
 * once the elements are known; CheckXmlCells.h checks the offsets.
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

  /// Throws Failure if an array of the parsed file is cut short or has sizes that cannot be.
  void Check(std::uint64_t fileSize);

  /// Whether a file of the size that Check() was given can hold so many numbers.
  bool CanHold(double count) const;

  /// Whether the values of an array are in the file as in memory, so that any of them can be read
  /// without those before.
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
