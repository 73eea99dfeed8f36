// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief ComparePictures PICTURE BASELINE FOLDER: exit status 0 if they are the same
 */

#include "ComparePictures.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: " << argv[0] << " PICTURE BASELINE FOLDER\n";
    return 2;
  }
  const std::string problem = ComparePictures(argv[1], argv[2], argv[3]);
  if (!problem.empty())
  {
    std::cerr << problem << "\n";
  }
  return problem.empty() ? 0 : 1;
}
