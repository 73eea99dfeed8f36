// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite inputs: each block is a surface of its own, in the order of the flat index.
#include "Blocks.h"

#include "vtkDataObjectTreeIterator.h"
#include "vtkIdList.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>

namespace
{
/// Blocks of two levels with empty places, and meshes with and without normals.
Blocks makeTree()
{
  const Mesh plain = makeMoved(makeSphere(8), { 1.0, 0.5, -0.5 });
  plain->GetPointData()->SetNormals(nullptr);
  const Blocks inner = makeBlocks(
    { nullptr, plain, makeMesh({}, {}), makeMoved(makeBox(0.5, 0.4, 0.3), { -1.25, 0.75, 0.5 }) });
  return makeBlocks({ makeSphere(6), inner, nullptr, makeSquare(1.5, -1.0) });
}

/// The meshes with cells and their flat indices, by VTK's iterator.
std::vector<std::pair<vtkPolyData*, vtkIdType>> leavesOf(vtkDataObjectTree* tree)
{
  std::vector<std::pair<vtkPolyData*, vtkIdType>> leaves;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* const mesh = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
    if (mesh && mesh->GetNumberOfCells() > 0)
    {
      leaves.emplace_back(mesh, iterator->GetCurrentFlatIndex());
    }
  }
  return leaves;
}

/// Expects the picture and the ids of the same meshes as inputs of their own.
void expectPictureOfLeaves(vtkDataObjectTree* tree, std::size_t leafCount)
{
  const auto leaves = leavesOf(tree);
  ASSERT_EQ(leaves.size(), leafCount);
  Studio separate(71, 53), composite(71, 53);
  for (Studio* studio : { &separate, &composite })
  {
    studio->look({ 2.0, 3.0, 4.0 }, Vec(0.0));
    studio->tracer->GenerateIdsOn();
    studio->tracer->AddInputDataObject(makeMoved(makeSphere(5), { 0.0, 1.25, 0.0 }));
  }
  for (const auto& leaf : leaves)
  {
    separate.tracer->AddInputDataObject(leaf.first);
  }
  composite.tracer->AddInputDataObject(tree);
  EXPECT_SAME_BITS(render(composite.tracer), render(separate.tracer));

  vtkImageData* const image = composite.tracer->GetOutput();
  const Ids inputs = idsOf(separate.tracer->GetOutput(), "InputIds");
  Ids expectedInputs, expectedBlocks;
  for (const vtkIdType input : inputs)
  {
    expectedInputs.push_back(std::min<vtkIdType>(input, 1));
    expectedBlocks.push_back(input < 1 ? -1 : leaves[static_cast<std::size_t>(input) - 1].second);
  }
  EXPECT_EQ(idsOf(image, "InputIds"), expectedInputs);
  EXPECT_EQ(idsOf(image, "BlockIds"), expectedBlocks);
  EXPECT_EQ(idsOf(image, "CellIds"), idsOf(separate.tracer->GetOutput(), "CellIds"));
  for (const auto& leaf : leaves)
  {
    EXPECT_GT(std::count(expectedBlocks.begin(), expectedBlocks.end(), leaf.second), 0);
  }
}
}

TEST(Blocks, OfAMultiBlockDataSetAreSurfaces)
{
  expectPictureOfLeaves(makeTree(), 4);
}

TEST(Blocks, OfAPartitionedDataSetAreSurfaces)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(1, makeSphere(6));
  partitions->SetPartition(3, makeMoved(makeBox(0.5, 0.4, 0.3), { -1.25, 0.75, 0.5 }));
  expectPictureOfLeaves(partitions, 2);
}

TEST(Blocks, OfACollectionAreSurfaces)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  vtkNew<vtkPartitionedDataSet> first, second;
  first->SetPartition(0, makeSphere(6));
  first->SetPartition(1, makeMoved(makeSphere(6), { 1.0, 0.0, 0.0 }));
  second->SetPartition(2, makeMoved(makeBox(0.5, 0.4, 0.3), { -1.25, 0.75, 0.5 }));
  collection->SetPartitionedDataSet(1, first);
  collection->SetPartitionedDataSet(2, second);
  expectPictureOfLeaves(collection, 3);
}

TEST(Blocks, OfNestedPiecesAreSurfaces)
{
  vtkNew<vtkMultiPieceDataSet> pieces;
  pieces->SetPiece(1, makeMoved(makeSphere(6), { -1.0, 0.0, 1.0 }));
  pieces->SetPiece(2, makeMoved(makeBox(0.5, 0.4, 0.3), { 0.5, -0.5, 1.5 }));
  expectPictureOfLeaves(makeBlocks({ makeTree(), pieces, nullptr, makeSquare(0.25, 2.0) }), 7);
}

TEST(Blocks, TiesGoToTheSmallestInputThenBlock)
{
  Studio studio(5, 1);
  lookAtRow(studio);
  studio.tracer->AddInputDataObject(makeRow(4, 5));
  studio.tracer->AddInputDataObject(
    makeBlocks({ makeBlocks({ makeRow(2, 4) }), makeRow(1, 5), makeRow(0, 5) }));
  studio.tracer->AddInputDataObject(makeRow(0, 5));
  EXPECT_EQ(renderIds(studio, "BlockIds"), (Ids{ 4, 3, 2, 2, -1 }));
  EXPECT_EQ(renderIds(studio, "InputIds"), (Ids{ 1, 1, 1, 1, 0 }));
  EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ 0, 0, 0, 1, 0 }));
}

TEST(Blocks, HaveIdsOnlyIfAnInputIsComposite)
{
  Studio studio(3, 1);
  lookAtRow(studio);
  studio.tracer->AddInputDataObject(makeRow(0, 2));
  EXPECT_TRUE(renderIds(studio, "BlockIds").empty());
  studio.tracer->AddInputDataObject(makeBlocks({ nullptr, makeMesh({}, {}) })); // nothing visible
  EXPECT_EQ(renderIds(studio, "BlockIds"), (Ids{ -1, -1, -1 }));
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 4);
  studio.tracer->GenerateIdsOff();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(Blocks, PartsEqualTheWhole)
{
  Studio studio(40, 30);
  studio.tracer->AddInputDataObject(makeTree());
  const Ids whole = renderIds(studio, "BlockIds");
  studio.tracer->Modified();
  const int extent[6] = { 7, 33, 5, 21, 0, 0 };
  studio.tracer->UpdateExtent(extent);
  Ids expected;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    expected.insert(
      expected.end(), whole.begin() + 40 * j + extent[0], whole.begin() + 40 * j + extent[1] + 1);
  }
  EXPECT_EQ(idsOf(studio.tracer->GetOutput(), "BlockIds"), expected);
}

// Also by the automatic camera, which uses the same bounds.
TEST(Blocks, AreFramedByResetCamera)
{
  Studio separate, composite;
  const Blocks tree = makeTree();
  for (const auto& leaf : leavesOf(tree))
  {
    separate.tracer->AddInputDataObject(leaf.first);
  }
  composite.tracer->AddInputDataObject(tree);
  separate.tracer->ResetCamera();
  composite.tracer->ResetCamera();
  EXPECT_EQ(composite.position(), separate.position());
  const Picture framed = render(separate.tracer);
  composite.tracer->SetCamera(nullptr);
  EXPECT_SAME_BITS(render(composite.tracer), framed);
}

TEST(Blocks, MayLackAPassArray)
{
  Studio studio(4, 1);
  lookAtRow(studio);
  const Mesh with = makeRow(0, 2), without = makeRow(2, 4);
  vtkNew<vtkFloatArray> values;
  values->SetName("Part");
  values->InsertNextValue(3.0f);
  values->InsertNextValue(4.0f);
  with->GetCellData()->AddArray(values);
  studio.tracer->AddInputDataObject(makeBlocks({ without, with }));
  studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
  studio.tracer->Update();
  vtkDataArray* const found = studio.tracer->GetOutput()->GetPointData()->GetArray("Part");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->GetComponent(0, 0), 3.0);
  EXPECT_EQ(found->GetComponent(1, 0), 4.0);
  EXPECT_TRUE(std::isnan(found->GetComponent(2, 0)));
}

// A grid of small squares, each a block, equals the grid as one mesh.
TEST(Blocks, MayBeMany)
{
  constexpr int n = 40;
  const Mesh whole = makeGrid(n, -n / 2.0, -n / 2.0);
  std::vector<Mesh> meshes;
  std::vector<vtkDataObject*> children;
  const std::vector<Vec> points = pointsOf(whole);
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    whole->GetCellPoints(cell, ids);
    meshes.push_back(makeMesh(
      { points[ids->GetId(0)], points[ids->GetId(1)], points[ids->GetId(2)] }, { { 0, 1, 2 } }));
    children.push_back(meshes.back());
  }
  Studio one(64, 48), many(64, 48);
  for (Studio* studio : { &one, &many })
  {
    studio->look({ 9.0, -20.0, 30.0 }, Vec(0.0));
  }
  one.tracer->AddInputDataObject(whole);
  many.tracer->AddInputDataObject(makeBlocks(children));
  Ids expected = renderIds(one, "CellIds");
  for (vtkIdType& id : expected)
  {
    id = id < 0 ? -1 : id + 1; // the root is 0
  }
  EXPECT_EQ(renderIds(many, "BlockIds"), expected);
  EXPECT_SAME_BITS(Picture(many.tracer->GetOutput()), Picture(one.tracer->GetOutput()));
}
