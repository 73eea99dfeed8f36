// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputImage.h"

#include "HugePages.h"
#include "InputSurfaces.h"
#include "PassTable.h"
#include "WatchedParallel.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <new>
#include <string>

namespace lambent::adapters
{
namespace
{
/// Refuses what the machine's memory certainly cannot hold. Most systems would promise it all the
/// same and end the process once it is written to.
void checkMemory(double bytes)
{
  constexpr double alwaysTried = 1e9;
  if (bytes > alwaysTried)
  {
    vtksys::SystemInformation machine;
    machine.RunMemoryCheck();
    if (bytes > 1024.0 * 1024.0 * static_cast<double>(machine.GetTotalPhysicalMemory()))
    {
      throw std::bad_alloc();
    }
  }
}

struct NamedPass
{
  Pass pass;
  std::string name;
};

std::vector<NamedPass> passesOf(const OutputSettings& settings, const InputSurfaces& surfaces)
{
  std::vector<NamedPass> passes;
  for (const PassContent content : settings.contents)
  {
    const PassEntry& entry = *entryOf(content);
    passes.push_back({ { content, entry.components, entry.isDouble, nullptr, 0 }, entry.name });
  }
  for (std::size_t k = 0; k < settings.passArrays.size(); ++k)
  {
    const InputSurfaces::ArrayForm form = surfaces.formOf(k);
    passes.push_back({ { PassContent::Attribute, form.components, form.isDouble, nullptr, k },
      settings.passArrays[k].name });
  }
  return passes;
}

double bytesPerPixel(const OutputSettings& settings, const std::vector<NamedPass>& passes)
{
  const int colorSize = vtkDataArray::GetDataTypeSize(settings.scalarType);
  double bytes = (settings.alpha ? 4.0 : 3.0) * colorSize;
  bytes += settings.ids ? 2.0 * sizeof(vtkIdType) + sizeof(std::uint32_t) : 0.0;
  bytes += settings.blockIds ? sizeof(vtkIdType) : 0.0;
  for (const NamedPass& pass : passes)
  {
    bytes += static_cast<double>(pass.pass.components) * (pass.pass.isDouble ? 8 : 4);
  }
  return bytes;
}

vtkSmartPointer<vtkDataArray> makeArray(
  int type, const std::string& name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  useHugePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(tuples) * components * array->GetDataTypeSize());
  return array;
}
}

Image allocateImage(const OutputSettings& settings, const InputSurfaces& surfaces,
  vtkInformation* outInfo, vtkImageData* output)
{
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  Image image;
  image.width = settings.size[0];
  image.height = settings.size[1];
  image.part = { extent[0], extent[1] + 1, extent[2], extent[3] + 1 };
  image.samples = settings.samples;
  image.hasAlpha = settings.alpha;
  const vtkIdType pixels = static_cast<vtkIdType>(image.part.width()) * image.part.height();
  std::vector<NamedPass> passes = passesOf(settings, surfaces);
  checkMemory(bytesPerPixel(settings, passes) * static_cast<double>(pixels));

  output->SetExtent(extent);
  const auto colors = makeArray(settings.scalarType, "Color", image.channels(), pixels);
  output->GetPointData()->SetScalars(colors);
  if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(colors))
  {
    image.bytes = bytes->GetPointer(0);
  }
  if (auto* floats = vtkFloatArray::SafeDownCast(colors))
  {
    image.floats = floats->GetPointer(0);
  }
  for (NamedPass& named : passes)
  {
    const auto array = makeArray(
      named.pass.isDouble ? VTK_DOUBLE : VTK_FLOAT, named.name, named.pass.components, pixels);
    named.pass.data = array->GetVoidPointer(0);
    output->GetPointData()->AddArray(array);
    image.passes.push_back(named.pass);
  }
  return image;
}

void addIds(const std::uint32_t* primitives, const InputSurfaces& surfaces, bool hasBlockIds,
  const WatchedParallel& parallel, vtkImageData* output)
{
  const vtkIdType pixels = output->GetNumberOfPoints();
  const auto cells = makeArray(VTK_ID_TYPE, "CellIds", 1, pixels);
  const auto inputs = makeArray(VTK_ID_TYPE, "InputIds", 1, pixels);
  const auto blocks = makeArray(VTK_ID_TYPE, "BlockIds", 1, hasBlockIds ? pixels : 0);
  auto* const cell = static_cast<vtkIdType*>(cells->GetVoidPointer(0));
  auto* const input = static_cast<vtkIdType*>(inputs->GetVoidPointer(0));
  auto* const block = static_cast<vtkIdType*>(blocks->GetVoidPointer(0));
  const auto addTo = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType k = begin; k < end; ++k)
    {
      InputSurfaces::Place place{ 0, -1, -1, -1 };
      if (primitives[k] != noPrimitive)
      {
        place = surfaces.find(primitives[k]);
      }
      cell[k] = static_cast<vtkIdType>(place.cell);
      input[k] = place.connection;
      if (hasBlockIds)
      {
        block[k] = place.block;
      }
    }
  };
  constexpr vtkIdType atOnce = 1024 * 1024;
  for (vtkIdType begin = 0; begin < pixels; begin += atOnce)
  {
    parallel.checkAbort();
    vtkSMPTools::For(begin, std::min(begin + atOnce, pixels), addTo);
  }
  output->GetPointData()->AddArray(cells);
  output->GetPointData()->AddArray(inputs);
  if (hasBlockIds)
  {
    output->GetPointData()->AddArray(blocks);
  }
}
}
