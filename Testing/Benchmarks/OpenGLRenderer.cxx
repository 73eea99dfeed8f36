// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLRenderer.h"

#include "Stopwatch.h"

#include "vtkActor.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>

bool OpenGLRenderer::isAvailable()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

OpenGLRenderer::OpenGLRenderer(const BenchmarkScene& scene)
  : Scene(scene)
{
  vtkNew<vtkCamera> camera; // A copy: OpenGL sets the clipping range.
  camera->DeepCopy(scene.camera);
  vtkNew<vtkLight> light;
  light->DeepCopy(scene.light);
  this->Renderer->SetActiveCamera(camera);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->AddLight(light);
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(scene.width, scene.height);
  this->Window->AddRenderer(this->Renderer);
  this->first();
}

std::string OpenGLRenderer::device()
{
  const std::string report = this->Window->ReportCapabilities();
  const std::string label = "OpenGL renderer string:";
  const std::size_t begin = report.find(label);
  if (begin == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t name = report.find_first_not_of(' ', begin + label.size());
  return report.substr(name, report.find('\n', name) - name);
}

double OpenGLRenderer::first()
{
  this->Renderer->RemoveAllViewProps();
  vtkNew<vtkPolyData> mesh; // New to the mapper, yet nothing is copied.
  mesh->ShallowCopy(this->Scene.mesh);
  mesh->GetPoints()->Modified();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->Renderer->ResetCameraClippingRange();
  return this->draw();
}

double OpenGLRenderer::next()
{
  return this->draw();
}

double OpenGLRenderer::draw()
{
  const int width = this->Scene.width, height = this->Scene.height;
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, width - 1, height - 1, /*front*/ 0, pixels);
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(width, height, 1);
  this->Picture->GetPointData()->SetScalars(pixels);
  return stopwatch.seconds();
}
