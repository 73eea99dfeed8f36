// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Rendering with the core only.
#include "BodySurface.h"
#include "Drawing.h"
#include "Render.h"

#include "../Core/ThreadedParallel.h"

#include <memory>
#include <stdexcept>

namespace
{
bool lacksNormals(const Body& body)
{
  return body.appearance.shading == lambent::Shading::Smooth && body.pointNormals.empty() &&
    body.hasFaces();
}

/// Converts bodies to surfaces, and computes normals for smooth ones without them.
std::vector<std::unique_ptr<BodySurface>> surfacesOf(std::vector<Body> bodies,
  const std::vector<StagePass>& passes, unsigned int shuffle, const lambent::Parallel& parallel)
{
  for (Body& body : bodies)
  {
    if (lacksNormals(body) && body.weighting != lambent::Weighting::Angle)
    {
      body.pointNormals = BodySurface(body, parallel).pointNormals(body.weighting, parallel);
    }
    else if (lacksNormals(body) && shuffle)
    {
      body = BodySurface(body, parallel).withOwnCorners(body, parallel);
    }
  }
  std::vector<std::unique_ptr<BodySurface>> surfaces;
  for (const Body& body : shuffle ? shuffled(bodies, shuffle) : bodies)
  {
    surfaces.push_back(std::make_unique<BodySurface>(body, parallel));
    if (lacksNormals(body))
    {
      surfaces.back()->computeNormals(parallel);
    }
    for (const StagePass& pass : passes)
    {
      if (pass.content == lambent::PassContent::Attribute)
      {
        surfaces.back()->addAttribute(body, pass.name, pass.isPerCell);
      }
    }
  }
  return surfaces;
}

/// The camera of vtkRenderer::ResetCamera(), in the default direction.
lambent::Camera framed(
  const Stage& stage, const lambent::Scene& scene, const lambent::Parallel& parallel)
{
  return frameBounds(
    lambent::Camera(), findBounds(scene.surfaces, parallel), stage.width, stage.height);
}

void drawPart(const lambent::Scene& scene, int samples, const lambent::Window& part,
  const lambent::Parallel& parallel, bool byBruteForce, Picture& picture)
{
  const std::size_t pixels = static_cast<std::size_t>(part.width()) * part.height();
  std::vector<float> floats(picture.channels * pixels);
  std::vector<unsigned char> bytes(floats.size());
  std::vector<PassPicture> passes = picture.passes;
  lambent::Image image;
  image.width = picture.width;
  image.height = picture.height;
  image.part = part;
  image.samples = samples;
  image.hasAlpha = picture.channels == 4;
  for (PassPicture& pass : passes)
  {
    const std::size_t size = pass.form.components * pixels;
    pass.form.isDouble ? pass.doubles.resize(size) : pass.floats.resize(size);
    pass.form.data =
      pass.form.isDouble ? static_cast<void*>(pass.doubles.data()) : pass.floats.data();
    image.passes.push_back(pass.form);
  }
  const lambent::Settings settings =
    byBruteForce ? lambent::Settings::bruteForce(image.samplePart()) : lambent::Settings();
  image.floats = floats.data();
  const auto outcome = render(scene, image, parallel, nullptr, settings).outcome;
  image.floats = nullptr;
  image.bytes = bytes.data();
  image.passes.clear(); // done
  render(scene, image, parallel, nullptr, settings);
  if (outcome != lambent::Outcome::Done)
  {
    throw std::runtime_error("a cell uses a point that does not exist");
  }
  paste(floats.data(), part, picture.width, picture.channels, picture.floats);
  paste(bytes.data(), part, picture.width, picture.channels, picture.bytes);
  for (std::size_t k = 0; k < passes.size(); ++k)
  {
    const int components = passes[k].form.components;
    passes[k].form.isDouble
      ? paste(passes[k].doubles.data(), part, picture.width, components, picture.passes[k].doubles)
      : paste(passes[k].floats.data(), part, picture.width, components, picture.passes[k].floats);
  }
}
}

Picture draw(const Stage& stage, const Manner& manner)
{
  if (!manner.backend.empty())
  {
    throw std::runtime_error("the core has no backends; omit --backend");
  }
  const int threads = manner.threads > 0
    ? manner.threads
    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const ThreadedParallel parallel(threads);
  const auto surfaces = surfacesOf(stage.visibleBodies(), stage.passes, manner.shuffle, parallel);
  lambent::Scene scene = stage.scene;
  for (const auto& surface : surfaces)
  {
    scene.surfaces.push_back(surface->surface());
  }
  const std::vector<unsigned char> behind = stage.backgroundImage.memory();
  if (!behind.empty())
  {
    const StageArray& image = stage.backgroundImage;
    scene.backgroundImage = { { behind.data(), image.type, image.components, false },
      stage.backgroundWidth, stage.backgroundHeight };
  }
  if (stage.isFramed)
  {
    scene.camera = framed(stage, scene, parallel);
  }
  Picture picture(stage);
  for (const lambent::Window& part : partsOf(stage, manner))
  {
    drawPart(scene, stage.samples, part, parallel, manner.byBruteForce, picture);
  }
  return picture;
}

std::vector<std::string> backendsHere()
{
  return {};
}
