// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "AverageKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorDoubles.h"

#include "AverageKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// Calls add(column) for each of the n columns of a row of samples, from the left. Each lane of a
/// column is the sample of another pixel.
template <typename Add>
void addRow(const double* samples, int n, const Add& add)
{
  V a, b, c, e;
  switch (n)
  {
    case 2:
      hn::LoadInterleaved2(d, samples, a, b);
      add(a);
      add(b);
      break;
    case 3:
      hn::LoadInterleaved3(d, samples, a, b, c);
      add(a);
      add(b);
      add(c);
      break;
    case 4:
      hn::LoadInterleaved4(d, samples, a, b, c, e);
      add(a);
      add(b);
      add(c);
      add(e);
      break;
    default:
      HWY_ALIGN double column[lanesAtMost];
      for (int k = 0; k < n; ++k)
      {
        for (std::size_t lane = 0; lane < lanes; ++lane)
        {
          column[lane] = samples[lane * n + k];
        }
        add(hn::Load(d, column));
      }
  }
}

void AverageSamples(const double* samples, int stride, int n, int count, double* averages)
{
  const V divisor = hn::Set(d, static_cast<double>(n * n));
  for (int p = 0; p < count; p += static_cast<int>(lanes))
  {
    V sum = hn::Zero(d);
    bool isFirst = true;
    for (int row = 0; row < n; ++row)
    {
      addRow(samples + static_cast<std::size_t>(row) * stride + p * n, n,
        [&](V value)
        {
          sum = isFirst ? value : hn::Add(sum, value);
          isFirst = false;
        });
    }
    hn::StoreU(hn::Div(sum, divisor), d, averages + p);
  }
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(AverageSamples);

void averageSamples(const double* samples, int stride, int n, int count, double* averages)
{
  HWY_DYNAMIC_DISPATCH(AverageSamples)(samples, stride, n, count, averages);
}
}
#endif
