// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Highlights as the settings of vtkProperty and vtkLight describe them: every pixel equals the
// formula, computed from trigonometry.
#include "ExpectedErrors.h"
#include "Meshes.h"

#include "vtkObjectFactory.h"

#include <limits>

namespace
{
/// vtkProperty itself clamps the power.
class NegativePower : public vtkProperty
{
public:
  static NegativePower* New();
  double GetSpecularPower() override { return -1.0; }
};
vtkStandardNewMacro(NegativePower);

struct Shiny : Studio
{
  double power = 12.0;
  Vec specular{ 0.4, 0.3, 0.2 }; ///< coefficient times colour

  Shiny()
  {
    this->property->SetDiffuse(0.0);
    this->property->SetSpecular(0.5);
    this->property->SetSpecularColor(0.8, 0.6, 0.4);
    this->setPower(this->power);
    this->tracer->SetInputData(makeSquare());
  }

  void setPower(double p)
  {
    this->power = p;
    this->property->SetSpecularPower(p);
  }

  /// The highlight in a direction to the light, seen along a ray, on a surface facing z.
  Vec highlight(const Vec& toLight, const Ray& ray, const Vec& lightColor) const
  {
    const Vec l = glm::normalize(toLight);
    const Vec reflected = glm::reflect(-l, Vec(0.0, 0.0, 1.0));
    const double cosine = glm::dot(reflected, -glm::normalize(ray.direction));
    return l.z > 0.0 ? this->specular * lightColor * std::pow(std::max(cosine, 0.0), this->power)
                     : Vec(0.0);
  }

  /// Expects highlightAt(ray, point) at every pixel.
  template <typename Highlight>
  void expectEverywhere(const Highlight& highlightAt)
  {
    const Picture picture = render(this->tracer);
    for (int j = 0; j < this->height(); ++j)
    {
      for (int i = 0; i < this->width(); ++i)
      {
        const Ray r = this->ray(i, j);
        const Vec point = r.origin - r.direction * (r.origin.z / r.direction.z);
        expectColor(picture.at(i, j), highlightAt(r, point), pixelName(i, j));
      }
    }
  }
};
}

TEST(Highlights, OfDirectionalLightsFollowTheFormula)
{
  Shiny shiny;
  const Vec from(0.5, -0.25, 2.0), color(0.5, 1.0, 0.75);
  shiny.tracer->AddLight(makeLight(from, { 0.0, 0.0, 0.0 }, color));
  for (const double power : { 0.0, 1.0, 2.5, 12.0, 128.0 })
  {
    shiny.setPower(power);
    shiny.expectEverywhere(
      [&](const Ray& ray, const Vec&) { return shiny.highlight(from, ray, color); });
  }
}

TEST(Highlights, OfPositionalLightsAreAttenuated)
{
  Shiny shiny;
  const Vec lamp(0.25, 0.5, 3.0);
  auto light = makeLight(lamp, { 0.0, 0.0, 0.0 }, Vec(1.0), true);
  light->SetAttenuationValues(0.5, 0.25, 0.125);
  light->SetIntensity(2.0);
  shiny.tracer->AddLight(light);
  const auto expected = [&](const Ray& ray, const Vec& point)
  {
    const double distance = glm::length(lamp - point);
    return shiny.highlight(lamp - point, ray, Vec(2.0)) /
      (0.5 + 0.25 * distance + 0.125 * distance * distance);
  };
  shiny.expectEverywhere(expected);
  light->SetConeAngle(15.0);
  light->SetExponent(3.0);
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec& point)
    {
      const double cosine = glm::dot(glm::normalize(point - lamp), glm::normalize(-lamp));
      return cosine < std::cos(15.0 * pi / 180.0) ? Vec(0.0)
                                                  : expected(ray, point) * std::pow(cosine, 3.0);
    });
}

TEST(Highlights, AreSeenAlongTheRaysOfAParallelView)
{
  Shiny shiny;
  const Vec from(0.5, -0.25, 2.0);
  shiny.look({ 0.5, 1.0, 5.0 }, { 0.0, 0.0, 0.0 });
  shiny.camera->ParallelProjectionOn();
  shiny.tracer->AddLight(makeLight(from, { 0.0, 0.0, 0.0 }));
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec&) { return shiny.highlight(from, ray, Vec(1.0)); });
}

TEST(Highlights, OfTheHeadlightFollowTheFormula)
{
  Shiny shiny;
  shiny.look({ 1.0, 0.5, 5.0 }, { 0.0, 0.0, 0.0 });
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec&) {
      return shiny.highlight({ 1.0, 0.5, 5.0 }, ray, Vec(1.0));
    });
}

TEST(Highlights, HaveTheSpecularColourOfTheLight)
{
  Shiny shiny;
  const Vec from(0.0, 0.0, 2.0), color(0.25, 0.5, 1.0);
  auto light = makeLight(from, { 0.0, 0.0, 0.0 }, Vec(0.0));
  light->SetSpecularColor(color.x, color.y, color.z);
  light->SetIntensity(0.5);
  shiny.tracer->AddLight(light);
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec&) { return shiny.highlight(from, ray, 0.5 * color); });
}

TEST(Highlights, AddUpWithTheOtherTerms)
{
  Shiny shiny;
  const Vec from(0.5, 0.5, 2.0);
  shiny.property->SetDiffuse(0.5);
  shiny.property->SetAmbient(0.25);
  shiny.tracer->AddLight(makeLight(from, { 0.0, 0.0, 0.0 }));
  shiny.tracer->AddLight(makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }));
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec&)
    {
      return Vec(0.5 * (glm::normalize(from).z + 1.0) + 2.0 * 0.25) +
        shiny.highlight(from, ray, Vec(1.0)) + shiny.highlight({ 0.0, 0.0, 1.0 }, ray, Vec(1.0));
    });
}

TEST(Highlights, AreNotInTheColoursOfArrays)
{
  Shiny shiny;
  Mesh mesh = makeSquare();
  auto colors = makeTuples({ { 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 } }, "Colours");
  mesh->GetPointData()->AddArray(colors);
  const Vec from(0.5, -0.25, 2.0);
  shiny.tracer->AddLight(makeLight(from, { 0.0, 0.0, 0.0 }));
  shiny.tracer->SetInputData(mesh);
  shiny.tracer->SetInputScalarVisibility(0, true);
  shiny.tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Colours");
  shiny.expectEverywhere(
    [&](const Ray& ray, const Vec&) { return shiny.highlight(from, ray, Vec(1.0)); });
}

TEST(Highlights, AreNotOnUnlitSurfacesOrTheFarSide)
{
  Shiny shiny;
  shiny.tracer->AddLight(makeLight({ 0.0, 0.0, -2.0 }, { 0.0, 0.0, 0.0 }));
  EXPECT_EQ(render(shiny.tracer).count(Vec(0.0)), 32 * 24);
  shiny.property->LightingOff();
  EXPECT_EQ(render(shiny.tracer).count(Vec(1.0)), 32 * 24);
}

TEST(Highlights, ThatAreNotFiniteAreAnError)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> parts{ "vtkProperty has a specular setting", "not a finite number",
    "SetSpecular()", "SetSpecularColor()", "SetSpecularPower()" };
  const auto mend = [](Studio& studio) { studio.property->SetSpecular(0.0); };
  expectError([&](Studio& studio) { studio.property->SetSpecular(nan); }, parts, mend);
  expectError(
    [&](Studio& studio)
    {
      studio.property->SetSpecular(0.5);
      studio.property->SetSpecularColor(0.0, nan, 0.0);
    },
    parts, mend);
  expectError(
    [&](Studio& studio)
    {
      studio.property->SetSpecular(0.5);
      studio.property->SetSpecularPower(nan);
    },
    parts, mend);
}

TEST(Highlights, WithANegativePowerAreAnError)
{
  vtkNew<NegativePower> property;
  property->SetSpecular(0.5);
  expectError([&](Studio& studio) { studio.tracer->SetInputProperty(0, property); },
    { "Input 0", "vtkProperty has a specular power below 0", "SetSpecularPower()" },
    [&](Studio& studio) { studio.tracer->SetInputProperty(0, nullptr); });
}

TEST(Highlights, OfLightsThatAreNotFiniteAreAnError)
{
  auto light = makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 });
  light->SetSpecularColor(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  expectError([&](Studio& studio) { studio.tracer->AddLight(light); },
    { "Light 0", "not a finite number", "colour" },
    [&](Studio& studio) { studio.tracer->RemoveLight(light); });
}
