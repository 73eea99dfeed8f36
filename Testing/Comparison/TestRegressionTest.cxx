// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The adapter for tests written for vtkTesting.

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
    return this->Run(picture, tolerance, this->Folder.string(), this->Baseline());
  }

  template <typename Picture>
  int Run(
    Picture* picture, double tolerance, const std::string& folder, const std::string& baseline)
  {
    std::string words[] = { "test", "-D", "data", "-T", folder, "-V", baseline };
    char* argv[7];
    std::transform(std::begin(words), std::end(words), argv, [](std::string& w) { return &w[0]; });
    testing::internal::CaptureStdout();
    const int result = lambentRegressionTest(7, argv, picture, tolerance);
    this->Said = testing::internal::GetCapturedStdout();
    return result;
  }

  void Update() { setenv("LAMBENT_UPDATE_BASELINES", "1", 1); }

  /// Expects that the test fails twice with this message, and that the baseline is unchanged.
  void ExpectBaselineIsKept(const std::string& folder, const std::string& baseline)
  {
    const auto picture = grey(7, 5, { { 5, 1, 0, 103 } });
    for (int run = 0; run < 2; ++run)
    {
      EXPECT_EQ(this->Run(picture.Get(), 0.0, folder, baseline), LambentFailed) << this->Said;
      EXPECT_EQ(this->Said.find("1 of 35 pixels differ"), 0u) << this->Said;
      EXPECT_NE(this->Said.find("is not written"), std::string::npos) << this->Said;
      EXPECT_EQ(this->Said.find("TestImage"), std::string::npos) << this->Said;
    }
    EXPECT_EQ(this->Run(grey(7, 5).Get(), 0.0, folder, baseline), LambentPassed) << this->Said;
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

TEST_F(RegressionTest, DifferentPictureFailsAndIsWritten)
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

TEST_F(RegressionTest, WithoutABaselineNothingIsRun)
{
  char name[] = "test";
  char* argv[] = { name };
  testing::internal::CaptureStdout();
  const int result = lambentRegressionTest(1, argv, grey(2, 2).Get());
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(result, LambentNotRun);
}

TEST_F(RegressionTest, FolderOfTheBaselineIsNotWrittenTo)
{
  const std::string valid = (this->Folder / "valid").string();
  fs::create_directory_symlink(valid, this->Folder / "link");
  for (const std::string& folder :
    { valid, valid + "/", valid + "/../valid/.", (this->Folder / "link").string() })
  {
    SCOPED_TRACE(folder);
    this->ExpectBaselineIsKept(folder, this->Baseline());
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(valid), fs::directory_iterator()), 1);
}

// Without -T, pictures go to the current folder.
TEST_F(RegressionTest, CurrentFolderMayBeThatOfTheBaseline)
{
  const fs::path before = fs::current_path();
  fs::current_path(this->Folder / "valid");
  this->ExpectBaselineIsKept("", "square.png");
  this->ExpectBaselineIsKept(".", "./square.png");
  fs::current_path(before);
}

TEST_F(RegressionTest, LinksToTheBaselineAreNotWrittenThrough)
{
  fs::create_symlink(this->Baseline(), this->Folder / "square.png");
  this->ExpectBaselineIsKept(this->Folder.string(), this->Baseline());
  fs::remove(this->Folder / "square.png");
  fs::create_hard_link(this->Baseline(), this->Folder / "square.png");
  this->ExpectBaselineIsKept(this->Folder.string(), this->Baseline());
  fs::remove(this->Folder / "square.png");
  // The baseline is a link, and its target has the name of the picture.
  fs::rename(this->Baseline(), this->Folder / "square.png");
  fs::create_symlink("../square.png", this->Baseline());
  this->ExpectBaselineIsKept(this->Folder.string(), this->Baseline());
}

TEST_F(RegressionTest, OnlyWrittenPicturesAreAccepted)
{
  this->Update();
  const auto refuse =
    [this](vtkImageData* picture, const std::string& baseline, const std::string& words)
  {
    SCOPED_TRACE(baseline);
    EXPECT_EQ(this->Run(picture, 0.0, this->Folder.string(), baseline), LambentFailed);
    EXPECT_NE(this->Said.find("cannot become the baseline"), std::string::npos) << this->Said;
    EXPECT_NE(this->Said.find(words), std::string::npos) << this->Said;
    EXPECT_EQ(this->Said.find("accepted"), std::string::npos) << this->Said;
  };
  const auto picture = grey(7, 5, { { 5, 1, 0, 103 } });
  fs::create_directories(this->Folder / "folder.png");
  std::ofstream(this->Folder / "file") << "not a folder";
  refuse(values<float>(7, 5, 3), this->Baseline(), "3 of float");
  refuse(values<float>(7, 5, 3), (this->Folder / "new.png").string(), "3 of float");
  refuse(values<unsigned char>(7, 5, 5), this->Baseline(), "5 of unsigned char");
  refuse(vtkNew<vtkImageData>(), this->Baseline(), "it is empty");
  refuse(picture, (this->Folder / "folder.png").string(), "not a regular file");
  refuse(picture, "/dev/full", "not a regular file");
  refuse(picture, "/proc/x/a.png", "cannot be written to");
  refuse(picture, (this->Folder / "file" / "a.png").string(), "");
  refuse(picture, (this->Folder / std::string(300, 'n')).string() + ".png", "");
  unsetenv("LAMBENT_UPDATE_BASELINES");
  EXPECT_EQ(this->Run(grey(7, 5).Get()), LambentPassed) << "the baseline is as it was";
  EXPECT_FALSE(fs::exists(this->Folder / "new.png"));
}

TEST_F(RegressionTest, ImpossibleBaselinesFail)
{
  for (const std::string& baseline :
    { std::string("/proc/x/a.png"), this->Folder.string(), std::string("/dev/null"),
      (this->Folder / std::string(300, 'n')).string(), std::string("/") })
  {
    SCOPED_TRACE(baseline);
    EXPECT_EQ(this->Run(grey(7, 5).Get(), 0.0, this->Folder.string(), baseline), LambentFailed);
    EXPECT_EQ(this->Said.find("are the same"), std::string::npos) << this->Said;
  }
}

TEST_F(RegressionTest, CutBaselineFailsAndCanBeReplaced)
{
  const auto size = fs::file_size(this->Baseline());
  fs::resize_file(this->Baseline(), size - 20);
  EXPECT_EQ(this->Run(grey(7, 5).Get()), LambentFailed);
  EXPECT_EQ(this->Said.find("The baseline '" + this->Baseline() +
              "' cannot be read: it is not a complete PNG file\n"),
    0u)
    << this->Said;
  EXPECT_NE(this->Said.find("accept it"), std::string::npos) << this->Said;
  this->Update();
  EXPECT_EQ(this->Run(grey(7, 5).Get()), LambentPassed) << this->Said;
  EXPECT_EQ(fs::file_size(this->Baseline()), size);
}

TEST_F(RegressionTest, UpdatingFollowsLinks)
{
  fs::rename(this->Baseline(), this->Folder / "kept.png");
  fs::create_symlink("../kept.png", this->Baseline());
  this->Update();
  EXPECT_EQ(this->Run(grey(7, 5, { { 5, 1, 0, 103 } }).Get()), LambentPassed) << this->Said;
  EXPECT_TRUE(fs::is_symlink(this->Baseline()));
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName((this->Folder / "kept.png").string().c_str());
  ASSERT_TRUE(reader->Read());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(5, 1, 0, 0), 103.0);
}

TEST_F(RegressionTest, PicturesThatCannotBeWrittenAreNotNamed)
{
  EXPECT_EQ(this->Run(grey(7, 5, { { 5, 1, 0, 103 } }).Get(), 0.0, "/proc/x", this->Baseline()),
    LambentFailed);
  EXPECT_NE(this->Said.find("'/proc/x/square.png' is not written"), std::string::npos)
    << this->Said;
  EXPECT_EQ(this->Said.find("TestImage"), std::string::npos) << this->Said;
  EXPECT_NE(this->Said.find("ImageError"), std::string::npos) << this->Said;
  EXPECT_EQ(this->Run(values<float>(7, 5, 3).Get()), LambentFailed);
  EXPECT_NE(this->Said.find("is not written: a PNG file holds"), std::string::npos) << this->Said;
  EXPECT_EQ(this->Said.find("accept"), std::string::npos) << this->Said;
}

TEST_F(RegressionTest, NoPictureFails)
{
  this->Update();
  EXPECT_EQ(this->Run(static_cast<vtkImageData*>(nullptr)), LambentFailed);
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(nullptr)), LambentFailed);
  vtkNew<vtkPNGWriter> noOutput;
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(noOutput)), LambentFailed);
}

// The last picture equals the baseline, but it cannot be rendered again.
TEST_F(RegressionTest, FailedAlgorithmsHaveNothingToCompare)
{
  vtkNew<vtkLambentPNGReader> source;
  source->SetFileName(this->Baseline().c_str());
  vtkNew<vtkImageCast> cast;
  cast->SetOutputScalarTypeToUnsignedChar();
  cast->SetInputConnection(source->GetOutputPort());
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(cast)), LambentPassed);
  source->SetFileName("none.png");
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_EQ(this->Run(static_cast<vtkAlgorithm*>(cast)), LambentFailed);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_NE(this->Said.find("vtkImageCast could not be updated"), std::string::npos) << this->Said;
}
