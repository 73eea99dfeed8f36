// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief warnings about settings, each given once and not every time a filter executes
 */
#ifndef NewMessages_h
#define NewMessages_h

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace lambent::adapters
{
class NewMessages
{
public:
  /// Those that did not hold the last time; all of them are remembered until the next.
  std::vector<std::string> update(std::vector<std::string> messages)
  {
    std::vector<std::string> fresh;
    for (const std::string& message : messages)
    {
      if (std::find(this->Last.begin(), this->Last.end(), message) == this->Last.end())
      {
        fresh.push_back(message);
      }
    }
    this->Last = std::move(messages);
    return fresh;
  }

private:
  std::vector<std::string> Last;
};
}

#endif
