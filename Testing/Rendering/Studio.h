// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a ray tracer with a camera, and this camera's rays from trigonometry
 */
#ifndef Studio_h
#define Studio_h

#include "Picture.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <cmath>

constexpr double pi = 3.14159265358979323846;

struct Ray
{
  Vec origin, direction;
};

/// An independent implementation of the light model for one light: rho_d, rho_a, the arriving
/// light, the vector to the light, the normal.
inline Vec reflected(
  const Vec& diffuse, const Vec& ambient, const Vec& light, const Vec& s, const Vec& m)
{
  const double cosine = glm::dot(s, m) / (glm::length(s) * glm::length(m));
  return diffuse * light * std::max(0.0, cosine) + ambient * light;
}

/// A scene light at a position, aimed at a focal point.
inline vtkSmartPointer<vtkLight> makeLight(
  const Vec& position, const Vec& focalPoint, const Vec& color = Vec(1.0), bool positional = false)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
  light->SetColor(color.x, color.y, color.z);
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  return light;
}

struct Studio
{
  vtkNew<vtkLambentRayTracer> tracer;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkProperty> property;

  /// Sets float output, a camera at (0, 0, 5) that looks at the origin, and a background colour
  /// that nothing else can have.
  explicit Studio(int width = 32, int height = 24)
  {
    this->tracer->SetImageSize(width, height);
    this->tracer->SetOutputScalarTypeToFloat();
    this->tracer->SetBackground(-1.0, -2.0, -3.0);
    this->tracer->SetCamera(this->camera);
    this->tracer->SetProperty(this->property);
    this->camera->SetPosition(0.0, 0.0, 5.0);
  }

  static Vec background() { return { -1.0, -2.0, -3.0 }; }

  void look(const Vec& from, const Vec& at, const Vec& up = Vec(0.0, 1.0, 0.0))
  {
    this->camera->SetPosition(from.x, from.y, from.z);
    this->camera->SetFocalPoint(at.x, at.y, at.z);
    this->camera->SetViewUp(up.x, up.y, up.z);
  }

  void reflect(const Vec& diffuse, const Vec& ambient)
  {
    this->property->SetDiffuseColor(diffuse.x, diffuse.y, diffuse.z);
    this->property->SetAmbientColor(ambient.x, ambient.y, ambient.z);
    this->property->SetDiffuse(1.0);
    this->property->SetAmbient(1.0);
  }

  int width() const { return this->tracer->GetImageSize()[0]; }
  int height() const { return this->tracer->GetImageSize()[1]; }

  Vec position() const { return glm::make_vec3(this->camera->GetPosition()); }
  Vec forward() const
  {
    return glm::normalize(glm::make_vec3(this->camera->GetFocalPoint()) - this->position());
  }
  Vec right() const
  {
    return glm::normalize(glm::cross(this->forward(), glm::make_vec3(this->camera->GetViewUp())));
  }
  Vec up() const { return glm::cross(this->right(), this->forward()); }

  /// Half the width and height of the view; at distance 1 in a perspective view.
  glm::dvec2 halfView() const
  {
    const double aspect = static_cast<double>(this->width()) / this->height();
    if (this->camera->GetParallelProjection())
    {
      return this->camera->GetParallelScale() * glm::dvec2(aspect, 1.0);
    }
    const double tangent = std::tan(this->camera->GetViewAngle() * pi / 360.0);
    return this->camera->GetUseHorizontalViewAngle() ? glm::dvec2(tangent, tangent / aspect)
                                                     : glm::dvec2(tangent * aspect, tangent);
  }

  /// The ray through the centre of a pixel.
  Ray ray(int i, int j) const
  {
    const glm::dvec2 half = this->halfView();
    const double x = half.x * ((2.0 * i + 1.0) / this->width() - 1.0 + this->center().x);
    const double y = half.y * ((2.0 * j + 1.0) / this->height() - 1.0 + this->center().y);
    const Vec across = x * this->right() + y * this->up();
    return this->camera->GetParallelProjection()
      ? Ray{ this->position() + across, this->forward() }
      : Ray{ this->position(), this->forward() + across };
  }

  /// The image position of a point, in pixels from the lower left corner.
  glm::dvec2 project(const Vec& point) const
  {
    const Vec d = point - this->position();
    const double w = this->camera->GetParallelProjection() ? 1.0 : glm::dot(d, this->forward());
    const glm::dvec2 across(glm::dot(d, this->right()), glm::dot(d, this->up()));
    return (across / (w * this->halfView()) - this->center() + 1.0) * 0.5 *
      glm::dvec2(this->width(), this->height());
  }

private:
  glm::dvec2 center() const
  {
    return { this->camera->GetWindowCenter()[0], this->camera->GetWindowCenter()[1] };
  }
};

#endif
