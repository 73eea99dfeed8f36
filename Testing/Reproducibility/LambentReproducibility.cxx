// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the scenes to files in a given manner; scenes.py hashes and compares them.
#include "Drawing.h"
#include "PictureFile.h"
#include "Scenes.h"
#include "VectorTarget.h"

#include <cstdlib>
#include <exception>
#include <iostream>

namespace
{
const char* const usage =
  "usage: LambentReproducibility FOLDER [--threads N] [--backend NAME] [--parts]\n"
  "                              [--shuffle SEED] [--brute-force] [--only TEXT]\n"
  "       LambentReproducibility --manners\n"
  "Renders each scene into FOLDER/<name>.pfm and .ppm (.pam with alpha), and into .passes if it\n"
  "has passes. --shuffle omits scenes in which the order of faces affects the picture. --only\n"
  "selects scenes whose name contains TEXT. --manners lists what this machine supports: values\n"
  "of LAMBENT_SIMD, backends.\n";

struct Command
{
  std::string folder;
  std::string only;
  Manner manner;
  bool listsManners = false;
};

/// Parses the command line. Returns false if it is invalid.
bool read(int argc, char** argv, Command& command)
{
  for (int k = 1; k < argc; ++k)
  {
    const std::string word = argv[k];
    const char* value = k + 1 < argc ? argv[k + 1] : "";
    if (word == "--parts")
    {
      command.manner.inParts = true;
    }
    else if (word == "--brute-force")
    {
      command.manner.byBruteForce = true;
    }
    else if (word == "--manners")
    {
      command.listsManners = true;
    }
    else if (word.compare(0, 2, "--") != 0 && command.folder.empty())
    {
      command.folder = word;
    }
    else if (*value == '\0')
    {
      return false;
    }
    else if (word == "--threads")
    {
      command.manner.threads = std::atoi(argv[++k]);
    }
    else if (word == "--backend")
    {
      command.manner.backend = argv[++k];
    }
    else if (word == "--shuffle")
    {
      command.manner.shuffle = static_cast<unsigned int>(std::atoi(argv[++k]));
    }
    else if (word == "--only")
    {
      command.only = argv[++k];
    }
    else
    {
      return false;
    }
  }
  return command.listsManners || !command.folder.empty();
}

void listManners()
{
  for (const std::string& target : lambent::vectorTargets())
  {
    std::cout << "LAMBENT_SIMD " << target << "\n";
  }
  for (const std::string& backend : backendsHere())
  {
    std::cout << "backend " << backend << "\n";
  }
}

void drawAll(const Command& command)
{
  for (const SceneEntry& entry : allScenes())
  {
    Stage stage;
    entry.build(stage);
    if (entry.name.find(command.only) == std::string::npos ||
      (command.manner.shuffle != 0 && stage.hasTies))
    {
      continue;
    }
    writePicture(draw(stage, command.manner), command.folder, entry.name);
  }
}
}

int main(int argc, char** argv)
{
  Command command;
  if (!read(argc, argv, command))
  {
    std::cerr << usage;
    return 2;
  }
  try
  {
    command.listsManners ? listManners() : drawAll(command);
    return 0;
  }
  catch (const std::exception& failure)
  {
    std::cerr << "error: " << failure.what() << "\n";
    return 1;
  }
}
