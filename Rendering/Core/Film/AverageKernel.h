// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief averages n x n samples per pixel
 */
#ifndef lambent_AverageKernel_h
#define lambent_AverageKernel_h

namespace lambent
{
/**
 * For p in [0, count), averages[p] becomes the sum of the samples n p to n p + n - 1 of n rows,
 * divided by n^2. Rows begin `stride` apart. The samples are added one after the other, rows from
 * the bottom, each from the left. May read and write as if `count` were up to seven larger.
 */
void averageSamples(const double* samples, int stride, int n, int count, double* averages);
}

#endif
