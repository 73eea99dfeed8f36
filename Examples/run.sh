#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds everything for the quick starts of the README (the module, the
# command, the Python package), and renders a mesh:
#   sh Examples/run.sh [MESH] [options of the command lambent]
# The default MESH is the seashell of Data/. Without any arguments the result is the picture of the
# README. It is written to build/, unless the options contain -o.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
install_missing
configure
compile --target lambent vtkLambentPython

# --verbose prints the path and size of the picture, the triangles, and the time of each stage.
mesh="$root/Data/seashell.vtp"
if [ $# -eq 0 ]; then
  lambent() { # quickstart.sh calls this; its first arguments are: Data/seashell.vtp -o seashell.png
    shift 3
    "$build/bin/lambent" "$mesh" -o "$build/seashell.png" "$@" --verbose
  }
  . "$root/Examples/CommandLine/quickstart.sh"
  exit
fi

case $1 in
  -*) ;;
  *)
    mesh=$1
    shift
    ;;
esac
name=$(basename -- "$mesh")
picture="$build/${name%.*}.png"
for option in "$@"; do
  case $option in
    -o* | --output | --output=*) picture= ;;
  esac
done
[ -z "$picture" ] || set -- "$@" -o "$picture"
exec "$build/bin/lambent" "$mesh" --verbose "$@"
