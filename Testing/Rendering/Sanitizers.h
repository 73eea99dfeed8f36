// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether this build uses the address or the thread sanitizer
 */
#ifndef Sanitizers_h
#define Sanitizers_h

#if defined(__has_feature)
#define LAMBENT_HAS_SANITIZER(name) __has_feature(name)
#else
#define LAMBENT_HAS_SANITIZER(name) 0
#endif

#if defined(__SANITIZE_ADDRESS__) || LAMBENT_HAS_SANITIZER(address_sanitizer)
#define LAMBENT_ADDRESS_SANITIZER 1
#else
#define LAMBENT_ADDRESS_SANITIZER 0
#endif

#if defined(__SANITIZE_THREAD__) || LAMBENT_HAS_SANITIZER(thread_sanitizer)
#define LAMBENT_THREAD_SANITIZER 1
#else
#define LAMBENT_THREAD_SANITIZER 0
#endif

#endif
