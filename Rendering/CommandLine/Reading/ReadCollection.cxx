// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckFile.h"
#include "Collection.h"
#include "Messages.h"
#include "Readers.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <filesystem>
#include <optional>

namespace lambent::command
{
namespace
{

using Names = std::vector<std::string>;
using Root = vtkSmartPointer<vtkXMLDataElement>;

constexpr int MostLevels = 16; // of nested files

Root ParseXml(const std::string& path, VtkMessages& messages)
{
  const auto root = Root::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  const std::string error = messages.TakeError();
  if (!root || !error.empty() || std::string(root->GetName()) != "VTKFile")
  {
    throw Failure((error.empty() ? "it is not a VTK XML file" : error) +
      "; check that the file is complete and has the right extension");
  }
  return root;
}

/// Calls visit(element) for all elements of that name, in file order.
template <typename Visit>
void ForEach(vtkXMLDataElement* element, const std::string& name, const Visit& visit)
{
  if (name == element->GetName())
  {
    visit(element);
  }
  for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
  {
    ForEach(element->GetNestedElement(k), name, visit);
  }
}

/// The values of an attribute of all elements of that name. Empty blocks have no such attribute.
Names AttributesOf(vtkXMLDataElement* root, const char* element, const char* attribute)
{
  Names names;
  ForEach(root, element,
    [&names, attribute](vtkXMLDataElement* found)
    {
      if (const char* const value = found->GetAttribute(attribute))
      {
        names.emplace_back(value);
      }
    });
  return names;
}

vtkSmartPointer<vtkDataObject> ReadParts(
  const std::string& path, const Names& names, VtkMessages& messages, Progress& progress)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const std::string& name : names)
  {
    blocks->SetBlock(
      blocks->GetNumberOfBlocks(), ReadPart(path, name, nullptr, messages, progress));
  }
  return blocks;
}

/// The names of the data sets of the earliest time step.
Names FirstTime(vtkXMLDataElement* root)
{
  Names names;
  std::optional<double> first;
  ForEach(root, "DataSet",
    [&](vtkXMLDataElement* found)
    {
      double time = 0;
      found->GetScalarAttribute("timestep", time);
      const char* const file = found->GetAttribute("file");
      if (!file || (first && time > *first))
      {
        return;
      }
      if (first && time < *first)
      {
        names.clear();
      }
      first = time;
      names.emplace_back(file);
    });
  return names;
}

} // namespace

vtkSmartPointer<vtkDataObject> ReadPart(const std::string& owner, const std::string& name,
  ReadFunction read, VtkMessages& messages, Progress& progress)
{
  static int level = 0; // static is safe, because the parts of a file are read sequentially
  const std::string path = (std::filesystem::path(owner).parent_path() / name).string();
  try
  {
    CheckFile(path);
    if (IsGzipped(path))
    {
      throw Failure("it is compressed; decompress it with gunzip first");
    }
    if (level >= MostLevels)
    {
      throw Failure("files refer to each other more than " + std::to_string(MostLevels) +
        " levels deep, or in a circle");
    }
    ++level;
    const vtkSmartPointer<vtkDataObject> data =
      (read ? read : RequireFormat(path).read)(path, messages, progress);
    --level;
    return data;
  }
  catch (const std::exception& reason)
  {
    level = 0; // reading ends here
    throw Failure("its part '" + name + "': " + reason.what());
  }
}

std::vector<std::string> PiecesIn(const std::string& path, VtkMessages& messages)
{
  const Names names = AttributesOf(ParseXml(path, messages), "Piece", "Source");
  if (names.empty())
  {
    throw Failure("it has no pieces; check that the file is complete and has the right extension");
  }
  return names;
}

vtkSmartPointer<vtkDataObject> ReadPieces(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadParts(path, PiecesIn(path, messages), messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadBlocks(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadParts(
    path, AttributesOf(ParseXml(path, messages), "DataSet", "file"), messages, progress);
}

vtkSmartPointer<vtkDataObject> ReadPvd(
  const std::string& path, VtkMessages& messages, Progress& progress)
{
  return ReadParts(path, FirstTime(ParseXml(path, messages)), messages, progress);
}

} // namespace lambent::command
