// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from the indices in an OBJ file to ids, each of which is checked
 *
 * A negative index counts back from the line that it is in. A positive one may
 * name what follows later in the file, so that it can only be judged at the end.
 * Of those that are ahead of the file so far, the growing maxima are kept with
 * their lines: the first of them that is too large in the end is also the first
 * index in the file that is.
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
  /// What the indices name, for messages: "normal" and the keyword "vn".
  ObjIndices(const char* noun, const char* keyword)
    : Noun(noun)
    , Keyword(keyword)
  {
  }

  /// The file has one more. Throws Failure if there are more than an id can count.
  void Add();

  /// The id, from 0, for an index in that line. Throws Failure if the index cannot be right.
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
  return static_cast<std::int32_t>(index - 1); // if it is cut off, CheckAll() throws
}

} // namespace lambent::command

#endif
