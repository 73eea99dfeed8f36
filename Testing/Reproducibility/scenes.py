#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders every scene, prints the SHA-256 of each picture, and compares with the list scenes.sha256.

    scenes.py PROGRAM [options of the program]             exit status 1 if a picture differs
    scenes.py --update PROGRAM [options of the program]    makes the results the list
    scenes.py --all PROGRAM                                with each instruction set, number of threads, ...

PROGRAM is LambentReproducibility or LambentReproducibilityVTK; it may be several words, such as an
emulator and its program. The list has the format of sha256sum, for the files that the program writes.
"""

import hashlib
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("scenes.sha256")
THREADS = ("1", "2", "3", "8")


def expected():
    """The listed hash of each picture, by file name."""
    lines = LIST.read_text(encoding="ascii").splitlines()
    return {name: digest for digest, name in (line.split(None, 1) for line in lines)}


def draw(command, environment=None):
    """Runs a program that renders all scenes. Returns the hash of each picture, by file name."""
    with tempfile.TemporaryDirectory(prefix="lambent-") as folder:
        run = subprocess.run([*command, folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env={**os.environ, **(environment or {})}, check=False)
        if run.returncode != 0:
            raise RuntimeError(run.stderr.decode(errors="replace").strip()[-500:]
                               or "exit status %d" % run.returncode)
        files = sorted(pathlib.Path(folder).iterdir())
        return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def compare(hashes, reference):
    """The names of the scenes, and of those that differ from the reference."""
    scenes = {pathlib.Path(name).stem for name in hashes}
    wrong = {pathlib.Path(name).stem for name in hashes if hashes[name] != reference.get(name)}
    return sorted(scenes), sorted(wrong)


def manners(program):
    """The instruction sets and threading backends that a program supports here."""
    text = subprocess.run([*program, "--manners"], stdout=subprocess.PIPE, check=True).stdout.decode()
    pairs = [line.split(" ", 1) for line in text.splitlines()]
    return ([name for kind, name in pairs if kind == "LAMBENT_SIMD"],
            [name for kind, name in pairs if kind == "backend"])


def variations(program):
    """A title and the arguments of draw(), for each variation of a program."""
    simds, backends = manners(program)
    for simd in simds:
        yield simd + ", 3 threads", [*program, "--threads", "3"], {"LAMBENT_SIMD": simd}
    for backend in backends or [""]:
        for threads in THREADS:
            yield (("%s %s threads" % (backend, threads)).strip(),
                   [*program, "--threads", threads, *(["--backend", backend] if backend else [])], {})
    for seed in ("1", "2", "3"):
        yield "shuffled and split, seed " + seed, [*program, "--shuffle", seed], {}
    yield "in parts", [*program, "--parts"], {}
    if not backends:
        yield "by brute force", [*program, "--brute-force"], {}


def check_all(program):
    reference = expected()
    failures = 0
    for title, command, environment in variations(program):
        scenes, wrong = compare(draw(command, environment), reference)
        failures += bool(wrong) or not scenes
        print("%-30s %3d of %3d scenes equal" % (title, len(scenes) - len(wrong), len(scenes)),
              " ".join(wrong))
    return failures


def main(arguments):
    option = arguments.pop(0) if arguments and arguments[0] in ("--update", "--all") else ""
    if not arguments or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    is_path = os.path.exists(arguments[0])  # can contain spaces
    program = [arguments[0]] if is_path else shlex.split(arguments[0])
    if option == "--all":
        return 1 if check_all(program) else 0
    hashes = draw([*program, *arguments[1:]])
    if option == "--update":
        LIST.write_text("".join("%s  %s\n" % (hashes[name], name) for name in hashes))
    scenes, wrong = compare(hashes, expected())
    for name, digest in hashes.items():
        print(digest, name + (" DIFFERS" if pathlib.Path(name).stem in wrong else ""))
    print("%d of %d scenes equal those of %s" % (len(scenes) - len(wrong), len(scenes), LIST.name))
    return 1 if wrong or not scenes else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (RuntimeError, OSError) as failure:
        sys.exit("error: %s" % failure)
