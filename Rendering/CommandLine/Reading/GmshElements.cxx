// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "GmshElements.h"
#include "GmshTypes.h"
#include "Messages.h"
#include "MshCursor.h"
#include "NumberedMesh.h"
#include "Progress.h"

#include <string>
#include <vector>

namespace lambent::command
{
namespace
{

class ElementReader
{
public:
  ElementReader(MshCursor& cursor, NumberedMesh& mesh, Progress& progress)
    : Cursor(cursor)
    , Mesh(mesh)
    , Update(progress)
  {
  }

  void Take(bool isVersion2)
  {
    if (!isVersion2)
    {
      this->TakeElements4();
      return;
    }
    const std::int64_t count = this->Cursor.TakeLineCount("the number of elements");
    for (std::int64_t taken = 0; taken < count;)
    {
      taken += this->Cursor.GetBinary() ? this->TakeElementBlock2() : this->TakeElement2();
      if (taken > count)
      {
        this->Cursor.Fail(
          "there are more elements than the " + std::to_string(count) + " that it declares");
      }
    }
  }

private:
  int TakeElement2()
  {
    const std::int64_t number = this->Cursor.TakeTextInt("the number of an element");
    const GmshType& type =
      this->FindType(this->Cursor.TakeTextInt("the type of an element"), number);
    this->SkipTags(this->Cursor.TakeTextInt("the number of tags of an element"));
    this->TakeElementNodes(type, number, false);
    return 1;
  }

  /// In binary files, elements with the same type and number of tags form a block.
  std::int64_t TakeElementBlock2()
  {
    const std::int64_t type = this->Cursor.TakeInt("the type of an element");
    const std::int64_t count = this->Cursor.TakeInt("the number of elements of a block");
    const std::int64_t tags = this->Cursor.TakeInt("the number of tags of an element");
    if (count <= 0)
    {
      this->Cursor.Fail("a block of elements is empty");
    }
    for (std::int64_t element = 0; element < count; ++element)
    {
      const std::int64_t number = this->Cursor.TakeInt("the number of an element");
      this->SkipTags(tags);
      this->TakeElementNodes(this->FindType(type, number), number, false);
    }
    return count;
  }

  void SkipTags(std::int64_t tags)
  {
    if (tags < 0)
    {
      this->Cursor.Fail("the number of tags of an element is negative");
    }
    for (std::int64_t k = 0; k < tags; ++k)
    {
      this->Cursor.TakeInt("a tag of an element");
    }
  }

  void TakeElements4()
  {
    const std::int64_t blocks = this->Cursor.TakeCount("the number of blocks of elements");
    const std::int64_t count = this->Cursor.TakeCount("the number of elements");
    this->Cursor.TakeCount("the smallest number of an element");
    this->Cursor.TakeCount("the largest number of an element");
    std::int64_t taken = 0;
    for (std::int64_t block = 0; block < blocks; ++block)
    {
      this->Cursor.TakeInt("the dimension of a block of elements");
      this->Cursor.TakeInt("the number of an entity");
      const std::int64_t type = this->Cursor.TakeInt("the type of an element");
      const std::int64_t size = this->Cursor.TakeCount("the number of elements of a block");
      for (std::int64_t element = 0; element < size; ++element)
      {
        const std::int64_t number = this->Cursor.TakeCount("the number of an element");
        this->TakeElementNodes(this->FindType(type, number), number, true);
      }
      taken += size;
    }
    if (taken != count)
    {
      this->Cursor.Fail("its blocks have " + std::to_string(taken) + " elements instead of " +
        std::to_string(count));
    }
  }

  const GmshType& FindType(std::int64_t number, std::int64_t element)
  {
    const GmshType* const type = FindGmshType(number);
    if (!type)
    {
      throw Failure("element " + std::to_string(element) + " is of type " + std::to_string(number) +
        ", which cannot be read; save it with elements of order 1 or 2");
    }
    return *type;
  }

  void TakeElementNodes(const GmshType& type, std::int64_t number, bool areSizes)
  {
    this->Corners.clear();
    for (int k = 0; k < type.nodes; ++k)
    {
      constexpr const char* what = "a node of an element";
      this->Corners.push_back(areSizes ? this->Cursor.TakeSize(what) : this->Cursor.TakeInt(what));
    }
    if (type.shape.corners > 0)
    {
      this->Mesh.AddElement(number, type.shape, this->Corners);
    }
    if (++this->Taken % 8192 == 0)
    {
      this->Update.Update(this->Cursor.Fraction());
    }
  }

  MshCursor& Cursor;
  NumberedMesh& Mesh;
  Progress& Update;
  std::vector<std::int64_t> Corners;
  std::int64_t Taken = 0;
};

} // namespace

void TakeGmshElements(MshCursor& cursor, bool isVersion2, NumberedMesh& mesh, Progress& progress)
{
  ElementReader(cursor, mesh, progress).Take(isVersion2);
}

} // namespace lambent::command
