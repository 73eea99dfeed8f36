#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Searches for input that causes failures, with clang's libFuzzer under the address and
# undefined-behaviour sanitizers, and reports how many inputs were tried:
#   sh Testing/Fuzzing/run.sh [SECONDS | -runs=N] [TARGET...]
# Each target in turn runs for this long (by default 60 seconds). It starts with Corpus/ and with what
# earlier runs have kept in build/fuzzing/corpus. An input that stopped a target is in
# build/fuzzing/found: correct the defect, and save the input in Corpus/ under a descriptive name.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
here="$root/Testing/Fuzzing"
. "$root/.ci/setup.sh"

case ${1:-} in
  '' | Fuzz*) budget=-max_total_time=60 ;;
  -runs=*)
    budget=$1
    shift
    ;;
  *)
    budget=-max_total_time=$1
    shift
    ;;
esac
[ $# -gt 0 ] || set -- FuzzCore FuzzNormals FuzzRayTracer FuzzFiles FuzzVtkFiles FuzzOptions

need "fuzzing" clang libclang-rt-14-dev llvm
need_build
install_missing
build="$root/build/fuzzing"
configure -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ \
  -DLAMBENT_FUZZ=ON -DLAMBENT_WRAP_PYTHON=OFF \
  "-DCMAKE_CXX_FLAGS=-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer"
compile --target "$@"

# VTK's containers were not compiled for the address sanitizer, which reports false overflows.
export ASAN_OPTIONS=detect_container_overflow=0
export LSAN_OPTIONS="print_suppressions=0:suppressions='$root/.ci/leaks.supp'"
export UBSAN_OPTIONS=print_stacktrace=1
mkdir -p "$build/found" "$build/log"
status=0
printf '%-14s %10s %12s %9s\n' target inputs 'per second' edges
for target in "$@"; do
  log="$build/log/$target"
  mkdir -p "$build/corpus/$target"
  # The timeout includes time in which other processes run. No input takes a second of its own.
  options="-timeout=600 -max_len=2000 -print_final_stats=1 -artifact_prefix=$build/found/$target-"
  [ ! -f "$here/$target.dict" ] || options="$options -dict=$here/$target.dict"
  # shellcheck disable=SC2086 # $options is a list of words
  "$build/bin/$target" $budget $options "$build/corpus/$target" "$here/Corpus/$target" \
    >"$log" 2>&1 || status=1
  printf '%-14s %10s %12s %9s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
    "$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")" \
    "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)"
done
[ $status = 0 ] || fail "something went wrong; see $build/found and the end of the logs in $build/log"
