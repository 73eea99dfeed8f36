# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# Every target of this directory and below computes in IEEE binary64 as it is
# written, whatever flags the user's environment or a parent project brings: directory options come
# after CMAKE_CXX_FLAGS and after the options of the parent. SHELL keeps CMake from dropping a flag
# of ours because it has seen the same one earlier on the line.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT CMAKE_CXX_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
  set(lambent_strict "SHELL:-fno-fast-math -fno-unsafe-math-optimizations -ffp-contract=off")
  add_compile_options("${lambent_strict}")
  # The linker's turn: -ffast-math would add start-up code that flushes subnormals to zero.
  add_link_options("SHELL:-fno-fast-math -fno-unsafe-math-optimizations")
elseif (MSVC)
  add_compile_options(/fp:precise)
endif ()
