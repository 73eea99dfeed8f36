// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSettings.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace lambent::adapters
{
namespace
{
/// Where a connection comes from: a filter and its output port.
using Source = std::pair<vtkAlgorithm*, int>;

std::vector<Source> sourcesOf(vtkAlgorithm* filter)
{
  std::vector<Source> sources(filter->GetNumberOfInputConnections(0));
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    sources[k].first = filter->GetInputAlgorithm(0, static_cast<int>(k), sources[k].second);
  }
  return sources;
}

/// The new number of each previous connection, or -1 if it is gone. If one source is connected
/// several times, the last of these connections count as the kept ones.
std::vector<int> match(
  const std::vector<Source>& before, const std::vector<Source>& after, int removed)
{
  std::vector<int> numbers(before.size(), -1);
  int next = static_cast<int>(after.size()) - 1;
  for (int k = static_cast<int>(before.size()) - 1; k >= 0 && next >= 0; --k)
  {
    if (k != removed && before[k] == after[next])
    {
      numbers[k] = next--;
    }
  }
  return numbers;
}
}

const InputSetting& InputSettings::of(int connection) const
{
  static const InputSetting none;
  const auto found = this->Settings.find(connection);
  return found == this->Settings.end() ? none : found->second;
}

void InputSettings::follow(vtkAlgorithm* filter, const std::function<void()>& change, int removed)
{
  const std::vector<Source> before = sourcesOf(filter);
  change();
  const std::vector<Source> after = sourcesOf(filter);
  if (before != after)
  {
    this->move(match(before, after, after.size() < before.size() ? removed : -1),
      static_cast<int>(before.size()) - static_cast<int>(after.size()));
  }
}

void InputSettings::followReplacement(vtkAlgorithm* filter, const std::function<void()>& change)
{
  const std::vector<Source> before = sourcesOf(filter);
  change();
  const std::vector<Source> after = sourcesOf(filter);
  const std::vector<int> numbers = match(before, after, -1);
  const bool isItsFirst = !numbers.empty() && numbers.front() == 0; // as in a new set-up
  if (!isItsFirst &&
    std::any_of(numbers.begin(), numbers.end(), [](int number) { return number >= 0; }))
  {
    this->move(numbers, static_cast<int>(before.size()) - static_cast<int>(after.size()));
  }
}

/// `numbers` has the new number of each connection, or -1. Settings of numbers that are not
/// connected move up by `fewer`.
void InputSettings::move(const std::vector<int>& numbers, int fewer)
{
  const auto count = static_cast<int>(numbers.size());
  std::map<int, InputSetting> moved;
  for (auto& [connection, setting] : this->Settings)
  {
    const int number = connection < count ? numbers[connection] : connection - fewer;
    if (number >= 0)
    {
      moved[number] = std::move(setting);
    }
  }
  this->Settings = std::move(moved);
}
}
