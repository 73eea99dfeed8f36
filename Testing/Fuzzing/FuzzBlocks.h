// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make composite data from the bytes of a fuzzer
 */
#ifndef FuzzBlocks_h
#define FuzzBlocks_h

#include "FuzzInput.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkDataObject;
class vtkDataObjectTree;
class vtkMultiBlockDataSet;
class vtkCompositeDataDisplayAttributes;

class FuzzBlocks
{
public:
  using MakeLeaf = std::function<vtkSmartPointer<vtkDataObject>()>;

  explicit FuzzBlocks(FuzzInput& input)
    : Input(input)
  {
  }
  FuzzBlocks(const FuzzBlocks&) = delete;
  ~FuzzBlocks();

  /// A tree with nested, empty and repeated blocks, blocks that cannot be drawn, and seldom one
  /// that contains itself.
  vtkSmartPointer<vtkDataObject> makeTree(const MakeLeaf& makeLeaf);

  /// Attributes of some of the blocks of all trees; the attributes may be invalid.
  vtkSmartPointer<vtkCompositeDataDisplayAttributes> makeAttributes();

private:
  vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const MakeLeaf& makeLeaf, int depth);
  vtkSmartPointer<vtkDataObject> makeCollection(const MakeLeaf& makeLeaf);
  vtkSmartPointer<vtkDataObject> makeChild(const MakeLeaf& makeLeaf, int depth);

  FuzzInput& Input;
  /// Attributes refer to objects by address. So no other object may get the address of an old one.
  std::vector<vtkSmartPointer<vtkDataObject>> Objects;
  int Repeats = 0; ///< blocks that occur again, in all trees
};

#endif
