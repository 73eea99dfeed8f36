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

std::string withSamples(const std::string& name, int samples)
{
  return samples == 1 ? name : "supersampling-" + std::to_string(samples) + "/" + name;
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

EmbreeBalls& Peers::balls()
{
  return madeOnce(this->Balls, this->Scene);
}

ManySurfaces& Peers::surfaces()
{
  return madeOnce(this->Surfaces, this->Scene);
}

void Peers::addPictures(std::vector<Contest>& contests, int samples)
{
  contests.push_back({ withSamples("lambent", samples),
    [this, samples]() { return this->lambent().render(samples); } });
  for (TreeQuality quality : treeQualities)
  {
    for (RayGrouping grouping : rayGroupings)
    {
      const std::string name = std::string(nameOf(quality)) + "/" + nameOf(grouping);
      contests.push_back({ withSamples("embree/trace/" + name, samples),
        [this, quality, grouping, samples]()
        { return this->embree().trace(quality, grouping, samples); } });
    }
  }
}

void Peers::addBalls(std::vector<Contest>& contests)
{
  contests.push_back({ "balls/lambent", [this]() { return this->lambent().render(); } });
  for (TreeQuality quality : { TreeQuality::Low, TreeQuality::Medium })
  {
    contests.push_back({ std::string("balls/build/") + nameOf(quality),
      [this, quality]() { return this->balls().build(quality); } });
    contests.push_back({ std::string("balls/trace/") + nameOf(quality),
      [this, quality]() { return this->balls().trace(quality); } });
  }
}

void Peers::addLooks(std::vector<Contest>& contests)
{
  const auto add = [&](const char* name, Look look)
  {
    contests.push_back({ std::string("looks/") + name,
      [this, look]() { return this->lambent().renderLook(look); } });
  };
  add("colors", Look::Colors);
  add("texture", Look::Texture);
  add("edges", Look::Edges);
}

void Peers::addLayers(std::vector<Contest>& contests)
{
  contests.push_back({ "layers/lambent", [this]() { return this->lambent().renderLayers(); } });
  for (TreeQuality quality : treeQualities)
  {
    contests.push_back({ std::string("layers/embree/trace/") + nameOf(quality) + "/packets",
      [this, quality]() { return this->embree().traceLayers(quality); } });
  }
}

void Peers::addSurfaces(std::vector<Contest>& contests)
{
  const auto add = [&](const char* name, double (ManySurfaces::*run)())
  {
    contests.push_back(
      { std::string("surfaces/") + name, [this, run]() { return (this->surfaces().*run)(); } });
  };
  add("inputs", &ManySurfaces::renderInputs);
  add("blind", &ManySurfaces::renderBlindly);
  add("one", &ManySurfaces::renderOne);
  add("many", &ManySurfaces::renderMany);
}

std::vector<Contest> Peers::all()
{
  std::vector<Contest> contests;
  for (TreeQuality quality : treeQualities)
  {
    contests.push_back({ std::string("embree/build/") + nameOf(quality),
      [this, quality]() { return this->embree().build(quality); } });
  }
  this->addPictures(contests, 1);
  for (int samples : supersamplings)
  {
    this->addPictures(contests, samples);
  }
  this->addLayers(contests);
  this->addLooks(contests);
  if (this->Scene.ballRadius > 0.0)
  {
    this->addBalls(contests);
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
    this->addSurfaces(contests);
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
    contests.push_back({ "layers/opengl", [this]() { return this->opengl().nextLayers(); } });
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
