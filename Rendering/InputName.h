// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how messages name an input, or a block of one
 */
#ifndef InputName_h
#define InputName_h

#include "SceneSettings.h"

#include <cctype>
#include <string>

namespace lambent::adapters
{
/// "Input 2", or "Input 2, block 5 ("wing")". A negative block means none.
inline std::string nameOfInput(int connection, vtkIdType block, const std::string& blockName)
{
  return "Input " + std::to_string(connection) +
    (block < 0 ? "" : ", block " + std::to_string(block)) +
    (block < 0 || blockName.empty() ? "" : " (\"" + blockName + "\")");
}

inline std::string nameOf(const SceneSettings::Input& input)
{
  return nameOfInput(input.connection, input.block, input.blockName);
}

/// The text with a lower-case first letter, for use within a sentence.
inline std::string withinSentence(std::string text)
{
  if (!text.empty())
  {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}
}

#endif
