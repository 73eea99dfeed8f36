// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief prevents libtiff from printing, and stores its first error
 *
 * It sets the handlers of the whole process, because handlers of a single file need libtiff 4.5,
 * and VTK's copy may be older. Therefore only one object may exist at a time.
 */

#ifndef TiffErrors_h
#define TiffErrors_h

#include "vtk_tiff.h"

namespace lambent::command
{

class TiffErrors
{
public:
  TiffErrors();
  ~TiffErrors();
  TiffErrors(const TiffErrors&) = delete;
  TiffErrors& operator=(const TiffErrors&) = delete;

  /// The first error since this object was created; empty if there was none.
  const char* First() const;

private:
  TIFFErrorHandler OnError;
  TIFFErrorHandler OnWarning;
};

} // namespace lambent::command

#endif
