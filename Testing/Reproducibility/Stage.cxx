// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

Body& Body::paint(const Vec3& diffuse, const Vec3& ambient)
{
  this->appearance.diffuseColor = diffuse;
  this->appearance.ambient = 1.0;
  this->appearance.ambientColor = ambient;
  return *this;
}

Body& Body::flat()
{
  this->appearance.shading = lambent::Shading::Flat;
  return *this;
}

Body& Body::unlit()
{
  this->appearance.shading = lambent::Shading::Unlit;
  return *this;
}

Body& Body::weigh(lambent::Weighting how)
{
  this->weighting = how;
  return *this;
}

Body& Body::round()
{
  this->pointNormals = this->shape.points;
  return *this;
}

Body& Body::floats()
{
  this->hasFloatPoints = true;
  this->has32BitIds = true;
  return *this;
}

Body& Body::strips()
{
  this->hasStrips = true;
  return *this;
}

Stage::Stage()
{
  this->look({ 2.0, 1.5, 4.0 }, Vec3(0.0));
  this->scene.background = this->scene.backgroundTop = { 0.0625, 0.125, 0.25 };
}

Body& Stage::add(const Shape& shape)
{
  this->bodies.emplace_back();
  this->bodies.back().shape = shape;
  return this->bodies.back().paint({ 0.9, 0.8, 0.7 }, { 0.05, 0.06, 0.07 });
}

void Stage::size(int w, int h)
{
  this->width = w;
  this->height = h;
}

void Stage::look(const Vec3& from, const Vec3& at, const Vec3& up)
{
  this->scene.camera.position = from;
  this->scene.camera.focalPoint = at;
  this->scene.camera.viewUp = up;
}

void Stage::lookParallel(double scale)
{
  this->scene.camera.parallel = true;
  this->scene.camera.parallelScale = scale;
}

lambent::Light& Stage::sun(const Vec3& direction, const Vec3& color)
{
  this->scene.lights.emplace_back();
  lambent::Light& light = this->scene.lights.back();
  light.direction = direction;
  light.color = color;
  return light;
}

lambent::Light& Stage::lamp(const Vec3& position, const Vec3& color)
{
  lambent::Light& light = this->sun({ 0.0, 0.0, -1.0 }, color);
  light.positional = true;
  light.position = position;
  return light;
}

lambent::Light& Stage::spot(
  const Vec3& position, const Vec3& direction, double angle, double exponent)
{
  lambent::Light& light = this->lamp(position);
  light.direction = direction;
  light.coneAngle = angle;
  light.exponent = exponent;
  return light;
}

void Stage::daylight()
{
  this->sun({ -1.0, -2.0, -1.5 }, { 0.75, 0.7, 0.6 });
  this->lamp({ -3.0, 1.0, 2.0 }, { 0.2, 0.3, 0.5 });
}
