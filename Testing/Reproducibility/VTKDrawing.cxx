// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Rendering with the VTK filters.
#include "BodySurface.h"
#include "Drawing.h"
#include "StageToVTK.h"

#include "../Rendering/Backends.h"

#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"
#include "vtkTexture.h"

#include <algorithm>
#include <stdexcept>

namespace
{
/// The bodies, with normals for those smooth ones whose normals the ray tracer cannot compute.
std::vector<Body> prepared(std::vector<Body> bodies, unsigned int shuffle)
{
  for (Body& body : bodies)
  {
    if (body.appearance.shading != lambent::Shading::Smooth || !body.pointNormals.empty() ||
      !body.hasFaces())
    {
      continue;
    }
    if (body.weighting != lambent::Weighting::Angle)
    {
      body.pointNormals = computeNormals(body);
    }
    else if (shuffle)
    {
      const lambent::Parallel serial;
      body = BodySurface(body, serial).withOwnCorners(body, serial);
    }
  }
  return shuffle ? shuffled(bodies, shuffle) : bodies;
}

void addColors(const StageColors& colors, int input, vtkLambentRayTracer* tracer)
{
  if (!colors.array.empty())
  {
    tracer->SetInputScalarVisibility(input, true);
    tracer->SetInputColorArray(input,
      colors.isPerCell ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                       : vtkDataObject::FIELD_ASSOCIATION_POINTS,
      colors.array.c_str());
    tracer->SetInputColorComponent(input, colors.component);
    tracer->SetInputLookupTable(input, toTable(colors));
    tracer->SetInputInterpolateScalarsBeforeMapping(input, colors.isMappedLast);
  }
}

/// The block at a place, which becomes a composite one.
vtkSmartPointer<vtkMultiBlockDataSet> parentOf(
  const std::vector<int>& place, vtkMultiBlockDataSet* root)
{
  vtkSmartPointer<vtkMultiBlockDataSet> parent = root;
  for (std::size_t level = 0; level + 1 < place.size(); ++level)
  {
    const auto child = static_cast<unsigned int>(place[level]);
    if (!parent->GetBlock(child))
    {
      parent->SetBlock(child, vtkNew<vtkMultiBlockDataSet>());
    }
    parent = vtkMultiBlockDataSet::SafeDownCast(parent->GetBlock(child));
  }
  return parent;
}

vtkDataObject* blockAt(const std::vector<int>& place, vtkMultiBlockDataSet* root)
{
  return parentOf(place, root)->GetBlock(static_cast<unsigned int>(place.back()));
}

/// Adds one composite input with all these bodies.
void addBlocks(const std::vector<Body>& bodies, const Stage& stage, vtkLambentRayTracer* tracer)
{
  const int input = tracer->GetNumberOfInputConnections(0);
  vtkNew<vtkMultiBlockDataSet> root;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  for (const Body& body : bodies)
  {
    const auto mesh = toPolyData(body);
    parentOf(body.block, root)->SetBlock(static_cast<unsigned int>(body.block.back()), mesh);
    if (body.blockOpacity)
    {
      attributes->SetBlockOpacity(mesh, *body.blockOpacity);
    }
    if (body.blockColor)
    {
      attributes->SetBlockColor(mesh, &body.blockColor->x);
    }
  }
  for (const std::vector<int>& hidden : stage.hiddenBlocks)
  {
    attributes->SetBlockVisibility(blockAt(hidden, root), false);
  }
  tracer->AddInputDataObject(root);
  tracer->SetInputProperty(input, toProperty(bodies.front()));
  tracer->SetInputTransform(input, toMatrix(bodies.front().transform));
  tracer->SetInputBlockAttributes(input, attributes);
}

void addBodies(const std::vector<Body>& bodies, const Stage& stage, vtkLambentRayTracer* tracer)
{
  for (auto body = bodies.begin(); body != bodies.end();)
  {
    const auto end =
      std::find_if(body, bodies.end(), [](const Body& other) { return other.block.empty(); });
    if (body != end)
    {
      addBlocks({ body, end }, stage, tracer);
      body = end;
      continue;
    }
    const int input = tracer->GetNumberOfInputConnections(0);
    tracer->AddInputDataObject(toPolyData(*body));
    tracer->SetInputProperty(input, toProperty(*body));
    tracer->SetInputTransform(input, toMatrix(body->transform));
    tracer->SetInputSphereRadius(input, body->radius);
    tracer->SetInputSphereRadiusArray(input, body->radii.empty() ? nullptr : radiiName);
    addColors(body->colors, input, tracer);
    tracer->SetInputTexture(input, toTexture(body->texture));
    ++body;
  }
  if (bodies.empty())
  {
    tracer->SetInputDataObject(vtkNew<vtkPolyData>());
  }
}

void setUp(const Stage& stage, const Manner& manner, vtkLambentRayTracer* tracer)
{
  const lambent::Scene& scene = stage.scene;
  // Shuffled bodies are inputs of their own.
  addBodies(
    prepared(manner.shuffle ? stage.visibleBodies() : stage.bodies, manner.shuffle), stage, tracer);
  for (const lambent::Light& light : scene.lights)
  {
    tracer->AddLight(toLight(light));
  }
  if (scene.lights.empty())
  {
    tracer->AddLight(noLight());
  }
  if (!stage.isFramed)
  {
    tracer->SetCamera(toCamera(scene.camera));
  }
  tracer->SetImageSize(stage.width, stage.height);
  tracer->SetSupersampling(stage.samples);
  tracer->SetTwoSidedLighting(scene.twoSidedLighting);
  tracer->SetAmbientModel(scene.ambientModel == lambent::AmbientModel::Scene
      ? vtkLambentRayTracer::SCENE
      : vtkLambentRayTracer::PER_LIGHT);
  tracer->SetGradientBackground(scene.background != scene.backgroundTop);
  tracer->SetBackground(scene.background.x, scene.background.y, scene.background.z);
  tracer->SetBackground2(scene.backgroundTop.x, scene.backgroundTop.y, scene.backgroundTop.z);
  tracer->SetBackgroundImage(toBackgroundImage(stage));
  tracer->SetOutputAlpha(stage.hasAlpha);
  for (const StagePass& pass : stage.passes)
  {
    switch (pass.content)
    {
      case lambent::PassContent::Depth:
        tracer->GenerateDepthOn();
        break;
      case lambent::PassContent::Normal:
        tracer->GenerateNormalsOn();
        break;
      case lambent::PassContent::Position:
        tracer->GeneratePositionsOn();
        break;
      case lambent::PassContent::Attribute:
        tracer->AddPassArray(pass.isPerCell ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                            : vtkDataObject::FIELD_ASSOCIATION_POINTS,
          pass.name.c_str());
    }
  }
}

template <typename Channel>
void fetch(vtkLambentRayTracer* tracer, int scalarType, const lambent::Window& part,
  const Picture& picture, std::vector<Channel>& whole)
{
  const int extent[6] = { part.i0, part.i1 - 1, part.j0, part.j1 - 1, 0, 0 };
  tracer->SetOutputScalarType(scalarType);
  tracer->UpdateExtent(extent);
  vtkImageData* image = tracer->GetOutput();
  if (image->GetNumberOfPoints() != static_cast<vtkIdType>(part.width()) * part.height())
  {
    throw std::runtime_error("the filter refuses the scene");
  }
  paste(static_cast<const Channel*>(image->GetScalarPointer()), part, picture.width,
    picture.channels, whole);
}

/// Copies the passes of the last part to the picture.
void fetchPasses(vtkLambentRayTracer* tracer, const lambent::Window& part, Picture& picture)
{
  for (PassPicture& pass : picture.passes)
  {
    vtkDataArray* const array = tracer->GetOutput()->GetPointData()->GetArray(pass.name.c_str());
    if (!array || array->GetNumberOfComponents() != pass.form.components ||
      array->GetDataType() != (pass.form.isDouble ? VTK_DOUBLE : VTK_FLOAT))
    {
      throw std::runtime_error("the array " + pass.name + " has an unexpected type or size");
    }
    const void* const values = array->GetVoidPointer(0);
    pass.form.isDouble ? paste(static_cast<const double*>(values), part, picture.width,
                           pass.form.components, pass.doubles)
                       : paste(static_cast<const float*>(values), part, picture.width,
                           pass.form.components, pass.floats);
  }
}

Picture drawHere(const Stage& stage, const Manner& manner)
{
  vtkNew<vtkLambentRayTracer> tracer;
  setUp(stage, manner, tracer);
  Picture picture(stage);
  for (const lambent::Window& part : partsOf(stage, manner))
  {
    fetch(tracer, VTK_FLOAT, part, picture, picture.floats);
    fetch(tracer, VTK_UNSIGNED_CHAR, part, picture, picture.bytes);
    fetchPasses(tracer, part, picture);
  }
  return picture;
}
}

Picture draw(const Stage& stage, const Manner& manner)
{
  if (manner.byBruteForce)
  {
    throw std::runtime_error("only the core has --brute-force");
  }
  vtkObject::GlobalWarningDisplayOff(); // hostile scenes cause warnings
  const std::string backend = manner.backend.empty() ? vtkSMPTools::GetBackend() : manner.backend;
  Picture picture;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ manner.threads, backend, false },
    [&]()
    {
      if (backend != vtkSMPTools::GetBackend())
      {
        throw std::runtime_error("this VTK has no backend " + backend);
      }
      picture = drawHere(stage, manner);
    });
  return picture;
}

std::vector<std::string> backendsHere()
{
  return smpBackends();
}
