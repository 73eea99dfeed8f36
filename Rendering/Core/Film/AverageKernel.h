// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the averages of n x n samples
 */
#ifndef lambent_AverageKernel_h
#define lambent_AverageKernel_h

namespace lambent
{
/**
 * averages[p], p from 0 to count - 1: the sum of the samples n p to n p + n - 1 of n rows,
 * which begin `stride` apart, divided by n^2. They are added one after the other, rows from
 * the bottom, each from the left. As many values may be read, and averages written, as if
 * there were seven more.
 */
void averageSamples(const double* samples, int stride, int n, int count, double* averages);
}

#endif
