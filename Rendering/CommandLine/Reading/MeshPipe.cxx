// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshPipe.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace lambent::command
{
namespace
{

enum Role
{
  PointCoordinates,
  PointArray,
  CellArray,
  FirstCells // from here on: offsets and connectivity of verts, lines, polys and strips
};

struct Header
{
  int role;
  int type;
  int components;
  int attribute; ///< a vtkDataSetAttributes::AttributeTypes, or -1
  vtkTypeInt64 tuples;
  std::uint64_t nameSize; ///< the name follows the header, then the values
};

constexpr int CellKinds = 4;

void ThrowBroken()
{
  throw Failure("its reader ended before the mesh was complete");
}

} // namespace

void MeshPipeWriter::Write(const void* bytes, std::size_t size)
{
  const char* at = static_cast<const char*>(bytes);
  while (size > 0)
  {
    const ssize_t written = write(this->File, at, size);
    if (written < 0 && errno != EINTR)
    {
      return;
    }
    at += std::max<ssize_t>(0, written);
    size -= static_cast<std::size_t>(std::max<ssize_t>(0, written));
  }
}

void MeshPipeWriter::Send(MessageTag tag, const void* bytes, std::size_t size)
{
  const std::uint64_t count = size;
  this->Write(&tag, sizeof(tag));
  this->Write(&count, sizeof(count));
  this->Write(bytes, size);
}

void MeshPipeWriter::Send(int role, const char* name, int attribute, vtkDataArray* array)
{
  const std::string text = name ? name : "";
  const Header header = { role, array->GetDataType(), array->GetNumberOfComponents(), attribute,
    array->GetNumberOfTuples(), text.size() };
  const std::size_t size = static_cast<std::size_t>(array->GetNumberOfValues()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  const MessageTag tag = MessageTag::Array;
  const std::uint64_t count = sizeof(header) + text.size() + size;
  this->Write(&tag, sizeof(tag));
  this->Write(&count, sizeof(count));
  this->Write(&header, sizeof(header));
  this->Write(text.data(), text.size());
  this->Write(array->GetVoidPointer(0), size);
}

void MeshPipeWriter::Send(vtkPolyData* mesh)
{
  if (mesh->GetPoints())
  {
    this->Send(PointCoordinates, nullptr, -1, mesh->GetPoints()->GetData());
  }
  vtkCellArray* const cells[CellKinds] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  for (int kind = 0; kind < CellKinds; ++kind)
  {
    if (cells[kind] && cells[kind]->GetNumberOfCells() > 0)
    {
      this->Send(FirstCells + 2 * kind, nullptr, -1, cells[kind]->GetOffsetsArray());
      this->Send(FirstCells + 2 * kind + 1, nullptr, -1, cells[kind]->GetConnectivityArray());
    }
  }
  for (const int role : { PointArray, CellArray })
  {
    vtkDataSetAttributes* const data = role == PointArray
      ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData())
      : static_cast<vtkDataSetAttributes*>(mesh->GetCellData());
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* const array = data->GetArray(k); // null for strings
      if (array && array->GetDataType() != VTK_BIT)
      {
        this->Send(role, array->GetName(), data->IsArrayAnAttribute(k), array);
      }
    }
  }
}

struct MeshPipeReader::Parts
{
  vtkNew<vtkPolyData> mesh;
  vtkSmartPointer<vtkDataArray> points;
  vtkSmartPointer<vtkDataArray> cells[2 * CellKinds];
  struct Data
  {
    bool isOfPoints;
    int attribute;
    vtkSmartPointer<vtkDataArray> array;
  };
  std::vector<Data> data;
};

MeshPipeReader::MeshPipeReader(int file)
  : File(file)
  , Taken(new Parts)
{
}

MeshPipeReader::~MeshPipeReader()
{
  delete this->Taken;
}

bool MeshPipeReader::Read(void* bytes, std::size_t size)
{
  char* at = static_cast<char*>(bytes);
  while (size > 0)
  {
    const ssize_t got = read(this->File, at, size);
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      return false;
    }
    at += std::max<ssize_t>(0, got);
    size -= static_cast<std::size_t>(std::max<ssize_t>(0, got));
  }
  return true;
}

bool MeshPipeReader::Next(MessageTag& tag)
{
  return this->Read(&tag, sizeof(tag)) && this->Read(&this->Size, sizeof(this->Size));
}

std::string MeshPipeReader::TakeText()
{
  std::string text;
  char bytes[4096];
  while (this->Size > 0)
  {
    const std::size_t step = std::min<std::uint64_t>(this->Size, sizeof(bytes));
    if (!this->Read(bytes, step))
    {
      ThrowBroken();
    }
    text.append(bytes, step);
    this->Size -= step;
  }
  return text;
}

double MeshPipeReader::TakeNumber()
{
  const std::string bytes = this->TakeText();
  double number = 0;
  std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof(number)));
  return number;
}

void MeshPipeReader::TakeArray()
{
  Header header;
  if (!this->Read(&header, sizeof(header)))
  {
    ThrowBroken();
  }
  std::string name(header.nameSize, '\0');
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(header.type));
  if (!array || !this->Read(name.data(), name.size()))
  {
    ThrowBroken();
  }
  array->SetNumberOfComponents(header.components);
  array->SetNumberOfTuples(header.tuples);
  if (!name.empty())
  {
    array->SetName(name.c_str());
  }
  if (!this->Read(array->GetVoidPointer(0),
        static_cast<std::size_t>(array->GetNumberOfValues()) *
          static_cast<std::size_t>(array->GetDataTypeSize())))
  {
    ThrowBroken();
  }
  if (header.role == PointCoordinates)
  {
    this->Taken->points = array;
  }
  else if (header.role >= FirstCells && header.role < FirstCells + 2 * CellKinds)
  {
    this->Taken->cells[header.role - FirstCells] = array;
  }
  else
  {
    this->Taken->data.push_back({ header.role == PointArray, header.attribute, array });
  }
}

vtkSmartPointer<vtkPolyData> MeshPipeReader::MakeMesh()
{
  vtkPolyData* const mesh = this->Taken->mesh;
  vtkNew<vtkPoints> points;
  if (this->Taken->points && this->Taken->points->GetNumberOfComponents() == 3)
  {
    points->SetData(this->Taken->points);
  }
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> cells[CellKinds];
  for (int kind = 0; kind < CellKinds; ++kind)
  {
    vtkDataArray* const offsets = this->Taken->cells[2 * kind];
    vtkDataArray* const connectivity = this->Taken->cells[2 * kind + 1];
    if (offsets && (!connectivity || !cells[kind]->SetData(offsets, connectivity)))
    {
      ThrowBroken();
    }
  }
  mesh->SetVerts(cells[0]);
  mesh->SetLines(cells[1]);
  mesh->SetPolys(cells[2]);
  mesh->SetStrips(cells[3]);
  for (const Parts::Data& data : this->Taken->data)
  {
    vtkDataSetAttributes* const attributes = data.isOfPoints
      ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData())
      : static_cast<vtkDataSetAttributes*>(mesh->GetCellData());
    const int index = attributes->AddArray(data.array);
    if (data.attribute >= 0)
    {
      attributes->SetActiveAttribute(index, data.attribute);
    }
  }
  return mesh;
}

} // namespace lambent::command
