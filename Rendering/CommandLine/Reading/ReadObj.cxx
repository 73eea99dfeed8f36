// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadObj.h"
#include "CellLists.h"
#include "FileBytes.h"
#include "Messages.h"
#include "OppositeFaces.h"
#include "ParseObj.h"
#include "SplitPoints.h"

#include "vtkLambentNormals.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent::command
{
namespace
{

using Ids = std::vector<std::int32_t>;

/// A mesh of the points and polygons, without data.
vtkSmartPointer<vtkPolyData> MakeMesh(const ObjContent& obj)
{
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<vtkDoubleArray>(obj.points, 3));
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCellArray(obj.faces));
  return mesh;
}

template <typename Value>
void AppendCopies(std::vector<Value>& values, std::size_t components, const Ids& copies)
{
  if (values.empty())
  {
    return;
  }
  values.reserve(values.size() + components * copies.size());
  for (const std::int32_t point : copies)
  {
    const std::size_t from = components * static_cast<std::size_t>(point);
    for (std::size_t i = 0; i < components; ++i)
    {
      values.push_back(values[from + i]);
    }
  }
}

/// Treats normals of length zero as missing. If all are missing, clears the list.
void DropZeroNormals(ObjContent& obj)
{
  bool hasAny = false;
  for (std::int32_t& id : obj.normalOfCorner)
  {
    const float* const normal =
      id == NoKey ? nullptr : &obj.normals[3 * static_cast<std::size_t>(id)];
    const bool isUsable = normal && (normal[0] != 0 || normal[1] != 0 || normal[2] != 0);
    id = isUsable ? id : NoKey;
    hasAny = hasAny || isUsable;
  }
  if (!hasAny)
  {
    obj.normalOfCorner.clear();
  }
}

/// Corners at a point have the same normal if their keys are equal. The keys count through the
/// normals of the file, then the smoothing groups, then the opposite sides of the groups, for
/// doubled faces. A negative key belongs to a single face.
Ids NormalKeys(const ObjContent& obj)
{
  const std::size_t normals = obj.normals.size() / 3;
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max() - 1;
  if (normals + 2 * static_cast<std::size_t>(obj.numberOfGroups) > most || obj.faces.size() > most)
  {
    throw Failure("it has too many faces, normals and smoothing groups; divide it into several "
                  "files");
  }
  const std::vector<bool> isOpposite =
    obj.numberOfGroups == 0 ? std::vector<bool>() : FindOppositeFaces(obj.faces);
  Ids keys(obj.faces.points.size());
  for (std::size_t face = 0; face < obj.faces.size(); ++face)
  {
    std::int32_t ownKey = -1 - static_cast<std::int32_t>(face);
    if (!obj.groupOfFace.empty() && obj.groupOfFace[face] > 0)
    {
      ownKey = static_cast<std::int32_t>(normals) + obj.groupOfFace[face] +
        (isOpposite[face] ? obj.numberOfGroups : 0);
    }
    const std::size_t end = static_cast<std::size_t>(obj.faces.offsets[face + 1]);
    for (std::size_t c = static_cast<std::size_t>(obj.faces.offsets[face]); c < end; ++c)
    {
      const std::int32_t normal = obj.normalOfCorner.empty() ? NoKey : obj.normalOfCorner[c];
      keys[c] = normal != NoKey ? normal : ownKey;
    }
  }
  return keys;
}

/// The normals of the points: those of the file, or else those of vtkLambentNormals.
std::vector<float> PointNormals(const ObjContent& obj, const Ids& keyOfPoint)
{
  const std::int32_t given = static_cast<std::int32_t>(obj.normals.size() / 3);
  const auto isComputed = [given](std::int32_t key)
  { return key != NoKey && (key < 0 || key >= given); };
  vtkNew<vtkLambentNormals> filter;
  vtkFloatArray* computed = nullptr;
  if (std::any_of(keyOfPoint.begin(), keyOfPoint.end(), isComputed))
  {
    filter->SetInputData(MakeMesh(obj));
    filter->Update();
    computed = vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetNormals());
    if (!computed) // out of memory, which the filter also reports
    {
      throw Failure("cannot compute the normals of its smoothing groups");
    }
  }
  std::vector<float> normals(3 * keyOfPoint.size(), 0.0f); // points without a face keep zero
  for (std::size_t point = 0; point < keyOfPoint.size(); ++point)
  {
    const std::int32_t key = keyOfPoint[point];
    if (isComputed(key))
    {
      std::copy_n(computed->GetPointer(3 * static_cast<vtkIdType>(point)), 3, &normals[3 * point]);
    }
    else if (key != NoKey)
    {
      std::copy_n(&obj.normals[3 * static_cast<std::size_t>(key)], 3, &normals[3 * point]);
    }
  }
  return normals;
}

/// u and v of each point; (0, 0) if no corner with a texture coordinate uses the point.
vtkSmartPointer<vtkFloatArray> TextureOfPoints(const ObjContent& obj, const Ids& keyOfPoint)
{
  std::vector<float> values(2 * keyOfPoint.size(), 0.0f);
  for (std::size_t point = 0; point < keyOfPoint.size(); ++point)
  {
    if (keyOfPoint[point] != NoKey)
    {
      std::copy_n(&obj.textureCoordinates[2 * static_cast<std::size_t>(keyOfPoint[point])], 2,
        &values[2 * point]);
    }
  }
  return MakeArray<vtkFloatArray>(values, 2);
}

/// Converts colours to bytes. If all are integers and one is above 1, they are bytes already;
/// otherwise they go from 0 to 1, and brighter ones are clamped.
vtkSmartPointer<vtkUnsignedCharArray> Bytes(const std::vector<float>& colors)
{
  const bool areBytes = *std::max_element(colors.begin(), colors.end()) > 1 &&
    std::all_of(
      colors.begin(), colors.end(), [](float color) { return color == std::floor(color); });
  std::vector<unsigned char> bytes(colors.size());
  std::transform(colors.begin(), colors.end(), bytes.begin(),
    [scale = areBytes ? 1.0 : 255.0](float color)
    { return static_cast<unsigned char>(std::clamp(scale * color, 0.0, 255.0) + 0.5); });
  return MakeArray<vtkUnsignedCharArray>(bytes, 3);
}

void SetPointData(vtkPolyData* mesh, const std::vector<float>& normals, vtkFloatArray* texture,
  const std::vector<float>& colors)
{
  if (!normals.empty())
  {
    const auto array = MakeArray<vtkFloatArray>(normals, 3);
    array->SetName("Normals");
    mesh->GetPointData()->SetNormals(array);
  }
  if (texture)
  {
    texture->SetName("TCoords");
    mesh->GetPointData()->SetTCoords(texture);
  }
  if (!colors.empty())
  {
    const auto array = Bytes(colors);
    array->SetName("RGB");
    mesh->GetPointData()->SetScalars(array);
  }
}

void Warn(const ObjContent& obj)
{
  if (obj.cellsOfTooFewPoints > 0)
  {
    vtkGenericWarningMacro(
      << "faces (f) of fewer than 3 points and lines (l) of fewer than 2 are skipped; "
      << "it has " << obj.cellsOfTooFewPoints << " of them");
  }
  if (obj.freeFormSurfaces > 0)
  {
    vtkGenericWarningMacro(<< "free-form surfaces (surf) are skipped; it has "
                           << obj.freeFormSurfaces << " of them");
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadObj(
  const std::string& path, const std::function<void(double)>& progress)
{
  const FileBytes file(path);
  ObjContent obj = ParseObj(file.view(), progress);
  Warn(obj);
  if (obj.points.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const auto append = [&obj](const SplitPoints& split)
  {
    AppendCopies(obj.points, 3, split.copies);
    AppendCopies(obj.colors, 3, split.copies);
  };

  DropZeroNormals(obj);
  std::vector<float> normals;
  if (!obj.normalOfCorner.empty() || !obj.groupOfFace.empty())
  {
    const SplitPoints split(obj.faces.points, NormalKeys(obj), obj.numberOfPoints());
    append(split);
    normals = PointNormals(obj, split.keyOfPoint);
  }
  vtkSmartPointer<vtkFloatArray> texture;
  if (!obj.textureOfCorner.empty())
  {
    Ids corners = obj.faces.points;
    const SplitPoints split(corners, obj.textureOfCorner, obj.numberOfPoints());
    if (!normals.empty() || split.copies.empty())
    {
      obj.faces.points.swap(corners);
      append(split);
      AppendCopies(normals, 3, split.copies);
      texture = TextureOfPoints(obj, split.keyOfPoint);
    }
  }

  const auto mesh = MakeMesh(obj);
  mesh->SetLines(MakeCellArray(obj.lines));
  mesh->SetVerts(MakeCellArray(obj.vertices));
  SetPointData(mesh, normals, texture, obj.colors);
  StoreMaterials(obj.materials, mesh);
  return mesh;
}

} // namespace lambent::command
