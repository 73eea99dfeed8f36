// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The comparison itself must be able to fail, on a single byte.

#include "ComparePictures.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace
{

namespace fs = std::filesystem;

class ComparePicturesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    unsetenv("LAMBENT_UPDATE_BASELINES");
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = fs::path(LAMBENT_BUILD_DIR) / "Testing" / ("Compare pictures " + test);
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }

  void TearDown() override
  {
    unsetenv("LAMBENT_UPDATE_BASELINES");
    fs::remove_all(this->Folder);
  }

  std::string Path(const char* name) const { return (this->Folder / name).string(); }

  /// A picture of one grey; the channel (x, y, c) is `value`.
  void Write(const char* name, int width, int height, int x, int y, int c, unsigned char value)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::memset(image->GetScalarPointer(), 100, 3 * width * height);
    static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[c] = value;
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->Path(name).c_str());
    writer->Write();
  }

  std::string Compare(const char* picture, const char* baseline) const
  {
    return ComparePictures(this->Path(picture), this->Path(baseline), this->Folder.string());
  }

  fs::path Folder;
};

TEST_F(ComparePicturesTest, SamePicturesPass)
{
  this->Write("picture.png", 7, 5, 0, 0, 0, 100);
  this->Write("baseline.png", 7, 5, 3, 2, 1, 100);
  EXPECT_EQ(this->Compare("picture.png", "baseline.png"), "");
}

TEST_F(ComparePicturesTest, OneByteThatDiffersByOneFailsAndIsShown)
{
  this->Write("picture.png", 7, 5, 6, 4, 2, 101);
  this->Write("baseline.png", 7, 5, 6, 4, 2, 100);
  const std::string problem = this->Compare("picture.png", "baseline.png");
  EXPECT_NE(problem.find("1 of 35 x 3 values differ"), std::string::npos) << problem;
  EXPECT_NE(problem.find(this->Path("baseline.difference.png")), std::string::npos) << problem;
  EXPECT_NE(problem.find("LAMBENT_UPDATE_BASELINES=1"), std::string::npos) << problem;

  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(this->Path("baseline.difference.png").c_str());
  reader->Update();
  vtkImageData* const strip = reader->GetOutput();
  ASSERT_EQ(strip->GetDimensions()[0], 3 * 7);
  ASSERT_EQ(strip->GetDimensions()[1], 5);
  EXPECT_EQ(strip->GetScalarComponentAsDouble(6, 4, 0, 2), 101);
  EXPECT_EQ(strip->GetScalarComponentAsDouble(7 + 6, 4, 0, 2), 100);
  for (int y = 0; y < 5; ++y)
  {
    for (int x = 0; x < 7; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const bool isTheOne = x == 6 && y == 4 && c == 2;
        EXPECT_EQ(strip->GetScalarComponentAsDouble(14 + x, y, 0, c), isTheOne ? 255 : 0);
      }
    }
  }
}

TEST_F(ComparePicturesTest, AnotherSizeFails)
{
  this->Write("picture.png", 7, 5, 0, 0, 0, 100);
  this->Write("baseline.png", 5, 7, 0, 0, 0, 100);
  const std::string problem = this->Compare("picture.png", "baseline.png");
  EXPECT_NE(problem.find("7 x 5"), std::string::npos) << problem;
  EXPECT_NE(problem.find("5 x 7"), std::string::npos) << problem;
}

TEST_F(ComparePicturesTest, MissingBaselineFailsAndSaysHowToAccept)
{
  this->Write("picture.png", 7, 5, 0, 0, 0, 100);
  const std::string problem = this->Compare("picture.png", "baseline.png");
  EXPECT_NE(problem.find("no PNG baseline"), std::string::npos) << problem;
  EXPECT_NE(problem.find(this->Path("baseline.png")), std::string::npos) << problem;
  EXPECT_NE(problem.find("LAMBENT_UPDATE_BASELINES=1"), std::string::npos) << problem;
}

TEST_F(ComparePicturesTest, MissingPictureFailsEvenWhenAccepting)
{
  this->Write("baseline.png", 7, 5, 0, 0, 0, 100);
  setenv("LAMBENT_UPDATE_BASELINES", "1", 1);
  const std::string problem = this->Compare("picture.png", "baseline.png");
  EXPECT_NE(problem.find("no PNG picture"), std::string::npos) << problem;
}

TEST_F(ComparePicturesTest, AcceptedPictureBecomesTheBaseline)
{
  this->Write("picture.png", 7, 5, 1, 1, 1, 17);
  this->Write("baseline.png", 7, 5, 0, 0, 0, 100);
  setenv("LAMBENT_UPDATE_BASELINES", "1", 1);
  EXPECT_EQ(this->Compare("picture.png", "baseline.png"), "");
  unsetenv("LAMBENT_UPDATE_BASELINES");
  EXPECT_EQ(this->Compare("picture.png", "baseline.png"), "");
}

} // namespace
