# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# Libraries that read further kinds of files. Without one the command is built all the same, and
# `lambent --formats` tells what it lacks.
find_package(assimp 5 QUIET)
include(CheckLanguage)
check_language(C) # VTK's search for HDF5, which Exodus files are made of, compiles some
if (CMAKE_C_COMPILER)
  enable_language(C)
  find_package(VTK "${VTK_VERSION}" EXACT QUIET OPTIONAL_COMPONENTS IOExodus)
endif ()

set(lacking)
foreach (pair IN ITEMS "ASSIMP assimp::assimp" "ENSIGHT VTK::IOEnSight" "EXODUS VTK::IOExodus"
    "ZLIB VTK::zlib")
  separate_arguments(pair)
  list(GET pair 0 name)
  list(GET pair 1 target)
  if (TARGET ${target})
    target_link_libraries(LambentCommand PRIVATE ${target})
    target_compile_definitions(LambentCommand PRIVATE LAMBENT_HAS_${name})
  else ()
    list(APPEND lacking ${target})
  endif ()
endforeach ()
if (TARGET assimp::assimp)
  target_sources(LambentCommand PRIVATE Reading/ReadAssimp.cxx)
endif ()
if (lacking)
  message(STATUS "The command lambent reads fewer kinds of files without ${lacking}")
endif ()
