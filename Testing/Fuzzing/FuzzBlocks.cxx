// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzBlocks.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <array>

namespace
{
constexpr int mostChildren = 4;
constexpr int mostDepth = 3;
constexpr int mostRepeats = 4; // each may double the number of meshes
}

FuzzBlocks::~FuzzBlocks()
{
  for (const auto& object : this->Objects)
  {
    if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(object))
    {
      blocks->SetNumberOfBlocks(0); // references in a cycle would never be released
    }
  }
}

vtkSmartPointer<vtkDataObject> FuzzBlocks::makeTree(const MakeLeaf& makeLeaf)
{
  return this->Input.seldom(64) ? this->makeCollection(makeLeaf)
                                : vtkSmartPointer<vtkDataObject>(this->makeBlocks(makeLeaf, 1));
}

vtkSmartPointer<vtkMultiBlockDataSet> FuzzBlocks::makeBlocks(const MakeLeaf& makeLeaf, int depth)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  this->Objects.emplace_back(tree);
  const auto count = static_cast<unsigned int>(this->Input.choice(mostChildren));
  tree->SetNumberOfBlocks(count);
  for (unsigned int k = 0; k < count; ++k)
  {
    tree->SetBlock(k, this->makeChild(makeLeaf, depth));
    if (this->Input.seldom(64))
    {
      tree->GetMetaData(k)->Set(vtkCompositeDataSet::NAME(), this->Input.flag() ? "Part" : "");
    }
  }
  if (this->Repeats < mostRepeats && this->Input.seldom(4))
  {
    ++this->Repeats;
    const int index = this->Input.choice(static_cast<int>(this->Objects.size()));
    tree->SetBlock(count, this->Objects[index]); // this may be itself, or a block above it
  }
  return tree;
}

vtkSmartPointer<vtkDataObject> FuzzBlocks::makeChild(const MakeLeaf& makeLeaf, int depth)
{
  const int kind = this->Input.byte();
  if (kind >= 240 && this->Repeats < mostRepeats)
  {
    ++this->Repeats;
    // Only meshes: makeBlocks() repeats trees.
    const auto& last = this->Objects.back();
    return vtkMultiBlockDataSet::SafeDownCast(last) ? nullptr : last;
  }
  if (kind >= 224)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDataObject> child;
  if (kind >= 160 && depth < mostDepth)
  {
    return this->makeBlocks(makeLeaf, depth + 1);
  }
  if (kind >= 152)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(1 + this->Input.choice(2), 2, 2);
    child = image;
  }
  else
  {
    child = makeLeaf();
  }
  this->Objects.push_back(child);
  return child;
}

vtkSmartPointer<vtkDataObject> FuzzBlocks::makeCollection(const MakeLeaf& makeLeaf)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  this->Objects.emplace_back(collection);
  const auto count = static_cast<unsigned int>(this->Input.choice(mostChildren));
  for (unsigned int k = 0; k < count; ++k)
  {
    vtkNew<vtkPartitionedDataSet> partitions;
    this->Objects.emplace_back(partitions);
    const auto parts = static_cast<unsigned int>(this->Input.choice(mostChildren));
    partitions->SetNumberOfPartitions(parts);
    for (unsigned int part = 0; part < parts; ++part)
    {
      partitions->SetPartition(part, this->makeChild(makeLeaf, mostDepth));
    }
    collection->SetPartitionedDataSet(k, partitions);
  }
  return collection;
}

vtkSmartPointer<vtkCompositeDataDisplayAttributes> FuzzBlocks::makeAttributes()
{
  auto attributes = vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New();
  const int count = this->Objects.empty() ? 0 : this->Input.choice(6);
  for (int k = 0; k < count; ++k)
  {
    vtkDataObject* const object =
      this->Objects[this->Input.choice(static_cast<int>(this->Objects.size()))];
    const int bits = this->Input.byte();
    if ((bits & 1) != 0)
    {
      attributes->SetBlockVisibility(object, (bits & 2) != 0);
    }
    if ((bits & 4) != 0)
    {
      std::array<double, 3> color{};
      for (double& channel : color)
      {
        channel = this->Input.seldom(2) ? this->Input.number() : this->Input.within(0.0, 1.0);
      }
      attributes->SetBlockColor(object, color.data());
    }
    if ((bits & 8) != 0)
    {
      attributes->SetBlockOpacity(
        object, this->Input.seldom(4) ? this->Input.number() : this->Input.within(0.0, 1.0));
    }
  }
  return attributes;
}
