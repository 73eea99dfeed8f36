// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief all ways to request a comparison, and inputs that fail
 */
#ifndef ComparisonRequests_h
#define ComparisonRequests_h

#include "ComparedImages.h"

#include "vtkImageAlgorithm.h"
#include "vtkImageCast.h"
#include "vtkImageDataStreamer.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <functional>
#include <utility>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

enum Failure
{
  NONE,
  INFORMATION,
  DATA // VTK ignores a failure between these, at RequestUpdateExtent()
};

/// Makes a grey picture, or copies its input, and can fail in one of the passes.
class Stage : public vtkImageAlgorithm
{
public:
  static Stage* New();
  vtkTypeMacro(Stage, vtkImageAlgorithm)
  vtkSetMacro(Failure, int);
  vtkSetMacro(Value, int);
  void SetInput(vtkAlgorithm* source)
  {
    this->SetNumberOfInputPorts(1);
    this->SetInputConnection(source->GetOutputPort());
  }

protected:
  Stage() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const int extent[6] = { 0, 3, 0, 2, 0, 0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
    return this->Failure != INFORMATION;
  }
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const vtkSmartPointer<vtkImageData> own =
      this->Value == 0 ? grey(4, 3) : grey(4, 3, { { 1, 1, 1, 100 + this->Value } });
    const bool isFilter = this->GetNumberOfInputPorts() == 1;
    vtkImageData::GetData(outputs)->ShallowCopy(
      isFilter ? vtkImageData::GetData(inputs[0]) : own.Get());
    return this->Failure != DATA;
  }

private:
  int Failure = NONE;
  int Value = 0;
};
vtkStandardNewMacro(Stage);

/// Has two inputs and outputs the first.
class Pair : public vtkImageAlgorithm
{
public:
  static Pair* New();
  vtkTypeMacro(Pair, vtkImageAlgorithm)

protected:
  Pair() { this->SetNumberOfInputPorts(2); }
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkImageData::GetData(outputs)->ShallowCopy(vtkImageData::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(Pair);

using Request = std::function<void(vtkLambentImageComparison*)>;

/// All ways to request a comparison.
inline const std::vector<std::pair<const char*, Request>>& requests()
{
  static const int whole[6] = { 0, 3, 0, 2, 0, 0 }, part[6] = { 1, 2, 0, 1, 0, 0 };
  using Comparison = vtkLambentImageComparison;
  static const std::vector<std::pair<const char*, Request>> list = {
    { "Update()", [](Comparison* c) { c->Update(); } },
    { "Update(0)", [](Comparison* c) { c->Update(0); } },
    { "Update() with requests", [](Comparison* c) { c->Update(0, nullptr); } },
    { "UpdateWholeExtent()", [](Comparison* c) { c->UpdateWholeExtent(); } },
    { "UpdateExtent()", [](Comparison* c) { c->UpdateExtent(whole); } },
    { "UpdateExtent() of a part", [](Comparison* c) { c->UpdateExtent(part); } },
    { "UpdatePiece()", [](Comparison* c) { c->UpdatePiece(0, 1, 0); } },
    { "UpdatePiece() of two", [](Comparison* c) { c->UpdatePiece(1, 2, 0); } },
    { "UpdateTimeStep()", [](Comparison* c) { c->UpdateTimeStep(0.5); } },
    { "the executive", [](Comparison* c) { c->GetExecutive()->Update(); } },
    { "the executive, port 0", [](Comparison* c) { c->GetExecutive()->Update(0); } },
    { "the executive, whole extent",
      [](Comparison* c) { Pipeline::SafeDownCast(c->GetExecutive())->UpdateWholeExtent(); } },
    { "the executive in two steps",
      [](Comparison* c)
      {
        c->GetExecutive()->UpdateInformation();
        Pipeline::SafeDownCast(c->GetExecutive())->UpdateData(0);
      } },
    { "a filter",
      [](Comparison* c)
      {
        vtkNew<vtkImageCast> filter;
        filter->SetInputConnection(c->GetOutputPort());
        filter->Update();
      } },
    { "a filter behind a filter",
      [](Comparison* c)
      {
        vtkNew<vtkImageCast> first, second;
        first->SetInputConnection(c->GetOutputPort());
        second->SetInputConnection(first->GetOutputPort());
        second->UpdateWholeExtent();
      } },
    { "a streamer",
      [](Comparison* c)
      {
        vtkNew<vtkImageDataStreamer> streamer;
        streamer->SetNumberOfStreamDivisions(3);
        streamer->SetInputConnection(c->GetOutputPort());
        streamer->Update();
      } },
    { "a writer",
      [](Comparison* c)
      {
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputConnection(c->GetOutputPort());
        writer->WriteToMemoryOn();
        writer->Write();
      } },
  };
  return list;
}

} // namespace

#endif
