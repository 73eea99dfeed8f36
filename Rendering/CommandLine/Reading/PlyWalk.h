// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief walks through the values of an element of a PLY file
 */

#ifndef PlyWalk_h
#define PlyWalk_h

#include "Messages.h"
#include "PlyCursor.h"
#include "PlyHeader.h"

#include <algorithm>
#include <functional>
#include <string>

namespace lambent::command
{

using ProgressFunction = std::function<void(double)>;

/// The index of the property of that name, or the number of properties if there is none.
inline std::size_t Find(const PlyElement& element, const std::string& name)
{
  const auto found = std::find_if(element.properties.begin(), element.properties.end(),
    [&name](const PlyProperty& property) { return property.name == name; });
  return static_cast<std::size_t>(found - element.properties.begin());
}

/// Walks through an element. For each property of each item, calls sink.Begin(property, number of
/// values), then sink.Value(property, value) for each value. After each item, calls sink.EndItem().
template <typename Sink>
void Walk(
  PlyCursor& cursor, const PlyElement& element, const ProgressFunction& progress, Sink& sink)
{
  std::size_t item = 0;
  const auto require = [&](bool isThere)
  {
    if (!isThere)
    {
      throw Failure("it is incomplete: it ends within " + element.name + " " +
        std::to_string(item) + " of " + std::to_string(element.count) +
        (cursor.GetLeftOver() == 0 ? "" : "; each element needs its own line"));
    }
  };
  for (; item < element.count && !element.properties.empty(); ++item)
  {
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const PlyProperty& property = element.properties[p];
      double count = 1;
      require(!property.isList ||
        (cursor.Next(property.countType, count) && cursor.CanHold(count, property.type)));
      sink.Begin(p, count);
      for (double k = 0; k < count; ++k)
      {
        double value;
        require(cursor.Next(property.type, value));
        sink.Value(p, value);
      }
    }
    cursor.EndItem();
    sink.EndItem();
    if (item % 65536 == 0)
    {
      progress(static_cast<double>(item) / static_cast<double>(element.count));
    }
  }
}

struct SkipSink
{
  void Begin(std::size_t, double) {}
  void Value(std::size_t, double) {}
  void EndItem() {}
};

} // namespace lambent::command

#endif
