// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the options about comparing pictures, of `lambent` and of `lambent compare`
 */

#ifndef ComparisonOptions_h
#define ComparisonOptions_h

#include "Options.h"

namespace CLI
{
class App;
class Option;
}

namespace lambent::command
{

/// Adds them; without `compare`, if there is one, they make no sense.
void AddComparison(CLI::App& app, ComparisonOptions& options, CLI::Option* compare);

/// For CLI11: what is wrong with the name of a picture that is to be read; empty if nothing.
std::string IsComparable(const std::string& path);

/// Reads the command line of `lambent compare`, as ParseOptions() does.
Parsed ParseCompareOptions(int argc, const char* const* argv);

} // namespace lambent::command

#endif
