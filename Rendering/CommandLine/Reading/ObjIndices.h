// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief converts the indices in an OBJ file to checked ids
 *
 * A negative index counts back from its line. A positive index may name an item later in the file,
 * so it can only be checked at the end. Of the indices that are ahead of the items read so far, the
 * running maxima are kept with their lines. The first of these that is too large at the end is also
 * the first such index in the file.
 */

#ifndef ObjIndices_h
#define ObjIndices_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lambent::command
{

class ObjIndices
{
public:
  /// The noun and the keyword of the items, for messages, such as "normal" and "vn".
  ObjIndices(const char* noun, const char* keyword)
    : Noun(noun)
    , Keyword(keyword)
  {
  }

  /// Counts one more item. Throws Failure if there are more than ids can count.
  void Add();

  /// The id, from 0, for an index in that line. Throws Failure if the index is surely invalid.
  std::int32_t Resolve(std::int64_t index, std::size_t line);

  /// At the end of the file: throws Failure if an index was too large.
  void CheckAll() const;

private:
  [[noreturn]] void Fail(std::int64_t index, std::size_t line) const;

  struct Ahead
  {
    std::int64_t index;
    std::size_t line;
  };

  const char* Noun;
  const char* Keyword;
  std::int64_t Count = 0;
  std::vector<Ahead> Maxima;
};

inline std::int32_t ObjIndices::Resolve(std::int64_t index, std::size_t line)
{
  if (index > this->Count)
  {
    if (this->Maxima.empty() || index > this->Maxima.back().index)
    {
      this->Maxima.push_back({ index, line });
    }
  }
  else if (index < 0 && index >= -this->Count)
  {
    return static_cast<std::int32_t>(this->Count + index);
  }
  else if (index <= 0)
  {
    this->Fail(index, line);
  }
  return static_cast<std::int32_t>(index - 1); // if it does not fit, CheckAll() throws
}

} // namespace lambent::command

#endif
