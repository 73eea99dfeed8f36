# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The measurements, from Google Benchmark's JSON."""

import json
import os
import platform
import statistics
from dataclasses import dataclass, field

QUALITIES = ("low", "medium", "high")
SUPERSAMPLING = "supersampling-"  # prefix of the names of contests with several samples per pixel


def spread(times):
    """Half the interquartile range, as a fraction of the median."""
    if len(times) < 3:
        return 0.0
    quarters = statistics.quantiles(times, n=4, method="inclusive")
    return (quarters[2] - quarters[0]) / 2 / statistics.median(times)


@dataclass
class Scene:
    """The times in milliseconds of all repetitions of each contest."""

    name: str
    triangles: int
    size: str
    times: dict
    differing: dict
    opengl: str = ""
    packet: str = ""
    memory: dict = field(default_factory=dict)

    @staticmethod
    def read(file):
        data = json.loads(file.read_text())
        context = data["context"]
        times = {}
        for entry in data["benchmarks"]:
            if entry["run_type"] == "iteration":
                contest = entry["name"].split("/iterations:")[0].split("/", 1)[1]
                times.setdefault(contest, []).append(entry["real_time"])
        differing = {
            key.split("/", 1)[1]: float(value)
            for key, value in context.items()
            if key.startswith("differing/")
        }
        return Scene(
            context["scene"],
            int(context["triangles"]),
            context["size"],
            times,
            differing,
            context.get("opengl", ""),
            context.get("packet", ""),
        )

    def median(self, contest):
        """The median of a contest; None if it was not run."""
        return statistics.median(self.times[contest]) if contest in self.times else None

    def spread(self, contest):
        return spread(self.times[contest])

    def build(self, quality, prefix=""):
        return self.median(f"{prefix}embree/build/{quality}")

    def best_trace(self, quality, prefix=""):
        """The fastest way to trace a tree of that quality, and its time; (None, None) if not run."""
        start = f"{prefix}embree/trace/{quality}/"
        found = {name[len(start) :]: self.median(name) for name in self.times if name.startswith(start)}
        return min(found.items(), key=lambda item: item[1]) if found else (None, None)

    def total(self, quality, prefix=""):
        """The time of Embree's build plus its best trace; None if not run."""
        one_tree = prefix.startswith(SUPERSAMPLING)  # for any number of rays
        build = self.build(quality, "" if one_tree else prefix)
        _, trace = self.best_trace(quality, prefix)
        return None if build is None or trace is None else build + trace

    def fastest_total(self, prefix=""):
        """The quality with the smallest total, and that total."""
        totals = {quality: self.total(quality, prefix) for quality in QUALITIES}
        known = {quality: total for quality, total in totals.items() if total is not None}
        return min(known.items(), key=lambda item: item[1]) if known else (None, None)

    def fastest_trace(self, prefix=""):
        """The fastest of all traces, whatever the cost of its tree, and its name."""
        found = []
        for quality in QUALITIES:
            grouping, trace = self.best_trace(quality, prefix)
            if trace is not None:
                found.append((trace, f"{quality}, {grouping}"))
        return min(found) if found else (None, None)


def machine():
    """The machine's description for the report."""
    model = platform.processor() or platform.machine()
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        for line in lines:
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    return {"processor": model, "cores": os.cpu_count(), "load": os.getloadavg()}
