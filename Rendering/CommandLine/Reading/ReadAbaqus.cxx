// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads *NODE and *ELEMENT, in parts or not, from Abaqus input files, which other programs write
// too. Rejects keywords that create or move nodes or elements in other ways, because the mesh would
// be incomplete. Skips all other keywords. Reference: Abaqus Keywords Reference Guide.

#include "AbaqusTypes.h"
#include "FileBytes.h"
#include "InpLines.h"
#include "Messages.h"
#include "NumberedMesh.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkObject.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <iterator>

namespace lambent::command
{
namespace
{

/// Keywords that create nodes or elements from others, or move them.
const char* const Refused[] = { "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM" };

class AbaqusReader
{
public:
  AbaqusReader(const FileBytes& file, Progress& progress)
    : Lines(file)
    , Update(progress)
  {
  }

  vtkSmartPointer<vtkPointSet> Read()
  {
    for (std::size_t line = 0; this->Lines.Next(); ++line)
    {
      if (line == 0 && !this->Lines.IsKeyword())
      {
        this->ThrowOther();
      }
      this->Lines.IsKeyword() ? this->TakeKeyword() : this->TakeData();
      if (line % 8192 == 0)
      {
        this->Update.Update(this->Lines.Fraction());
      }
    }
    this->EndElement();
    if (!this->HasElements)
    {
      throw Failure("it has no elements (*ELEMENT); check that the file is complete and has the "
                    "right extension");
    }
    this->Warn();
    return this->Mesh.MakeData();
  }

private:
  enum class Data
  {
    Other,
    Nodes,
    Elements,
    UnknownElements,
    Instance
  };

  /// Fails for a file that does not begin with a keyword. AVS UCD files begin with five counts.
  [[noreturn]] void ThrowOther()
  {
    while (!this->Lines.Text().empty() && this->Lines.Text()[0] == '#') // an AVS comment
    {
      this->Lines.Next();
    }
    const std::string& text = this->Lines.Text();
    if (!text.empty() &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }))
    {
      throw Failure("it is an AVS (UCD) mesh, not an Abaqus one; convert it with meshio to .vtu");
    }
    throw Failure(
      "it does not begin with a keyword such as *NODE, as Abaqus files do; convert other "
      ".inp files to one of the kinds that lambent --formats lists");
  }

  void TakeKeyword()
  {
    this->EndElement();
    const InpKeyword keyword = this->Lines.TakeKeyword();
    this->Next = Data::Other;
    this->Refuse(keyword);
    if (keyword.name == "NODE")
    {
      this->Next = Data::Nodes;
    }
    else if (keyword.name == "ELEMENT")
    {
      this->BeginElements(keyword);
    }
    else if (keyword.name == "INSTANCE")
    {
      this->Next = Data::Instance;
      this->Mesh.EndPart();
    }
    else if (keyword.name == "PART" || keyword.name == "ENDPART" || keyword.name == "ENDINSTANCE")
    {
      this->Mesh.EndPart();
    }
  }

  void Refuse(const InpKeyword& keyword)
  {
    const bool isMesh = keyword.name == "NODE" || keyword.name == "ELEMENT";
    if (keyword.name == "INCLUDE" || (isMesh && keyword.parameters.count("INPUT") > 0))
    {
      this->Lines.Fail("*" + keyword.name +
        " refers to another file, which is not read; replace this line by the lines of that file");
    }
    const auto system = keyword.parameters.find("SYSTEM");
    if (isMesh && system != keyword.parameters.end() && system->second != "R")
    {
      this->Lines.Fail("its nodes are not in rectangular coordinates (*NODE, SYSTEM=" +
        Quoted(system->second) + "); save them in rectangular ones");
    }
    if (std::find(std::begin(Refused), std::end(Refused), keyword.name) != std::end(Refused))
    {
      this->Lines.Fail("*" + keyword.name +
        " creates or moves nodes or elements, which is not supported; save the file with all of "
        "them in *NODE and *ELEMENT");
    }
  }

  void BeginElements(const InpKeyword& keyword)
  {
    this->HasElements = true;
    const auto type = keyword.parameters.find("TYPE");
    if (type == keyword.parameters.end())
    {
      this->Lines.Fail("*ELEMENT has no TYPE; use a complete copy");
    }
    this->TypeName = type->second;
    this->Type = FindAbaqusType(this->TypeName);
    this->Next = this->Type.nodes > 0 ? Data::Elements : Data::UnknownElements;
  }

  void TakeData()
  {
    if (this->Next == Data::Nodes)
    {
      double coordinates[3];
      const std::int64_t number = this->Lines.Node(coordinates);
      this->Mesh.AddNode(number, coordinates);
    }
    else if (this->Next == Data::Elements)
    {
      this->TakeElementLine();
    }
    else if (this->Next == Data::UnknownElements)
    {
      if (this->LeftOut++ == 0)
      {
        this->FirstLeftOut = this->TypeName;
      }
    }
    else if (this->Next == Data::Instance)
    {
      this->HasMovedInstance = true;
    }
  }

  /// The nodes of an element may take several lines.
  void TakeElementLine()
  {
    const std::size_t all = 1 + static_cast<std::size_t>(this->Type.nodes);
    this->Lines.AddIntegers(this->Numbers);
    if (this->Numbers.size() > all)
    {
      this->Lines.Fail("element " + std::to_string(this->Numbers[0]) + " has more than the " +
        std::to_string(this->Type.nodes) + " nodes of its type " + Quoted(this->TypeName) +
        "; correct it in the program that writes the file");
    }
    if (this->Numbers.size() == all)
    {
      const std::int64_t number = this->Numbers[0];
      this->Numbers.erase(this->Numbers.begin());
      this->Mesh.AddElement(number, this->Type.shape, this->Numbers);
      this->Numbers.clear();
    }
  }

  void EndElement()
  {
    if (!this->Numbers.empty())
    {
      this->Lines.Fail("element " + std::to_string(this->Numbers[0]) + " has only " +
        std::to_string(this->Numbers.size() - 1) + " of the " + std::to_string(this->Type.nodes) +
        " nodes of its type " + Quoted(this->TypeName) + "; use a complete copy");
    }
  }

  void Warn()
  {
    if (this->LeftOut > 0)
    {
      vtkGenericWarningMacro("elements of unsupported types, such as "
        << Quoted(this->FirstLeftOut) << ", are skipped; they take up " << this->LeftOut
        << " lines");
    }
    if (this->HasMovedInstance)
    {
      vtkGenericWarningMacro("its parts are drawn where they are defined, not moved to where its "
                             "instances are");
    }
  }

  InpLines Lines;
  Progress& Update;
  NumberedMesh Mesh{ true };
  Data Next = Data::Other;
  AbaqusType Type;
  std::string TypeName;
  std::vector<std::int64_t> Numbers; // the numbers read so far of an element and its nodes
  bool HasElements = false;
  bool HasMovedInstance = false;
  std::size_t LeftOut = 0;
  std::string FirstLeftOut;
};

} // namespace

vtkSmartPointer<vtkDataObject> ReadAbaqus(const std::string& path, VtkMessages&, Progress& progress)
{
  const FileBytes file(path);
  return AbaqusReader(file, progress).Read();
}

} // namespace lambent::command
