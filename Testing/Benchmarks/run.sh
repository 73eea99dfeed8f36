#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds, and runs Lambent and its peers side by side:
#   sh Testing/Benchmarks/run.sh            everything; about twenty minutes
#   sh Testing/Benchmarks/run.sh --quick    the goals, in a minute
# Further options: see suite.py.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
need_benchmarks
install_missing
configure_benchmarks
compile --target LambentBenchmarks

# A screen for VTK's OpenGL; Mesa's llvmpipe renders on two threads.
screen="$build/screen"
: >"$screen"
Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$screen" >"$build/xvfb.log" 2>&1 &
xvfb=$!
trap 'kill "$xvfb" 2>/dev/null || true' EXIT
trap 'exit 1' HUP INT TERM
for _ in 1 2 3 4 5 6 7 8 9 10; do
  [ -s "$screen" ] && break
  sleep 0.5
done
if [ -s "$screen" ]; then
  DISPLAY=":$(cat "$screen")"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LP_NUM_THREADS=2
else
  say "Xvfb does not start (see $build/xvfb.log); VTK's OpenGL is left out"
  unset DISPLAY
fi

/usr/bin/python3 "$root/Testing/Benchmarks/suite.py" --build "$build" \
  --data "${LAMBENT_SHARED_DATA_DIR:-$root/../shared/data}" "$@"
