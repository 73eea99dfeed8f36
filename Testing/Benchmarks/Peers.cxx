// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Peers.h"

#include "ThreadLimit.h"

#include <regex>

namespace
{
template <typename Peer>
Peer& madeOnce(std::unique_ptr<Peer>& peer, const BenchmarkScene& scene)
{
  if (!peer)
  {
    peer.reset(new Peer(scene));
  }
  return *peer;
}

Contest onOneThread(const Contest& contest)
{
  const std::string name = "1-thread/" + contest.name;
  if (contest.name.find("embree/") == 0)
  {
    return { name,
      [run = contest.run]()
      {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        return run();
      } };
  }
  return { name,
    [run = contest.run]()
    {
      const SequentialVtk one;
      return run();
    } };
}
}

Peers::Peers(const BenchmarkScene& scene)
  : Scene(scene)
  , BareMesh(withoutNormals(scene.mesh))
{
}

LambentRenderer& Peers::lambent()
{
  return madeOnce(this->Lambent, this->Scene);
}

EmbreeRenderer& Peers::embree()
{
  return madeOnce(this->Embree, this->Scene);
}

OpenGLRenderer& Peers::opengl()
{
  return madeOnce(this->OpenGL, this->Scene);
}

ManySurfaces& Peers::surfaces()
{
  return madeOnce(this->Surfaces, this->Scene);
}

std::vector<Contest> Peers::all()
{
  std::vector<Contest> contests;
  contests.push_back({ "lambent", [this]() { return this->lambent().render(); } });
  for (TreeQuality quality : treeQualities)
  {
    const std::string name = nameOf(quality);
    contests.push_back(
      { "embree/build/" + name, [this, quality]() { return this->embree().build(quality); } });
    for (RayGrouping grouping : rayGroupings)
    {
      contests.push_back({ "embree/trace/" + name + "/" + nameOf(grouping),
        [this, quality, grouping]() { return this->embree().trace(quality, grouping); } });
    }
  }
  const auto addNormals = [&](const char* name, NormalsFilter filter)
  {
    contests.push_back({ std::string("normals/") + name,
      [this, filter]() { return computeNormals(filter, this->BareMesh); } });
  };
  addNormals("vtkLambentNormals", NormalsFilter::Lambent);
  addNormals("vtkPolyDataNormals", NormalsFilter::PolyData);
  addNormals("vtkTriangleMeshPointNormals", NormalsFilter::TriangleMeshPoint);
  if (this->Scene.pieces > 1)
  {
    contests.push_back({ "surfaces/inputs", [this]() { return this->surfaces().renderInputs(); } });
    contests.push_back({ "surfaces/one", [this]() { return this->surfaces().renderOne(); } });
    contests.push_back({ "surfaces/many", [this]() { return this->surfaces().renderMany(); } });
  }
  for (std::size_t k = 0, count = contests.size(); k < count; ++k)
  {
    contests.push_back(onOneThread(contests[k]));
  }
  if (OpenGLRenderer::isAvailable())
  {
    contests.push_back({ "opengl/first", [this]() { return this->opengl().first(); } });
    contests.push_back({ "opengl/new-mesh", [this]() { return this->opengl().newMesh(); } });
    contests.push_back({ "opengl/next", [this]() { return this->opengl().next(); } });
  }
  return contests;
}

std::vector<Contest> Peers::contests(const std::string& regex)
{
  const std::regex wanted(regex);
  std::vector<Contest> chosen;
  for (Contest& contest : this->all())
  {
    if (std::regex_match(contest.name, wanted))
    {
      chosen.push_back(std::move(contest));
    }
  }
  return chosen;
}
