// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads the meshes of a scene with assimp. Each mesh appears once for every node that refers to it,
// with that node's transform. Colours, textures, bones and animations are ignored. In formats that
// give each face its own points, identical points are merged, so that computed normals are smooth
// across faces.

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
    // The mesh has normals for all of its points or for none.
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

/// During its lifetime, forwards assimp's warnings about skipped faces and indices as VTK warnings.
/// Other warnings are about materials, animations and the like.
class GeometryWarnings
{
public:
  GeometryWarnings()
  {
    constexpr unsigned int severity = Assimp::Logger::Warn | Assimp::Logger::Err;
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Stream, severity); // the logger takes ownership
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
  // glTF indexes its points, so points at the same position are separate on purpose.
  const std::string extension = ExtensionOf(path);
  const unsigned int join = extension == ".gltf" || extension == ".glb"
    ? 0U
    : static_cast<unsigned int>(aiProcess_JoinIdenticalVertices);
  const aiScene* const scene =
    importer.ReadFile(path, aiProcess_RemoveComponent | aiProcess_ValidateDataStructure | join);
  if (!scene || !scene->mRootNode)
  {
    throw Failure(OneLine(importer.GetErrorString()) +
      "; check that the file is complete and has the right extension");
  }
  SceneMesh mesh(scene);
  mesh.AddNode(scene->mRootNode, aiMatrix4x4());
  return mesh.Get();
}

} // namespace lambent::command
