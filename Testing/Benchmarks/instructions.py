# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Count the instructions of a few small pictures with callgrind; compare with instructions.json.

    python3 instructions.py PROGRAM [--update]

A count does not depend on other work of the machine, so it shows regressions that a clock does not.
It does depend on the compiler, whose version is stored with the counts. The instruction set is
limited to those that valgrind supports. Exit status 1: a count has changed by more than the
tolerance.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

KEPT = pathlib.Path(__file__).with_name("instructions.json")
TOLERANCE = 0.02
TARGETS = ("AVX2", "SSE4")


def compiler():
    return subprocess.run(
        ["c++", "-dumpfullversion"], capture_output=True, text=True, check=True
    ).stdout.strip()


def count(program, scene, target):
    """The number of instructions that measuredRender() executes."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--toggle-collect=measuredRender"]
        command += [f"--callgrind-out-file={folder}/out", program, scene]
        run = subprocess.run(
            command, capture_output=True, text=True, env={**os.environ, "LAMBENT_SIMD": target}
        )
    collected = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not collected:
        sys.exit(f"error: {' '.join(command)} failed:\n{run.stderr}")
    return int(collected[1])


def measure(program):
    scenes = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()
    return {
        target: {scene: count(program, scene, target) for scene in scenes} for target in TARGETS
    }


def compare(kept, counts):
    """Print a table. Returns the number of counts that are new or beyond the tolerance."""
    changed = 0
    print(f"{'target':8}{'scene':12}{'kept':>14}{'now':>14}{'change':>9}")
    for target, scenes in counts.items():
        for scene, now in scenes.items():
            before = kept.get(target, {}).get(scene)
            if before is None:
                print(f"{target:8}{scene:12}{'-':>14}{now:>14}      new")
                changed += 1
                continue
            change = (now - before) / before
            far = abs(change) > TOLERANCE
            changed += far
            print(
                f"{target:8}{scene:12}{before:>14}{now:>14}{change:>+9.1%}"
                + (("  WORSE" if change > 0 else "  better: keep it with --update") if far else "")
            )
    return changed


def main():
    program, *options = sys.argv[1:]
    counts = measure(program)
    kept = json.loads(KEPT.read_text()) if KEPT.exists() else {"counts": {}}
    changed = compare(kept["counts"], counts)
    if options == ["--update"]:
        KEPT.write_text(json.dumps({"compiler": compiler(), "counts": counts}, indent=2) + "\n")
        print(f"Kept in {KEPT}")
        return 0
    if kept.get("compiler") != compiler():
        print(f"Kept with compiler {kept.get('compiler')}, counted with {compiler()}.")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
