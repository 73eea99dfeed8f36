// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what one run of the benchmark is asked for, beside Google Benchmark's own options
 */
#ifndef Options_h
#define Options_h

#include <string>

struct Options
{
  std::string scene;           ///< --scene=NAME, see Scenes.h
  std::string contests = ".*"; ///< --contests=REGEX of the names in Peers.h
  std::string data = ".";      ///< --data=FOLDER of bunny.ply and dragon.ply
  std::string cache = ".";     ///< --cache=FOLDER for meshes that take long to make
  std::string pictures;        ///< --pictures=FOLDER to write each peer's picture to
  std::string memory;          ///< --memory=CONTEST: measure that alone, no times
  int threads = 2;             ///< --threads=N
  double seconds = 2.0;        ///< --seconds=S to spend on each contest, roughly
  int fewest = 3;              ///< --fewest=N repetitions, however long they take
  int most = 61;               ///< --most=N repetitions, however short they are
  bool quiet = false;          ///< --quiet: no figures on standard output
  bool list = false;           ///< --list: print the names of the scenes
};

/// Take the options above out of the command line; others are left. Throws
/// std::invalid_argument.
Options takeOptions(int& argc, char** argv);

#endif
