// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A result is never older than the last request, whoever made it and whether or not it succeeded.

#include "ComparisonRequests.h"

#include "vtkJPEGReader.h"
#include "vtkJPEGWriter.h"
#include "vtkLambentPNGReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace
{

class ImageComparisonRequests : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkObject::GlobalWarningDisplayOff(); // the executives of all stages report failures
    this->Behind->SetInput(this->Picture);
    this->Comparison->SetInputConnection(0, this->Behind->GetOutputPort());
    this->Comparison->SetInputConnection(1, this->Baseline->GetOutputPort());
  }
  void TearDown() override { vtkObject::GlobalWarningDisplayOn(); }

  void ExpectNothing(const std::string& words = "")
  {
    EXPECT_FALSE(this->Comparison->GetPassed());
    EXPECT_TRUE(std::isnan(this->Comparison->GetMaximumDifference()));
    EXPECT_TRUE(std::isnan(this->Comparison->GetRootMeanSquare()));
    EXPECT_EQ(this->Comparison->GetNumberOfChangedPixels(), 0);
    EXPECT_EQ(this->Comparison->GetChangedExtent()[1], -1);
    const std::string message = this->Comparison->GetMessage();
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find("pixels"), std::string::npos) << message;
  }

  vtkNew<Stage> Picture, Behind, Baseline;
  vtkNew<vtkLambentImageComparison> Comparison;
};

TEST_F(ImageComparisonRequests, EachGivesAResult)
{
  for (const auto& [name, request] : requests())
  {
    SCOPED_TRACE(name);
    this->Picture->SetValue(0);
    request(this->Comparison);
    EXPECT_TRUE(this->Comparison->GetPassed()) << this->Comparison->GetMessage();
    this->Picture->SetValue(7);
    request(this->Comparison);
    EXPECT_FALSE(this->Comparison->GetPassed());
    EXPECT_EQ(this->Comparison->GetMaximumDifference(), 7.0);
    request(this->Comparison); // again, although nothing has changed
    EXPECT_EQ(this->Comparison->GetMaximumDifference(), 7.0);
  }
}

TEST_F(ImageComparisonRequests, AFailedInputLeavesNoResult)
{
  const std::pair<const char*, Stage*> stages[] = { { "the picture", this->Picture },
    { "behind the picture", this->Behind }, { "the baseline", this->Baseline } };
  for (const auto& [name, request] : requests())
  {
    for (const auto& [where, stage] : stages)
    {
      for (const int failure : { INFORMATION, DATA })
      {
        for (const int value : { 0, 7 }) // whether or not it passed before
        {
          SCOPED_TRACE(std::string(name) + ", pass " + std::to_string(failure) + ", " + where);
          this->Picture->SetValue(value);
          this->Comparison->Update();
          ASSERT_EQ(this->Comparison->GetPassed(), value == 0) << this->Comparison->GetMessage();
          stage->SetFailure(failure);
          request(this->Comparison);
          this->ExpectNothing();
          stage->SetFailure(NONE);
        }
      }
    }
  }
}

TEST_F(ImageComparisonRequests, AMissingOrWrongInputLeavesNoResult)
{
  vtkNew<vtkTrivialProducer> mesh, blocks;
  mesh->SetOutput(vtkNew<vtkPolyData>());
  vtkNew<vtkMultiBlockDataSet> twice; // block by block, only the last one would count
  twice->SetBlock(0, grey(4, 3, { { 1, 1, 1, 9 } }));
  twice->SetBlock(1, grey(4, 3));
  blocks->SetOutput(twice);
  for (const auto& [name, request] : requests())
  {
    for (vtkAlgorithm* wrong : { static_cast<vtkAlgorithm*>(nullptr),
           static_cast<vtkAlgorithm*>(mesh.Get()), static_cast<vtkAlgorithm*>(blocks.Get()) })
    {
      SCOPED_TRACE(name);
      this->Comparison->SetInputConnection(0, this->Behind->GetOutputPort());
      this->Comparison->Update();
      ASSERT_TRUE(this->Comparison->GetPassed());
      this->Comparison->SetInputConnection(0, wrong ? wrong->GetOutputPort() : nullptr);
      request(this->Comparison);
      this->ExpectNothing();
    }
  }
}

// The other input of a downstream filter fails, so the comparison is not asked for data.
TEST_F(ImageComparisonRequests, FailuresOfOtherInputsLeaveNoResult)
{
  vtkNew<Stage> other;
  vtkNew<Pair> pair;
  pair->SetInputConnection(0, other->GetOutputPort());
  pair->SetInputConnection(1, this->Comparison->GetOutputPort());
  pair->Update();
  ASSERT_TRUE(this->Comparison->GetPassed());
  other->SetFailure(INFORMATION);
  this->Picture->SetValue(7);
  pair->Update();
  this->ExpectNothing("nothing has been compared since an input or a setting changed");
}

TEST_F(ImageComparisonRequests, RequestsWithoutDataLeaveNoOldResult)
{
  const auto ask = [this](const char* name, const Request& request)
  {
    SCOPED_TRACE(name);
    this->Picture->SetValue(0);
    this->Comparison->Update();
    ASSERT_TRUE(this->Comparison->GetPassed());
    request(this->Comparison);
    EXPECT_TRUE(this->Comparison->GetPassed()) << "nothing has changed";
    this->Picture->SetValue(7);
    request(this->Comparison);
    this->ExpectNothing("nothing has been compared since an input or a setting changed");
  };
  ask("UpdateInformation()", [](vtkLambentImageComparison* c) { c->UpdateInformation(); });
  ask("UpdateData() alone",
    [](vtkLambentImageComparison* c) { Pipeline::SafeDownCast(c->GetExecutive())->UpdateData(0); });
}

TEST_F(ImageComparisonRequests, SettingsMatterToo)
{
  this->Picture->SetValue(7);
  this->Comparison->SetTolerance(8);
  this->Comparison->Update();
  ASSERT_TRUE(this->Comparison->GetPassed());
  this->Comparison->SetTolerance(6);
  this->Comparison->UpdateInformation();
  this->ExpectNothing();
  this->Comparison->Update();
  EXPECT_EQ(this->Comparison->GetMaximumDifference(), 7.0);
}

// The files of readers vanish. Only vtkXMLImageDataReader and vtkLambentPNGReader fail then. The
// JPEG reader sets an error code and passes on uninitialized memory.
template <typename Reader, typename Writer>
void expectNothingOfAVanishedFile(const std::string& name, vtkLambentImageComparison* comparison)
{
  const fs::path file = fs::path(LAMBENT_BUILD_DIR) / "Testing" / name;
  vtkNew<Reader> reader;
  reader->SetFileName(file.string().c_str());
  vtkNew<Stage> behind;
  behind->SetInput(reader);
  comparison->SetInputConnection(0, behind->GetOutputPort());
  for (const auto& [how, request] : requests())
  {
    SCOPED_TRACE(name + ", " + how);
    vtkNew<Writer> writer;
    writer->SetInputData(grey(4, 3));
    writer->SetFileName(file.string().c_str());
    writer->Write();
    reader->Modified();
    comparison->Update();
    ASSERT_TRUE(comparison->GetPassed()) << comparison->GetMessage();
    fs::remove(file);
    reader->Modified();
    request(comparison);
    EXPECT_FALSE(comparison->GetPassed());
    EXPECT_TRUE(std::isnan(comparison->GetMaximumDifference())) << comparison->GetMessage();
    comparison->SetTolerance(comparison->GetTolerance() + 1);
    comparison->Update(); // this compares again
    EXPECT_FALSE(comparison->GetPassed());
    EXPECT_TRUE(std::isnan(comparison->GetMaximumDifference())) << comparison->GetMessage();
  }
}

TEST_F(ImageComparisonRequests, FailedReadersLeaveNoResult)
{
  expectNothingOfAVanishedFile<vtkXMLImageDataReader, vtkXMLImageDataWriter>(
    "vanished.vti", this->Comparison);
  expectNothingOfAVanishedFile<vtkJPEGReader, vtkJPEGWriter>("vanished.jpg", this->Comparison);
  expectNothingOfAVanishedFile<vtkLambentPNGReader, vtkPNGWriter>("vanished.png", this->Comparison);
}

} // namespace
