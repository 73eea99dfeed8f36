// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckedXmlParser.h"
#include "Messages.h"

#include "vtkInputStream.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <string>
#include <vector>

namespace lambent::command
{
namespace
{

/// None of VTK's compressors has a higher ratio.
constexpr std::uint64_t LargestRatio = 1 << 16;

/// A limit, because the readers look up a name for each component.
constexpr vtkTypeInt64 MostComponents = 1 << 16;

std::string Attribute(vtkXMLDataElement* element, const char* name)
{
  const char* const value = element->GetAttribute(name);
  return value ? value : "";
}

[[noreturn]] void Fail(vtkXMLDataElement* element, const std::string& what)
{
  throw Failure("it is incomplete or corrupt: " + what + " of '" + element->GetName() + " " +
    Attribute(element, "Name") + "' is invalid; use a complete copy");
}

} // namespace

vtkStandardNewMacro(CheckedXmlParser);

void CheckedXmlParser::Check(std::uint64_t fileSize)
{
  this->FileSize = fileSize;
  this->IsCompressed = !Attribute(this->RootElement, "compressor").empty();
  this->CheckElement(this->RootElement);
}

bool CheckedXmlParser::CanHold(double count) const
{
  return count >= 0.0 && count <= static_cast<double>(LargestRatio * this->FileSize);
}

bool CheckedXmlParser::IsRaw(vtkXMLDataElement* array) const
{
  // Decoding streams are of derived classes.
  return array->GetAttribute("offset") && !this->Compressor &&
    std::string(this->AppendedDataStream->GetClassName()) == "vtkInputStream";
}

void CheckedXmlParser::CheckElement(vtkXMLDataElement* element)
{
  const std::string name = element->GetName();
  if (name == "Piece")
  {
    this->CheckCounts(element);
  }
  if (name == "DataArray" || name == "Array")
  {
    this->CheckHeader(element);
  }
  for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
  {
    this->CheckElement(element->GetNestedElement(k));
  }
}

void CheckedXmlParser::CheckCounts(vtkXMLDataElement* piece)
{
  for (int k = 0; k < piece->GetNumberOfAttributes(); ++k)
  {
    const char* const name = piece->GetAttributeName(k);
    vtkTypeInt64 count = 0;
    if (std::string(name).compare(0, 8, "NumberOf") == 0 &&
      piece->GetScalarAttribute(name, count) && !this->CanHold(static_cast<double>(count)))
    {
      Fail(piece, name);
    }
  }
}

/// Decides as the readers do: an array is appended (it has an offset), inline binary, or text.
void CheckedXmlParser::CheckHeader(vtkXMLDataElement* array)
{
  vtkTypeInt64 offset = 0;
  array->GetScalarAttribute("offset", offset);
  const bool isAppended = array->GetAttribute("offset") != nullptr;
  int type = 0;
  if (!array->GetWordTypeAttribute("type", type))
  {
    Fail(array, "the type");
  }
  vtkTypeInt64 components = 1;
  array->GetScalarAttribute("NumberOfComponents", components);
  if (components < 1 || components > MostComponents)
  {
    Fail(array, "NumberOfComponents");
  }
  if (!isAppended && Attribute(array, "format") != "binary")
  {
    return;
  }
  this->DataStream = isAppended ? this->AppendedDataStream : this->InlineDataStream;
  isAppended ? this->SeekG(this->AppendedDataPosition + offset)
             : this->SeekInlineDataPosition(array);
  this->DataStream->SetStream(this->Stream);
  this->DataStream->StartReading();
  const bool isSound = this->HeaderType == 64 ? this->IsHeaderSound<vtkTypeUInt64>()
                                              : this->IsHeaderSound<vtkTypeUInt32>();
  this->DataStream->EndReading();
  if (!isSound)
  {
    Fail(array, "the size");
  }
}

template <typename Words>
bool CheckedXmlParser::ReadWords(Words& words)
{
  constexpr std::size_t wordSize = sizeof(typename Words::value_type);
  const std::size_t size = words.size() * wordSize;
  const bool isThere = this->DataStream->Read(words.data(), size) == size;
  this->PerformByteSwap(words.data(), words.size(), wordSize);
  return isThere;
}

/// Without compression the header is the size in bytes. With compression it holds the number of
/// blocks, the size of a block, the size of the last block if that is smaller (else 0), and the
/// compressed size of each block.
template <typename Word>
bool CheckedXmlParser::IsHeaderSound()
{
  std::vector<Word> header(this->IsCompressed ? 3 : 1);
  if (!this->ReadWords(header))
  {
    return false;
  }
  if (!this->IsCompressed)
  {
    return header[0] <= this->FileSize;
  }
  const std::uint64_t count = header[0], size = header[1], lastSize = header[2];
  if (count == 0)
  {
    return lastSize == 0;
  }
  std::vector<Word> blocks(std::min<std::uint64_t>(count, this->FileSize));
  if (count > this->FileSize || !this->ReadWords(blocks))
  {
    return false;
  }
  std::uint64_t left = this->FileSize;
  for (const std::uint64_t block : blocks)
  {
    if (block > left)
    {
      return false;
    }
    left -= block;
  }
  // Within these bounds, the products and sums in vtkXMLDataParser do not overflow.
  return size > 0 && lastSize <= size && size <= LargestRatio * LargestRatio;
}

} // namespace lambent::command
