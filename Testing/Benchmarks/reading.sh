#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds, and reads large files of every format with VTK and with the
# command's functions, in turn:
#   sh Testing/Benchmarks/reading.sh [--files=REGEX] [--runs=N]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
need_benchmarks
install_missing
configure_benchmarks -DLAMBENT_BUILD_EXAMPLES=ON
compile --target LambentReading
exec "$build/bin/LambentReading" --data="${LAMBENT_SHARED_DATA_DIR:-$root/../shared/data}" \
  --cache="$build/meshes" "$@"
