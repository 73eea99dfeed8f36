// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The adapter for tests that were written for vtkTesting.

#include "ComparedImages.h"
#include "LambentRegressionTest.h"

#include "vtkImageCast.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

namespace fs = std::filesystem;

class RegressionTest : public testing::Test
{
protected:
  void SetUp() override
  {
    unsetenv("LAMBENT_UPDATE_BASELINES");
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = fs::path(LAMBENT_BUILD_DIR) / "Testing" / ("Regression test " + test);
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder / "valid");
    lambentRegression::write(grey(7, 5), this->Baseline());
  }
  void TearDown() override
  {
    unsetenv("LAMBENT_UPDATE_BASELINES");
    fs::remove_all(this->Folder);
  }

  std::string Baseline() const { return (this->Folder / "valid" / "square.png").string(); }

  template <typename Picture>
  int Run(Picture* picture, double tolerance = 0.0)
  {
    std::string words[] = { "test", "-D", "data", "-T", this->Folder.string(), "-V",
      this->Baseline() };
    char* argv[7];
    std::transform(std::begin(words), std::end(words), argv, [](std::string& w) { return &w[0]; });
    testing::internal::CaptureStdout();
    const int result = lambentRegressionTest(7, argv, picture, tolerance);
    this->Said = testing::internal::GetCapturedStdout();
    return result;
  }

  fs::path Folder;
  std::string Said;
};

TEST_F(RegressionTest, SamePicturePasses)
{
  EXPECT_EQ(this->Run(grey(7, 5).Get()), LambentPassed);
  EXPECT_EQ(this->Said, "all of 35 pixels are the same\n");
}

TEST_F(RegressionTest, AlgorithmIsUpdated)
{
  vtkNew<vtkImageCast> cast;
  cast->SetInputData(grey(7, 5));
  cast->SetOutputScalarTypeToUnsignedChar();
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(cast)), LambentPassed);
  cast->SetInputData(grey(7, 5, { { 1, 1, 1, 17 } }));
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(cast)), LambentFailed);
  vtkNew<vtkTrivialProducer> noPicture;
  noPicture->SetOutput(vtkNew<vtkPolyData>());
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(noPicture)), LambentFailed);
}

TEST_F(RegressionTest, DifferentPictureFailsAndIsLeftBehind)
{
  const auto picture = grey(7, 5, { { 5, 1, 0, 103 } });
  EXPECT_EQ(this->Run(picture.Get()), LambentFailed);
  EXPECT_EQ(this->Said.find("1 of 35 pixels differ"), 0u) << this->Said;
  const std::string file = "type=\"image/png\">" + this->Folder.string();
  for (const std::string& tag :
    { "\"TestImage\" " + file + "/square.png<", "\"ValidImage\" " + file + "/valid/square.png<",
      "\"DifferenceImage\" " + file + "/square.diff.png<",
      std::string("\"ImageError\" type=\"numeric/double\">3<") })
  {
    EXPECT_NE(this->Said.find(tag), std::string::npos) << tag << "\n" << this->Said;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((this->Folder / "square.png").string().c_str());
  reader->Update();
  EXPECT_TRUE(compare(reader->GetOutput(), picture)->GetPassed());
  EXPECT_EQ(this->Run(picture.Get(), 3.0), LambentPassed);
}

TEST_F(RegressionTest, MissingBaselineFailsAndCanBeAccepted)
{
  const auto picture = grey(7, 5, { { 5, 1, 0, 103 } });
  fs::remove_all(this->Folder / "valid");
  EXPECT_EQ(this->Run(picture.Get()), LambentFailed);
  EXPECT_NE(this->Said.find("There is no baseline"), std::string::npos) << this->Said;
  EXPECT_NE(this->Said.find("LAMBENT_UPDATE_BASELINES=1"), std::string::npos) << this->Said;
  EXPECT_TRUE(fs::exists(this->Folder / "square.png"));
  setenv("LAMBENT_UPDATE_BASELINES", "1", 1);
  EXPECT_EQ(this->Run(picture.Get()), LambentPassed);
  unsetenv("LAMBENT_UPDATE_BASELINES");
  EXPECT_EQ(this->Run(picture.Get()), LambentPassed);
}

TEST_F(RegressionTest, NothingToCompareWithIsNotRun)
{
  char name[] = "test";
  char* argv[] = { name };
  testing::internal::CaptureStdout();
  const int result = lambentRegressionTest(1, argv, grey(2, 2).Get());
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(result, LambentNotRun);
}
