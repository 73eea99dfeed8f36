// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BrokenFiles.h"

#include "../Rendering/Sanitizers.h"
#include "FileKinds.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadPicture.h"
#include "ReadSurface.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLambentRayTracer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <unistd.h>

#if LAMBENT_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

using namespace lambent::command;

namespace
{

/// The values of a mesh, which must also be possible to render.
std::vector<double> ValuesOf(vtkPolyData* mesh)
{
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetImageSize(4, 4);
  tracer->SetInputData(mesh);
  tracer->Update();
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(mesh->GetPointData()->GetArray(i)->GetNumberOfTuples(), mesh->GetNumberOfPoints());
  }
  std::vector<double> values;
  for (vtkCellArray* const cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      values.push_back(static_cast<double>(ids->GetNumberOfIds()));
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        const double* const point = mesh->GetPoint(ids->GetId(k));
        values.insert(values.end(), point, point + 3);
      }
    }
  }
  return values;
}

std::vector<double> ValuesOf(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType k = 0; k < scalars->GetNumberOfValues(); ++k)
  {
    const int components = scalars->GetNumberOfComponents();
    values.push_back(scalars->GetComponent(k / components, static_cast<int>(k % components)));
  }
  return values;
}

} // namespace

Scratch::Scratch(const std::string& extension)
  : path("TestBrokenFiles-" + std::to_string(getpid()) + extension)
{
}

Scratch::~Scratch()
{
  std::remove(this->path.c_str());
}

std::string Scratch::read() const
{
  std::ifstream file(this->path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

void Scratch::write(const std::string& bytes) const
{
  std::ofstream(this->path, std::ios::binary | std::ios::trunc) << bytes;
}

Content Read(const Scratch& scratch, const std::string& bytes)
{
  scratch.write(bytes);
#if LAMBENT_ADDRESS_SANITIZER
  // VTK 9.1's reader of grids leaks its arrays if a file is broken.
  const __lsan::ScopedDisabler isTolerated;
#endif
  VtkMessages messages(true);
  Content content;
  try
  {
    Progress progress(false);
    content.values = PictureKindOf(scratch.path)
      ? ValuesOf(ReadPicture(scratch.path, messages))
      : ValuesOf(ReadSurface(scratch.path, messages, progress));
    testing::internal::CaptureStderr();
    messages.FlushWarnings("");
    content.warnings = testing::internal::GetCapturedStderr();
  }
  catch (const Failure& failure)
  {
    content.failure = failure.what();
  }
  return content;
}
