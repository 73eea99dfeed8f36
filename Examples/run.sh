#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds, and renders a mesh:
#   sh Examples/run.sh [MESH] [options of the command lambent]
# Without a MESH it draws that of Data/, without anything the picture of the README. The picture
# goes to build/, unless an option -o says otherwise.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd -P)
. "$root/.ci/setup.sh"

need_build
install_missing
configure
compile --target lambent

mesh="$root/Data/seashell.vtp"
if [ $# -eq 0 ]; then # the scene of the README's picture
  set -- --camera-position 0,0,7.25 --focal-point 0,0,0 --diffuse 0.95 --ambient 0.05 \
    --light 'direction=5,-6,-7;color=1,0.7,0.4' --light 'direction=-7,1,-2.5;color=0.2,0.4,1'
fi
case "${1-}" in
  "" | -*) ;;
  *)
    mesh=$1
    shift
    ;;
esac
name=$(basename -- "$mesh")
picture="$build/${name%.*}.png"
for option in "$@"; do
  case "$option" in
    -o* | --output | --output=*) picture= ;;
  esac
done
[ -z "$picture" ] || set -- "$@" -o "$picture"

# --verbose tells where the picture is, its size, the triangles and the time of each stage.
exec "$build/bin/lambent" "$mesh" --verbose "$@"
