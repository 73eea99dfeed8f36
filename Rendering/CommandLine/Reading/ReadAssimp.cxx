// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// The meshes of a scene that assimp reads, each as often as nodes show it, where these put it.
// Colours, textures, bones and animations are left out. In kinds that give each face points of its
// own, those that differ in nothing else become one, so that computed normals are smooth across
// them.

#include "FileKinds.h"
#include "Messages.h"
#include "Readers.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>

namespace lambent::command
{
namespace
{

constexpr int LeftOut = aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
  aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES |
  aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

class SceneMesh
{
public:
  explicit SceneMesh(const aiScene* scene)
    : Scene(scene)
  {
    // Normals of some points only would leave the others without.
    this->HasNormals = std::all_of(scene->mMeshes, scene->mMeshes + scene->mNumMeshes,
      [](const aiMesh* mesh) { return mesh->HasNormals(); });
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetName("Normals");
  }

  void AddNode(const aiNode* node, const aiMatrix4x4& above)
  {
    const aiMatrix4x4 transform = above * node->mTransformation;
    for (unsigned int k = 0; k < node->mNumMeshes; ++k)
    {
      this->AddMesh(this->Scene->mMeshes[node->mMeshes[k]], transform);
    }
    for (unsigned int k = 0; k < node->mNumChildren; ++k)
    {
      this->AddNode(node->mChildren[k], transform);
    }
  }

  vtkSmartPointer<vtkPolyData> Get()
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polygons);
    if (this->HasNormals && this->Points->GetNumberOfPoints() > 0)
    {
      mesh->GetPointData()->SetNormals(this->Normals);
    }
    return mesh;
  }

private:
  void AddMesh(const aiMesh* mesh, const aiMatrix4x4& transform)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const aiMatrix3x3 linear(transform);
    const bool isMirrored = linear.Determinant() < 0;
    aiMatrix3x3 forNormals = linear;
    forNormals.Inverse().Transpose();
    for (unsigned int k = 0; k < mesh->mNumVertices; ++k)
    {
      const aiVector3D point = transform * mesh->mVertices[k];
      this->Points->InsertNextPoint(point.x, point.y, point.z);
      if (this->HasNormals)
      {
        const aiVector3D normal = (forNormals * mesh->mNormals[k]).NormalizeSafe();
        this->Normals->InsertNextTuple3(normal.x, normal.y, normal.z);
      }
    }
    for (unsigned int k = 0; k < mesh->mNumFaces; ++k)
    {
      this->AddFace(mesh->mFaces[k], first, isMirrored);
    }
  }

  void AddFace(const aiFace& face, vtkIdType first, bool isMirrored)
  {
    if (face.mNumIndices < 3) // points and lines
    {
      return;
    }
    this->Polygons->InsertNextCell(static_cast<int>(face.mNumIndices));
    for (unsigned int k = 0; k < face.mNumIndices; ++k)
    {
      const unsigned int corner = isMirrored ? face.mNumIndices - 1 - k : k;
      this->Polygons->InsertCellPoint(first + face.mIndices[corner]);
    }
  }

  const aiScene* Scene;
  bool HasNormals;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkCellArray> Polygons;
};

/// While it lives, assimp's warnings of faces and indices that it leaves out are warnings here. The
/// others are of materials, animations, and the like.
class GeometryWarnings
{
public:
  GeometryWarnings()
  {
    constexpr unsigned int severity = Assimp::Logger::Warn | Assimp::Logger::Err;
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Stream, severity); // the logger's from now on
  }
  ~GeometryWarnings() { Assimp::DefaultLogger::kill(); }
  GeometryWarnings(const GeometryWarnings&) = delete;
  GeometryWarnings& operator=(const GeometryWarnings&) = delete;

private:
  struct Stream : Assimp::LogStream
  {
    void write(const char* message) override
    {
      std::string text = message; // "Warn,  T0: text"
      text.erase(0, text.find(": ") == std::string::npos ? 0 : text.find(": ") + 2);
      for (const char* const word : { "face", "indices", "index" })
      {
        if (text.find(word) != std::string::npos)
        {
          vtkGenericWarningMacro(<< text);
          return;
        }
      }
    }
  };
};

} // namespace

vtkSmartPointer<vtkDataObject> ReadAssimp(const std::string& path, VtkMessages&, Progress&)
{
  const GeometryWarnings warnings;
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, LeftOut);
  // glTF names its points by index, so that points of equal place are apart on purpose.
  const std::string extension = ExtensionOf(path);
  const unsigned int join = extension == ".gltf" || extension == ".glb"
    ? 0U
    : static_cast<unsigned int>(aiProcess_JoinIdenticalVertices);
  const aiScene* const scene =
    importer.ReadFile(path, aiProcess_RemoveComponent | aiProcess_ValidateDataStructure | join);
  if (!scene || !scene->mRootNode)
  {
    throw Failure(
      OneLine(importer.GetErrorString()) + "; is it whole, and of the kind that its name tells?");
  }
  SceneMesh mesh(scene);
  mesh.AddNode(scene->mRootNode, aiMatrix4x4());
  return mesh.Get();
}

} // namespace lambent::command
