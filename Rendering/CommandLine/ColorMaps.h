// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colour maps of `--colormap`, by their usual names
 *
 * A map is a few colours at given places from 0 to 1, joined by straight lines in RGB, and gives a
 * table of 256 colours. Integers, and + - * / of doubles, decide its bytes, so they are the same on
 * every platform. The comment of each map says who designed it and how exact it is.
 */

#ifndef ColorMaps_h
#define ColorMaps_h

#include <array>
#include <optional>
#include <string>

namespace lambent::command
{

/// Red, green and blue of each entry.
using ColorTable256 = std::array<std::array<unsigned char, 3>, 256>;

constexpr const char* DefaultColorMap = "viridis";

/// The table of that name. The case of letters does not matter, nor do spaces, '-' and '_' between
/// words; "_r" at the end reverses the map. Empty if the name is unknown.
std::optional<ColorTable256> FindColorMap(const std::string& name);

/// The names of all maps, without synonyms: "viridis, plasma, ...".
std::string ColorMapNames();

} // namespace lambent::command

#endif
