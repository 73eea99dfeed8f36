// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckXml.h"
#include "Messages.h"

#include "vtkDataArray.h"
#include "vtkInputStream.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkZLibDataCompressor.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <vector>

namespace lambent::command
{
namespace
{

/// No compressor of VTK's makes one byte of more than so many.
constexpr std::uint64_t LargestRatio = 1 << 16;

std::string Attribute(vtkXMLDataElement* element, const char* name)
{
  const char* const value = element->GetAttribute(name);
  return value ? value : "";
}

[[noreturn]] void Fail(vtkXMLDataElement* element, const std::string& what)
{
  throw Failure("it is cut short or broken: " + what + " of '" + element->GetName() + " " +
    Attribute(element, "Name") + "' cannot be; get a whole copy of it");
}

/// An array is appended, at an offset, or binary where it stands, or text: as the readers have it.
bool IsAppended(vtkXMLDataElement* array, vtkTypeInt64& offset)
{
  array->GetScalarAttribute("offset", offset);
  return array->GetAttribute("offset") != nullptr;
}

bool IsBinary(vtkXMLDataElement* array)
{
  return Attribute(array, "format") == "binary";
}

class Parser : public vtkXMLDataParser
{
public:
  static Parser* New();
  vtkTypeMacro(Parser, vtkXMLDataParser)

  void Check(std::uint64_t fileSize)
  {
    this->FileSize = fileSize;
    const std::string compressor = Attribute(this->RootElement, "compressor");
    this->IsCompressed = !compressor.empty();
    for (vtkDataCompressor* const known :
      std::initializer_list<vtkDataCompressor*>{ this->ZLib, this->LZ4, this->LZMA })
    {
      if (compressor == known->GetClassName())
      {
        this->SetCompressor(known);
      }
    }
    this->CheckElement(this->RootElement);
  }

private:
  void CheckElement(vtkXMLDataElement* element)
  {
    const std::string name = element->GetName();
    if (name == "Piece")
    {
      this->CheckCounts(element);
    }
    if (name == "DataArray" || name == "Array")
    {
      this->CheckHeader(element);
      this->CheckLastOffset(element);
    }
    for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
    {
      this->CheckElement(element->GetNestedElement(k));
    }
  }

  void CheckCounts(vtkXMLDataElement* piece)
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

  bool CanHold(double count) const
  {
    return count >= 0.0 && count <= static_cast<double>(LargestRatio * this->FileSize);
  }

  void CheckHeader(vtkXMLDataElement* array)
  {
    vtkTypeInt64 offset = 0;
    const bool isAppended = IsAppended(array, offset);
    if (!isAppended && !IsBinary(array))
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

  template <typename Word>
  bool ReadWords(std::vector<Word>& words)
  {
    const std::size_t size = words.size() * sizeof(Word);
    const bool isThere = this->DataStream->Read(words.data(), size) == size;
    this->PerformByteSwap(words.data(), words.size(), sizeof(Word));
    return isThere;
  }

  /// The header is the size; or the number of blocks, their size, that of the last one if it is
  /// smaller or else 0, and then how many bytes each is compressed to.
  template <typename Word>
  bool IsHeaderSound()
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
    // With these, the products and sums of vtkXMLDataParser do not overflow.
    return size > 0 && lastSize <= size && size <= LargestRatio * LargestRatio;
  }

  /// Of the offsets of Polys, say, there are as many as the piece has in NumberOfPolys.
  void CheckLastOffset(vtkXMLDataElement* array)
  {
    vtkXMLDataElement* const cells = array->GetParent();
    vtkXMLDataElement* const piece = cells ? cells->GetParent() : nullptr;
    if (!piece || Attribute(array, "Name") != "offsets")
    {
      return;
    }
    const std::string name = "NumberOf" + std::string(cells->GetName());
    vtkTypeInt64 count = 0;
    int type = VTK_VOID;
    if (!piece->GetScalarAttribute(name.c_str(), count) || count <= 0 ||
      !array->GetWordTypeAttribute("type", type))
    {
      return;
    }
    const auto last = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    auto* const number = vtkDataArray::SafeDownCast(last);
    if (number)
    {
      number->SetNumberOfTuples(1);
      number->SetComponent(0, 0, 0.0);
      this->ReadWord(array, number->GetVoidPointer(0), count - 1, type);
      if (!this->CanHold(number->GetComponent(0, 0)))
      {
        Fail(array, "the last offset");
      }
    }
  }

  void ReadWord(vtkXMLDataElement* array, void* word, vtkTypeInt64 index, int type)
  {
    vtkTypeInt64 offset = 0;
    if (IsAppended(array, offset))
    {
      this->ReadAppendedData(offset, word, index, 1, type);
    }
    else
    {
      this->ReadInlineData(array, !IsBinary(array), word, index, 1, type);
    }
  }

  std::uint64_t FileSize = 0;
  bool IsCompressed = false;
  vtkNew<vtkZLibDataCompressor> ZLib;
  vtkNew<vtkLZ4DataCompressor> LZ4;
  vtkNew<vtkLZMADataCompressor> LZMA;
};
vtkStandardNewMacro(Parser);

} // namespace

void CheckXml(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  vtkNew<Parser> parser;
  parser->SetStream(&file);
  if (parser->Parse())
  {
    parser->Check(std::filesystem::file_size(path));
  }
}

} // namespace lambent::command
