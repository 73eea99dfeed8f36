// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The single-file formats in the folder Formats, truncated and with flipped bits. Most of their
// readers crash on some of these; the command turns that into one line. TestFormats.py reads the
// whole files, and breaks those that have several parts.

#include "BrokenFiles.h"

#include "FileKinds.h"
#include "Formats.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadSurface.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

using namespace lambent::command;

namespace
{

/// The files that this build can read.
std::vector<File> MakeFormats()
{
  std::vector<File> files;
  for (const char* const name : { "tetrahedron.off", "tetrahedron.gii", "tetrahedron.msh",
         "box.msh", "tetrahedron.inp", "tetrahedron.gltf", "tetrahedron.glb", "tetrahedron.dae",
         "tetrahedron.amf", "tetrahedron.3mf", "tetrahedron.3ds", "tetrahedron.fbx", "box.vtr",
         "box.vts", "box.vti", "box.e", "image.vtk", "structured.vtk", "rectilinear.vtk" })
  {
    if (FindFormat(name)->read)
    {
      std::ifstream file(std::string(FORMATS_FOLDER "/") + name, std::ios::binary);
      files.push_back({ name, ExtensionOf(name), { std::istreambuf_iterator<char>(file), {} } });
    }
  }
  return files;
}

/// Whether one of Lambent's own readers reads the file, in this process, which takes little time.
bool IsFast(const std::string& path)
{
  const Format& format = *FindFormat(path);
  return format.kind == MeshKind::Other && format.trust == Trust::Checked;
}

/// The coordinates and the number of polygons.
Content ReadFormat(const Scratch& scratch, const std::string& bytes)
{
  scratch.write(bytes);
  VtkMessages messages(true);
  Content content;
  try
  {
    Progress progress(false);
    const auto contour = // the files of fast readers have no arrays
      IsFast(scratch.path) ? std::nullopt : std::optional(ContourValue{ 0.75, "x" });
    const auto mesh = ReadSurface(scratch.path, messages, progress, contour);
    for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
    {
      const double* const point = mesh->GetPoint(k);
      content.values.insert(content.values.end(), point, point + 3);
    }
    content.values.push_back(static_cast<double>(mesh->GetNumberOfPolys()));
    for (const std::string& warning : messages.TakeWarnings())
    {
      if (warning.find("--contour") == std::string::npos) // polygons cause this warning
      {
        content.warnings += warning;
      }
    }
  }
  catch (const Failure& failure)
  {
    content.failure = failure.what();
    EXPECT_EQ(content.failure.rfind("cannot read '" + scratch.path + "': ", 0), 0u);
    EXPECT_EQ(content.failure.find('\n'), std::string::npos) << content.failure;
  }
  return content;
}

/// Tries every cut near the end, where little is missing, and some before. For fast readers, tries
/// all cuts.
bool IsTried(const File& file, std::size_t size)
{
  return IsFast(file.name) || size + 20 > file.bytes.size() ||
    size % (1 + file.bytes.size() / 50) == 0;
}

/// In text, the last line need not end, and half of the number at its end is another number. An
/// Abaqus file may end after any line of its elements.
bool MayEndThere(const File& file, std::size_t size)
{
  return (file.extension == ".off" && size > file.bytes.find_last_of(' ')) ||
    (file.extension == ".inp" && size > file.bytes.find("*Element"));
}

} // namespace

TEST(BrokenFormats, CutShort)
{
  for (const File& file : MakeFormats())
  {
    SCOPED_TRACE(file.name);
    const Scratch scratch(file.extension);
    const Content whole = ReadFormat(scratch, file.bytes);
    ASSERT_EQ(whole.failure, "");
    ASSERT_EQ(whole.warnings, "");
    for (std::size_t size = 0; size < file.bytes.size(); ++size)
    {
      if (!IsTried(file, size))
      {
        continue;
      }
      const Content cut = ReadFormat(scratch, file.bytes.substr(0, size));
      if (cut.failure.empty() && cut.values != whole.values && !MayEndThere(file, size))
      {
        EXPECT_NE(cut.warnings.find("incomplete"), std::string::npos) << size << " bytes";
      }
    }
  }
}

TEST(BrokenFormats, WithAFlippedBit)
{
  for (const File& file : MakeFormats())
  {
    SCOPED_TRACE(file.name);
    const Scratch scratch(file.extension);
    std::size_t failures = 0;
    const std::size_t bits = 8 * file.bytes.size();
    for (std::size_t bit = 0; bit < bits; bit += 1 + bits / (IsFast(file.name) ? 2000 : 100))
    {
      std::string bytes = file.bytes;
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
      failures += !ReadFormat(scratch, bytes).failure.empty();
    }
    EXPECT_GT(failures, 0u);
  }
}
