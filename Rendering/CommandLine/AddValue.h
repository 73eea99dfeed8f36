// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CLI11 options whose text is parsed by the functions of Values.h
 */

#ifndef AddValue_h
#define AddValue_h

#include "Values.h"

#include <CLI/CLI.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace lambent::command
{

template <typename Target>
struct IsVector : std::false_type
{
};

template <typename Item>
struct IsVector<std::vector<Item>> : std::true_type
{
};

/// Adds an option whose text is parsed into `target`, or appended to it if it is a vector.
template <typename Target, typename Parse>
CLI::Option* AddValue(CLI::App& app, const std::string& name, const std::string& kind,
  Target& target, Parse parse, const std::string& help)
{
  const auto take = [&target, parse, name](const std::string& text)
  {
    try
    {
      if constexpr (IsVector<Target>::value)
      {
        target.push_back(parse(text));
      }
      else
      {
        target = parse(text);
      }
    }
    catch (const BadValue& error)
    {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return app.add_option_function<std::string>(name, take, help)
    ->type_name(kind)
    ->trigger_on_parse(); // so that every --light counts, not only the last
}

} // namespace lambent::command

#endif
