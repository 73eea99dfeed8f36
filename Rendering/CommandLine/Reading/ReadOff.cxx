// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads the text form of the Object File Format: a word such as OFF, COFF or NOFF, which may be
// missing; the numbers of vertices, faces and edges; a line for each vertex and each face. Further
// numbers on such a line are colours and are skipped. A count is accepted only if the rest of the
// file can hold it. Reference: Geomview manual, "OFF Files".

#include "FileBytes.h"
#include "Messages.h"
#include "OffCursor.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <vector>

namespace lambent::command
{
namespace
{

constexpr vtkIdType BetweenUpdates = 8192;

struct OffHeader
{
  bool hasNormals = false;
  vtkIdType vertices = 0;
  vtkIdType faces = 0;
};

/// Parses the first word: [ST][C][N]OFF.
void JudgeWord(OffCursor& cursor, const std::string& word, OffHeader& header)
{
  const std::size_t end = word.find("OFF");
  if (end == std::string::npos || end + 3 != word.size())
  {
    cursor.Fail("it begins with '" + word.substr(0, 20) + "'");
  }
  std::string prefix = word.substr(0, end);
  for (const std::string letters : { "ST", "C" }) // their values come last on a line
  {
    prefix.erase(0, prefix.compare(0, letters.size(), letters) == 0 ? letters.size() : 0);
  }
  header.hasNormals = prefix == "N";
  if (!prefix.empty() && !header.hasNormals)
  {
    throw Failure(
      "its points do not have three coordinates ('" + word + "'); save it as plain OFF");
  }
}

OffHeader TakeHeader(OffCursor& cursor)
{
  OffHeader header;
  std::string word = cursor.TakeWord();
  if (!word.empty())
  {
    JudgeWord(cursor, word, header);
    word = cursor.TakeWord();
  }
  if (word == "BINARY")
  {
    throw Failure("it is a binary OFF file; save it as text");
  }
  header.vertices = cursor.TakeWhole("the number of vertices", -1);
  header.faces = cursor.TakeWhole("the number of faces", -1);
  cursor.SkipLine(); // the number of edges is not needed, and often wrong or missing
  // A vertex takes at least three digits and three spaces, a face a digit and a space.
  const double size =
    6.0 * static_cast<double>(header.vertices) + 2.0 * static_cast<double>(header.faces);
  if (header.vertices < 0 || header.faces < 0 || size > static_cast<double>(cursor.GetRest()) + 1)
  {
    cursor.Fail("it is too short for the " + std::to_string(header.vertices) + " vertices and " +
      std::to_string(header.faces) + " faces that it declares");
  }
  return header;
}

void TakeVertices(OffCursor& cursor, const OffHeader& header, vtkPolyData* mesh, Progress& progress)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(header.vertices);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(header.hasNormals ? header.vertices : 0);
  for (vtkIdType vertex = 0; vertex < header.vertices; ++vertex)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates->SetValue(3 * vertex + axis, cursor.TakeNumber("vertex", vertex));
    }
    for (int axis = 0; axis < 3 && header.hasNormals; ++axis)
    {
      normals->SetValue(3 * vertex + axis, static_cast<float>(cursor.TakeNumber("vertex", vertex)));
    }
    cursor.SkipLine();
    if (vertex % BetweenUpdates == 0)
    {
      progress.Update(0.5 * static_cast<double>(vertex) / static_cast<double>(header.vertices));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  mesh->SetPoints(points);
  if (header.hasNormals)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
}

vtkIdType TakeCorner(OffCursor& cursor, const OffHeader& header, vtkIdType face)
{
  const vtkIdType vertex = cursor.TakeWhole("face", face);
  if (vertex < 0 || vertex >= header.vertices)
  {
    cursor.Fail("face " + std::to_string(face) + " uses vertex " + std::to_string(vertex) +
      ", which does not exist; there are " + std::to_string(header.vertices) + ", numbered from 0");
  }
  return vertex;
}

void TakeFaces(OffCursor& cursor, const OffHeader& header, vtkPolyData* mesh, Progress& progress)
{
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> corners;
  vtkIdType skipped = 0;
  for (vtkIdType face = 0; face < header.faces; ++face)
  {
    const long long count = cursor.TakeWhole("face", face);
    if (count < 0 || static_cast<std::size_t>(count) > cursor.GetRest() / 2 + 1)
    {
      cursor.Fail(
        "face " + std::to_string(face) + " cannot have " + std::to_string(count) + " vertices");
    }
    corners.clear();
    for (long long k = 0; k < count; ++k)
    {
      corners.push_back(TakeCorner(cursor, header, face));
    }
    if (count >= 3)
    {
      polygons->InsertNextCell(count, corners.data());
    }
    skipped += count < 3;
    cursor.SkipLine();
    if (face % BetweenUpdates == 0)
    {
      progress.Update(0.5 + 0.5 * static_cast<double>(face) / static_cast<double>(header.faces));
    }
  }
  mesh->SetPolys(polygons);
  if (skipped > 0)
  {
    vtkGenericWarningMacro("" << skipped << " faces with fewer than three vertices are skipped");
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadOff(const std::string& path, VtkMessages&, Progress& progress)
{
  const FileBytes file(path);
  OffCursor cursor(file);
  const OffHeader header = TakeHeader(cursor);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  TakeVertices(cursor, header, mesh, progress);
  TakeFaces(cursor, header, mesh, progress);
  if (cursor.Skip())
  {
    vtkGenericWarningMacro("it has more data than its counts declare; the rest is ignored");
  }
  return mesh;
}

} // namespace lambent::command
