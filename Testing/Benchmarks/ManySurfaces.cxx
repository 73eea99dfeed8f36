// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ManySurfaces.h"

#include "Render.h"
#include "SMPParallel.h"
#include "Stopwatch.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTrivialProducer.h"

#include <functional>

namespace
{
lambent::Vec3 toVec3(const Triple& v)
{
  return { v[0], v[1], v[2] };
}

/// The scene without its surfaces.
lambent::Scene emptyScene(const BenchmarkScene& scene)
{
  const View view = scene.view();
  lambent::Scene result;
  result.camera.position = toVec3(view.eye);
  result.camera.focalPoint = toVec3(view.eye) + toVec3(view.forward);
  result.camera.viewUp = toVec3(view.up);
  result.camera.viewAngle = scene.camera->GetViewAngle();
  lambent::Light light;
  light.positional = true;
  light.position = toVec3(view.light);
  result.lights.push_back(light);
  return result;
}

lambent::TupleSpan floats(vtkDataArray* array, vtkIdType first, vtkIdType count)
{
  return { vtkFloatArray::SafeDownCast(array)->GetPointer(3 * first), false,
    static_cast<std::size_t>(count) };
}

vtkSmartPointer<vtkFloatArray> part(vtkDataArray* array, vtkIdType first, vtkIdType count)
{
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetNumberOfComponents(3);
  result->SetArray(
    vtkFloatArray::SafeDownCast(array)->GetPointer(3 * first), 3 * count, 1); // not copied
  return result;
}

vtkSmartPointer<vtkPolyData> makePiece(
  vtkPolyData* mesh, vtkIdType first, vtkIdType points, const std::vector<vtkIdType>& corners)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetData(part(mesh->GetPoints()->GetData(), first, points));
  vtkNew<vtkCellArray> triangles;
  for (std::size_t k = 0; k < corners.size(); k += 3)
  {
    triangles->InsertNextCell(3, &corners[k]);
  }
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  piece->SetPoints(coordinates);
  piece->SetPolys(triangles);
  piece->GetPointData()->SetNormals(part(mesh->GetPointData()->GetNormals(), first, points));
  return piece;
}
}

/// A filter with the ports of vtkLambentRayTracer that does not look at its inputs.
class BlindFilter : public vtkImageAlgorithm
{
public:
  static BlindFilter* New();
  vtkTypeMacro(BlindFilter, vtkImageAlgorithm);

  std::function<void()> work; ///< called in each update

protected:
  int FillInputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    this->work();
    return 1;
  }
};
vtkStandardNewMacro(BlindFilter);

ManySurfaces::ManySurfaces(const BenchmarkScene& scene)
  : Width(scene.width)
  , Height(scene.height)
  , Mesh(scene.mesh)
  , One(emptyScene(scene))
  , Many(this->One)
{
  this->Filter->SetImageSize(scene.width, scene.height);
  this->Filter->SetCamera(scene.camera);
  this->Filter->AddLight(scene.light);

  vtkDataArray* const points = this->Mesh->GetPoints()->GetData();
  vtkDataArray* const normals = this->Mesh->GetPointData()->GetNormals();
  const auto* const corners = static_cast<const vtkIdType*>(
    this->Mesh->GetPolys()->GetConnectivityArray()->GetVoidPointer(0));
  const vtkIdType cornersOfPiece = 3 * this->Mesh->GetNumberOfPolys() / scene.pieces;
  const vtkIdType pointsOfPiece = this->Mesh->GetNumberOfPoints() / scene.pieces;
  this->Corners.assign(corners, corners + cornersOfPiece);

  lambent::Surface surface;
  surface.points = floats(points, 0, this->Mesh->GetNumberOfPoints());
  surface.pointNormals = floats(normals, 0, this->Mesh->GetNumberOfPoints());
  surface.corners = { corners, sizeof(vtkIdType) == 8,
    static_cast<std::size_t>(cornersOfPiece * scene.pieces) };
  this->One.surfaces.push_back(surface);

  surface.corners = { this->Corners.data(), sizeof(vtkIdType) == 8, this->Corners.size() };
  for (vtkIdType k = 0; k < scene.pieces; ++k)
  {
    surface.points = floats(points, k * pointsOfPiece, pointsOfPiece);
    surface.pointNormals = floats(normals, k * pointsOfPiece, pointsOfPiece);
    this->Many.surfaces.push_back(surface);
  }
}

void ManySurfaces::connect(vtkAlgorithm* filter)
{
  const auto points = static_cast<vtkIdType>(this->Many.surfaces.front().points.size);
  for (std::size_t k = 0; k < this->Many.surfaces.size(); ++k)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(
      makePiece(this->Mesh, static_cast<vtkIdType>(k) * points, points, this->Corners));
    filter->AddInputConnection(producer->GetOutputPort());
  }
}

double ManySurfaces::renderInputs()
{
  if (this->Filter->GetNumberOfInputConnections(0) == 0)
  {
    this->connect(this->Filter);
  }
  this->Filter->GetOutput()->Initialize();
  this->Filter->Modified();
  const Stopwatch stopwatch;
  this->Filter->Update();
  return stopwatch.seconds();
}

double ManySurfaces::renderBlindly()
{
  if (!this->Blind)
  {
    vtkNew<BlindFilter> filter;
    filter->work = [this]() { this->renderMany(); };
    this->Blind = filter;
    this->connect(this->Blind);
  }
  this->Blind->Modified();
  const Stopwatch stopwatch;
  this->Blind->Update();
  return stopwatch.seconds();
}

double ManySurfaces::render(const lambent::Scene& scene)
{
  const lambent::adapters::SMPParallel parallel;
  const Stopwatch stopwatch;
  const std::unique_ptr<unsigned char[]> bytes(new unsigned char[3u * this->Width * this->Height]);
  lambent::Image image;
  image.width = this->Width;
  image.height = this->Height;
  image.part = { 0, this->Width, 0, this->Height };
  image.bytes = bytes.get();
  lambent::render(scene, image, parallel);
  return stopwatch.seconds();
}
