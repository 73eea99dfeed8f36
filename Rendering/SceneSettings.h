// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief all that a picture shows, as VTK's objects and plain values
 *
 * A ray tracer fills it in (vtkLambentAlgorithm::DescribeScene()); nothing here knows which.
 * The objects must outlive it. Where an error message names a setting, it is by the name of the
 * ray tracer's method.
 */
#ifndef SceneSettings_h
#define SceneSettings_h

#include "InputColors.h"
#include "Scene.h"
#include "Transform.h"

#include "vtkType.h"

#include <optional>
#include <string>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkLight;
class vtkPolyData;
class vtkProperty;
class vtkTexture;

namespace lambent::adapters
{
/// Whether the points of an input are drawn as spheres, in place of its cells.
struct SphereSettings
{
  double radius = 0.0;     ///< 0: none, or 1 if there is an array
  std::string radiusArray; ///< of points; its values are multiplied by the radius

  bool areOn() const { return this->radius != 0.0 || !this->radiusArray.empty(); }
};

struct SceneSettings
{
  /// A mesh: an input connection's, or a block of it. Ordered by connection, then by block.
  struct Input
  {
    vtkPolyData* mesh = nullptr;
    vtkProperty* property = nullptr; ///< none: that of all inputs
    InputColors colors;
    vtkTexture* texture = nullptr;
    SphereSettings spheres;
    int connection = 0;
    vtkIdType block = -1;          ///< flat index; -1: the input is not composite
    std::string blockName;         ///< may be empty
    std::optional<Vec3> color;     ///< of the block, instead of the property's colours
    std::optional<double> opacity; ///< of the block
    Transform transform;
  };
  std::vector<Input> inputs;
  bool hasCompositeInput = false;
  std::vector<std::string> undrawableBlocks; ///< what each is, for a warning

  vtkCamera* camera = nullptr;     ///< none: a new one, reset to the bounds of the inputs
  std::vector<vtkLight*> lights;   ///< none: a headlight
  vtkProperty* property = nullptr; ///< of inputs that have none; none: the default one

  // How normals are made.
  bool usePointNormals = true;
  bool splitting = true;
  double featureAngle = 30.0; ///< degrees

  /// Point or cell arrays of the inputs that become point arrays of the picture.
  struct PassArray
  {
    int association; ///< vtkDataObject::FIELD_ASSOCIATION_POINTS or _CELLS
    std::string name;
  };
  std::vector<PassArray> passArrays;

  // Of the picture.
  int imageSize[2] = { 300, 300 };
  AmbientModel ambientModel = AmbientModel::PerLight;
  bool twoSidedLighting = true;
  Vec3 background{ 0.0 };  ///< at the bottom edge
  Vec3 background2{ 0.0 }; ///< at the top edge, if there is a gradient
  bool gradientBackground = false;
  vtkImageData* backgroundImage = nullptr;
  bool outputAlpha = false;

  Vec3 backgroundTop() const
  {
    return this->gradientBackground ? this->background2 : this->background;
  }

  vtkProperty* propertyOf(const Input& input) const
  {
    return input.property ? input.property : this->property;
  }
};
}

#endif
