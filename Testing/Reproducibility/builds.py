# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of the matrix, built with different compilers and flags, and for different processors."""

import dataclasses
import os
import pathlib
import platform
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = ROOT / "Testing" / "Reproducibility"
INSTALL = "sh Testing/Reproducibility/run.sh installs it"


class NotHere(Exception):
    """The program cannot be built or run on this machine. The message gives the reason."""


@dataclasses.dataclass
class Build:
    title: str
    compiler: str
    options: list = dataclasses.field(default_factory=list)  # for cmake
    foreign: str = ""  # Debian's name of the processor, if different from this one
    runner: object = None  # returns a prefix for the command, such as an emulator

    def make(self, folder, jobs):
        """Builds the program and returns the command that runs it."""
        if not shutil.which(self.compiler):
            raise NotHere("no %s; %s" % (self.compiler, INSTALL))
        options = ["-DCMAKE_CXX_COMPILER=" + self.compiler, *self.options]
        prefix = []
        if self.foreign:
            library = foreign_highway(self.foreign, folder / ("highway-" + self.foreign))
            options.append("-Dhwy_DIR=%s/cmake/hwy" % library)
            prefix = self.runner(library)
        build = folder / slug(self.title)
        cmake(SOURCE, build, options, "LambentReproducibility", jobs)
        return [*prefix, str(build / "LambentReproducibility")]


def slug(title):
    return "".join(c if c.isalnum() else "-" for c in title).strip("-")


def quietly(words, log):
    """Runs a command; its output goes to a log."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with open(log, "ab") as file:
        run = subprocess.run(words, stdout=file, stderr=subprocess.STDOUT, check=False)
    if run.returncode != 0:
        raise NotHere("'%s ...' failed, see %s" % (" ".join(map(str, words[:3])), log))


def cmake(source, build, options, target, jobs, prefix=()):
    log = build.with_suffix(".log")
    quietly([*prefix, "cmake", "-S", str(source), "-B", str(build), *options], log)
    quietly([*prefix, "cmake", "--build", str(build), "--target", target,
             "--parallel", str(jobs)], log)


def foreign_highway(architecture, folder):
    """Highway for another processor, from Debian's packages, unpacked but not installed."""
    debian = {"arm64": "aarch64-linux-gnu", "i386": "i386-linux-gnu"}[architecture]
    library = folder / "usr" / "lib" / debian
    if (library / "cmake" / "hwy").is_dir() and (library / "libhwy.so").exists():
        return library
    if not shutil.which("apt-get"):
        raise NotHere("no apt-get to fetch Highway for %s with" % architecture)
    # Uses separate package lists, so that the system does not get a second architecture.
    for part in ("lists/partial", "archives/partial"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    apt = ["apt-get", "-o", "Dir::State::Lists=%s/lists" % folder, "-o", "Dir::Cache=%s" % folder,
           "-o", "APT::Architectures::=" + architecture, "-o", "Acquire::Retries=3", "--quiet"]
    log = folder.with_suffix(".log")
    words = ["libhwy1:" + architecture, "libhwy-dev:" + architecture]
    with open(log, "ab") as file:
        for step in (["update"], ["download", *words]):  # some unneeded list may fail
            subprocess.run([*apt, *step], cwd=folder, stdout=file, stderr=file, check=False)
    packages = sorted(folder.glob("*.deb"))
    if len(packages) != len(words):
        raise NotHere("Highway for %s could not be fetched, see %s" % (architecture, log))
    for package in packages:
        quietly(["dpkg-deb", "--extract", str(package), str(folder)], log)
    return library


def under_qemu(library):
    if not shutil.which("qemu-aarch64-static"):
        raise NotHere("no qemu-user-static; " + INSTALL)
    return ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu",
            "-E", "LD_LIBRARY_PATH=%s" % library]


def by_loader(library):
    if platform.machine() != "x86_64":
        raise NotHere("no x86 processor")
    system = "/usr/i686-linux-gnu/lib"
    return [system + "/ld-linux.so.2", "--library-path", "%s:%s" % (system, library)]


def flags(text):
    """Options that replace the release flags."""
    return ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=" + text]


def target(name, processor):
    return ["-DCMAKE_SYSTEM_NAME=" + name, "-DCMAKE_SYSTEM_PROCESSOR=" + processor]


def core_builds():
    """Builds of the core only."""
    return [
        Build("GCC -O3", "g++"),
        Build("GCC -O0", "g++", flags("-O0")),
        Build("GCC -O2", "g++", flags("-O2")),
        Build("GCC -O3 -march=native", "g++", flags("-O3 -march=native")),
        Build("GCC -Ofast -march=native -ffast-math -ffp-contract=fast", "g++",
              flags("-Ofast -march=native -ffast-math -ffp-contract=fast")),
        Build("Clang -O3, libstdc++", "clang++"),
        Build("Clang -O0, libstdc++", "clang++", flags("-O0")),
        Build("Clang -O3 -march=native, libc++", "clang++",
              [*flags("-O3 -march=native"), "-DCMAKE_CXX_FLAGS=-stdlib=libc++"]),
        Build("GCC -O3, 32 bits (i686, SSE2)", "i686-linux-gnu-g++",
              ["-DCMAKE_CXX_FLAGS=-msse2 -mfpmath=sse", *target("Linux", "i686")], "i386", by_loader),
        Build("GCC -O3, Arm (aarch64, under qemu)", "aarch64-linux-gnu-g++",
              target("Linux", "aarch64"), "arm64", under_qemu),
    ]


VTK_OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DLAMBENT_BUILD_EXAMPLES=OFF",
               "-DLAMBENT_WRAP_PYTHON=OFF"]


def vtk_program(folder, jobs):
    """The filters, with this system's VTK."""
    build = folder / "VTK"
    cmake(ROOT, build, VTK_OPTIONS, "LambentReproducibilityVTK", jobs)
    return [str(build / "bin" / "LambentReproducibilityVTK")]


def version(words):
    """The first line of a program's version message."""
    try:
        run = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
        return run.stdout.decode().splitlines()[0].strip()
    except (OSError, IndexError):
        return ""


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return "%d × %s" % (os.cpu_count(), names[0] if names else platform.machine())
