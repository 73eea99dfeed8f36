// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "NothingSeen.h"
#include "EmptyView.h"
#include "Scene.h"

#include "vtkLambentRayTracer.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;
using Pixel = std::array<unsigned char, 3>;

constexpr Pixel Black{ 0, 0, 0 };

Pixel BytesOf(const Triple& color)
{
  Pixel bytes;
  std::transform(color.begin(), color.end(), bytes.begin(),
    [](double c) { return static_cast<unsigned char>(255 * std::clamp(c, 0.0, 1.0) + 0.5); });
  return bytes;
}

/// True if each pixel of a picture of bytes has one of two colours. Starts in the middle, where
/// most pictures show something.
bool HasOnly(vtkImageData* picture, const Pixel& one, const Pixel& other)
{
  auto* const colors = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const vtkIdType count = colors ? colors->GetNumberOfTuples() : 0;
  const unsigned char* const first = count > 0 ? colors->GetPointer(0) : nullptr;
  for (vtkIdType k = 0; k < count; ++k)
  {
    const unsigned char* const p =
      first + colors->GetNumberOfComponents() * ((k + count / 2) % count);
    if (!std::equal(one.begin(), one.end(), p) && !std::equal(other.begin(), other.end(), p))
    {
      return false;
    }
  }
  return true;
}

bool IsBlack(const Triple& color)
{
  return std::all_of(color.begin(), color.end(), [](double c) { return c <= 0; });
}

/// True if no channel of a picture of bytes is brighter than that of the colour.
bool HasOnlyBetween(vtkImageData* picture, const Pixel& brightest)
{
  auto* const colors = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  for (vtkIdType k = 0; colors && k < colors->GetNumberOfValues(); ++k)
  {
    if (colors->GetValue(k) > brightest[k % 3])
    {
      return false;
    }
  }
  return colors != nullptr;
}

vtkSmartPointer<vtkImageData> Draw(const Options& options, const Meshes& meshes)
{
  const auto tracer = MakeScene(options, meshes);
  tracer->Update();
  return tracer->GetOutput();
}

/// Renders the scene on a black background.
vtkSmartPointer<vtkImageData> DrawOnBlack(Options options, const Meshes& meshes)
{
  options.background = { 0, 0, 0 };
  return Draw(options, meshes);
}

bool IsAllBlack(vtkImageData* picture)
{
  return HasOnly(picture, Black, Black);
}

/// Renders every visible face white, whatever its colour, and everything else black.
vtkSmartPointer<vtkImageData> DrawHits(Options options, const Meshes& meshes)
{
  options.shading = Shading::Unlit;
  options.color = Triple{ 1, 1, 1 };
  options.colors = ColorOptions();
  options.opacity = 1;
  options.edges = false;
  options.edgeColor.reset();
  return DrawOnBlack(options, meshes);
}

/// True if the picture is black wherever a face is visible.
bool IsBlackWhereHit(vtkImageData* picture, vtkImageData* hits)
{
  const auto* const colors =
    vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const auto* const mask = vtkUnsignedCharArray::SafeDownCast(hits->GetPointData()->GetScalars());
  for (vtkIdType k = 0; k < mask->GetNumberOfValues(); ++k)
  {
    if (mask->GetValue(k) != 0 && colors->GetValue(k) != 0)
    {
      return false;
    }
  }
  return true;
}

/// A change to the scene, and the reason for the black picture if the change brightens it.
struct Experiment
{
  /// Returns false if the scene already had that value.
  std::function<bool(Options&, LightValue&)> change;
  const char* reason;
};

template <typename Value>
bool Set(Value& value, const Value& wanted)
{
  const bool isChange = value != wanted;
  value = wanted;
  return isChange;
}

bool IsLamp(const LightValue& light)
{
  return light.kind == LightValue::Kind::Positional;
}

bool HideEdges(Options& options)
{
  const bool isChange = options.edges || options.edgeColor;
  options.edges = false;
  options.edgeColor.reset();
  return isChange;
}

/// Made in this order; each experiment keeps the changes of those before it.
const std::vector<Experiment>& Experiments()
{
  static const std::vector<Experiment> experiments{
    { [](Options& options, LightValue&) { return HideEdges(options); },
      "the edges hide the faces; try a larger --size, a smaller --line-width or another "
      "--edge-color" },
    { [](Options& options, LightValue&) { return Set(options.opacity, 1.0); },
      "the surfaces are too transparent to show; try a larger --opacity" },
    { [](Options&, LightValue& light) { return IsLamp(light) && Set(light.cone, 180.0); },
      "no visible face lies in the cone of a light; try a wider cone or another focal point in "
      "--light" },
    { [](Options&, LightValue& light) {
       return IsLamp(light) && Set(light.attenuation, Triple{ 1, 0, 0 });
     },
      "the lights are too far away for their attenuation; try a smaller one in --light" },
    { [](Options&, LightValue& light) { return Set(light.intensity, 1e6); },
      "the light is too weak to show; try a larger intensity in --light" },
    { [](Options&, LightValue& light) { return Set(light.kind, LightValue::Kind::Headlight); },
      "the lights shine along the faces or from behind them; try --headlight or --ambient 0.2" },
    { [](Options&, LightValue& light) {
       return Set(light.color, Triple{ 1, 1, 1 });
     },
      "the light has none of the colours that the faces reflect; try another --color, or "
      "another color in --light" },
    { [](Options& options, LightValue&) { return Set(options.shading, Shading::Flat); },
      "the normals of the mesh are invalid or point away from the light; try --shading flat" },
    { [](Options& options, LightValue&)
      {
        const bool hasColors = Set(options.colors.array, std::string());
        return Set(options.color, std::optional<Triple>({ 1, 1, 1 })) || hasColors;
      },
      "the data has black colours where it is visible; try another --colormap, --range or "
      "--color" },
  };
  return experiments;
}

std::string WhyAllIsBlack(Options options, const Meshes& meshes)
{
  const Triple color = options.color.value_or(Triple{ 1, 1, 1 });
  const bool isUnlit = options.shading == Shading::Unlit;
  const bool reflectsDiffuse = (options.diffuse > 0 || isUnlit) && !IsBlack(color);
  const bool reflectsSpecular = options.specular.value_or(0) > 0;
  const bool reflectsAmbient =
    options.ambient > 0 && !IsBlack(options.ambientColor.value_or(color));
  if (!reflectsDiffuse && (isUnlit || (!reflectsSpecular && !reflectsAmbient)))
  {
    return "all visible faces are black; try another --color, --diffuse or --ambient";
  }
  if (options.lights.empty())
  {
    options.lights.emplace_back(); // the default headlight
  }
  if (std::all_of(options.lights.begin(), options.lights.end(),
        [](const LightValue& light) { return light.intensity <= 0 || IsBlack(light.color); }))
  {
    return "the lights have no intensity or colour; try another --light, or --headlight";
  }
  for (const Experiment& experiment : Experiments())
  {
    bool isChange = false;
    for (LightValue& light : options.lights)
    {
      isChange = experiment.change(options, light) || isChange;
    }
    if (isChange && !IsAllBlack(DrawOnBlack(options, meshes)))
    {
      return experiment.reason;
    }
  }
  return "hardly any light falls on the visible faces; try --ambient 0.2";
}

} // namespace

std::string WhyNothingIsSeen(const Options& drawing, const Meshes& meshes, vtkImageData* drawn)
{
  // Render one sample per pixel, because the average of two colours is neither of them, and a plain
  // background, because neither alpha nor a background image changes what is hit.
  Options options = drawing;
  options.supersampling = 1;
  options.alpha = false;
  const bool hasImage = !drawing.backgroundImage.empty();
  if (hasImage)
  {
    options.background = { 0, 0, 0 };
  }
  const Pixel background = BytesOf(options.background);
  vtkSmartPointer<vtkImageData> picture = drawn;
  if (background != Black && drawing.supersampling.value_or(1) > 1)
  {
    if (!HasOnlyBetween(drawn, background))
    {
      return "";
    }
    picture = Draw(options, meshes);
  }
  else if (hasImage || (drawing.alpha && HasOnly(drawn, Black, Black)))
  {
    picture = Draw(options, meshes);
  }
  if (!HasOnly(picture, background, Black))
  {
    return "";
  }
  const std::string nothing =
    hasImage ? "the picture shows only the background image: " : "the picture shows nothing: ";
  const auto hits = DrawHits(options, meshes);
  if (IsAllBlack(hits))
  {
    const auto tracer = MakeScene(options, meshes);
    const std::string reason = WhyNothingIsHit(options, meshes, tracer->GetCamera());
    return reason.empty() ? "" : nothing + reason;
  }
  if (options.opacity <= 0)
  {
    return nothing + "the surfaces are invisible; try a larger --opacity";
  }
  if (IsBlackWhereHit(picture, hits))
  {
    const std::string what = hasImage || drawing.alpha ? "the surfaces show only black: "
      : background != Black                            ? "the picture shows only black: "
                                                       : nothing;
    return what + WhyAllIsBlack(options, meshes);
  }
  return HasOnly(picture, background, background)
    ? nothing + "all visible faces have the colour of the background; try another --background"
    : "";
}

} // namespace lambent::command
