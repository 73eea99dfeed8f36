#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds, and runs all tests:
#   sh Testing/run.sh [options of ctest]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
need_opengl
install_missing
configure
compile
exec ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
