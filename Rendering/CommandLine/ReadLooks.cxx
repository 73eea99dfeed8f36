// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FileBytes.h"
#include "FileKinds.h"
#include "MaterialInputs.h"
#include "Messages.h"
#include "ObjMaterials.h"
#include "ReadBackground.h"

#include "vtkImageData.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace lambent::command
{
namespace
{

namespace fs = std::filesystem;

/// A file that another one in a folder names. Names from Windows have backslashes.
fs::path Find(const fs::path& folder, std::string name)
{
  std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path path = folder / name; // the name itself if it is absolute
  std::error_code error;
  const fs::path beside = folder / fs::path(name).filename();
  return fs::exists(path, error) || !fs::exists(beside, error) ? path : beside;
}

class LookReader
{
public:
  LookReader(vtkPolyData* mesh, const std::string& path, VtkMessages& messages, Progress& progress)
    : Wanted(StoredMaterials(mesh))
    , Folder(fs::path(path).parent_path())
    , HasCoordinates(mesh->GetPointData()->GetTCoords() != nullptr)
    , Messages(messages)
    , Status(progress)
  {
  }

  MeshLooks Read();

private:
  void ReadLibrary(const std::string& name);
  vtkSmartPointer<vtkImageData> ImageOf(const std::string& name, const fs::path& folder);

  ObjMaterials Wanted;
  const fs::path Folder;
  const bool HasCoordinates;
  VtkMessages& Messages;
  Progress& Status;
  std::map<std::string, Look> Found;                           ///< by name
  std::map<std::string, vtkSmartPointer<vtkImageData>> Images; ///< by path
};

MeshLooks LookReader::Read()
{
  MeshLooks result;
  if (this->Wanted.empty())
  {
    return result;
  }
  for (const std::string& library : this->Wanted.libraries)
  {
    this->ReadLibrary(library);
  }
  std::vector<std::int32_t> numbers; // of the looks, by material
  result.looks.emplace_back();       // of faces without a material
  for (const std::string& name : this->Wanted.names)
  {
    const auto found = this->Found.find(name);
    numbers.push_back(
      found == this->Found.end() ? 0 : static_cast<std::int32_t>(result.looks.size()));
    if (found != this->Found.end())
    {
      result.looks.push_back(found->second);
    }
  }
  for (const std::int32_t number : this->Wanted.ofFace)
  {
    result.ofPolygon.push_back(number < 0 ? 0 : numbers[static_cast<std::size_t>(number)]);
  }
  return result.looks.size() > 1 ? result : MeshLooks();
}

void LookReader::ReadLibrary(const std::string& name)
{
  const fs::path path = Find(this->Folder, name);
  try
  {
    const FileBytes file(path.string());
    for (const Material& material : ParseMtl(file.view()))
    {
      const bool isUsed = std::find(this->Wanted.names.begin(), this->Wanted.names.end(),
                            material.name) != this->Wanted.names.end();
      if (isUsed && this->Found.count(material.name) == 0)
      {
        this->Found[material.name] = { material,
          material.image.empty() ? nullptr : this->ImageOf(material.image, path.parent_path()) };
      }
    }
  }
  catch (const std::exception& reason)
  {
    vtkGenericWarningMacro(<< "cannot read its materials in '" << path.string()
                           << "': " << reason.what());
  }
}

vtkSmartPointer<vtkImageData> LookReader::ImageOf(const std::string& name, const fs::path& folder)
{
  const fs::path path = Find(folder, name);
  const auto [entry, isNew] = this->Images.try_emplace(path.string());
  if (!isNew)
  {
    return entry->second;
  }
  try
  {
    if (!this->HasCoordinates)
    {
      throw Failure("the mesh has no texture coordinates (vt), or points that need several of them "
                    "but have no normals (vn)");
    }
    if (!PictureKindOf(path.string()))
    {
      throw Failure("its format is unknown; convert it to one of " + PictureExtensions());
    }
    entry->second = ReadBackground(path.string(), this->Messages, this->Status);
  }
  catch (const std::exception& reason)
  {
    vtkGenericWarningMacro(<< "cannot use the texture '" << path.string()
                           << "': " << reason.what());
  }
  return entry->second;
}

} // namespace

MeshLooks ReadLooks(
  vtkPolyData* mesh, const std::string& path, VtkMessages& messages, Progress& progress)
{
  return LookReader(mesh, path, messages, progress).Read();
}

} // namespace lambent::command
