// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief one of VTK's XML readers that checks sizes as it meets them
 */

#ifndef CheckedXmlReader_h
#define CheckedXmlReader_h

#include "CheckXmlCells.h"
#include "CheckXmlType.h"
#include "CheckedReader.h"
#include "CheckedXmlParser.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLReader.h"

#include <filesystem>

namespace lambent::command
{

/// Reader is any class of VTK's that is derived from vtkXMLDataReader.
template <typename Reader>
class CheckedXmlReader : public Reader, public CheckedReader
{
public:
  static CheckedXmlReader* New() { VTK_STANDARD_NEW_BODY(CheckedXmlReader); }

protected:
  void CreateXMLParser() override
  {
    this->Parser = CheckedXmlParser::New();
    this->Parser->AddObserver(vtkCommand::ProgressEvent, this->DataProgressObserver);
    this->XMLParser = this->Parser; // which DestroyXMLParser() deletes
  }

  /// The elements are known, of the arrays none is read.
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
    return this->Reader::ReadArrayValues(
             element, arrayIndex, array, startIndex, numValues, type) &&
      this->Passes(check);
  }

private:
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
};

} // namespace lambent::command

#endif
