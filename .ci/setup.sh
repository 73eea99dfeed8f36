# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Functions for the scripts of this project: install packages and build. Source it from a POSIX
# shell, with $root set to the project's folder. Messages go to standard error; standard output
# belongs to the script.

# Put Debian's cmake, ninja, compilers and python3 first on PATH: Debian's VTK needs these.
PATH="/usr/bin:/bin:/usr/sbin:/sbin:$PATH"
export PATH

build="$root/build"
missing=

say() { echo "$*" >&2; }

fail() {
  say "error: $*"
  exit 1
}

# quietly LOG COMMAND...: sends the output to the log; shows its end if the command fails.
quietly() {
  log=$1
  shift
  if ! "$@" >>"$log" 2>&1; then
    tail -n 60 "$log" >&2
    fail "'$*' failed; all of its output is in $log"
  fi
}

# need REASON PACKAGE...: records and reports the packages that are not installed.
need() {
  reason=$1
  shift
  absent=
  for package in "$@"; do
    status=$(dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null) || status=
    [ "$status" = "install ok installed" ] || absent="$absent $package"
  done
  [ -z "$absent" ] || say "Missing for $reason:$absent"
  missing="$missing$absent"
}

need_build() {
  need "building" g++ cmake ninja-build
  need "the module (VTK, GLM, Highway)" libvtk9-dev libglm-dev libhwy-dev
  need "the command (CLI11)" libcli11-dev
  need "glTF, COLLADA, FBX, 3DS, 3MF and AMF in the command (assimp)" libassimp-dev
  need "Python and the tests" python3-vtk9 python3-numpy libgtest-dev
  need "image tests with pytest" python3-pytest python3-pytest-xdist python3-pil
}

need_opengl() {
  need "VTK's OpenGL without a screen (Xvfb, llvmpipe)" xvfb libgl1-mesa-dri
}

need_benchmarks() {
  need "the benchmarks (Embree, Google Benchmark)" libembree-dev libbenchmark-dev
  need_opengl
  need "counting instructions" valgrind
}

need_matrix() {
  need "other compilers and processors" clang libc++-dev libc++abi-dev g++-i686-linux-gnu \
    g++-aarch64-linux-gnu qemu-user-static
}

# Installs the packages that need() found missing.
install_missing() {
  [ -n "$missing" ] || return 0
  command -v apt-get >/dev/null ||
    fail "cannot install them without apt-get. Install the packages of your system for them, then" \
      "run 'cmake --workflow --preset default' in $root"
  become=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "cannot install them without root. Run as root:" \
        "apt-get install --no-install-recommends$missing"
    become=sudo
  fi
  mkdir -p "$build"
  say "Installing the missing packages, log: $build/apt.log ..."
  # shellcheck disable=SC2086 # $become and $missing are lists of words
  for step in update "install --no-install-recommends $missing"; do
    quietly "$build/apt.log" $become env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes \
      -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3 $step
  done
}

# The release build, in $build: configure [OPTION OF cmake...], then compile [OPTION OF
# cmake --build...].
configure() {
  cache="$build/CMakeCache.txt"
  # If the project's folder was copied or renamed, its build tree still points to the old path.
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    say "$build belongs to another folder; creating a new build"
    rm -rf "$build"
  fi
  set -- -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE=/usr/bin/python3 \
    "$@"
  [ -f "$cache" ] || set -- "$@" -G Ninja
  mkdir -p "$build"
  : >"$build/configure.log"
  quietly "$build/configure.log" cmake "$@"
}

# The benchmarks have a separate build that contains nothing else.
configure_benchmarks() {
  build="$root/build/benchmarks"
  configure -DLAMBENT_BUILD_BENCHMARKS=ON -DLAMBENT_BUILD_TESTING=OFF \
    -DLAMBENT_BUILD_EXAMPLES=OFF -DLAMBENT_WRAP_PYTHON=OFF "$@"
}

compile() {
  say "Building in $build ..."
  cmake --build "$build" --parallel "$(nproc)" "$@" >&2 || fail "the build failed"
}
