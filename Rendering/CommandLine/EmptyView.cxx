// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmptyView.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lambent::command
{
namespace
{

/// Faces that no ray hits are edge-on if at most this fraction of their area faces the camera.
constexpr double EdgeOn = 0.01;

/// A point in view coordinates: x to the right and y up, in half heights of the picture, and the
/// depth along the view direction.
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

  /// The direction in which the camera sees a point.
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

/// What one pass over the triangles of all faces finds.
struct Faces
{
  vtkIdType count = 0;
  bool hasTooFewCorners = false;
  double largestArea = 0;
  double largestSeenArea = 0; ///< projected along the view direction
  bool isInFront = false, isInView = false;
  Triple normal{ 0, 0, 0 }; ///< the sum of the normals, each turned to the side of the sum so far
};

void AddTriangle(Faces& faces, const View& view, const std::array<Triple, 3>& corners)
{
  Triple u, v, area;
  vtkMath::Subtract(corners[1].data(), corners[0].data(), u.data());
  vtkMath::Subtract(corners[2].data(), corners[0].data(), v.data());
  vtkMath::Cross(u.data(), v.data(), area.data());
  const double size = vtkMath::Norm(area.data());
  if (!std::isfinite(size)) // the ray tracer has already warned
  {
    return;
  }
  ++faces.count;
  for (const Triple& corner : corners)
  {
    const Seen seen = view.see(corner);
    faces.isInFront = faces.isInFront || seen.depth > 0;
    faces.isInView = faces.isInView || (seen.depth > 0 && view.contains(seen));
  }
  const Triple way = view.wayTo(corners[0]);
  faces.largestArea = std::max(faces.largestArea, size);
  faces.largestSeenArea =
    std::max(faces.largestSeenArea, std::fabs(vtkMath::Dot(area.data(), way.data())));
  const double side = vtkMath::Dot(area.data(), faces.normal.data()) < 0 ? -1 : 1;
  vtkMath::MultiplyScalar(area.data(), side);
  vtkMath::Add(faces.normal.data(), area.data(), faces.normal.data());
}

void AddCells(Faces& faces, const View& view, vtkPolyData* mesh, vtkCellArray* cells)
{
  const bool areStrips = cells == mesh->GetStrips();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    faces.hasTooFewCorners = faces.hasTooFewCorners || ids->GetNumberOfIds() < 3;
    for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
    {
      std::array<Triple, 3> corners;
      mesh->GetPoint(ids->GetId(areStrips ? k - 2 : 0), corners[0].data());
      mesh->GetPoint(ids->GetId(k - 1), corners[1].data());
      mesh->GetPoint(ids->GetId(k), corners[2].data());
      AddTriangle(faces, view, corners);
    }
  }
}

/// Why no line or vertex is hit, if there are any with finite points.
std::string WhyNoLineIsHit(const View& view,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, const std::string& tryWithout)
{
  bool isAny = false, isInFront = false, isInView = false;
  vtkNew<vtkIdList> ids;
  for (vtkPolyData* mesh : meshes)
  {
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfVerts() + mesh->GetNumberOfLines(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      for (const vtkIdType id : *ids)
      {
        Triple point;
        mesh->GetPoint(id, point.data());
        const Seen seen = view.see(point);
        isAny = isAny || std::isfinite(seen.depth);
        isInFront = isInFront || seen.depth > 0;
        isInView = isInView || (seen.depth > 0 && view.contains(seen));
      }
    }
  }
  return !isAny || isInView ? ""
    : isInFront             ? "no line or vertex lies in the view of the camera" + tryWithout
                            : "all lines and vertices lie behind the camera" + tryWithout;
}

/// The normal as a value of --direction: rounded, and on the side of the default direction.
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

/// The given options that place and aim the camera.
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
  const std::string given = CameraOptions(options);
  const std::string tryWithout = given.empty() ? "" : "; try without " + given;
  if (options.spheres)
  {
    return "no sphere is hit; try a larger radius in --spheres" +
      (given.empty() ? "" : ", or try without " + given);
  }
  Faces faces;
  const View view(camera, *options.size);
  for (vtkPolyData* mesh : meshes)
  {
    AddCells(faces, view, mesh, mesh->GetPolys());
    AddCells(faces, view, mesh, mesh->GetStrips());
  }
  if (faces.count == 0) // missing faces and NaN points have already caused warnings
  {
    const std::string reason = WhyNoLineIsHit(view, meshes, tryWithout);
    return !reason.empty()     ? reason
      : faces.hasTooFewCorners ? "none of the faces has three corners"
                               : "";
  }
  if (faces.largestArea <= 0)
  {
    return "none of the faces has an area; their corners lie on a line or at a point";
  }
  if (!faces.isInFront)
  {
    return "all faces lie behind the camera" + tryWithout;
  }
  if (faces.largestSeenArea <= EdgeOn * faces.largestArea)
  {
    return "the faces are flat and seen edge-on; try --direction " + DirectionAlong(faces.normal) +
      (options.cameraPosition ? " instead of --camera-position" : "");
  }
  if (!faces.isInView)
  {
    return "no face lies in the view of the camera" + tryWithout;
  }
  if (options.representation != Representation::Surface)
  {
    return options.representation == Representation::Points
      ? "the points fall between the pixels; try a larger --point-size"
      : "the lines fall between the pixels; try a larger --line-width";
  }
  return "the faces appear so small that they fall between the pixels; try a larger --zoom or "
         "--size";
}

} // namespace lambent::command
