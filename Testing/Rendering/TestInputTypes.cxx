// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Types of data objects and of normals that the port takes or refuses.
#include "Meshes.h"
#include "Messages.h"

#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"

// Otherwise the executive would make one picture per block.
TEST(InputTypes, CompositeDataAreRefused)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSquare());
  blocks->SetBlock(1, makeSphere(6));
  for (int connection : { 0, 1 })
  {
    Studio studio;
    Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSquare());
    const Picture expected = render(studio.tracer);
    studio.tracer->RemoveAllInputConnections(0);
    for (int k = 0; k < connection; ++k)
    {
      studio.tracer->AddInputDataObject(makeSquare());
    }
    studio.tracer->AddInputDataObject(blocks);
    studio.tracer->Update();
    expectMessage(messages.errors(),
      { "Input " + std::to_string(connection) + " is a vtkMultiBlockDataSet",
        "vtkPolyData is required", "vtkCompositeDataGeometryFilter" });
    ASSERT_NE(vtkImageData::SafeDownCast(studio.tracer->GetOutputDataObject(0)), nullptr);
    EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
    messages.clear();
    studio.tracer->ResetCamera();
    expectMessage(messages.errors(), { "vtkCompositeDataGeometryFilter" });

    messages.clear();
    studio.tracer->SetInputData(makeSquare());
    EXPECT_SAME_BITS(render(studio.tracer), expected);
    EXPECT_TRUE(messages.errors().empty());
  }
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
