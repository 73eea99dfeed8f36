// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief warnings about settings, given once and not each time that a filter executes
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
  /// Returns the messages that the previous call did not have, and remembers all of them.
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
