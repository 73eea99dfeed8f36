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

//------------------------------------------------------------------------------
double OpenGLRenderer::first()
{
  this->Window = nullptr; // Closing the last window does not count.
  this->Renderer = nullptr;
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->open();
  this->load();
  this->draw();
  return stopwatch.seconds();
}

double OpenGLRenderer::newMesh()
{
  this->Renderer->RemoveAllViewProps();
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->load();
  this->draw();
  return stopwatch.seconds();
}

double OpenGLRenderer::next()
{
  this->Picture = nullptr;
  const Stopwatch stopwatch;
  this->draw();
  return stopwatch.seconds();
}

double OpenGLRenderer::nextLayers()
{
  constexpr int peels = 1000; // more than any scene has layers
  this->Window->SetAlphaBitPlanes(1);
  this->Renderer->SetUseDepthPeeling(true);
  this->Renderer->SetMaximumNumberOfPeels(peels);
  this->Renderer->SetOcclusionRatio(0.0);
  this->Property->SetOpacity(layerOpacity);
  const double seconds = this->next();
  this->Property->SetOpacity(1.0);
  return seconds;
}

//------------------------------------------------------------------------------
void OpenGLRenderer::open()
{
  vtkNew<vtkCamera> camera; // A copy: OpenGL sets the clipping range.
  camera->DeepCopy(this->Scene.camera);
  vtkNew<vtkLight> light;
  light->DeepCopy(this->Scene.light);
  this->Renderer = vtkSmartPointer<vtkRenderer>::New();
  this->Renderer->SetActiveCamera(camera);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->AddLight(light);
  this->Window = vtkSmartPointer<vtkRenderWindow>::New();
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(this->Scene.width, this->Scene.height);
  this->Window->AddRenderer(this->Renderer);
}

void OpenGLRenderer::load()
{
  vtkNew<vtkPolyData> mesh; // New to the mapper, without a copy.
  mesh->ShallowCopy(this->Scene.mesh);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Property = actor->GetProperty();
  this->Renderer->AddActor(actor);
  this->Renderer->ResetCameraClippingRange();
}

void OpenGLRenderer::draw()
{
  const int width = this->Scene.width, height = this->Scene.height;
  this->Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, width - 1, height - 1, /*front*/ 0, pixels);
  this->Picture = vtkSmartPointer<vtkImageData>::New();
  this->Picture->SetDimensions(width, height, 1);
  this->Picture->GetPointData()->SetScalars(pixels);
}
