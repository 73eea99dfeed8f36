// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadStl.h"
#include "CellLists.h"
#include "FileBytes.h"
#include "MergedPoints.h"
#include "Messages.h"
#include "ParseStlText.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>

namespace lambent::command
{
namespace
{

constexpr std::size_t HeaderSize = 84; // 80 arbitrary bytes and the count
constexpr std::size_t TriangleSize = 50;

/// Reads a number from the file, which is always little-endian.
std::uint32_t ReadWord(const char* at)
{
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i)
  {
    word = word << 8 | static_cast<unsigned char>(at[i]);
  }
  return word;
}

float ReadFloat(const char* at)
{
  const std::uint32_t word = ReadWord(at);
  float value;
  std::memcpy(&value, &word, sizeof(value));
  return value;
}

/// The count in the header; 0 if the file is too short for a header.
std::size_t CountOf(std::string_view file)
{
  return file.size() < HeaderSize ? 0 : ReadWord(file.data() + HeaderSize - 4);
}

template <typename PointArray, typename Coordinate>
vtkSmartPointer<vtkPolyData> MakeMesh(
  const MergedPoints<Coordinate>& merged, const CellLists& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<PointArray>(merged.GetValues(), 3));
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCellArray(triangles));
  return mesh;
}

/// The real number of triangles, even if the count in the header is too small.
std::size_t CheckedCount(std::string_view file)
{
  if (file.size() < HeaderSize)
  {
    throw Failure(
      "it is incomplete or not an STL file: it is too short for a header; use a complete "
      "copy");
  }
  const std::size_t count = CountOf(file);
  if (file.size() < HeaderSize + TriangleSize * count)
  {
    throw Failure("it is incomplete or not an STL file: it is too short for the " +
      std::to_string(count) + " triangles that it declares; use a complete copy");
  }
  const std::size_t leftOver = file.size() - HeaderSize - TriangleSize * count;
  if (leftOver % TriangleSize != 0)
  {
    vtkGenericWarningMacro(<< "ignored " << leftOver << (leftOver == 1 ? " byte" : " bytes")
                           << " after its last triangle");
    return count;
  }
  const std::size_t all = count + leftOver / TriangleSize;
  if (leftOver > 0)
  {
    vtkGenericWarningMacro(<< "the number of triangles in its header is " << count
                           << ", but there are " << all << "; all of them are read");
  }
  return all;
}

vtkSmartPointer<vtkPolyData> ReadBinary(
  std::string_view file, const std::function<void(double)>& progress)
{
  constexpr std::size_t trianglesBetweenProgress = 65536;
  const std::size_t count = CheckedCount(file);
  MergedPoints<float> points;
  CellLists triangles;
  triangles.points.reserve(3 * count);
  triangles.offsets.reserve(count + 1);
  for (std::size_t triangle = 0; triangle < count; ++triangle)
  {
    const char* at = file.data() + HeaderSize + TriangleSize * triangle + 12; // after the normal
    for (int corner = 0; corner < 3; ++corner, at += 12)
    {
      const float point[3] = { ReadFloat(at), ReadFloat(at + 4), ReadFloat(at + 8) };
      triangles.points.push_back(points.Add(point));
    }
    triangles.EndCell();
    if (triangle % trianglesBetweenProgress == 0)
    {
      progress(static_cast<double>(triangle) / static_cast<double>(count));
    }
  }
  return MakeMesh<vtkFloatArray>(points, triangles);
}

vtkSmartPointer<vtkPolyData> ReadText(
  std::string_view file, const std::function<void(double)>& progress)
{
  const StlText text = ParseStlText(file, progress);
  if (text.ignoredFrom > 0)
  {
    vtkGenericWarningMacro(<< "line " << text.ignoredFrom
                           << " and everything after it are ignored, outside of any solid");
  }
  return MakeMesh<vtkDoubleArray>(text.points, text.facets);
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadStl(
  const std::string& path, const std::function<void(double)>& progress)
{
  const FileBytes bytes(path);
  const std::string_view file = bytes.view();
  const bool hasBinarySize =
    file.size() >= HeaderSize && file.size() == HeaderSize + TriangleSize * CountOf(file);
  return !hasBinarySize && IsStlText(file) ? ReadText(file, progress) : ReadBinary(file, progress);
}

} // namespace lambent::command
