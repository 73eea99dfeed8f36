// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadThroughVtk.h"
#include "CheckedReader.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace lambent::command
{
namespace
{

const char* const Advice = "; check that the file is complete and has the right extension";

void ThrowErrors(vtkAlgorithm* reader, VtkMessages& messages)
{
  const auto* const checked = dynamic_cast<const CheckedReader*>(reader);
  if (checked && !checked->GetFailure().empty())
  {
    throw Failure(checked->GetFailure());
  }
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error + Advice);
  }
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(
      vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()) + std::string(Advice));
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* reader, VtkMessages& messages, Progress& progress)
{
  progress.Follow(reader);
  reader->Update();
  ThrowErrors(reader, messages);
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> RunAtFirstTime(
  vtkAlgorithm* reader, VtkMessages& messages, Progress& progress)
{
  progress.Follow(reader);
  reader->UpdateInformation();
  ThrowErrors(reader, messages);
  vtkInformation* const information = reader->GetOutputInformation(0);
  const auto steps = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (information->Has(steps) && information->Length(steps) > 0)
  {
    reader->UpdateTimeStep(information->Get(steps, 0));
  }
  return Run(reader, messages, progress);
}

} // namespace lambent::command
