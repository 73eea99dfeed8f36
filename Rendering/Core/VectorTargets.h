// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the instruction sets that kernels are compiled for
 *
 * Not guarded on purpose: a kernel's file includes it after naming itself in
 * HWY_TARGET_INCLUDE, and Highway then includes that file once for each target.
 * Left out is a variant of AVX-512 whose additions the kernels have no use for.
 */
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_AVX3_DL
#endif
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
