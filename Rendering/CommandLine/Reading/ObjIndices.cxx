// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ObjIndices.h"
#include "Messages.h"

#include <limits>

namespace lambent::command
{

void ObjIndices::Add()
{
  if (this->Count == std::numeric_limits<std::int32_t>::max())
  {
    throw Failure("it has more than " + std::to_string(this->Count) + " " + this->Noun +
      "s; divide it into several files");
  }
  ++this->Count;
}

void ObjIndices::Fail(std::int64_t index, std::size_t line) const
{
  const std::string all = (this->Count == 0 ? "no " : std::to_string(this->Count) + " ") +
    this->Noun + (this->Count == 1 ? "" : "s") + " (" + this->Keyword + ")";
  throw Failure("line " + std::to_string(line) + " uses " + this->Noun + " " +
    std::to_string(index) + ", but " +
    (index > 0       ? "the file has " + all
        : index == 0 ? "indices start at 1; so far the file has " + all
                     : "before that line it has " + all) +
    "; correct the line, or use a complete copy");
}

void ObjIndices::CheckAll() const
{
  for (const Ahead& ahead : this->Maxima)
  {
    if (ahead.index > this->Count)
    {
      this->Fail(ahead.index, ahead.line);
    }
  }
}

} // namespace lambent::command
