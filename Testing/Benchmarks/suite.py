# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run the benchmarks, scene by scene, and report. Called by run.sh.

Each scene runs in a separate process, in which all peers take turns; so does each measurement of
memory. Results go to BUILD/results: Google Benchmark's JSON of each scene, report.md, and the
scaling curves, scaling.json and scaling.svg.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time

import report
import scaling
from results import Scene, machine

HERE = pathlib.Path(__file__).parent
NOTHING_TO_DO = 77

GOAL_SCENES = ["bunny", "dragon", "dragon-zoom", "wave-300", "wave-600"]
HARD_SCENES = [
    "layers",
    "needles",
    "one-pixel",
    "box",
    "soup",
    "curtain",
    "late",
    "dragon-parallel",
    "dragon-uhd",
]

SURFACE_SCENES = ["spheres", "facets"]  # scenes with many surfaces
# Scenes of other primitives than triangles, and their contests.
KIND_SCENES = {"balls": "balls/.*", "lines": "lambent|1-thread/lambent|opengl/.*"}

# The contests that matter for the goals, without those that have never been the fastest.
QUICK = "lambent|embree/build/(low|medium)|embree/trace/(low|medium)/packet.*"
EVERYTHING = "lambent|1-thread/lambent|embree/.*|opengl/.*"
SURFACES = "lambent|surfaces/.*"
SUPERSAMPLING = ["dragon", "bunny"]  # scenes that also run with several samples per pixel
NORMALS = "normals/.*"
# With transparent surfaces. Depth peeling takes minutes for 64 layers over the whole picture.
TRANSPARENT = {"dragon": "layers/.*", "layers": "layers/(lambent|embree/.*)"}


class Suite:
    """Runs the benchmark program."""

    def __init__(self, build, data, quick):
        self.program = build / "bin" / "LambentBenchmarks"
        self.results = build / "results"
        self.results.mkdir(exist_ok=True)
        self.common = [f"--data={data}", f"--cache={build / 'meshes'}"]
        self.pace = (
            ["--seconds=0.35", "--fewest=3", "--most=25"]
            if quick
            else ["--seconds=1.5", "--fewest=3", "--most=41"]
        )

    def time(self, name, contests):
        """Run all contests of a scene. Returns None if its file is missing."""
        file = self.results / f"{name}.json"
        run = self._run(
            f"--scene={name}",
            f"--contests={contests}",
            *self.pace,
            "--benchmark_enable_random_interleaving=true",
            "--quiet",
            f"--benchmark_out={file}",
            "--benchmark_out_format=json",
        )
        return None if run is None else Scene.read(file)

    def memory(self, name, contest):
        """The peak megabytes of a contest, beyond mesh and image."""
        run = self._run(f"--scene={name}", f"--memory={contest}")
        return None if run is None else float(run) / 1e6

    def _run(self, *arguments):
        run = subprocess.run(
            [str(self.program), *self.common, *arguments], stdout=subprocess.PIPE, text=True
        )
        if run.returncode == NOTHING_TO_DO:
            return None
        if run.returncode != 0:
            sys.exit(f"error: {' '.join(arguments)} ended with status {run.returncode}")
        return run.stdout


def say(text):
    print(text, file=sys.stderr, flush=True)


def contests_of(name, quick):
    if name in SURFACE_SCENES:
        return SURFACES
    if name in KIND_SCENES:
        return KIND_SCENES[name]
    contests = QUICK if quick else EVERYTHING
    if name in SUPERSAMPLING:
        contests = f"(supersampling-./)?({contests})"
    if name == "dragon" or (name.startswith("wave") and not quick):
        contests += "|1-thread/lambent|" + NORMALS
    if name in TRANSPARENT and not quick:
        contests += "|" + TRANSPARENT[name]
    if name == "dragon" and not quick:
        contests += "|looks/.*"
    return contests


def measure(suite, names, quick):
    """Measure the scenes whose files exist, including their memory."""
    scenes = []
    for name in names:
        start = time.monotonic()
        scene = suite.time(name, contests_of(name, quick))
        if scene is None:
            say(f"{name}: skipped")
            continue
        if (not quick and name not in KIND_SCENES) or "megabytes" in report.GOALS["scenes"].get(name, {}):
            scene.memory["lambent"] = suite.memory(name, "lambent")
        if not quick and name not in KIND_SCENES:
            for quality in ("low", "medium", "high"):
                contest = f"embree/build/{quality}"
                scene.memory[contest] = suite.memory(name, contest)
        say(f"{name}: {time.monotonic() - start:.0f} s")
        scenes.append(scene)
    return scenes


def keep(results):
    """Copy the report and the curves to this folder, for its README."""
    for name in ("report.md", "scaling.json", "scaling.svg"):
        if (results / name).exists():
            shutil.copy(results / name, HERE / name)
            say(f"Kept {HERE / name}")


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true", help="only the goals, in a minute")
    parser.add_argument("--scenes", help="only these, separated by commas")
    parser.add_argument("--no-scaling", action="store_true", help="without the scaling curves")
    parser.add_argument("--only-scaling", action="store_true", help="only the scaling curves")
    parser.add_argument("--keep", action="store_true", help="copy report and curves to the sources")
    parser.add_argument("--build", type=pathlib.Path, required=True, help="set by run.sh")
    parser.add_argument("--data", type=pathlib.Path, required=True, help="set by run.sh")
    return parser.parse_args()


def main():
    options = parse()
    suite = Suite(options.build, options.data, options.quick)
    before = machine()
    if not options.only_scaling:
        names = GOAL_SCENES + SURFACE_SCENES
        names += [] if options.quick else [*KIND_SCENES, *HARD_SCENES]
        names = options.scenes.split(",") if options.scenes else names
        scenes = measure(suite, names, options.quick)
        text = report.write(scenes, before, os.getloadavg(), options.quick)
        (suite.results / "report.md").write_text(text)
        print(text)
    if options.only_scaling or not (options.quick or options.no_scaling or options.scenes):
        scaling.measure(suite, suite.results / "scaling.json", before, say)
        scaling.draw(suite.results / "scaling.json", suite.results / "scaling.svg")
        say(f"Drawn: {suite.results / 'scaling.svg'}")
    if options.keep:
        keep(suite.results)


if __name__ == "__main__":
    main()
