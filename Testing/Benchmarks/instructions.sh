#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds, and counts the instructions of a few small pictures. The counts
# must be within 2 % of those in instructions.json:
#   sh Testing/Benchmarks/instructions.sh [--update]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
need_benchmarks
install_missing
configure_benchmarks
compile --target LambentInstructions
exec /usr/bin/python3 "$root/Testing/Benchmarks/instructions.py" \
  "$build/bin/LambentInstructions" "$@"
