// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief compare the reading times of the command and of VTK
 *
 * VTK's reader with the surface filter, and ReadSurface(), run in turn, so that other work on the
 * machine affects both. The files are in the system's cache. Prints the medians, their ratio, and
 * the ratio of the fastest runs, which other work disturbs less. A file is marked if both ratios
 * exceed the goal.
 *
 *   LambentReading --data=FOLDER --cache=FOLDER [--files=REGEX] [--runs=N]
 */
#include "ReadingFiles.h"
#include "Stopwatch.h"

#include "Messages.h"
#include "Progress.h"
#include "ReadSurface.h"

#include "vtkCellArray.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <regex>
#include <stdexcept>

namespace
{
constexpr double goal = 1.2;

struct ReadingOptions
{
  std::string data = ".";
  std::string cache = ".";
  std::string files = ".*";
  int runs = 9;
};

ReadingOptions takeReadingOptions(int argc, char** argv)
{
  ReadingOptions options;
  for (int k = 1; k < argc; ++k)
  {
    const std::string argument = argv[k];
    const std::size_t equals = std::min(argument.find('='), argument.size() - 1);
    const std::string name = argument.substr(0, equals), value = argument.substr(equals + 1);
    if (name == "--runs")
    {
      options.runs = std::max(1, std::atoi(value.c_str()));
      continue;
    }
    std::string* const text = name == "--data" ? &options.data
      : name == "--cache"                      ? &options.cache
      : name == "--files"                      ? &options.files
                                               : nullptr;
    if (!text)
    {
      throw std::invalid_argument("no option " + argument);
    }
    *text = value;
  }
  return options;
}

/// The milliseconds of one of the two.
struct Times
{
  explicit Times(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    this->fastest = values.front();
    this->median = values[values.size() / 2];
  }

  double fastest;
  double median;
};

vtkSmartPointer<vtkPolyData> readWithLambent(const std::string& path)
{
  lambent::command::VtkMessages messages(false);
  lambent::command::Progress progress(false);
  return lambent::command::ReadSurface(path, messages, progress);
}

/// Prints a line; returns whether the goal was met.
bool compare(const ReadingFile& file, int runs)
{
  std::vector<double> times[2];
  vtkIdType polygons[2] = {};
  for (int run = 0; run <= runs; ++run) // the first run does not count
  {
    for (int side : { run % 2, 1 - run % 2 })
    {
      const Stopwatch watch;
      const auto mesh = side == 0 ? file.readWithVtk(file.path) : readWithLambent(file.path);
      polygons[side] = mesh->GetNumberOfPolys();
      if (run > 0)
      {
        times[side].push_back(1e3 * watch.seconds());
      }
    }
  }
  const Times vtk(times[0]), own(times[1]);
  const double ratio = own.median / vtk.median, best = own.fastest / vtk.fastest;
  const bool isMet = std::min(ratio, best) <= goal;
  std::printf("%-34s %6.1f %9.1f %9.1f %6.2f %6.2f%s%s\n", file.name.c_str(),
    1e-6 * static_cast<double>(std::filesystem::file_size(file.path)), vtk.median, own.median,
    ratio, best, isMet ? "" : " missed",
    polygons[0] == polygons[1] ? "" : " (another number of polygons)");
  std::fflush(stdout);
  return isMet;
}

int run(const ReadingOptions& options)
{
  const std::regex wanted(options.files);
  int missed = 0;
  std::printf("%-34s %6s %9s %9s %6s %6s\n", "file", "MB", "VTK ms", "own ms", "ratio", "best");
  for (const ReadingFile& file : makeReadingFiles(options.data, options.cache))
  {
    if (std::regex_search(file.name, wanted))
    {
      missed += !compare(file, options.runs);
    }
  }
  std::printf("%d above the goal of %.1f\n", missed, goal);
  return EXIT_SUCCESS;
}
}

int main(int argc, char** argv)
{
  try
  {
    return run(takeReadingOptions(argc, argv));
  }
  catch (const std::exception& failure)
  {
    std::cerr << "error: " << failure.what() << "\n";
    return EXIT_FAILURE;
  }
}
