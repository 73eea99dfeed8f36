// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Types of data objects and of normals that the port takes.
#include "Meshes.h"
#include "Messages.h"

#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"

// Otherwise the executive would make one picture per block.
TEST(InputTypes, CompositeDataGiveOnePicture)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSquare());
  blocks->SetBlock(1, makeSphere(6));
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(blocks);
  studio.tracer->Update();
  ASSERT_NE(vtkImageData::SafeDownCast(studio.tracer->GetOutputDataObject(0)), nullptr);
  EXPECT_GT(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(messages.errors().empty() && messages.warnings().empty());
}

// Composite data of no tree, and other data with cells, have no block that could be drawn.
TEST(InputTypes, AdaptiveMeshesAreLeftOutWithAWarning)
{
  vtkNew<vtkOverlappingAMR> meshes;
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(meshes);
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.at(16, 12), Studio::background());
  expectMessage(
    messages.warnings(), { "input 0, a vtkOverlappingAMR", "vtkCompositeDataGeometryFilter" });
  EXPECT_TRUE(messages.errors().empty());
}

TEST(InputTypes, IntegerNormalsAreUsed)
{
  const Mesh mesh = makeSquare();
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(mesh);
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkIntArray> integers;
  for (vtkDataArray* normals :
    { static_cast<vtkDataArray*>(floats), static_cast<vtkDataArray*>(integers) })
  {
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
    {
      normals->SetTuple3(k, 1.0, static_cast<double>(k), 2.0);
    }
  }
  mesh->GetPointData()->SetNormals(floats);
  const Picture expected = render(studio.tracer);
  mesh->GetPointData()->SetNormals(integers);
  EXPECT_SAME_BITS(render(studio.tracer), expected);
  EXPECT_TRUE(messages.errors().empty() && messages.warnings().empty());
}
