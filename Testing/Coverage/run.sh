#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Lists the lines and branches that no test reaches:
#   sh Testing/Coverage/run.sh [options of ctest]
# Prints the table; build/coverage/report/index.html shows each line. Branches that only an exception
# takes are not counted, nor those within VTK's macros, most of which are for debugging.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
. "$root/.ci/setup.sh"

need "coverage" gcovr
need_build
install_missing
build="$root/build/coverage"
# Counting takes time, and a test that is killed for exceeding its time counts nothing.
configure -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=g++ -DLAMBENT_WRAP_PYTHON=OFF \
  -DLAMBENT_TEST_TIMEOUT=3600 "-DCMAKE_CXX_FLAGS=-O1 --coverage -fprofile-update=atomic"
compile
find "$build" -name '*.gcda' -delete
export GCOV_ERROR_FILE=/dev/null # hides the errors of processes that may not write files
# Counting takes memory, which CommandLine.Memory would measure.
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" --exclude-regex '^(Build\.|CommandLine\.Memory)' "$@" >&2 ||
  say "Some tests failed; what they reached counts all the same"
mkdir -p "$build/report"
gcovr --root "$root" --object-directory "$build" --exclude-directories '.*/CompilerIdCXX' \
  --gcov-ignore-parse-errors \
  --exclude-throw-branches --exclude-unreachable-branches \
  --exclude-branches-by-pattern '\s*vtk\w*(Macro|Body)\b.*' --filter "$root/Rendering/" \
  --filter "$root/Filters/" \
  --html-details "$build/report/index.html" --txt "$build/report/lines.txt" --print-summary "$build"
cat "$build/report/lines.txt"
