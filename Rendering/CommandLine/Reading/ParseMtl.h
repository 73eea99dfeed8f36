// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parses the materials in a .mtl file
 *
 * Of each `newmtl`, the diffuse colour (`Kd`), the ambient colour (`Ka`), the specular colour
 * (`Ks`) with its exponent (`Ns`), the opacity (`d`, or else `Tr`, which is 1 minus the opacity),
 * the illumination model (`illum`) and the image of the diffuse colour (`map_Kd`, with the options
 * `-s`,
 * `-o` and `-clamp`) are read; everything else is skipped. Colours are one number or three, clamped
 * to 0 ... 1; those given as spectra (`spectral`, `xyz`) are skipped.
 *
 * Reference: Wavefront Technologies, "MTL material format (Lightwave, OBJ)", 1995.
 */

#ifndef ParseMtl_h
#define ParseMtl_h

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambent::command
{

struct Material
{
  std::string name;
  std::optional<std::array<double, 3>> diffuse, ambient;
  std::optional<std::array<double, 3>> specular;
  std::optional<double> specularPower; ///< 0 ... 128, the range of vtkProperty
  std::optional<double> opacity;       ///< 0 ... 1, of `d`
  std::optional<double> transparency;  ///< 0 ... 1, of `Tr`; `d` overrides it
  bool hasHighlights = true;           ///< the illumination model is not 0 or 1
  std::string image;                   ///< file of the texture as written, or empty
  std::array<double, 2> scale{ 1, 1 }; ///< of texture coordinates, before the offset
  std::array<double, 2> offset{ 0, 0 };
  bool isClamped = false; ///< the texture is not repeated
};

/// Throws Failure with the line if a number is invalid. A zero byte must follow the text.
std::vector<Material> ParseMtl(std::string_view text);

} // namespace lambent::command

#endif
