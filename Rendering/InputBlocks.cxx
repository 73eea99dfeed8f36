// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputBlocks.h"

#include "InputName.h"
#include "Vec3FromVTK.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lambent::adapters
{
namespace
{
/// The children of any tree, which are protected in VTK 9.1. VTK's iterators cannot be used: they
/// look into all first children at once, and would never end if a block contains itself.
class Children : public vtkDataObjectTree
{
public:
  static unsigned int count(vtkDataObjectTree* tree)
  {
    return (tree->*&Children::GetNumberOfChildren)();
  }
  static vtkDataObject* at(vtkDataObjectTree* tree, unsigned int child)
  {
    return (tree->*&Children::GetChild)(child);
  }
  /// nullptr if it has none.
  static const char* name(vtkDataObjectTree* tree, unsigned int child)
  {
    vtkInformation* const data = (tree->*&Children::HasChildMetaData)(child)
      ? (tree->*&Children::GetChildMetaData)(child)
      : nullptr;
    return data && data->Has(vtkCompositeDataSet::NAME()) ? data->Get(vtkCompositeDataSet::NAME())
                                                          : nullptr;
  }
};

class BlockVisitor
{
public:
  BlockVisitor(vtkCompositeDataDisplayAttributes* attributes, SceneSettings& scene)
    : Attributes(attributes)
    , Scene(scene)
  {
  }

  /// What a block inherits.
  struct State
  {
    SceneSettings::Input input;
    bool isVisible = true;
  };

  void visit(vtkDataObject* object, State state)
  {
    const vtkIdType block = this->Next++;
    if (!object)
    {
      return;
    }
    this->apply(object, state);
    if (auto* const tree = vtkDataObjectTree::SafeDownCast(object))
    {
      this->Scene.hasCompositeInput = true;
      state.input.block = block;
      this->visitChildren(tree, state);
      return;
    }
    // Blocks have a number, inputs that are none do not.
    state.input.block = this->Parents.empty() ? -1 : block;
    if (state.isVisible)
    {
      this->add(object, std::move(state.input));
    }
  }

private:
  /// Replaces what the block does not inherit.
  void apply(vtkDataObject* object, State& state) const
  {
    if (!this->Attributes)
    {
      return;
    }
    if (this->Attributes->HasBlockVisibility(object))
    {
      state.isVisible = this->Attributes->GetBlockVisibility(object);
    }
    if (this->Attributes->HasBlockColor(object))
    {
      double color[3];
      this->Attributes->GetBlockColor(object, color);
      state.input.color = vec3FromVTK(color);
    }
    if (this->Attributes->HasBlockOpacity(object))
    {
      state.input.opacity = this->Attributes->GetBlockOpacity(object);
    }
  }

  void visitChildren(vtkDataObjectTree* tree, const State& state)
  {
    const auto parent = std::find_if(this->Parents.begin(), this->Parents.end(),
      [tree](const auto& entry) { return entry.first == tree; });
    if (parent != this->Parents.end())
    {
      throw std::runtime_error(nameOf(state.input) + " contains itself: it is the same " +
        tree->GetClassName() + " as block " + std::to_string(parent->second) +
        ", which contains it. Remove it from the block above it, for instance with SetBlock().");
    }
    this->Parents.emplace_back(tree, state.input.block);
    for (unsigned int k = 0; k < Children::count(tree); ++k)
    {
      State ofChild = state;
      if (const char* const name = Children::name(tree, k))
      {
        ofChild.input.blockName = name;
      }
      this->visit(Children::at(tree, k), std::move(ofChild));
    }
    this->Parents.pop_back();
  }

  void add(vtkDataObject* object, SceneSettings::Input input)
  {
    auto* const dataSet = vtkDataSet::SafeDownCast(object);
    input.mesh = vtkPolyData::SafeDownCast(object);
    const bool isBlock = input.block >= 0;
    if (!input.mesh && !(dataSet && dataSet->GetNumberOfCells() == 0))
    {
      this->Scene.undrawableBlocks.push_back(
        withinSentence(nameOf(input)) + ", a " + object->GetClassName());
    }
    else if (input.mesh &&
      (!isBlock || input.mesh->GetNumberOfCells() > 0 ||
        (input.spheres.areOn() && input.mesh->GetNumberOfPoints() > 0)))
    {
      this->Scene.inputs.push_back(std::move(input));
    }
  }

  vtkCompositeDataDisplayAttributes* const Attributes;
  SceneSettings& Scene;
  vtkIdType Next = 0;                                            ///< flat index
  std::vector<std::pair<vtkDataObjectTree*, vtkIdType>> Parents; ///< with their flat indices
};
}

void addBlocks(const SceneSettings::Input& input, vtkDataObject* data,
  vtkCompositeDataDisplayAttributes* attributes, SceneSettings& scene)
{
  BlockVisitor(attributes, scene).visit(data, { input, true });
}
}
