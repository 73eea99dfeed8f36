// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReportSection.h"
#include "ReportFile.h"
#include "WritePicture.h"

#include "vtkBase64Utilities.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace lambent::command
{
namespace
{

constexpr std::size_t MostRows = 15;

/// The picture as bytes. Floats are scaled from 0..1 to 0..255, unsigned shorts from 0..65535;
/// other types are clamped.
vtkSmartPointer<vtkImageData> InBytes(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  if (values->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return image;
  }
  const bool isReal = values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE;
  const double scale = isReal                     ? 255.0
    : values->GetDataType() == VTK_UNSIGNED_SHORT ? 1 / 257.0
                                                  : 1.0;
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(values->GetNumberOfComponents());
  bytes->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType pixel = 0; pixel < values->GetNumberOfTuples(); ++pixel)
  {
    for (int channel = 0; channel < values->GetNumberOfComponents(); ++channel)
    {
      const double value = scale * values->GetComponent(pixel, channel);
      bytes->SetComponent(
        pixel, channel, value > 0 ? std::floor(std::min(value, 255.0) + 0.5) : 0.0);
    }
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  result->GetPointData()->SetScalars(bytes);
  return result;
}

std::string ImageTag(vtkImageData* image, const char* what, VtkMessages& messages)
{
  const auto png = EncodePng(InBytes(image), messages);
  const auto size = static_cast<std::size_t>(png->GetNumberOfValues());
  std::string code(4 * ((size + 2) / 3), '\0');
  code.resize(vtkBase64Utilities::Encode(
    png->GetPointer(0), size, reinterpret_cast<unsigned char*>(&code[0])));
  return std::string("<img alt=\"") + what + "\" src=\"data:image/png;base64," + code + "\">";
}

/// Small pictures are enlarged by a whole factor.
std::string Width(vtkImageData* image)
{
  const int width = image->GetDimensions()[0];
  return "style=\"width: " + std::to_string(width * std::max(1, 360 / width)) + "px\"";
}

std::string Figure(vtkImageData* image, const char* what, VtkMessages& messages)
{
  return "<figure " + Width(image) + ">" + ImageTag(image, what, messages) + "<figcaption>" + what +
    "</figcaption></figure>\n";
}

std::string Slider(const Verdict& verdict, VtkMessages& messages)
{
  return "<figure " + Width(verdict.picture) + "><div class=\"slide\">" +
    ImageTag(verdict.picture, "picture", messages) +
    ImageTag(verdict.baseline, "baseline", messages) +
    "</div><input type=\"range\" aria-label=\"picture or baseline\" oninput=\""
    "previousElementSibling.lastElementChild.style.clipPath = `inset(0 0 0 ${value}%)`\">"
    "<figcaption><span>picture</span><span>baseline</span></figcaption></figure>\n";
}

std::string Pictures(const Verdict& verdict, VtkMessages& messages)
{
  if (verdict.difference)
  {
    return Slider(verdict, messages) + Figure(verdict.difference, "difference", messages);
  }
  std::string all;
  for (const auto& [image, what] : { std::make_pair(verdict.picture.Get(), "picture"),
         std::make_pair(verdict.baseline.Get(), "baseline") })
  {
    if (image && image->GetNumberOfPoints() > 0 && image->GetDimensions()[2] == 1)
    {
      all += Figure(image, what, messages);
    }
  }
  return all;
}

std::string Table(const Verdict& verdict)
{
  if (verdict.cells.empty())
  {
    return "";
  }
  std::vector<ChangedCell> cells = verdict.cells;
  std::stable_sort(cells.begin(), cells.end(),
    [](const ChangedCell& a, const ChangedCell& b) { return a.pixels > b.pixels; });
  std::string rows = "<table><tr><th>changed pixels show</th><th>cell</th><th>pixels</th>"
                     "<th>the first</th></tr>\n";
  for (std::size_t k = 0; k < std::min(cells.size(), MostRows); ++k)
  {
    const ChangedCell& cell = cells[k];
    const bool isHit = cell.input >= 0;
    rows += "<tr><td>" +
      (isHit ? EscapeHtml(verdict.inputs[cell.input]) : std::string("the background")) +
      "</td><td>" + (isHit ? std::to_string(cell.cell) : std::string()) + "</td><td>" +
      std::to_string(cell.pixels) + "</td><td>(" + std::to_string(cell.x) + ", " +
      std::to_string(cell.y) + ")</td></tr>\n";
  }
  const std::size_t others = cells.size() - std::min(cells.size(), MostRows);
  return rows + "</table>\n" +
    (others == 0 ? "" : "<p>and " + std::to_string(others) + " other cells</p>\n");
}

} // namespace

std::string DescribeInHtml(const std::string& name, const Verdict& verdict, VtkMessages& messages)
{
  std::string text = std::string("<section class=\"") + (verdict.passed ? "passed" : "failed") +
    "\">\n<h2>" + EscapeHtml(name) + "</h2>\n<div>" + EscapeHtml(verdict.message) + "</div>\n";
  if (!verdict.passed)
  {
    text +=
      "<div class=\"pictures\">\n" + Pictures(verdict, messages) + "</div>\n" + Table(verdict);
  }
  return text + "</section>";
}

} // namespace lambent::command
