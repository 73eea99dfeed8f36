# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# Everything built in this directory and below computes in IEEE binary64 as written, whatever flags
# the user's environment or a parent project adds: directory options come after CMAKE_CXX_FLAGS,
# those of the build type, and the parent's. SHELL prevents CMake from dropping an option that is
# already on the command line. Testing/Build tests this.
if (MSVC)
  add_compile_options(/fp:precise)
else ()
  add_compile_options("SHELL:-fno-fast-math -fno-unsafe-math-optimizations -ffp-contract=off")
  # At the link, -Ofast or -ffast-math would add start-up code that flushes subnormals to zero.
  add_link_options("SHELL:-O2 -fno-fast-math -fno-unsafe-math-optimizations")
endif ()
