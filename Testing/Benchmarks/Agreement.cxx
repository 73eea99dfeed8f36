// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Agreement.h"

#include "vtkPNGWriter.h"

#include <cstdlib>
#include <filesystem>

namespace
{
double fractionDiffering(vtkImageData* a, vtkImageData* b)
{
  const auto* left = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* right = static_cast<const unsigned char*>(b->GetScalarPointer());
  const vtkIdType bytes = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  if (bytes != b->GetNumberOfPoints() * b->GetNumberOfScalarComponents())
  {
    return 1.0;
  }
  vtkIdType differing = 0;
  for (vtkIdType k = 0; k < bytes; ++k)
  {
    differing += std::abs(left[k] - right[k]) > 2;
  }
  return static_cast<double>(differing) / static_cast<double>(bytes);
}

class Pictures
{
public:
  explicit Pictures(const std::string& folder)
    : Folder(folder)
  {
  }

  void write(std::string name, vtkImageData* picture) const
  {
    if (this->Folder.empty())
    {
      return;
    }
    std::filesystem::create_directories(this->Folder);
    std::replace(name.begin(), name.end(), '/', '-');
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(picture);
    writer->SetFileName((this->Folder + "/" + name + ".png").c_str());
    writer->Write();
  }

private:
  const std::string Folder;
};
}

std::map<std::string, double> comparePictures(
  Peers& peers, bool withEmbree, bool withOpenGL, const std::string& folder)
{
  const Pictures pictures(folder);
  std::map<std::string, double> differing;
  peers.lambent().render();
  pictures.write("lambent", peers.lambent().picture());
  const auto compare = [&](const std::string& name, vtkImageData* picture)
  {
    pictures.write(name, picture);
    differing[name] = fractionDiffering(peers.lambent().picture(), picture);
  };
  if (withEmbree)
  {
    peers.embree().build(TreeQuality::Medium);
    for (RayGrouping grouping : rayGroupings)
    {
      peers.embree().trace(TreeQuality::Medium, grouping);
      compare(std::string("embree/") + nameOf(grouping), peers.embree().picture());
    }
  }
  if (withOpenGL)
  {
    compare("opengl", peers.opengl().picture());
  }
  return differing;
}
