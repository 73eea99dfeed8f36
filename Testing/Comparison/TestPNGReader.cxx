// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reader of baselines gives vtkPNGReader's result for valid files
// (Testing/Python/TestPNGReader.py tests all kinds), and a message for all others.

#include "ComparedImages.h"

#include "../Rendering/Messages.h"

#include "vtkErrorCode.h"
#include "vtkLambentPNGReader.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace
{

class PNGReader : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!vtkLambentPNGReader::IsAvailable())
    {
      GTEST_SKIP() << "without VTK::png";
    }
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Path = fs::path(LAMBENT_BUILD_DIR) / "Testing" / ("png reader " + test + ".png");
  }
  void TearDown() override { fs::remove(this->Path); }

  static std::string Bytes(vtkImageData* image)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->AddText("Title", "a square");
    writer->WriteToMemoryOn();
    writer->Write();
    const auto* bytes = reinterpret_cast<const char*>(writer->GetResult()->GetPointer(0));
    return std::string(bytes, static_cast<std::size_t>(writer->GetResult()->GetNumberOfValues()));
  }

  /// The reader's message about a file with these bytes.
  std::string Problem(const std::string& bytes)
  {
    std::ofstream(this->Path, std::ios::binary) << bytes;
    vtkNew<vtkLambentPNGReader> reader;
    reader->SetFileName(this->Path.string().c_str());
    const bool isRead = reader->Read();
    const std::string message = reader->GetMessage();
    EXPECT_EQ(isRead, message.empty());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }

  fs::path Path;
};

TEST_F(PNGReader, EqualsVtkPNGReader)
{
  for (const auto& image :
    { grey(7, 5, { { 1, 2, 0, 9 }, { 6, 4, 2, 8 } }),
      values<unsigned char>(3, 2, 1, { 1, 2, 3, 4, 5 }), values<unsigned char>(1, 1, 2, { 7, 8 }),
      values<unsigned char>(2, 2, 4, { 1, 2, 3, 4, 5 }),
      values<unsigned short>(2, 2, 3, { 1, 256, 65535, 770 }),
      values<unsigned short>(3, 1, 1, { 1, 256, 65535 }) })
  {
    ASSERT_EQ(this->Problem(Bytes(image)), "");
    vtkNew<vtkLambentPNGReader> reader;
    reader->SetFileName(this->Path.string().c_str());
    reader->Update();
    vtkNew<vtkPNGReader> other;
    other->SetFileName(this->Path.string().c_str());
    other->Update();
    EXPECT_TRUE(compare(reader->GetOutput(), image)->GetPassed());
    EXPECT_TRUE(compare(reader->GetOutput(), other->GetOutput())->GetPassed());
    EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "PNGImage");
    EXPECT_STREQ(reader->GetText("Title"), "a square");
    EXPECT_EQ(reader->GetText("title"), nullptr);
    EXPECT_EQ(reader->GetText(nullptr), nullptr);
  }
}

TEST_F(PNGReader, CutAfterEachByteOrWithAChangedByte)
{
  const std::string whole = Bytes(grey(7, 5));
  for (std::size_t size = 0; size < whole.size(); ++size)
  {
    const std::string problem = this->Problem(whole.substr(0, size));
    EXPECT_EQ(problem,
      size == 0    ? "it is empty, so it is not a PNG file"
        : size < 8 ? "it is not a PNG file"
                   : "it is not a complete PNG file")
      << size;
    std::string changed = whole;
    changed[size] = static_cast<char>(changed[size] ^ 0x20);
    EXPECT_NE(this->Problem(changed), "") << size;
  }
  EXPECT_EQ(this->Problem(whole + "and more"), "");
}

TEST_F(PNGReader, MissingAndSpecialFiles)
{
  vtkNew<vtkLambentPNGReader> reader;
  EXPECT_FALSE(reader->Read());
  EXPECT_STREQ(reader->GetMessage(), "there is no file name; call SetFileName()");
  const std::pair<const char*, const char*> cases[] = { { "/no/such.png",
                                                          "there is no such file; check its name" },
    { LAMBENT_BUILD_DIR, "it is a folder; name a file in it" },
    { "/dev/null", "it is not a regular file; copy it to one" } };
  for (const auto& [path, problem] : cases)
  {
    reader->SetFileName(path);
    EXPECT_FALSE(reader->Read());
    EXPECT_STREQ(reader->GetMessage(), problem);
  }
}

TEST_F(PNGReader, UpdateReportsAnErrorAndEmptiesTheOutput)
{
  vtkNew<vtkLambentPNGReader> reader;
  ASSERT_EQ(this->Problem(Bytes(grey(7, 5))), "");
  reader->SetFileName(this->Path.string().c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 35);
  ASSERT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Problem("something else"), "it is not a PNG file");
  reader->Modified();
  const Messages messages(reader);
  reader->Update();
  expectMessage(
    messages.errors(), { "'" + this->Path.string() + "' cannot be read: it is not a PNG file" });
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError);
}

TEST_F(PNGReader, ReadReadsAgainAndUpdateUsesTheResult)
{
  ASSERT_EQ(this->Problem(Bytes(grey(7, 5))), "");
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName(this->Path.string().c_str());
  reader->Update();
  std::ofstream(this->Path, std::ios::binary) << Bytes(grey(3, 2));
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 35); // Update() does not check the file
  ASSERT_TRUE(reader->Read());
  fs::remove(this->Path);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 6);
}

// A header may claim more pixels than the file can hold; that memory must not be allocated.
TEST_F(PNGReader, PixelsThatDoNotFitInTheFile)
{
  std::string huge = Bytes(grey(7, 5));
  const std::string header("\x00\x0f\x00\x00\x00\x0f\x00\x00", 8); // 983040 x 983040
  huge.replace(16, 8, header);
  EXPECT_EQ(this->Problem(huge), "the file is damaged: a check sum is wrong");
  huge.replace(29, 4, "\x1f\x5d\x66\x98");
  EXPECT_EQ(
    this->Problem(huge), "the file is damaged: it is too short for its 983040 x 983040 pixels");
}

TEST_F(PNGReader, PrintSelfIsComplete)
{
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName("some.png");
  std::ostringstream text;
  reader->Print(text);
  EXPECT_NE(text.str().find("FileName: some.png\n"), std::string::npos);
  EXPECT_NE(text.str().find("Message: no file has been read yet\n"), std::string::npos);
}

} // namespace
