#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds with every compiler, and renders every scene in every way:
#   sh Testing/Reproducibility/run.sh                       everything; about a quarter of an hour
#   sh Testing/Reproducibility/run.sh --newer-vtk FOLDER    also with Debian testing's VTK
# Further options: see matrix --help.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
need_matrix
case " $* " in
  *" --newer-vtk"*) need "a newer VTK" debootstrap ;;
esac
install_missing
CMAKE_GENERATOR=Ninja
export CMAKE_GENERATOR
exec /usr/bin/python3 -B "$root/Testing/Reproducibility/matrix" "$@"
