// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite inputs with blocks that cannot be drawn, and messages that name blocks.
#include "Blocks.h"
#include "ExpectedErrors.h"

#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace
{
/// A grid of one tetrahedron.
vtkSmartPointer<vtkUnstructuredGrid> makeGrid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(
    makeMesh({ Vec(0.0), { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, {})
      ->GetPoints());
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  return grid;
}

const Change removeInputs = [](Studio& studio)
{
  while (studio.tracer->GetNumberOfInputConnections(0) > 1)
  {
    studio.tracer->RemoveInputConnection(0, 1);
  }
};

/// Expects an error for a composite input 1 with the mesh as block 2, "wing".
void expectErrorForBlock(
  vtkPolyData* mesh, const std::vector<std::string>& parts, const Change& set = [](Studio&) {})
{
  const Blocks blocks = makeBlocks({ makeSphere(4), mesh });
  setName(blocks, 1, "wing");
  std::vector<std::string> all{ "Input 1, block 2 (\"wing\"): " };
  all.insert(all.end(), parts.begin(), parts.end());
  expectError(
    [&](Studio& studio)
    {
      studio.tracer->AddInputDataObject(blocks);
      set(studio);
    },
    all,
    [](Studio& studio)
    {
      removeInputs(studio);
      studio.tracer->RemoveAllPassArrays();
    });
}
}

TEST(BadBlocks, OfOtherClassesCauseOneWarning)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(makeSphere(6));
  const Picture expected = render(studio.tracer);
  vtkNew<vtkTable> table;
  vtkNew<vtkUnstructuredGrid> empty;
  const Blocks inner = makeBlocks({ empty, makeGrid() });
  const Blocks blocks = makeBlocks({ inner, makeMoved(makeSphere(4), { 0.0, 0.0, 9.0 }), table });
  setName(inner, 1, "hull");
  studio.tracer->AddInputDataObject(blocks);
  EXPECT_SAME_BITS(render(studio.tracer), expected);
  expectMessage(messages.warnings(),
    { "input 1, block 3 (\"hull\"), a vtkUnstructuredGrid; input 1, block 5, a vtkTable.",
      "vtkCompositeDataGeometryFilter", "vtkDataSetSurfaceFilter" });
  EXPECT_EQ(messages.warnings()[0].find("block 2"), std::string::npos); // it is empty
  EXPECT_TRUE(messages.errors().empty());
  messages.clear();
  studio.tracer->Modified();
  render(studio.tracer);
  EXPECT_TRUE(messages.warnings().empty()); // only once
}

TEST(BadBlocks, AreListedUpToANumber)
{
  const auto grid = makeGrid();
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(makeBlocks(std::vector<vtkDataObject*>(1000, grid)));
  render(studio.tracer);
  expectMessage(messages.warnings(), { "block 1,", "block 20,", "; and 980 more." });
}

TEST(BadBlocks, ThatAreHiddenCauseNoWarning)
{
  const auto grid = makeGrid();
  Studio studio;
  const Messages messages(studio.tracer);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(grid, false);
  studio.tracer->AddInputDataObject(makeBlocks({ grid }));
  studio.tracer->SetInputBlockAttributes(0, attributes);
  render(studio.tracer);
  EXPECT_TRUE(messages.warnings().empty());
}

// Without the check, the visit would never end.
TEST(BadBlocks, ThatContainThemselvesAreAnError)
{
  const Blocks inner = makeBlocks({ makeSphere(4) });
  const Blocks outer = makeBlocks({ makeSphere(4), inner });
  setName(outer, 1, "loop");
  inner->SetBlock(3, outer);
  const Blocks own = makeBlocks({ nullptr });
  own->SetBlock(0, own);
  expectError([&](Studio& studio) { studio.tracer->AddInputDataObject(outer); },
    { "Input 1, block 6 (\"loop\") contains itself", "vtkMultiBlockDataSet as block 0",
      "SetBlock()" },
    removeInputs);
  expectError([&](Studio& studio) { studio.tracer->AddInputDataObject(own); },
    { "Input 1, block 1 contains itself", "block 0" }, removeInputs);
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(own);
  studio.tracer->ResetCamera();
  expectMessage(messages.errors(), { "Input 0, block 1 contains itself" });
  inner->SetBlock(3, nullptr); // otherwise they would keep each other alive
  own->SetBlock(0, nullptr);
}

// The same block twice is none.
TEST(BadBlocks, DoNotIncludeSharedOnes)
{
  const Blocks shared = makeBlocks({ makeSphere(6) });
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(makeBlocks({ shared, shared, makeBlocks({ shared }) }));
  EXPECT_FALSE(render(studio.tracer).empty());
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadBlocks, AreNamedInErrors)
{
  const Mesh wrongCorner = makeSphere(4);
  wrongCorner->GetPolys()->InsertNextCell({ 0, 1, 999 });
  expectErrorForBlock(wrongCorner, { "999" });
  const Mesh wrongNormals = makeSphere(4);
  setPointNormals(wrongNormals, { Vec(1.0) });
  expectErrorForBlock(wrongNormals, { "the point normals, array \"PointNormals\", have 1 tuples" });
  const Mesh wrongPoints = makeSphere(4);
  wrongPoints->GetPoints()->GetData()->SetNumberOfComponents(2);
  expectErrorForBlock(wrongPoints, { "the points have 2 components" });
  const Mesh wrongArray = makeSphere(4);
  vtkNew<vtkFloatArray> heat;
  heat->SetName("Heat");
  heat->InsertNextValue(1.0f);
  wrongArray->GetPointData()->AddArray(heat);
  const auto pass = [](Studio& studio)
  { studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heat"); };
  expectErrorForBlock(wrongArray, { "the point array \"Heat\" has 1 tuples" }, pass);
}

TEST(BadBlocks, AreNamedWhereArraysDiffer)
{
  const Mesh one = makeSquare(), other = makeSquare();
  vtkNew<vtkFloatArray> scalars, vectors;
  scalars->SetName("Part");
  scalars->InsertNextValue(1.0f);
  vectors->SetName("Part");
  vectors->SetNumberOfComponents(2);
  vectors->InsertNextTuple2(1.0, 2.0);
  one->GetCellData()->AddArray(scalars);
  other->GetCellData()->AddArray(vectors);
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(makeBlocks({ makeBlocks({ one }), other }));
  studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
  studio.tracer->Update();
  expectMessage(messages.errors(),
    { "Input 0, block 3: the cell array \"Part\" has 2 components, but that of input 0, block 2 "
      "has 1" });
}

TEST(BadBlocks, AreNamedInTheWarningAboutPoints)
{
  const Mesh mesh = makeMesh({ Vec(0.0), { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
                               Vec(std::numeric_limits<double>::infinity()) },
    { { 0, 1, 2 }, { 0, 1, 3 } });
  const Blocks blocks = makeBlocks({ makeSphere(4), mesh });
  setName(blocks, 1, "tail");
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(blocks);
  render(studio.tracer);
  expectMessage(messages.warnings(), { "the first is cell 1 of input 0, block 2 (\"tail\")." });
}

// A partition usually has no name, but the set of partitions does.
TEST(BadBlocks, InheritTheirNames)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  vtkNew<vtkPartitionedDataSet> partitions;
  const Mesh wrong = makeSphere(4);
  wrong->GetPoints()->GetData()->SetNumberOfComponents(2);
  partitions->SetPartition(1, wrong);
  collection->SetPartitionedDataSet(0, partitions);
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "fin");
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(collection);
  studio.tracer->Update();
  expectMessage(messages.errors(), { "Input 0, block 3 (\"fin\"): " });
}
