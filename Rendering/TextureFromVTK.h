// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a vtkTexture as the core's texture
 *
 * Which pixels are colours, and which are mapped, is as in vtkOpenGLTexture. In its default colour
 * mode, unsigned char is colours; everything else is mapped through the lookup table, or, if there
 * is none, through a new one over the range of the first component. If direct scalars are asked
 * for, unsigned short and float with three or four components are colours, too.
 *
 * One component and a vtkLookupTable are mapped by the core. All else is mapped by VTK.
 */
#ifndef TextureFromVTK_h
#define TextureFromVTK_h

#include "SpansFromVTK.h"
#include "Texture.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkScalarsToColors;
class vtkTexture;
class vtkUnsignedCharArray;

namespace lambent::adapters
{
class TextureFromVTK
{
public:
  /// Brings the texture's image up to date, as vtkTexture::Render() does. The texture must outlive
  /// this object and keep its image. Throws std::runtime_error with a message for the user.
  explicit TextureFromVTK(vtkTexture* texture);
  TextureFromVTK(const TextureFromVTK&) = delete;

  const Texture& texture() const { return this->Result; }

private:
  void setSize(vtkImageData* image, vtkDataArray* pixels);
  void setPixels(vtkTexture* texture, vtkDataArray* pixels);
  void map(vtkTexture* texture, vtkDataArray* pixels);
  void setMatrix(vtkTexture* texture);

  SpansFromVTK Spans;
  vtkSmartPointer<vtkUnsignedCharArray> MappedByVTK;
  std::vector<unsigned char> Mapped;
  Texture Result;
};
}

#endif
