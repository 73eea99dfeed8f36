# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A second system, Debian testing, in a folder, with its newer VTK, compiler and Highway."""

import os
import pathlib
import shutil
import tempfile

from builds import ROOT, VTK_OPTIONS, NotHere, quietly, version

SOURCE_THERE = "/mnt/source"
BUILD_THERE = "/mnt/build"
PACKAGES = "g++,cmake,ninja-build,libglm-dev,libhwy-dev,libgtest-dev"


def inside(folder, build):
    """A prefix that runs a command in the folder's system, with sources, build and /tmp mounted. The mounts
    disappear with the command."""
    mounts = [(ROOT, SOURCE_THERE), (build, BUILD_THERE), (tempfile.gettempdir(), "/tmp")]
    script = "".join("mkdir -p '%s%s' && mount --bind '%s' '%s%s' && "
                     % (folder, there, here, folder, there) for here, there in mounts)
    script += "mount -t proc proc '%s/proc' && exec chroot '%s' \"$@\"" % (folder, folder)
    return ["unshare", "--mount", "--propagation", "private", "sh", "-ec", script, "sh"]


def mirror():
    """The package source of this system, if it is easy to find."""
    for path in sorted(pathlib.Path("/etc/apt").glob("sources.list.d/*.sources")):
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith("URIs:"):
                return [line.split()[1]]
    return []


def install(folder, build, log):
    if not (folder / "usr" / "bin" / "g++").exists():
        quietly(["debootstrap", "--variant=minbase", "--include=" + PACKAGES, "testing",
                 str(folder), *mirror()], log)
    quietly([*inside(folder, build), "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "--yes",
             "install", "--no-install-recommends", "libvtk9-dev", *PACKAGES.split(",")], log)


def newer_vtk_program(folder, build, jobs):
    """The filters with the newer VTK, and a description of the newer versions."""
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        raise NotHere("needs root and debootstrap")
    folder, build = pathlib.Path(folder).resolve(), build.resolve()
    build.mkdir(parents=True, exist_ok=True)
    install(folder, build, build / "newer-vtk.log")
    go = inside(folder, build)
    build_there = pathlib.Path(BUILD_THERE) / "VTK"
    log = build / "VTK.log"
    quietly([*go, "cmake", "-S", SOURCE_THERE, "-B", str(build_there), "-G", "Ninja",
             *VTK_OPTIONS], log)
    quietly([*go, "cmake", "--build", str(build_there), "--target", "LambentReproducibilityVTK",
             "--parallel", str(jobs)], log)
    what = [version([*go, "dpkg-query", "--show", "--showformat=" + name + " ${Version}\n", package])
            for package, name in (("libvtk9-dev", "VTK"), ("g++", "GCC"), ("libhwy-dev", "Highway"))]
    return [*go, str(build_there / "bin" / "LambentReproducibilityVTK")], what
