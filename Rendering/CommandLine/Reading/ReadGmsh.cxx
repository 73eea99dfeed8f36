// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads Gmsh's native format, versions 2 and 4.1, text or binary. A file consists of sections
// between $Name and $EndName, of which $MeshFormat, $Nodes and $Elements are used. Points and lines
// are skipped; higher-order elements are reduced to their corners. Reference: Gmsh manual, "MSH
// file format" and "MSH file format version 2 (Legacy)".

#include "FileBytes.h"
#include "GmshElements.h"
#include "Messages.h"
#include "MshCursor.h"
#include "NumberedMesh.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <vector>

namespace lambent::command
{
namespace
{

class MshReader
{
public:
  MshReader(const FileBytes& file, Progress& progress)
    : Cursor(file)
    , Update(progress)
  {
  }

  vtkSmartPointer<vtkPointSet> Read()
  {
    this->TakeFormat();
    bool hasNodes = false, hasElements = false;
    for (std::string name = this->Cursor.TakeSection(); !name.empty();
         name = this->Cursor.TakeSection())
    {
      if (name == "Nodes")
      {
        this->IsVersion2 ? this->TakeNodes2() : this->TakeNodes4();
        this->Cursor.EndSection(name);
        hasNodes = true;
      }
      else if (name == "Elements")
      {
        TakeGmshElements(this->Cursor, this->IsVersion2, this->Mesh, this->Update);
        this->Cursor.EndSection(name);
        hasElements = true;
      }
      else
      {
        this->Cursor.SkipSection(name);
      }
    }
    if (!hasNodes || !hasElements)
    {
      this->Cursor.Fail(hasNodes ? "there is no section $Elements" : "there is no section $Nodes");
    }
    return this->Mesh.MakeData();
  }

private:
  void TakeFormat()
  {
    if (this->Cursor.TakeSection() != "MeshFormat")
    {
      throw Failure(
        "it does not begin with $MeshFormat, as Gmsh files do; convert other .msh files "
        "with meshio");
    }
    const double version = this->Cursor.TakeTextNumber("the version");
    const std::int64_t isBinary = this->Cursor.TakeTextInt("the kind of file");
    const std::int64_t size = this->Cursor.TakeTextInt("the size of numbers");
    this->IsVersion2 = version >= 2 && version < 3;
    if (!this->IsVersion2 && version != 4.1)
    {
      throw Failure("its version of the format is neither 2 nor 4.1; save it again with Gmsh's "
                    "-format msh41");
    }
    if (isBinary < 0 || isBinary > 1 || size != 8)
    {
      this->Cursor.Fail("its format is neither text nor binary with numbers of 8 bytes");
    }
    if (isBinary == 1)
    {
      this->TakeByteOrder();
    }
    this->Cursor.EndSection("MeshFormat");
  }

  void TakeByteOrder()
  {
    this->Cursor.SkipLine();
    this->Cursor.SetBinary(false);
    const std::int64_t one = this->Cursor.TakeInt("the number that shows the byte order");
    if (one != 1 && one != 1 << 24)
    {
      this->Cursor.Fail("the number that shows the byte order is not 1");
    }
    this->Cursor.SetBinary(one != 1);
  }

  void TakeCoordinates(double coordinates[3])
  {
    std::generate_n(
      coordinates, 3, [this]() { return this->Cursor.TakeNumber("a coordinate of a node"); });
  }

  void Show(std::int64_t item)
  {
    if (item % 8192 == 0)
    {
      this->Update.Update(this->Cursor.Fraction());
    }
  }

  void TakeNodes2()
  {
    const std::int64_t count = this->Cursor.TakeLineCount("the number of nodes");
    for (std::int64_t node = 0; node < count; ++node)
    {
      const std::int64_t number = this->Cursor.TakeInt("the number of a node");
      double coordinates[3];
      this->TakeCoordinates(coordinates);
      this->Mesh.AddNode(number, coordinates);
      this->Show(node);
    }
  }

  void TakeNodes4()
  {
    const std::int64_t blocks = this->Cursor.TakeCount("the number of blocks of nodes");
    const std::int64_t count = this->Cursor.TakeCount("the number of nodes");
    this->Cursor.TakeCount("the smallest number of a node");
    this->Cursor.TakeCount("the largest number of a node");
    std::int64_t taken = 0;
    for (std::int64_t block = 0; block < blocks; ++block)
    {
      taken += this->TakeNodeBlock();
    }
    if (taken != count)
    {
      this->Cursor.Fail(
        "its blocks have " + std::to_string(taken) + " nodes instead of " + std::to_string(count));
    }
  }

  std::int64_t TakeNodeBlock()
  {
    const std::int64_t dimension = this->Cursor.TakeInt("the dimension of a block of nodes");
    this->Cursor.TakeInt("the number of an entity");
    const std::int64_t hasParameters = this->Cursor.TakeInt("whether nodes have parameters");
    const std::int64_t count = this->Cursor.TakeCount("the number of nodes of a block");
    if (dimension < 0 || dimension > 3 || hasParameters < 0 || hasParameters > 1)
    {
      this->Cursor.Fail("the dimension or the parameter flag of a block of nodes is invalid");
    }
    std::vector<std::int64_t> numbers;
    for (std::int64_t node = 0; node < count; ++node)
    {
      numbers.push_back(this->Cursor.TakeSize("the number of a node"));
    }
    for (const std::int64_t number : numbers)
    {
      double coordinates[3];
      this->TakeCoordinates(coordinates);
      for (std::int64_t k = 0; k < dimension * hasParameters; ++k)
      {
        this->Cursor.TakeNumber("a parameter of a node");
      }
      this->Mesh.AddNode(number, coordinates);
    }
    this->Update.Update(this->Cursor.Fraction());
    return count;
  }

  MshCursor Cursor;
  Progress& Update;
  bool IsVersion2 = false;
  NumberedMesh Mesh{ false };
};

} // namespace

vtkSmartPointer<vtkDataObject> ReadGmsh(const std::string& path, VtkMessages&, Progress& progress)
{
  const FileBytes file(path);
  const char* const first = std::find_if(
    file.begin(), file.end(), [](char c) { return c != ' ' && c != '\r' && c != '\n'; });
  if (first != file.end() && *first == '(')
  {
    throw Failure("it is an ANSYS Fluent mesh, not a Gmsh one; convert it with meshio to .vtu");
  }
  return MshReader(file, progress).Read();
}

} // namespace lambent::command
