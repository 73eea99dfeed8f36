// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief run all contests of one scene in one process, in turn
 *
 * Each contest runs once to warm up; the time of this run determines the number of
 * repetitions. A repetition consists of another warm-up run, unless that would take long,
 * and a timed run. Google Benchmark runs the repetitions of all contests in random order,
 * so that other work on the machine affects all of them equally.
 */
#include "Agreement.h"
#include "Memory.h"
#include "Options.h"
#include "Peers.h"
#include "ThreadLimit.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace
{
constexpr int nothingToDo = 77; ///< the exit status of a scene whose file is missing
constexpr double tooLongToWarmUp = 0.4;

/// Prints nothing, for --quiet: the results are in the file of --benchmark_out.
class SilentReporter : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>&) override {}
};

int repetitionsFor(double seconds, const Options& options)
{
  const double runs = seconds < tooLongToWarmUp ? 2 * seconds : seconds;
  return std::clamp(static_cast<int>(options.seconds / runs), options.fewest, options.most);
}

void add(const Contest& contest, const std::string& scene, const Options& options)
{
  const double cold = contest.run();
  const double expected = cold < tooLongToWarmUp ? contest.run() : cold;
  const auto repetition = [run = contest.run, expected](benchmark::State& state)
  {
    for (auto _ : state)
    {
      if (expected < tooLongToWarmUp)
      {
        run();
      }
      state.SetIterationTime(run());
    }
  };
  benchmark::RegisterBenchmark((scene + "/" + contest.name).c_str(), repetition)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->Repetitions(repetitionsFor(expected, options));
}

bool anyHas(const std::vector<Contest>& contests, const std::string& part)
{
  return std::any_of(contests.begin(), contests.end(),
    [&](const Contest& contest) { return contest.name.find(part) != std::string::npos; });
}

/// The peers' pictures that belong to these contests.
Compared comparedBy(const std::vector<Contest>& contests)
{
  Compared compared;
  if (anyHas(contests, "embree/"))
  {
    compared.embree.push_back(1);
  }
  for (int samples : supersamplings)
  {
    if (anyHas(contests, withSamples("embree/", samples)))
    {
      compared.embree.push_back(samples);
    }
  }
  compared.balls = anyHas(contests, "balls/trace");
  compared.layers = anyHas(contests, "layers/embree");
  compared.openGL = anyHas(contests, "opengl/");
  return compared;
}

void describe(const BenchmarkScene& scene, const std::vector<Contest>& contests, Peers& peers,
  const Options& options)
{
  benchmark::AddCustomContext("scene", scene.name);
  benchmark::AddCustomContext("triangles", std::to_string(scene.mesh->GetNumberOfPolys()));
  benchmark::AddCustomContext(
    "size", std::to_string(scene.width) + "x" + std::to_string(scene.height));
  benchmark::AddCustomContext("threads", std::to_string(options.threads));
  const Compared compared = comparedBy(contests);
  if (!compared.embree.empty())
  {
    benchmark::AddCustomContext("packet", std::to_string(peers.embree().raysAtOnce()));
  }
  if (compared.openGL)
  {
    benchmark::AddCustomContext("opengl", peers.opengl().device());
  }
  for (const auto& peer : comparePictures(peers, compared, options.pictures))
  {
    benchmark::AddCustomContext("differing/" + peer.first, std::to_string(peer.second));
  }
}

int measureMemory(const BenchmarkScene& scene, Peers& peers, const Options& options)
{
  const std::vector<Contest> contests = peers.contests(options.memory);
  if (contests.size() != 1)
  {
    throw std::invalid_argument("--memory names one contest");
  }
  const bool makesImage = contests[0].name.find("build") == std::string::npos;
  const double imageBytes = makesImage ? 3.0 * scene.width * scene.height : 0.0;
  std::cout << peakMemory(contests[0], imageBytes) << std::endl;
  return EXIT_SUCCESS;
}

int run(const Options& options, int argc, char** argv)
{
  const ThreadLimit limit(options.threads);
  BenchmarkScene scene;
  makeScene(options.scene, options.data, options.cache, scene);
  Peers peers(scene);
  if (!options.memory.empty())
  {
    return measureMemory(scene, peers, options);
  }
  const std::vector<Contest> contests = peers.contests(options.contests);
  describe(scene, contests, peers, options);
  for (const Contest& contest : contests)
  {
    add(contest, scene.name, options);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return EXIT_FAILURE;
  }
  SilentReporter silent;
  benchmark::RunSpecifiedBenchmarks(options.quiet ? &silent : nullptr);
  benchmark::Shutdown();
  return EXIT_SUCCESS;
}
}

int main(int argc, char** argv)
{
  try
  {
    const Options options = takeOptions(argc, argv);
    if (options.list)
    {
      for (const std::string& name : sceneNames())
      {
        std::cout << name << "\n";
      }
      return EXIT_SUCCESS;
    }
    return run(options, argc, argv);
  }
  catch (const SceneMissing& missing)
  {
    std::cerr << "skipped: " << missing.message << "\n";
    return nothingToDo;
  }
  catch (const std::exception& failure)
  {
    std::cerr << "error: " << failure.what() << "\n";
    return EXIT_FAILURE;
  }
}
