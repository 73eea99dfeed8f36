#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Breaks each formula once and checks that a test fails.

    python3 Testing/Mutation/run.py [--build FOLDER] [--jobs N] [PART OF A FILE'S NAME OR REASON]...

Works on a copy of the sources, in FOLDER (build/mutation). Each mutation is applied, the affected files
are compiled, and the tests of that area run until one fails. Mutations that no test detects are listed at
the end: each needs a test, or a reason why it cannot be observed.
"""

import argparse
import pathlib
import subprocess
import sys

from mutations import MUTATIONS

ROOT = pathlib.Path(__file__).resolve().parents[2]

# The tests for a file, by the beginning of its path; the first match counts.
TESTS = (("Rendering/Core/", ("TestLambentArithmetic", "TestLambentCore", "TestLambentRendering")),
         ("Filters/Base/", ("TestLambentArithmetic", "TestLambentCore", "TestLambentRendering")),
         ("Rendering/CommandLine/", ("TestLambentCommandLine",)),
         ("Rendering/", ("TestLambentRendering",)),
         ("Filters/Core/TriangleNormals", ("TestLambentRendering",)),
         ("Filters/SpansFromVTK", ("TestLambentRendering",)),
         ("Filters/", ("TestLambentFilters",)))

# Slow tests run last. Tests of progress or memory do not check formulas, so they do not run.
LONG = "BruteForce.*:Properties.*"
NEVER = "Memory.*:Progress.*"
FILTERS = (f"-{LONG}:{NEVER}", f"{LONG}-{NEVER}")


def tests_of(path):
    return next(tests for start, tests in TESTS if path.startswith(start))


class Mutant:
    """A copy of the sources with its build."""

    def __init__(self, folder, jobs):
        self.source = folder / "source"
        self.binaries = folder / "build"
        self.jobs = str(jobs)
        paths = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, text=True,
                               stdout=subprocess.PIPE).stdout.splitlines()
        for path in paths:
            self.write(path, (ROOT / path).read_bytes())
        kept = set(paths)
        # An earlier run may have left files that have been moved since.
        for old in self.source.rglob("*"):
            if old.is_file() and str(old.relative_to(self.source)) not in kept:
                old.unlink()
        # Kernels for one instruction set only; otherwise compiling them would take most of the time.
        self.run("cmake", "-S", self.source, "-B", self.binaries, "-G", "Ninja",
                 "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -march=native",
                 "-DCMAKE_CXX_FLAGS=-DHWY_COMPILE_ONLY_STATIC", "-DLAMBENT_WRAP_PYTHON=OFF",
                 "-DLAMBENT_BUILD_EXAMPLES=OFF", check=True)

    def write(self, path, content):
        """Writes the file only if it differs, so that nothing is compiled needlessly."""
        target = self.source / path
        if not target.exists() or target.read_bytes() != content:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)

    def run(self, *command, **keywords):
        return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, **keywords)

    def first_failure(self, tests):
        """The place of the first failure, or None. Programs are built one by one, since the first one
        often detects the mutation."""
        for test in tests:
            done = self.run("cmake", "--build", self.binaries, "--parallel", self.jobs,
                            "--target", test)
            if done.returncode:
                raise ValueError("does not compile: correct mutations.py\n" + done.stdout[-2000:])
            for chosen in FILTERS:
                failure = self.failure_of(test, chosen)
                if failure:
                    return failure
        return None

    def failure_of(self, test, chosen):
        """The first assertion that fails, which ends the program."""
        try:
            done = self.run(self.binaries / "bin" / test, "--gtest_throw_on_failure",
                            "--gtest_brief=1", "--gtest_filter=" + chosen, timeout=600)
        except subprocess.TimeoutExpired:
            return test + " timed out"
        if not done.returncode:
            return None
        places = [pathlib.Path(line.split(": Failure")[0]).name
                  for line in done.stdout.splitlines() if line.endswith(": Failure")]
        return places[0] if places else f"{test} exits with {done.returncode}"

    def outcome(self, path, old, new):
        """The result of one mutation: (whether it survives, a description)."""
        text = (ROOT / path).read_text()
        if text.count(old) != 1:
            return True, f"its text occurs {text.count(old)} times: correct mutations.py"
        self.write(path, text.replace(old, new).encode())
        try:
            failure = self.first_failure(tests_of(path))
            return failure is None, failure or "no test fails"
        except ValueError as error:
            return True, str(error)
        finally:
            self.write(path, text.encode())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "mutation")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("only", nargs="*")
    arguments = parser.parse_args()
    chosen = [m for m in MUTATIONS
              if not arguments.only or any(o in m[0] or o in m[3] for o in arguments.only)]
    mutant = Mutant(arguments.build, arguments.jobs)
    failure = mutant.first_failure(sorted({test for m in chosen for test in tests_of(m[0])}))
    if failure:
        sys.exit("A test fails without any mutation: " + failure)
    survivors = []
    for path, old, new, reason in chosen:
        survives, word = mutant.outcome(path, old, new)
        print(f"{'SURVIVES' if survives else 'killed  '} {path}: {reason}: {word}", flush=True)
        if survives:
            survivors.append((path, reason, word))
    print(f"{len(chosen)} mutations, {len(survivors)} survivors")
    for path, reason, word in survivors:
        print(f"  {path}: {reason}: {word}")
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
