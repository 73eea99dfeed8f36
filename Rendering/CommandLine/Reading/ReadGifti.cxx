// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads GIFTI, a format for brain surfaces: XML with a DataArray of points (NIFTI_INTENT_POINTSET)
// and one of triangles (NIFTI_INTENT_TRIANGLE). The first array of triangles belongs to the first
// array of points, and so on; all of them form one mesh. Other arrays and the coordinate transforms
// are ignored.

#include "CellLists.h"
#include "CheckedReader.h"
#include "GiftiArray.h"
#include "Messages.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace lambent::command
{
namespace
{

using Arrays = std::vector<std::vector<double>>;

constexpr const char* PointSet = "NIFTI_INTENT_POINTSET";
constexpr const char* Triangle = "NIFTI_INTENT_TRIANGLE";

/// Collects the arrays of points and triangles.
class GiftiParser
  : public vtkXMLParser
  , public CheckedReader
{
public:
  static GiftiParser* New();
  vtkTypeMacro(GiftiParser, vtkXMLParser)

  Arrays Points;
  Arrays Triangles;
  bool IsGifti = false;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    const std::string element = name;
    this->IsGifti |= element == "GIFTI";
    if (element == "DataArray")
    {
      this->Header = {};
      this->Text.clear();
      for (; attributes[0] && attributes[1]; attributes += 2)
      {
        this->SetAttribute(attributes[0], attributes[1]);
      }
      this->IsWanted = this->Header.intent == PointSet || this->Header.intent == Triangle;
    }
    this->IsInData = element == "Data" && this->IsWanted;
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    if (this->IsInData)
    {
      this->Passes([&]() { this->Text.append(data, static_cast<std::size_t>(length)); });
    }
  }

  void EndElement(const char* name) override
  {
    this->IsInData = false;
    if (name == std::string("DataArray"))
    {
      if (this->IsWanted)
      {
        this->Passes([this]() { this->TakeArray(); });
      }
      this->IsWanted = false;
      ++this->ArrayIndex;
    }
  }

  int ParsingComplete() override { return this->GetFailure().empty() ? 0 : 1; }

private:
  void SetAttribute(const std::string& name, const char* value)
  {
    const std::pair<const char*, std::string*> attributes[] = {
      { "Intent", &this->Header.intent },
      { "DataType", &this->Header.dataType },
      { "Encoding", &this->Header.encoding },
      { "Endian", &this->Header.endian },
      { "ArrayIndexingOrder", &this->Header.order },
      { "Dimensionality", &this->Header.dimensionality },
      { "Dim0", &this->Header.rows },
      { "Dim1", &this->Header.columns },
    };
    for (const auto& [known, where] : attributes)
    {
      if (name == known)
      {
        *where = value;
      }
    }
  }

  void TakeArray()
  {
    if (!this->GetFailure().empty())
    {
      return;
    }
    try
    {
      (this->Header.intent == PointSet ? this->Points : this->Triangles)
        .push_back(DecodeGiftiArray(this->Header, this->Text));
    }
    catch (const Failure& reason)
    {
      throw Failure("data array " + std::to_string(this->ArrayIndex) + " (" + this->Header.intent +
        "): " + reason.what());
    }
  }

  GiftiHeader Header;
  std::string Text;
  bool IsWanted = false;
  bool IsInData = false;
  int ArrayIndex = 0;
};
vtkStandardNewMacro(GiftiParser);

void Parse(GiftiParser* parser, const std::string& path, VtkMessages& messages)
{
  std::ifstream file(path, std::ios::binary);
  parser->SetStream(&file);
  const bool isParsed = parser->Parse() != 0;
  const std::string error = messages.TakeError();
  if (!parser->GetFailure().empty())
  {
    throw Failure(parser->GetFailure());
  }
  if (!isParsed || !error.empty() || !parser->IsGifti)
  {
    throw Failure((error.empty() ? "it is not a GIFTI file" : error) +
      "; check that the file is complete and has the right extension");
  }
}

void CheckCounts(const GiftiParser& parser)
{
  const std::size_t points = parser.Points.size(), triangles = parser.Triangles.size();
  if (points == 0 && triangles == 0)
  {
    throw Failure(
      "it has no surface, only values on one; draw the surface that it belongs to, often "
      "named .surf.gii");
  }
  if (points != triangles)
  {
    throw Failure("it has " + std::to_string(points) + " arrays of points and " +
      std::to_string(triangles) + " of triangles; each surface needs one of each");
  }
}

void AppendPoints(const std::vector<double>& from, std::vector<double>& to)
{
  const auto wrong =
    std::find_if_not(from.begin(), from.end(), [](double value) { return std::isfinite(value); });
  if (wrong != from.end())
  {
    throw Failure("point " + std::to_string((wrong - from.begin()) / 3) +
      " has a coordinate that is not a finite number; correct it in the program that writes the "
      "file");
  }
  to.insert(to.end(), from.begin(), from.end());
  if (to.size() / 3 > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Failure("it has more points than 32 bits can count; split it into several files");
  }
}

void AppendTriangles(
  const std::vector<double>& from, std::size_t pointCount, std::size_t firstPoint, CellLists& to)
{
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    if (!(from[k] >= 0 && from[k] < static_cast<double>(pointCount)) ||
      from[k] != std::floor(from[k]))
    {
      throw Failure("triangle " + std::to_string(k / 3) +
        " uses a point that does not exist; "
        "there are " +
        std::to_string(pointCount) +
        ", numbered from 0; correct it in the program that writes the file, or use a complete "
        "copy");
    }
    to.points.push_back(static_cast<std::int32_t>(firstPoint + static_cast<std::size_t>(from[k])));
    if (k % 3 == 2)
    {
      to.EndCell();
    }
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadGifti(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  vtkNew<GiftiParser> parser;
  Parse(parser, path, messages);
  progress.Update(0.8);
  CheckCounts(*parser);
  std::vector<double> coordinates;
  CellLists cells;
  for (std::size_t surface = 0; surface < parser->Points.size(); ++surface)
  {
    const std::size_t first = coordinates.size() / 3;
    AppendPoints(parser->Points[surface], coordinates);
    AppendTriangles(parser->Triangles[surface], coordinates.size() / 3 - first, first, cells);
  }
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<vtkDoubleArray>(coordinates, 3));
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCellArray(cells));
  return mesh;
}

} // namespace lambent::command
