// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckXml.h"
#include "CheckedXmlParser.h"
#include "Messages.h"

#include "vtkDataArray.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkZLibDataCompressor.h"

#include <filesystem>
#include <fstream>
#include <initializer_list>

namespace lambent::command
{
namespace
{

std::string Attribute(vtkXMLDataElement* element, const char* name)
{
  const char* const value = element->GetAttribute(name);
  return value ? value : "";
}

/// Also checks the last offset of each list of cells.
class OffsetsParser : public CheckedXmlParser
{
public:
  static OffsetsParser* New();
  vtkTypeMacro(OffsetsParser, CheckedXmlParser)

  void CheckLastOffsets()
  {
    const std::string compressor = Attribute(this->RootElement, "compressor");
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
    this->CheckLastOffset(element);
    for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
    {
      this->CheckElement(element->GetNestedElement(k));
    }
  }

  /// The piece's NumberOfPolys, for example, is the number of offsets of Polys.
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
        throw Failure("it is incomplete or corrupt: the last offset of '" +
          std::string(cells->GetName()) + "' is invalid; use a complete copy");
      }
    }
  }

  void ReadWord(vtkXMLDataElement* array, void* word, vtkTypeInt64 index, int type)
  {
    vtkTypeInt64 offset = 0;
    if (array->GetScalarAttribute("offset", offset))
    {
      this->ReadAppendedData(offset, word, index, 1, type);
    }
    else
    {
      this->ReadInlineData(array, Attribute(array, "format") != "binary", word, index, 1, type);
    }
  }

  vtkNew<vtkZLibDataCompressor> ZLib;
  vtkNew<vtkLZ4DataCompressor> LZ4;
  vtkNew<vtkLZMADataCompressor> LZMA;
};
vtkStandardNewMacro(OffsetsParser);

} // namespace

void CheckXml(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  vtkNew<OffsetsParser> parser;
  parser->SetStream(&file);
  if (parser->Parse())
  {
    parser->Check(std::filesystem::file_size(path));
    parser->CheckLastOffsets();
  }
}

} // namespace lambent::command
