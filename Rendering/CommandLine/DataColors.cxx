// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataColors.h"
#include "ColorScale.h"
#include "SphereRadii.h"

#include "vtkLambentRayTracer.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

int AssociationOf(const ShownArray& shown)
{
  return shown.isOfCells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                         : vtkDataObject::FIELD_ASSOCIATION_POINTS;
}

/// A copy of the mesh that shares all arrays, and has the shown one once more as unsigned short:
/// for the ray tracer, unsigned chars are colours. `shown` becomes the copy.
vtkSmartPointer<vtkPolyData> WithNumbers(vtkPolyData* mesh, ShownArray& shown)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  vtkNew<vtkUnsignedShortArray> numbers;
  numbers->DeepCopy(shown.array);
  numbers->SetName((std::string(shown.array->GetName()) + " as numbers").c_str());
  vtkFieldData* const data = shown.isOfCells ? static_cast<vtkFieldData*>(copy->GetCellData())
                                             : static_cast<vtkFieldData*>(copy->GetPointData());
  data->AddArray(numbers);
  shown.array = numbers;
  return copy;
}

/// Adds inputs with the settings of `--color-by`.
class Painter
{
public:
  Painter(const Options& options, const Meshes& meshes, vtkLambentRayTracer* tracer)
    : Wanted(FindColorBy(options.colors.array, meshes))
    , Range(RangeOf(options, this->Wanted, meshes))
    , Table(MakeTable(options.colors, this->Range))
    , Tracer(tracer)
  {
  }

  /// Returns false, and adds nothing, if the mesh does not have the array.
  bool Add(int connection, vtkPolyData* mesh) const
  {
    std::optional<ShownArray> shown = ShownArrayOf(mesh, this->Wanted);
    if (!shown)
    {
      return false;
    }
    const bool areBytes = shown->array->GetDataType() == VTK_UNSIGNED_CHAR;
    vtkSmartPointer<vtkPolyData> input = mesh;
    if (areBytes && !shown->areColors)
    {
      input = WithNumbers(mesh, *shown);
    }
    this->Tracer->AddInputDataObject(0, input);
    this->Tracer->SetInputScalarVisibility(connection, true);
    this->Tracer->SetInputColorArray(connection, AssociationOf(*shown), shown->array->GetName());
    if (!shown->areColors)
    {
      shown->array->SetLookupTable(nullptr); // it would come before that of the input
      this->Tracer->SetInputColorComponent(connection, shown->component);
      this->Tracer->SetInputLookupTable(connection, this->Table);
      this->Tracer->SetInputScalarRange(connection, this->Range[0], this->Range[1]);
      this->Tracer->SetInputInterpolateScalarsBeforeMapping(connection, true);
    }
    return true;
  }

private:
  ColorBy Wanted;
  std::array<double, 2> Range;
  vtkSmartPointer<vtkLookupTable> Table;
  vtkLambentRayTracer* Tracer;
};

/// The inputs whose colours come from an array, and those where it holds numbers.
struct Colored
{
  std::size_t inputs = 0;
  std::size_t byNumbers = 0;
  std::size_t byOption = 0; ///< by the array of `--color-by`
};

Colored CountColored(const Options& options, const Meshes& meshes)
{
  Colored colored;
  std::optional<ColorBy> wanted;
  if (!options.colors.array.empty())
  {
    wanted = FindColorBy(options.colors.array, meshes);
  }
  for (vtkPolyData* const mesh : meshes)
  {
    const auto shown = wanted ? ShownArrayOf(mesh, *wanted) : std::nullopt;
    const bool isOwn = !shown && !options.color && HasOwnColors(mesh);
    colored.inputs += shown || isOwn ? 1 : 0;
    colored.byOption += shown ? 1 : 0;
    colored.byNumbers += shown && !shown->areColors ? 1 : 0;
  }
  return colored;
}

} // namespace

void AddMeshes(const Options& options, const Meshes& meshes, vtkLambentRayTracer* tracer)
{
  std::optional<Painter> painter;
  if (!options.colors.array.empty())
  {
    painter.emplace(options, meshes, tracer);
  }
  if (options.spheres)
  {
    CheckSpheres(*options.spheres, meshes);
  }
  for (std::size_t k = 0; k < meshes.size(); ++k)
  {
    const int connection = static_cast<int>(k);
    vtkPolyData* const mesh = meshes[k];
    if (!painter || !painter->Add(connection, mesh))
    {
      tracer->AddInputDataObject(0, mesh);
      tracer->SetInputScalarVisibility(connection, !options.color && HasOwnColors(mesh));
    }
    if (options.spheres)
    {
      SetSpheres(*options.spheres, mesh, connection, tracer);
    }
  }
}

bool HasOwnColors(vtkPolyData* mesh)
{
  vtkDataArray* const ofPoints = mesh->GetPointData()->GetScalars();
  return AreColors(ofPoints ? ofPoints : mesh->GetCellData()->GetScalars());
}

std::string DescribeColors(const Options& options, const Meshes& meshes)
{
  if (options.colors.array.empty())
  {
    return "";
  }
  if (CountColored(options, meshes).byNumbers == 0)
  {
    return options.colors.array;
  }
  const auto range = RangeOf(options, FindColorBy(options.colors.array, meshes), meshes);
  std::ostringstream text;
  text << options.colors.array << " from " << range[0] << " to " << range[1] << ", "
       << options.colors.map.value_or(DefaultColorMap)
       << (options.colors.isLogarithmic ? ", logarithmic" : "");
  return text.str();
}

std::vector<std::string> WhyColorsAreIdle(const Options& options, const Meshes& meshes)
{
  const ColorOptions& colors = options.colors;
  const Colored colored = CountColored(options, meshes);
  std::vector<std::string> reasons;
  std::string scale; // the options of the table
  for (const auto& [isGiven, name] : { std::pair(colors.map.has_value(), "--colormap"),
         std::pair(colors.range.has_value(), "--range"), std::pair(colors.isLogarithmic, "--log"),
         std::pair(colors.nan.has_value(), "--nan-color") })
  {
    scale += isGiven ? (scale.empty() ? "" : " and ") + std::string(name) : "";
  }
  if (!scale.empty() && colored.byNumbers == 0)
  {
    reasons.push_back(scale + " has no effect, because " + colors.array +
      " holds colours; omit it, or choose a component, such as --color-by " + colors.array + ":0");
  }
  if (options.color && colored.byOption == meshes.size())
  {
    reasons.push_back("--color has no effect, because all inputs have the array of --color-by; "
                      "omit one of them");
  }
  if (options.ambientColor && colored.inputs == meshes.size())
  {
    reasons.push_back("--ambient-color has no effect, because colours from arrays replace it; "
                      "omit it");
  }
  return reasons;
}

} // namespace lambent::command
