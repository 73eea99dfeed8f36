// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Formats.h"
#include "FileKinds.h"
#include "Messages.h"
#include "ReadLegacyVtk.h"
#include "Readers.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

// The build defines these if it found the library.
#ifdef LAMBENT_HAS_ASSIMP
#define LAMBENT_IF_ASSIMP(read) read
#else
#define LAMBENT_IF_ASSIMP(read) nullptr
#endif
#ifdef LAMBENT_HAS_EXODUS
#define LAMBENT_IF_EXODUS(read) read
#else
#define LAMBENT_IF_EXODUS(read) nullptr
#endif
#ifdef LAMBENT_HAS_ENSIGHT
#define LAMBENT_IF_ENSIGHT(read) read
#else
#define LAMBENT_IF_ENSIGHT(read) nullptr
#endif
#ifdef LAMBENT_HAS_ZLIB
constexpr bool HasZlib = true;
#else
constexpr bool HasZlib = false;
#endif

namespace lambent::command
{
namespace
{

constexpr MeshKind Other = MeshKind::Other;
constexpr Trust Checked = Trust::Checked;
constexpr Trust Isolated = Trust::Isolated;
constexpr const char* Vtk = "VTK";
constexpr const char* Own = "Lambent";
#ifdef LAMBENT_HAS_ASSIMP
// VTK's reader fails if a texture is missing and crashes if a buffer is missing; assimp does not.
constexpr const char* Gltf = "assimp";
constexpr ReadFunction ReadGltfFile = ReadAssimp;
#else
constexpr const char* Gltf = "VTK";
constexpr ReadFunction ReadGltfFile = ReadGltf;
#endif

const Format Table[] = {
  // kind, extensions, description, library, reader, trust, names further files
  { MeshKind::Vtp, ".vtp", "VTK polygons", Vtk, ReadVtpFile, Checked, false },
  { MeshKind::LegacyVtk, ".vtk", "VTK legacy: polygons, grids, images", Vtk, ReadLegacyVtkFile,
    Checked, false },
  { MeshKind::Vtu, ".vtu", "VTK unstructured grid", Vtk, ReadVtuFile, Checked, false },
  { MeshKind::Ply, ".ply", "Stanford polygons", Own, ReadPlyFile, Checked, false },
  { MeshKind::Stl, ".stl", "stereolithography", Own, ReadStlFile, Checked, false },
  { MeshKind::Obj, ".obj", "Wavefront", Own, ReadObjFile, Checked, false },
  { Other, ".off", "Object File Format", Own, ReadOff, Checked, false },
  { Other, ".gii", "GIFTI surfaces", Own, ReadGifti, Checked, false },
  { Other, ".msh", "Gmsh, versions 2 and 4.1", Own, ReadGmsh, Checked, false },
  { Other, ".inp", "Abaqus", Own, ReadAbaqus, Checked, false },
  { Other, ".vti", "VTK image (with --contour)", Vtk, ReadVti, Isolated, false },
  { Other, ".vtr", "VTK rectilinear grid", Vtk, ReadVtr, Isolated, false },
  { Other, ".vts", "VTK structured grid", Vtk, ReadVts, Isolated, false },
  { Other, ".pvtp .pvtu", "VTK polygons or grid in pieces", Own, ReadPieces, Isolated, true },
  { Other, ".pvti", "VTK image in pieces (with --contour)", Vtk, ReadPvti, Isolated, true },
  { Other, ".pvtr", "VTK rectilinear grid in pieces", Vtk, ReadPvtr, Isolated, true },
  { Other, ".pvts", "VTK structured grid in pieces", Vtk, ReadPvts, Isolated, true },
  { Other, ".vtm .vtmb", "VTK blocks", Own, ReadBlocks, Isolated, true },
  { Other, ".vtpd .vtpc", "VTK partitions and collections", Own, ReadBlocks, Isolated, true },
  { Other, ".pvd", "ParaView time series (first step)", Own, ReadPvd, Isolated, true },
  { Other, ".gltf .glb", "GL transmission format 2", Gltf, ReadGltfFile, Isolated, true },
  { Other, ".dae", "COLLADA", "assimp", LAMBENT_IF_ASSIMP(ReadAssimp), Isolated, false },
  { Other, ".3ds", "3D Studio", "assimp", LAMBENT_IF_ASSIMP(ReadAssimp), Isolated, false },
  { Other, ".fbx", "Filmbox", "assimp", LAMBENT_IF_ASSIMP(ReadAssimp), Isolated, false },
  { Other, ".3mf", "3D manufacturing", "assimp", LAMBENT_IF_ASSIMP(ReadAssimp), Isolated, false },
  { Other, ".amf", "additive manufacturing", "assimp", LAMBENT_IF_ASSIMP(ReadAssimp), Isolated,
    false },
  { Other, ".e .ex2 .exo .exii", "Exodus II (first time step)", "VTK::IOExodus",
    LAMBENT_IF_EXODUS(ReadExodus), Isolated, false },
  { Other, ".case", "EnSight (first time step)", "VTK::IOEnSight", LAMBENT_IF_ENSIGHT(ReadEnSight),
    Isolated, true },
  { Other, ".foam", "OpenFOAM (first time step)", Vtk, ReadFoam, Isolated, true, true },
};

/// Kinds that users may try, and the remedy.
const struct
{
  const char* extensions;
  const char* remedy;
} NotRead[] = {
  { ".bdf .nas .med .xdmf .xmf", "convert it with meshio" },
  { ".step .stp .iges .igs .brep", "save a mesh of it from a CAD program" },
  { ".blend .max .ma .mb .c4d .skp", "export a mesh from the program that made it" },
  { ".usd .usda .usdc .usdz .abc", "convert it with Blender" },
  { ".wrl .x3d .dxf .lwo .ac .ms3d .x", "convert it with Blender, MeshLab or assimp" },
};

/// Whether `words` contains the word.
bool Contains(const char* words, const std::string& word)
{
  std::istringstream stream(words);
  for (std::string known; stream >> known;)
  {
    if (known == word)
    {
      return true;
    }
  }
  return false;
}

/// The extension, without the ".gz" of a gzipped file.
std::string InnerExtensionOf(const std::string& path)
{
  return ExtensionOf(IsGzipped(path) ? path.substr(0, path.size() - 3) : path);
}

[[noreturn]] void ThrowUnknown(const std::string& path)
{
  const std::string kinds = MeshExtensions() + ", or in one of them and .gz";
  const std::string extension = InnerExtensionOf(path);
  for (const auto& [extensions, remedy] : NotRead)
  {
    if (Contains(extensions, extension))
    {
      throw Failure(extension + " files cannot be read; " + remedy +
        ", to a name that ends in one of " + kinds);
    }
  }
  throw Failure("its format is unknown; its name must end in one of " + kinds);
}

} // namespace

bool IsGzipped(const std::string& path)
{
  return ExtensionOf(path) == ".gz";
}

const Format* FindFormat(const std::string& path)
{
  const auto found = std::find_if(std::begin(Table), std::end(Table),
    [extension = InnerExtensionOf(path)](const Format& format)
    { return Contains(format.extensions, extension); });
  return found != std::end(Table) ? found : nullptr;
}

std::optional<MeshKind> MeshKindOf(const std::string& path)
{
  const Format* const format = FindFormat(path);
  return format ? std::optional(format->kind) : std::nullopt;
}

Trust TrustIn(const Format& format, const std::string& path)
{
  if (format.kind == MeshKind::LegacyVtk)
  {
    // VTK's readers do not check the sizes of images and grids.
    return LegacyTypeOf(path) == LegacyType::Other ? Trust::Isolated : Trust::Checked;
  }
  return format.trust;
}

const Format& RequireFormat(const std::string& path)
{
  const Format* const format = FindFormat(path);
  if (!format)
  {
    ThrowUnknown(path);
  }
  if (!format->read)
  {
    throw Failure(std::string("this build of lambent was made without ") + format->library +
      ", which reads " + format->extensions +
      "; install it and build again, or convert the file to " + "one of " + MeshExtensions());
  }
  if (IsGzipped(path) && !HasZlib)
  {
    throw Failure(
      "this build of lambent was made without VTK::zlib; decompress it with gunzip first");
  }
  return *format;
}

std::string MeshExtensions()
{
  std::string list;
  for (const Format& format : Table)
  {
    if (format.read)
    {
      list += (list.empty() ? "" : " ") + std::string(format.extensions);
    }
  }
  return list;
}

std::string DescribeFormats()
{
  const auto row = [](std::string name, std::string what, const std::string& through)
  {
    name.resize(std::max<std::size_t>(20, name.size() + 1), ' ');
    what.resize(std::max<std::size_t>(40, what.size() + 1), ' ');
    return "  " + name + what + through + "\n";
  };
  std::string text = "Reads:\n";
  for (const Format& format : Table)
  {
    text += row(format.extensions, format.description,
      format.read ? format.library : std::string("not in this build: ") + format.library);
  }
  text += row(
    "(any).gz", "each of these, gzipped", HasZlib ? "VTK::zlib" : "not in this build: VTK::zlib");
  return text + "Writes:\n  " + PictureExtensions() + "\n";
}

} // namespace lambent::command
