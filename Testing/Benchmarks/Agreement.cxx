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
  Peers& peers, const Compared& compared, const std::string& folder)
{
  const Pictures pictures(folder);
  std::map<std::string, double> differing;
  const auto renderOurs = [&](int samples)
  {
    peers.lambent().render(samples);
    pictures.write(withSamples("lambent", samples), peers.lambent().picture());
  };
  const auto compare = [&](const std::string& name, vtkImageData* picture)
  {
    pictures.write(name, picture);
    differing[name] = fractionDiffering(peers.lambent().picture(), picture);
  };
  for (int samples : compared.embree)
  {
    renderOurs(samples);
    for (RayGrouping grouping : rayGroupings)
    {
      peers.embree().trace(TreeQuality::Medium, grouping, samples);
      compare(
        withSamples(std::string("embree/") + nameOf(grouping), samples), peers.embree().picture());
    }
  }
  if (compared.layers)
  {
    peers.lambent().renderLayers();
    pictures.write("layers/lambent", peers.lambent().picture());
    peers.embree().traceLayers(TreeQuality::Medium);
    compare("layers/embree/packets", peers.embree().picture());
  }
  if (compared.balls)
  {
    renderOurs(1);
    peers.balls().trace(TreeQuality::Medium);
    compare("balls/embree", peers.balls().picture());
  }
  if (compared.openGL)
  {
    renderOurs(1);
    compare("opengl", peers.opengl().picture());
  }
  return differing;
}
