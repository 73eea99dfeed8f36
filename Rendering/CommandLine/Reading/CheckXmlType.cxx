// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckXmlType.h"
#include "Formats.h"
#include "Messages.h"

#include "vtkXMLDataElement.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace lambent::command
{
namespace
{

/// The extension for each type of file.
constexpr std::pair<const char*, const char*> Endings[] = { { "PolyData", ".vtp" },
  { "UnstructuredGrid", ".vtu" }, { "ImageData", ".vti" }, { "RectilinearGrid", ".vtr" },
  { "StructuredGrid", ".vts" }, { "vtkMultiBlockDataSet", ".vtm" }, { "PPolyData", ".pvtp" },
  { "PUnstructuredGrid", ".pvtu" }, { "PImageData", ".pvti" }, { "PRectilinearGrid", ".pvtr" },
  { "PStructuredGrid", ".pvts" }, { "Collection", ".pvd" }, { "vtkPartitionedDataSet", ".vtpd" },
  { "vtkPartitionedDataSetCollection", ".vtpc" }, { "HyperTreeGrid", ".htg" }, { "Table", ".vtt" },
  { "vtkOverlappingAMR", ".vthb" }, { "vtkNonOverlappingAMR", ".vthb" },
  { "vtkHierarchicalBoxDataSet", ".vthb" } };

/// What to do with a file of that type.
std::string Remedy(const std::string& type)
{
  const auto* const known = std::find_if(std::begin(Endings), std::end(Endings),
    [&type](const auto& ending) { return type == ending.first; });
  if (known != std::end(Endings) && MeshKindOf(std::string("x") + known->second))
  {
    return std::string("; rename it so that its name ends in ") + known->second;
  }
  return "; such files cannot be read: save its surface as a .vtp file, for instance with ParaView";
}

std::string TypeOf(vtkXMLDataElement* root)
{
  if (const char* const type = root->GetAttribute("type"))
  {
    return type;
  }
  return root->GetNumberOfNestedElements() > 0 ? root->GetNestedElement(0)->GetName() : "nothing";
}

} // namespace

void CheckXmlType(vtkXMLDataElement* root, const std::string& expected)
{
  if (root->FindNestedElementWithName(expected.c_str()))
  {
    return;
  }
  const std::string type = TypeOf(root);
  if (std::string(root->GetName()) != "VTKFile")
  {
    throw Failure("it is not a VTK file: its XML begins with <" + std::string(root->GetName()) +
      ">; give its name the extension of its format");
  }
  if (type == expected)
  {
    throw Failure("it has no element <" + expected + ">; use a complete copy");
  }
  throw Failure("it holds " + type + " instead of " + expected + Remedy(type));
}

void CheckVtkStart(const std::string& path, bool expectsXml)
{
  std::ifstream file(path, std::ios::binary);
  char bytes[1000] = {};
  file.read(bytes, sizeof(bytes));
  const std::string start(bytes, static_cast<std::size_t>(file.gcount()));
  if (expectsXml && start.compare(0, 12, "# vtk DataFi") == 0)
  {
    throw Failure("it is a legacy VTK file; rename it so that its name ends in .vtk");
  }
  const std::size_t root = start.find("<VTKFile");
  if (!expectsXml && root != std::string::npos && start.compare(0, 5, "# vtk") != 0)
  {
    const std::string mark = "type=\"";
    const std::size_t from = start.find(mark, root);
    const std::size_t begin = from == std::string::npos ? start.size() : from + mark.size();
    const std::string type = start.substr(begin, start.find('"', begin) - begin);
    throw Failure(
      "it is a VTK XML file that holds " + (type.empty() ? "something" : type) + Remedy(type));
  }
}

} // namespace lambent::command
