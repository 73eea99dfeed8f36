# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

# Image tests for CTest. find_package(Lambent) defines
#
#   lambent_add_image_test(NAME <name> INPUT <mesh>... BASELINE <file>
#     [ARGS <option of lambent>...] [METRIC max|rmse|ssim] [TOLERANCE <t>])
#
# The test <name> renders the meshes with the command lambent and these options, and passes if the
# picture matches the baseline: exactly, or within METRIC and TOLERANCE. Paths are relative to the
# source folder, in which the test runs. The picture has the size of the baseline, unless --size is
# given. In ARGS, join the parts of a light with colons (--light position=3,4,5:color=gold), since
# set() splits lists at semicolons.
#
#   lambent_add_image_test(NAME <name> PICTURE <file> BASELINE <file>
#     [COMMAND <command> <argument>...] [WORKING_DIRECTORY <folder>] [METRIC ...] [TOLERANCE ...])
#
# The test <name> passes if the picture, a .png or .vti, matches the baseline. COMMAND draws it, in a
# test <name>.Draw that runs first. That test runs in WORKING_DIRECTORY, by default the binary folder,
# and <file> is relative to it. A relative WORKING_DIRECTORY lies in the binary folder and is created
# if missing. Without COMMAND, something else must draw the picture first. The picture must not be the
# baseline itself, which would always pass.
#
# A test without a baseline fails and names its picture. To accept the pictures, build the target
# lambent-update-baselines, or run ctest with LAMBENT_UPDATE_BASELINES=1 in the environment. Select
# tests with -R <name>; all of these tests have the label lambent-image. If tests fail, the page
# LAMBENT_IMAGE_REPORT (default: lambent-report.html in the top binary folder) shows picture, baseline
# and difference. CDash receives them, too.

include_guard(GLOBAL)

# Makes a caller's path absolute, relative to a folder, unless it begins with a generator expression.
function (_lambent_absolute result path folder)
  if (NOT path MATCHES "^\\$<" AND NOT IS_ABSOLUTE "${path}")
    set(path "${folder}/${path}")
  endif ()
  set("${result}" "${path}" PARENT_SCOPE)
endfunction ()

function (_lambent_check_image_test)
  foreach (required IN ITEMS NAME BASELINE)
    if (NOT arg_${required})
      message(FATAL_ERROR "lambent_add_image_test(${arg_NAME}) needs ${required}.")
    endif ()
  endforeach ()
  if (arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "lambent_add_image_test(${arg_NAME}) has no argument ${arg_UNPARSED_ARGUMENTS}.")
  endif ()
  if (arg_INPUT AND (arg_PICTURE OR arg_COMMAND OR arg_WORKING_DIRECTORY))
    message(FATAL_ERROR "lambent_add_image_test(${arg_NAME}): the command lambent renders INPUT. "
      "Omit INPUT, or omit PICTURE, COMMAND and WORKING_DIRECTORY.")
  endif ()
  if (NOT arg_INPUT AND (NOT arg_PICTURE OR arg_ARGS))
    message(FATAL_ERROR "lambent_add_image_test(${arg_NAME}) needs INPUT or PICTURE. ARGS "
      "require INPUT.")
  endif ()
  if (NOT TARGET Lambent::Command)
    message(FATAL_ERROR "lambent_add_image_test() needs the command lambent, but Lambent was built "
      "without it. Build it with CLI11 and LAMBENT_BUILD_EXAMPLES.")
  endif ()
endfunction ()

# A unique file name for a test, even if the file system ignores case. A name that is a C identifier is
# used unchanged; any other gets its hash appended.
function (_lambent_file_name result name)
  string(MAKE_C_IDENTIFIER "${name}" file)
  string(TOLOWER "${file}" key)
  get_property(used DIRECTORY PROPERTY _lambent_image_files)
  list(FIND used "${key}" place)
  if (NOT file STREQUAL name OR NOT place EQUAL -1)
    string(SHA256 hash "${name}")
    string(SUBSTRING "${hash}" 0 8 hash)
    string(APPEND file "-${hash}")
  else ()
    set_property(DIRECTORY APPEND PROPERTY _lambent_image_files "${key}")
  endif ()
  set("${result}" "${file}" PARENT_SCOPE)
endfunction ()

# Stops if the picture is the baseline, as far as this is known at configure time. The command checks
# again when the test runs.
function (_lambent_check_not_baseline picture)
  _lambent_absolute(baseline "${arg_BASELINE}" "${CMAKE_CURRENT_SOURCE_DIR}")
  if (NOT "${picture}${baseline}" MATCHES "\\$<")
    foreach (path IN ITEMS picture baseline)
      if (NOT EXISTS "${${path}}") # REAL_PATH does not resolve links in the path of a missing file
        get_filename_component(name "${${path}}" NAME)
        get_filename_component(${path} "${${path}}" DIRECTORY)
        file(REAL_PATH "${${path}}" ${path})
        set(${path} "${${path}}/${name}")
      endif ()
      file(REAL_PATH "${${path}}" ${path})
    endforeach ()
  endif ()
  if (picture STREQUAL baseline)
    message(FATAL_ERROR "lambent_add_image_test(${arg_NAME}): PICTURE and BASELINE are the same file, "
      "${baseline}, and would always be equal. Name two files.")
  endif ()
endfunction ()

function (_lambent_add_update_target)
  if (NOT TARGET lambent-update-baselines)
    add_custom_target(lambent-update-baselines
      COMMAND "${CMAKE_COMMAND}" -E env LAMBENT_UPDATE_BASELINES=1
        "${CMAKE_CTEST_COMMAND}" --test-dir "${CMAKE_BINARY_DIR}" -C "$<CONFIG>"
          -L "^lambent-image$" --output-on-failure
      COMMENT "Accepting the pictures of the image tests as their baselines"
      USES_TERMINAL VERBATIM)
  endif ()
endfunction ()

function (lambent_add_image_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;BASELINE;METRIC;TOLERANCE;PICTURE;WORKING_DIRECTORY"
    "INPUT;ARGS;COMMAND")
  _lambent_check_image_test()
  _lambent_add_update_target()

  set(report "${CMAKE_BINARY_DIR}/lambent-report.html")
  if (LAMBENT_IMAGE_REPORT)
    _lambent_absolute(report "${LAMBENT_IMAGE_REPORT}" "${CMAKE_BINARY_DIR}")
  endif ()
  _lambent_file_name(file "${arg_NAME}")
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/lambent-images")
  file(MAKE_DIRECTORY "${folder}")
  set(how --report "${report}" --name "${arg_NAME}" --difference "${folder}/${file}.difference.png")
  if (DEFINED arg_METRIC)
    list(APPEND how --metric "${arg_METRIC}")
  endif ()
  if (DEFINED arg_TOLERANCE)
    list(APPEND how --tolerance "${arg_TOLERANCE}")
  endif ()

  if (arg_INPUT)
    add_test(NAME "${arg_NAME}"
      COMMAND Lambent::Command ${arg_INPUT} ${arg_ARGS} -o "${folder}/${file}.png"
        --compare "${arg_BASELINE}" ${how}
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  else ()
    if (NOT arg_WORKING_DIRECTORY)
      set(arg_WORKING_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
    endif ()
    _lambent_absolute(arg_WORKING_DIRECTORY "${arg_WORKING_DIRECTORY}" "${CMAKE_CURRENT_BINARY_DIR}")
    if (NOT arg_WORKING_DIRECTORY MATCHES "\\$<")
      file(MAKE_DIRECTORY "${arg_WORKING_DIRECTORY}")
    endif ()
    _lambent_absolute(picture "${arg_PICTURE}" "${arg_WORKING_DIRECTORY}")
    _lambent_check_not_baseline("${picture}")
    add_test(NAME "${arg_NAME}"
      COMMAND Lambent::Command compare "${picture}" "${arg_BASELINE}" ${how}
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  endif ()
  set_tests_properties("${arg_NAME}" PROPERTIES LABELS lambent-image)

  if (arg_COMMAND)
    add_test(NAME "${arg_NAME}.Draw" COMMAND ${arg_COMMAND}
      WORKING_DIRECTORY "${arg_WORKING_DIRECTORY}")
    set_tests_properties("${arg_NAME}.Draw" PROPERTIES
      LABELS lambent-image FIXTURES_SETUP "${arg_NAME}.Draw")
    set_tests_properties("${arg_NAME}" PROPERTIES FIXTURES_REQUIRED "${arg_NAME}.Draw")
  endif ()
endfunction ()
