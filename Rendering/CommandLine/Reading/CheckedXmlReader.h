// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a VTK XML reader that checks sizes while it reads
 */

#ifndef CheckedXmlReader_h
#define CheckedXmlReader_h

#include "CheckXmlCells.h"
#include "CheckXmlType.h"
#include "CheckedReader.h"
#include "CheckedXmlParser.h"
#include "ListCheck.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLReader.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

namespace lambent::command
{

/// Reader is any VTK class derived from vtkXMLDataReader.
template <typename Reader>
class CheckedXmlReader
  : public Reader
  , public CheckedReader
{
public:
  static CheckedXmlReader* New() { VTK_STANDARD_NEW_BODY(CheckedXmlReader); }

protected:
  void CreateXMLParser() override
  {
    this->Parser = CheckedXmlParser::New();
    this->Parser->AddObserver(vtkCommand::ProgressEvent, this->DataProgressObserver);
    this->XMLParser = this->Parser; // DestroyXMLParser() deletes it
  }

  /// All elements have been parsed; no array has been read yet.
  int ReadVTKFile(vtkXMLDataElement* root) override
  {
    const auto check = [this, root]
    {
      CheckXmlType(root, this->GetDataSetName());
      this->Parser->Check(std::filesystem::file_size(this->GetFileName()));
    };
    return this->Passes(check) ? this->Reader::ReadVTKFile(root) : 0;
  }

  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array,
    vtkIdType startIndex, vtkIdType numValues,
    vtkXMLReader::FieldType type = vtkXMLReader::OTHER) override
  {
    const auto check = [this, element, array] { this->CheckArray(element, array); };
    auto* const values = vtkDataArray::SafeDownCast(array);
    const bool isRead = values && this->IsListInParts(element)
      ? this->ReadInParts(element, arrayIndex, values, startIndex, numValues, type)
      : this->Reader::ReadArrayValues(element, arrayIndex, array, startIndex, numValues, type) != 0;
    return isRead && this->Passes(check);
  }

  void ReadXMLData() override
  {
    this->Lists.clear();
    this->Reader::ReadXMLData();
    if (this->NumberOfPieces != 1)
    {
      return; // VTK has merged the lists of the pieces
    }
    if (auto* const mesh = vtkPolyData::SafeDownCast(this->GetCurrentOutput()))
    {
      this->Lists["Polys"].Note(mesh->GetPolys());
      this->Lists["Strips"].Note(mesh->GetStrips());
    }
    else if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetCurrentOutput()))
    {
      this->Lists["Cells"].Note(grid->GetCells());
    }
  }

private:
  /// Whether the element holds the point ids of cells and can be read in parts.
  bool IsListInParts(vtkXMLDataElement* element) const
  {
    const char* const name = element->GetAttribute("Name");
    return name && element->GetParent() && this->Parser->IsRaw(element) &&
      std::string(name) == "connectivity";
  }

  bool ReadInParts(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkDataArray* array,
    vtkIdType startIndex, vtkIdType numValues, vtkXMLReader::FieldType type)
  {
    const auto inserted =
      this->Lists.try_emplace(element->GetParent()->GetName(), this->GetNumberOfPoints());
    ListCheck& list = inserted.first->second;
    list.TrustOffsets(); // VTK checks them before it reads the ids
    float range[2] = {};
    this->GetProgressRange(range);
    bool isRead = true;
    for (vtkIdType k = 0; k < numValues && isRead; k += ListCheck::Part)
    {
      const vtkIdType count = std::min(ListCheck::Part, numValues - k), at = arrayIndex + k;
      this->SetProgressRange(range, static_cast<int>(k / ListCheck::Part),
        static_cast<int>((numValues - 1) / ListCheck::Part + 1));
      isRead = this->Reader::ReadArrayValues(element, at, array, startIndex + k, count, type) != 0;
      list.LookAtIds(array, at, at + count);
    }
    this->SetProgressRange(range, 0, 1);
    return isRead;
  }

  void CheckArray(vtkXMLDataElement* element, vtkAbstractArray* array)
  {
    const char* const name = element->GetAttribute("Name");
    auto* const values = vtkDataArray::SafeDownCast(array);
    if (!name || !values)
    {
      return;
    }
    this->CellsCheck.Check(name, values, *this->Parser);
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetCurrentOutput());
    const int version = 10 * this->GetFileMajorVersion() + this->GetFileMinorVersion();
    if (grid && std::string(name) == "types" && version < 21)
    {
      XmlCellsCheck::CheckOldHexahedra(grid, values);
    }
  }

  CheckedXmlParser* Parser = nullptr;
  XmlCellsCheck CellsCheck;
  std::map<std::string, ListCheck> Lists; ///< by the name of their element
};

} // namespace lambent::command

#endif
