// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TiffErrors.h"

#include <cstdarg>
#include <cstdio>

namespace lambent::command
{
namespace
{

char FirstError[256]; // exceptions must not pass through libtiff, so nothing is allocated

void KeepError(const char*, const char* format, va_list values)
{
  if (FirstError[0] == '\0')
  {
    std::vsnprintf(FirstError, sizeof FirstError, format, values);
  }
}

} // namespace

TiffErrors::TiffErrors()
  : OnError(TIFFSetErrorHandler(KeepError))
  , OnWarning(TIFFSetWarningHandler(nullptr))
{
  FirstError[0] = '\0';
}

TiffErrors::~TiffErrors()
{
  TIFFSetErrorHandler(this->OnError);
  TIFFSetWarningHandler(this->OnWarning);
}

const char* TiffErrors::First() const
{
  return FirstError;
}

} // namespace lambent::command
