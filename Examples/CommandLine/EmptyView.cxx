// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptyView.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::command
{
namespace
{

/// Areas and distances below this part of the largest are rounding.
constexpr double Negligible = 1e-9;

/// A point as the camera sees it: right and up in halves of the picture's height, and how far
/// in front.
struct Seen
{
  double x, y, depth;
};

class View
{
public:
  View(vtkCamera* camera, const std::array<int, 2>& size)
    : IsParallel(camera->GetParallelProjection() != 0)
    , Aspect(static_cast<double>(size[0]) / size[1])
    , Half(this->IsParallel ? camera->GetParallelScale()
                            : std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2))
  {
    Triple focus;
    camera->GetPosition(this->Position.data());
    camera->GetFocalPoint(focus.data());
    vtkMath::Subtract(focus.data(), this->Position.data(), this->Forward.data());
    vtkMath::Normalize(this->Forward.data());
    vtkMath::Cross(this->Forward.data(), camera->GetViewUp(), this->Right.data());
    vtkMath::Normalize(this->Right.data());
    vtkMath::Cross(this->Right.data(), this->Forward.data(), this->Up.data());
  }

  Seen see(const Triple& point) const
  {
    Triple way;
    vtkMath::Subtract(point.data(), this->Position.data(), way.data());
    const double depth = vtkMath::Dot(way.data(), this->Forward.data());
    const double unit = this->Half * (this->IsParallel ? 1 : depth);
    return { vtkMath::Dot(way.data(), this->Right.data()) / unit,
      vtkMath::Dot(way.data(), this->Up.data()) / unit, depth };
  }

  /// The way that the camera looks along at a point.
  Triple wayTo(const Triple& point) const
  {
    Triple way = this->Forward;
    if (!this->IsParallel)
    {
      vtkMath::Subtract(point.data(), this->Position.data(), way.data());
      vtkMath::Normalize(way.data());
    }
    return way;
  }

  bool contains(const Seen& point) const
  {
    return std::fabs(point.x) <= this->Aspect && std::fabs(point.y) <= 1;
  }

private:
  bool IsParallel;
  double Aspect;
  double Half;
  Triple Position, Forward, Right, Up;
};

/// What is found in one pass over the faces.
struct Faces
{
  vtkIdType count = 0;
  bool hasTooFewCorners = false;
  double largestArea = 0;
  double largestSeenArea = 0; ///< of those across the way that the camera looks
  bool isInFront = false, isInView = false;
  Triple normal{ 0, 0, 0 }; ///< the sum, each turned to the side of the first
};

void AddFace(Faces& faces, const View& view, vtkPolyData* mesh, vtkIdList* ids)
{
  Triple first, last, next, area{ 0, 0, 0 };
  bool isInFront = false, isInView = false;
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    mesh->GetPoint(ids->GetId(k), next.data());
    const Seen seen = view.see(next);
    isInFront = isInFront || seen.depth > 0;
    isInView = isInView || (seen.depth > 0 && view.contains(seen));
    if (k == 0)
    {
      first = next;
    }
    Triple u, v, part;
    vtkMath::Subtract(last.data(), first.data(), u.data());
    vtkMath::Subtract(next.data(), first.data(), v.data());
    vtkMath::Cross(u.data(), v.data(), part.data());
    if (k >= 2)
    {
      vtkMath::Add(area.data(), part.data(), area.data());
    }
    last = next;
  }
  const double size = vtkMath::Norm(area.data());
  if (!std::isfinite(size)) // the ray tracer has told of it
  {
    return;
  }
  ++faces.count;
  faces.isInFront = faces.isInFront || isInFront;
  faces.isInView = faces.isInView || isInView;
  faces.largestArea = std::max(faces.largestArea, size);
  faces.largestSeenArea =
    std::max(faces.largestSeenArea, std::fabs(vtkMath::Dot(area.data(), view.wayTo(first).data())));
  const double side = vtkMath::Dot(area.data(), faces.normal.data()) < 0 ? -1 : 1;
  vtkMath::MultiplyScalar(area.data(), side);
  vtkMath::Add(faces.normal.data(), area.data(), faces.normal.data());
}

Faces FindFaces(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, const View& view)
{
  Faces faces;
  vtkNew<vtkIdList> ids;
  for (vtkPolyData* mesh : meshes)
  {
    for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
    {
      for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k)
      {
        cells->GetCellAtId(k, ids);
        if (ids->GetNumberOfIds() < 3)
        {
          faces.hasTooFewCorners = true;
        }
        else
        {
          AddFace(faces, view, mesh, ids);
        }
      }
    }
  }
  return faces;
}

/// Rounded, and from the front, the right, or above.
std::string DirectionAlong(Triple normal)
{
  vtkMath::Normalize(normal.data());
  const Triple usual = DefaultDirection;
  if (vtkMath::Dot(normal.data(), usual.data()) < 0)
  {
    vtkMath::MultiplyScalar(normal.data(), -1);
  }
  std::string text;
  for (const double value : normal)
  {
    char number[32];
    std::snprintf(number, sizeof(number), "%.2g", std::round(100 * value) / 100 + 0.0);
    text += (text.empty() ? "" : ",") + std::string(number);
  }
  return text;
}

/// The options that decide where the camera stands and looks, as far as they are given.
std::string CameraOptions(const Options& options)
{
  std::string names;
  const auto add = [&names](bool isGiven, const char* name)
  {
    if (isGiven)
    {
      names += (names.empty() ? "" : " or ") + std::string(name);
    }
  };
  add(options.cameraPosition.has_value(), "--camera-position");
  add(options.focalPoint.has_value(), "--focal-point");
  add(options.parallelScale.has_value(), "--parallel-scale");
  add(options.zoom != 1, "--zoom");
  return names;
}

} // namespace

std::string WhyNothingIsHit(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, vtkCamera* camera)
{
  const Faces faces = FindFaces(meshes, View(camera, *options.size));
  const std::string given = CameraOptions(options);
  const std::string tryWithout = given.empty() ? "" : "; try without " + given;
  if (faces.count == 0) // of no corners, or of such that are not numbers, others have told
  {
    return faces.hasTooFewCorners ? "none of the faces has three corners" : "";
  }
  if (faces.largestArea <= 0)
  {
    return "none of the faces has an area; their corners lie in one line or place";
  }
  if (!faces.isInFront)
  {
    return "all faces lie behind the camera" + tryWithout;
  }
  if (faces.largestSeenArea <= Negligible * faces.largestArea)
  {
    return "the faces are flat and seen along their plane; try --direction " +
      DirectionAlong(faces.normal) +
      (options.cameraPosition ? " instead of --camera-position" : "");
  }
  if (!faces.isInView)
  {
    return "no face lies in the view of the camera" + tryWithout;
  }
  return "the faces are so small there that they fall between the pixels; try a larger --zoom or "
         "--size";
}

} // namespace lambent::command
