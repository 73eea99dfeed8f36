// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PassValue.h"
#include "FileKinds.h"
#include "Values.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lambent::command
{
namespace
{

using Content = PassValue::Content;
using Association = PassValue::Association;

struct KnownPass
{
  const char* word;
  Content content;
  const char* array; ///< its name in the picture
};

constexpr KnownPass Known[] = {
  { "depth", Content::Depth, "Depth" },
  { "normals", Content::Normals, "Normals" },
  { "positions", Content::Positions, "Positions" },
  { "ids", Content::CellIds, "CellIds" },
  { "input-ids", Content::InputIds, "InputIds" },
};

/// Makes the pass store the array of that name, which may begin with point: or cell:.
void NameArray(PassValue& pass, const std::string& name)
{
  pass.content = Content::Array;
  pass.array = name;
  for (const auto& [prefix, association] :
    { std::pair("point:", Association::Points), std::pair("cell:", Association::Cells) })
  {
    const std::string start = prefix;
    if (name.compare(0, start.size(), start) == 0)
    {
      pass.association = association;
      pass.array = name.substr(start.size());
    }
  }
  if (pass.array.empty())
  {
    throw BadValue("'" + pass.text +
      "' needs a name: depth, normals, positions, ids, input-ids or the name of an array");
  }
  if (IsOwnArray(pass.array))
  {
    throw BadValue("'" + pass.array +
      "' is the name of an array that the picture itself has (depth, normals, positions, ids and "
      "input-ids request these); to store an input's array of that name, rename it");
  }
}

} // namespace

bool IsOwnArray(const std::string& name)
{
  return name == "Color" ||
    std::any_of(std::begin(Known), std::end(Known),
      [&name](const KnownPass& known) { return name == known.array; });
}

PassValue ParsePass(const std::string& text)
{
  const std::size_t equals = text.find('=');
  PassValue pass;
  pass.text = text.substr(0, equals);
  bool isKnown = false;
  for (const KnownPass& known : Known)
  {
    if (pass.text == known.word)
    {
      pass.content = known.content;
      pass.array = known.array;
      isKnown = true;
    }
  }
  if (!isKnown)
  {
    NameArray(pass, pass.text);
  }
  if (equals != std::string::npos)
  {
    pass.file = text.substr(equals + 1);
    const auto kind = PictureKindOf(pass.file);
    if (kind != PictureKind::Tiff && kind != PictureKind::Vti)
    {
      throw BadValue("'" + pass.file +
        "' does not end in .tif, .tiff or .vti, the kinds of files that can hold floats");
    }
  }
  return pass;
}

} // namespace lambent::command
