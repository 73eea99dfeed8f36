// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the options of a benchmark run, besides those of Google Benchmark
 */
#ifndef Options_h
#define Options_h

#include <string>

struct Options
{
  std::string scene;           ///< --scene=NAME, see Scenes.h
  std::string contests = ".*"; ///< --contests=REGEX of the names in Peers.h
  std::string data = ".";      ///< --data=FOLDER with bunny.ply and dragon.ply
  std::string cache = ".";     ///< --cache=FOLDER for meshes that are slow to make
  std::string pictures;        ///< --pictures=FOLDER to write each peer's picture to
  std::string memory;          ///< --memory=CONTEST: measure its memory only
  int threads = 2;             ///< --threads=N
  double seconds = 2.0;        ///< --seconds=S for each contest, roughly
  int fewest = 3;              ///< --fewest=N repetitions, however long they take
  int most = 61;               ///< --most=N repetitions, however short they are
  bool quiet = false;          ///< --quiet: no figures on standard output
  bool list = false;           ///< --list: print the names of the scenes
};

/// Parse the options above and remove them from the command line. Others remain. Throws
/// std::invalid_argument.
Options takeOptions(int& argc, char** argv);

#endif
