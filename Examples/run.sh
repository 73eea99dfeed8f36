#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds what the quick starts of the README take (the module, the command,
# the Python package), and renders a mesh:
#   sh Examples/run.sh [MESH] [options of the command lambent]
# Without a MESH it is the seashell of Data/; without options too, the picture of the README. The
# picture goes to build/, unless an option -o says otherwise.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
install_missing
configure
compile --target lambent vtkLambentPython

# --verbose tells where the picture is, its size, the triangles and the time of each stage.
mesh="$root/Data/seashell.vtp"
if [ $# -eq 0 ]; then
  lambent() { # the quick start's, whose first words are: Data/seashell.vtp -o seashell.png
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
