// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorMaps.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace lambent::command
{
namespace
{

/// A colour of a formula: a place from 0 to 1, and red, green and blue from 0 to 1.
struct Stop
{
  double place, red, green, blue;
};

/// A colour of a sampled map: the number of an entry, and its colour as 0xrrggbb.
struct Knot
{
  int entry;
  unsigned color;
};

/// A map that straight lines define: exact. The first of the names is the one in messages, and the
/// others are in the form of Simplified().
struct Formula
{
  std::vector<const char*> names;
  std::vector<Stop> stops;
};

/// A map that was published as a table. The knots are the fewest that keep each channel of all 256
/// entries within 1/255 of the published one, and the first and last entry exact to the byte.
struct Sampled
{
  std::vector<const char*> names;
  std::vector<Knot> knots;
};

const std::vector<Sampled>& SampledMaps()
{
  static const std::vector<Sampled> maps = {
    // By S. van der Walt, N. Smith and E. Firing, for matplotlib: CC0, as are the next three.
    { { "viridis", "viridis(matplotlib)" },
      { { 0, 0x440154 }, { 20, 0x491e70 }, { 40, 0x453782 }, { 61, 0x3c4f8b }, { 100, 0x2a768f },
        { 133, 0x1f958c }, { 148, 0x1fa386 }, { 161, 0x29af80 }, { 176, 0x3ebc73 },
        { 194, 0x62cb60 }, { 215, 0x95d840 }, { 235, 0xcae11e }, { 242, 0xdde318 },
        { 249, 0xeee51b }, { 255, 0xfde725 } } },
    { { "plasma", "plasma(matplotlib)" },
      { { 0, 0x0d0887 }, { 6, 0x1e068e }, { 23, 0x3e049c }, { 45, 0x6100a7 }, { 61, 0x7901a9 },
        { 72, 0x8a09a6 }, { 91, 0xa41e9a }, { 119, 0xc33d80 }, { 150, 0xdf6064 }, { 183, 0xf58948 },
        { 211, 0xfeb030 }, { 228, 0xfdcb25 }, { 237, 0xfada25 }, { 253, 0xf1f526 },
        { 255, 0xf0f921 } } },
    { { "inferno", "inferno(matplotlib)" },
      { { 0, 0x000004 }, { 4, 0x010109 }, { 15, 0x090722 }, { 30, 0x1d0d45 }, { 38, 0x2b0b57 },
        { 48, 0x3d0966 }, { 63, 0x550f6e }, { 85, 0x781c6e }, { 109, 0x9f2a64 }, { 131, 0xc03952 },
        { 152, 0xdc4f3b }, { 173, 0xf06d21 }, { 192, 0xfa8e08 }, { 200, 0xfb9d06 },
        { 207, 0xfcaa0e }, { 221, 0xfac52c }, { 232, 0xf4db4b }, { 242, 0xf1ee70 },
        { 249, 0xf4f78e }, { 255, 0xfcffa4 } } },
    { { "magma", "magma(matplotlib)" },
      { { 0, 0x000004 }, { 5, 0x01010b }, { 23, 0x110d31 }, { 37, 0x231253 }, { 47, 0x341069 },
        { 55, 0x420f75 }, { 65, 0x52127d }, { 89, 0x782282 }, { 116, 0xa3307f }, { 139, 0xc83d73 },
        { 158, 0xe54e64 }, { 172, 0xf3635c }, { 184, 0xf97a5c }, { 201, 0xfe9969 },
        { 221, 0xfebf83 }, { 249, 0xfcf2b3 }, { 255, 0xfcfdbf } } },
    // By J. Nunez, C. Anderton and R. Renslow, PLoS ONE 13(7), 2018.
    { { "cividis" },
      { { 0, 0x00224e }, { 16, 0x002e69 }, { 20, 0x003071 }, { 23, 0x013171 }, { 29, 0x15366f },
        { 43, 0x2c406d }, { 69, 0x49526b }, { 104, 0x686a71 }, { 133, 0x817f79 }, { 164, 0x9f9776 },
        { 198, 0xc2b26a }, { 224, 0xdec958 }, { 243, 0xf3db43 }, { 252, 0xfee333 },
        { 255, 0xfee838 } } },
    // By A. Mikhailov, "Turbo, An Improved Rainbow Colormap for Visualization", 2019: Apache-2.0.
    { { "turbo" },
      { { 0, 0x30123b }, { 5, 0x362160 }, { 13, 0x3e3892 }, { 22, 0x4451bf }, { 30, 0x4666de },
        { 40, 0x467ff7 }, { 46, 0x448efe }, { 52, 0x3d9dfe }, { 59, 0x31b0f6 }, { 71, 0x1dcbdb },
        { 79, 0x17dbc4 }, { 86, 0x1be6b4 }, { 93, 0x29efa1 }, { 102, 0x46f884 }, { 114, 0x75fe5c },
        { 122, 0x93ff46 }, { 131, 0xacfb37 }, { 142, 0xc8ef33 }, { 154, 0xe4db38 },
        { 166, 0xf7c33b }, { 178, 0xfea732 }, { 189, 0xfd8625 }, { 202, 0xf36014 },
        { 212, 0xe5460a }, { 224, 0xd12f04 }, { 239, 0xad1601 }, { 254, 0x7e0502 },
        { 255, 0x7a0403 } } },
    // By K. Moreland, "Diverging Color Maps for Scientific Visualization", ISVC 2009: ParaView's
    // default. The knots fit the table of matplotlib, which has it as "coolwarm".
    { { "coolwarm", "cooltowarm" },
      { { 0, 0x3b4cc0 }, { 20, 0x526edd }, { 39, 0x6b8df1 }, { 59, 0x86aafd }, { 80, 0xa3c2ff },
        { 100, 0xbed3f7 }, { 120, 0xd5dce6 }, { 130, 0xe0dcd9 }, { 149, 0xf0cfbd },
        { 169, 0xf7b99e }, { 187, 0xf6a181 }, { 207, 0xec7f63 }, { 229, 0xd85545 },
        { 244, 0xc43132 }, { 247, 0xbf282f }, { 255, 0xb40426 } } },
  };
  return maps;
}

const std::vector<Formula>& Formulas()
{
  static const std::vector<Formula> formulas = {
    { { "gray", "grey", "grayscale" }, { { 0, 0, 0, 0 }, { 1, 1, 1, 1 } } },
    { { "x-ray", "xray", "binary", "greys" }, { { 0, 1, 1, 1 }, { 1, 0, 0, 0 } } },
    // VTK's and ParaView's rainbow from blue to red: hues from 240 to 0 degrees. VTK's default
    // table goes from red to blue: rainbow_r.
    { { "rainbow", "bluetoredrainbow" },
      { { 0, 0, 0, 1 }, { 0.25, 0, 1, 1 }, { 0.5, 0, 1, 0 }, { 0.75, 1, 1, 0 }, { 1, 1, 0, 0 } } },
    // As in matplotlib: the corners of its three channels.
    { { "jet" },
      { { 0, 0, 0, 0.5 }, { 0.11, 0, 0, 1 }, { 0.125, 0, 0, 1 }, { 0.34, 0, 0.86, 1 },
        { 0.35, 0, 0.9, 30 / 31.0 }, { 0.375, 2.5 / 31, 1, 27.5 / 31 },
        { 0.64, 29 / 31.0, 1, 1 / 31.0 }, { 0.65, 30 / 31.0, 26 / 27.0, 0 },
        { 0.66, 1, 25 / 27.0, 0 }, { 0.89, 1, 2 / 27.0, 0 },
        { 0.91, 1 - 0.5 * (0.02 / 0.11), 0, 0 }, { 1, 0.5, 0, 0 } } },
    // As in MATLAB and matplotlib: black, red, yellow, white.
    { { "hot" },
      { { 0, 0.0416, 0, 0 }, { 0.365079, 1, 0, 0 }, { 0.746032, 1, 1, 0 }, { 1, 1, 1, 1 } } },
    // ParaView's "Black-Body Radiation".
    { { "black-body", "blackbodyradiation", "blackbody" },
      { { 0, 0, 0, 0 }, { 0.4, 0.9, 0, 0 }, { 0.8, 0.9, 0.9, 0 }, { 1, 1, 1, 1 } } },
    // The others are as in MATLAB or matplotlib.
    { { "cool" }, { { 0, 0, 1, 1 }, { 1, 1, 0, 1 } } },
    { { "bone" },
      { { 0, 0, 0, 0 }, { 0.365079, 0.652778 * (0.365079 / 0.746032), 0.319444, 0.444444 },
        { 0.746032, 0.652778, 0.777778, 0.444444 + 0.555556 * (0.380953 / 0.634921) },
        { 1, 1, 1, 1 } } },
    { { "copper" },
      { { 0, 0, 0, 0 }, { 0.809524, 1, 0.7812 * 0.809524, 0.4975 * 0.809524 },
        { 1, 1, 0.7812, 0.4975 } } },
    { { "bwr" }, { { 0, 0, 0, 1 }, { 0.5, 1, 1, 1 }, { 1, 1, 0, 0 } } },
    { { "seismic" },
      { { 0, 0, 0, 0.3 }, { 0.25, 0, 0, 1 }, { 0.5, 1, 1, 1 }, { 0.75, 1, 0, 0 },
        { 1, 0.5, 0, 0 } } },
    { { "hsv" },
      { { 0, 1, 0, 0 }, { 1 / 6.0, 1, 1, 0 }, { 2 / 6.0, 0, 1, 0 }, { 3 / 6.0, 0, 1, 1 },
        { 4 / 6.0, 0, 0, 1 }, { 5 / 6.0, 1, 0, 1 }, { 1, 1, 0, 0 } } },
  };
  return formulas;
}

/// Lower case, without spaces, '-' and '_'.
std::string Simplified(const std::string& name)
{
  std::string simple;
  for (const char c : name)
  {
    if (c != ' ' && c != '-' && c != '_')
    {
      simple += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return simple;
}

/// Whether the name ends in "_r" or "_R"; removes that.
bool TakeReversal(std::string& name)
{
  const std::size_t size = name.size();
  const bool isReversed =
    size > 2 && name[size - 2] == '_' && (name[size - 1] == 'r' || name[size - 1] == 'R');
  name.resize(isReversed ? size - 2 : size);
  return isReversed;
}

template <typename Map>
const Map* Find(const std::vector<Map>& maps, const std::string& name)
{
  const std::string wanted = Simplified(name);
  const auto found = std::find_if(maps.begin(), maps.end(),
    [&wanted](const Map& map)
    {
      return std::any_of(map.names.begin(), map.names.end(),
        [&wanted](const char* known) { return Simplified(known) == wanted; });
    });
  return found != maps.end() ? &*found : nullptr;
}

ColorTable256 TableOf(const Formula& map)
{
  ColorTable256 table;
  std::size_t next = 1;
  for (int k = 0; k < 256; ++k)
  {
    const double place = k / 255.0;
    while (place > map.stops[next].place)
    {
      ++next;
    }
    const Stop &a = map.stops[next - 1], &b = map.stops[next];
    const double t = (place - a.place) / (b.place - a.place);
    const auto mix = [t](double from, double to)
    { return static_cast<unsigned char>(255 * (from + t * (to - from)) + 0.5); };
    table[k] = { mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue) };
  }
  return table;
}

ColorTable256 TableOf(const Sampled& map)
{
  ColorTable256 table;
  std::size_t next = 1;
  for (int k = 0; k < 256; ++k)
  {
    next += k > map.knots[next].entry ? 1 : 0;
    const Knot &a = map.knots[next - 1], &b = map.knots[next];
    const unsigned ofA = static_cast<unsigned>(b.entry - k);
    const unsigned ofB = static_cast<unsigned>(k - a.entry);
    const auto mix = [&](int shift)
    {
      const unsigned from = a.color >> shift & 255, to = b.color >> shift & 255;
      const unsigned twice = 2 * (from * ofA + to * ofB) + ofA + ofB; // rounds to the nearest
      return static_cast<unsigned char>(twice / (2 * (ofA + ofB)));
    };
    table[k] = { mix(16), mix(8), mix(0) };
  }
  return table;
}

} // namespace

std::optional<ColorTable256> FindColorMap(const std::string& name)
{
  std::string plain = name;
  const bool isReversed = TakeReversal(plain);
  const Sampled* const sampled = Find(SampledMaps(), plain);
  const Formula* const formula = Find(Formulas(), plain);
  if (!sampled && !formula)
  {
    return std::nullopt;
  }
  ColorTable256 table = sampled ? TableOf(*sampled) : TableOf(*formula);
  if (isReversed)
  {
    std::reverse(table.begin(), table.end());
  }
  return table;
}

std::string ColorMapNames()
{
  std::string names;
  const auto add = [&names](const auto& maps)
  {
    for (const auto& map : maps)
    {
      names += (names.empty() ? "" : ", ") + std::string(map.names.front());
    }
  };
  add(SampledMaps());
  add(Formulas());
  return names;
}

} // namespace lambent::command
