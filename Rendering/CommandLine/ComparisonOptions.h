// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the comparison options of `lambent` and `lambent compare`
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

/// Adds the options. If `compare` is not null, they require that option.
void AddComparison(CLI::App& app, ComparisonOptions& options, CLI::Option* compare);

/// A CLI11 check: the error in the name of a picture to compare, or an empty string.
std::string IsComparable(const std::string& path);

/// Parses the command line of `lambent compare`; otherwise like ParseOptions().
Parsed ParseCompareOptions(int argc, const char* const* argv);

} // namespace lambent::command

#endif
