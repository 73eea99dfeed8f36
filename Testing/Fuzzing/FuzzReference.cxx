// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzReference.h"

#include "FuzzInput.h"

#include "InputBlocks.h"
#include "Render.h"
#include "SceneFromSettings.h"
#include "TransformFromVTK.h"
#include "Vec3FromVTK.h"

#include "vtkCollectionRange.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

#include <cmath>
#include <cstring>
#include <string>

namespace
{
lambent::adapters::SceneSettings::Input inputOf(vtkLambentRayTracer* tracer, int connection)
{
  lambent::adapters::SceneSettings::Input input;
  input.property = tracer->GetInputProperty(connection);
  input.connection = connection;
  input.transform =
    lambent::adapters::transformFromVTK(tracer->GetInputTransform(connection), connection);
  const auto text = [](const char* name) { return std::string(name ? name : ""); };
  lambent::adapters::InputColors& colors = input.colors;
  colors.scalarVisibility = tracer->GetInputScalarVisibility(connection);
  colors.association = tracer->GetInputColorArrayAssociation(connection);
  colors.arrayName = text(tracer->GetInputColorArrayName(connection));
  colors.component = tracer->GetInputColorComponent(connection);
  colors.lookupTable = tracer->GetInputLookupTable(connection);
  colors.hasScalarRange = tracer->GetInputScalarRange(connection, colors.scalarRange);
  colors.interpolateScalarsBeforeMapping =
    tracer->GetInputInterpolateScalarsBeforeMapping(connection);
  input.texture = tracer->GetInputTexture(connection);
  input.spheres.radius = tracer->GetInputSphereRadius(connection);
  input.spheres.radiusArray = text(tracer->GetInputSphereRadiusArray(connection));
  return input;
}

lambent::adapters::SceneSettings settingsOf(const FuzzSubject& subject)
{
  vtkLambentRayTracer* const tracer = subject.tracer;
  lambent::adapters::SceneSettings result;
  for (int k = 0; k < static_cast<int>(subject.inputs.size()); ++k)
  {
    addBlocks(inputOf(tracer, k), subject.inputs[k], tracer->GetInputBlockAttributes(k), result);
  }
  result.camera = tracer->GetCamera();
  for (vtkLight* light : vtk::Range(tracer->GetLights()))
  {
    result.lights.push_back(light);
  }
  result.property = tracer->GetProperty();
  result.usePointNormals = tracer->GetUsePointNormals() != 0;
  result.splitting = tracer->GetSplitting() != 0;
  result.featureAngle = tracer->GetFeatureAngle();
  result.passArrays = subject.passArrays;
  tracer->GetImageSize(result.imageSize);
  result.ambientModel = tracer->GetAmbientModel() == vtkLambentRayTracer::SCENE
    ? lambent::AmbientModel::Scene
    : lambent::AmbientModel::PerLight;
  result.twoSidedLighting = tracer->GetTwoSidedLighting() != 0;
  result.background = lambent::adapters::vec3FromVTK(tracer->GetBackground());
  result.background2 = lambent::adapters::vec3FromVTK(tracer->GetBackground2());
  result.gradientBackground = tracer->GetGradientBackground() != 0;
  result.backgroundImage = tracer->GetBackgroundImage();
  result.outputAlpha = tracer->GetOutputAlpha() != 0;
  return result;
}

/// An array of the picture, and the memory for the same pass by brute force.
struct Expected
{
  vtkDataArray* found;
  lambent::Pass pass;
  std::vector<unsigned char> memory;
};

std::vector<Expected> passesOf(
  const FuzzSubject& subject, const lambent::adapters::InputSurfaces& surfaces)
{
  std::vector<Expected> result;
  const auto add = [&](const std::string& name, const lambent::Pass& pass)
  {
    vtkImageData* const image = subject.tracer->GetOutput();
    vtkDataArray* const array = image->GetPointData()->GetArray(name.c_str());
    require(array && array->GetNumberOfTuples() == image->GetNumberOfPoints() &&
        array->GetNumberOfComponents() == pass.components &&
        array->GetDataType() == (pass.isDouble ? VTK_DOUBLE : VTK_FLOAT),
      "there is an array for each pass");
    const auto size =
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize());
    result.push_back({ array, pass, std::vector<unsigned char>(size) });
  };
  if (subject.tracer->GetGenerateDepth())
  {
    add("Depth", { lambent::PassContent::Depth, 1, false, nullptr, 0 });
  }
  if (subject.tracer->GetGenerateNormals())
  {
    add("Normals", { lambent::PassContent::Normal, 3, false, nullptr, 0 });
  }
  if (subject.tracer->GetGeneratePositions())
  {
    add("Positions", { lambent::PassContent::Position, 3, true, nullptr, 0 });
  }
  for (std::size_t k = 0; k < subject.passArrays.size(); ++k)
  {
    const auto form = surfaces.formOf(k);
    add(subject.passArrays[k].name,
      { lambent::PassContent::Attribute, form.components, form.isDouble, nullptr, k });
  }
  return result;
}

void compareColors(
  vtkDataArray* colors, const std::vector<float>& floats, const std::vector<unsigned char>& bytes)
{
  const int channels = colors->GetNumberOfComponents();
  for (vtkIdType k = 0; k < colors->GetNumberOfValues(); ++k)
  {
    const double expected =
      colors->GetDataType() == VTK_FLOAT ? static_cast<double>(floats[k]) : bytes[k];
    const double found = colors->GetComponent(k / channels, static_cast<int>(k % channels));
    require(found == expected || (std::isnan(found) && std::isnan(expected)),
      "each pixel equals that of brute force");
  }
}
}

void compareWithBruteForce(const FuzzSubject& subject, const std::array<int, 6>& extent)
{
  vtkDataArray* const colors = subject.tracer->GetOutput()->GetPointData()->GetScalars();
  const lambent::Parallel one;
  lambent::Image image;
  image.width = subject.tracer->GetImageSize()[0];
  image.height = subject.tracer->GetImageSize()[1];
  image.part = { extent[0], extent[1] + 1, extent[2], extent[3] + 1 };
  image.samples = subject.tracer->GetSupersampling();
  image.hasAlpha = subject.tracer->GetOutputAlpha() != 0;
  std::vector<float> floats(colors->GetNumberOfValues());
  std::vector<unsigned char> bytes(colors->GetNumberOfValues());
  const bool isFloat = colors->GetDataType() == VTK_FLOAT;
  image.floats = isFloat ? floats.data() : nullptr;
  image.bytes = isFloat ? nullptr : bytes.data();
  const lambent::adapters::SceneSettings settings = settingsOf(subject);
  const lambent::adapters::SceneFromSettings scene(settings, one);
  std::vector<Expected> passes = passesOf(subject, scene.surfaces());
  for (Expected& expected : passes)
  {
    expected.pass.data = expected.memory.data();
    image.passes.push_back(expected.pass);
  }
  const lambent::Report report =
    render(scene.scene(), image, one, nullptr, lambent::Settings::bruteForce(image.samplePart()));
  require(report.outcome == lambent::Outcome::Done, "brute force renders it, too");
  compareColors(colors, floats, bytes);
  for (const Expected& expected : passes)
  {
    require(std::memcmp(expected.found->GetVoidPointer(0), expected.memory.data(),
              expected.memory.size()) == 0,
      "each value of a pass equals that of brute force");
  }
}
