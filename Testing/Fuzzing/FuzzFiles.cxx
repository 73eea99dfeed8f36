// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// What the command reads by itself: PLY files. A Failure, or a sound mesh.
#include "FuzzInput.h"

#include "Messages.h"
#include "ReadPly.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <memory>
#include <string>

using namespace lambent::command;

namespace
{
/// A file without a name that is gone when it is closed.
class NamelessFile
{
public:
  NamelessFile(const std::uint8_t* data, std::size_t size)
  {
    require(this->File && std::fwrite(data, 1, size, this->File.get()) == size &&
        std::fflush(this->File.get()) == 0,
      "a temporary file can be written");
  }

  std::string path() const { return "/dev/fd/" + std::to_string(fileno(this->File.get())); }

private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File{ std::tmpfile(), std::fclose };
};

void check(vtkPolyData* mesh)
{
  vtkCellArray* polygons = mesh->GetPolys();
  require(mesh->GetPoints() && mesh->GetPoints()->GetData()->GetNumberOfComponents() == 3,
    "there are points");
  vtkDataArray* offsets = polygons->GetOffsetsArray();
  double before = 0;
  for (vtkIdType k = 0; k < offsets->GetNumberOfTuples(); ++k)
  {
    const double offset = offsets->GetTuple1(k);
    require(offset >= before && offset <= polygons->GetNumberOfConnectivityIds(),
      "offsets increase up to the end");
    before = offset;
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff(); // of texts whose last line is not ended, as most are here
  const NamelessFile file(data, size);
  try
  {
    check(ReadPly(file.path(), [](double) {}));
  }
  catch (const Failure& failure)
  {
    require(*failure.what() != '\0', "a failure says why");
  }
  return 0;
}
