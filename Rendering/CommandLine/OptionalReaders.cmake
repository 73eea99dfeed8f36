# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# Libraries that read further kinds of files. The command is built without the missing ones, and
# `lambent --formats` lists what it cannot read.
find_package(assimp 5 QUIET)
include(CheckLanguage)
check_language(C) # VTK's search for HDF5, the base of Exodus files, compiles C
if (CMAKE_C_COMPILER)
  enable_language(C)
  find_package(VTK "${VTK_VERSION}" EXACT QUIET OPTIONAL_COMPONENTS IOExodus)
endif ()

# VTK's targets exist even if libraries that they link are missing, so check which components were
# found.
set(lacking)
foreach (triple IN ITEMS
    "ASSIMP assimp_FOUND assimp::assimp"
    "ENSIGHT VTK_IOEnSight_FOUND VTK::IOEnSight"
    "EXODUS VTK_IOExodus_FOUND VTK::IOExodus"
    "ZLIB VTK_zlib_FOUND VTK::zlib")
  separate_arguments(triple)
  list(GET triple 0 name)
  list(GET triple 1 is_found)
  list(GET triple 2 target)
  if (${is_found} AND TARGET ${target})
    target_link_libraries(LambentCommand PRIVATE ${target})
    target_compile_definitions(LambentCommand PRIVATE LAMBENT_HAS_${name})
  else ()
    list(APPEND lacking ${target})
  endif ()
endforeach ()
if (NOT assimp::assimp IN_LIST lacking)
  target_sources(LambentCommand PRIVATE Reading/ReadAssimp.cxx)
endif ()
if (lacking)
  message(STATUS "The command lambent reads fewer file formats, because of missing ${lacking}")
endif ()
