# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scaling curves: time over triangles and over pixels, on one thread and on two.

    python3 scaling.py scaling.json scaling.svg    draws the measurements again
"""

import json
import math
import pathlib
import statistics
import sys

from chart import Panel, Series, page

TRIANGLES = [round(10 ** (k / 2)) for k in range(6, 15)]
PIXELS = [round(10 ** (k / 2)) for k in range(8, 16)]
FIXED_TRIANGLES = 1000000
FIXED_SIZE = (1920, 1080)

ONE = "1-thread/"
CONTESTS = (
    "lambent|1-thread/lambent"
    "|embree/build/(low|medium)|embree/trace/(low|medium)/packets"
    "|1-thread/embree/build/medium|1-thread/embree/trace/medium/packets"
)


def series_of(scene):
    """The milliseconds of each curve, by name."""
    return {
        "lambent": scene.median("lambent"),
        "lambent, 1 thread": scene.median("1-thread/lambent"),
        "embree medium": scene.total("medium"),
        "embree medium, 1 thread": scene.total("medium", ONE),
        "embree low": scene.total("low"),
        "embree trace": min(scene.best_trace(quality)[1] for quality in ("low", "medium")),
    }


def size_of(pixels):
    """A width and height of 16:9."""
    height = math.sqrt(pixels * 9 / 16)
    return round(height * 16 / 9), round(height)


def measure(suite, file, machine, say):
    points = {"triangles": [], "pixels": []}
    for triangles in TRIANGLES:
        scene = suite.time(f"bumps-{triangles}", CONTESTS)
        points["triangles"].append({"x": scene.triangles, "ms": series_of(scene)})
        say(f"{scene.triangles} triangles: {scene.median('lambent'):.2f} ms")
    for pixels in PIXELS:
        width, height = size_of(pixels)
        scene = suite.time(f"bumps-{FIXED_TRIANGLES}@{width}x{height}", CONTESTS)
        points["pixels"].append({"x": width * height, "ms": series_of(scene)})
        say(f"{width} x {height} pixels: {scene.median('lambent'):.2f} ms")
    description = {"machine": machine, "size": FIXED_SIZE, "fixed triangles": FIXED_TRIANGLES}
    file.write_text(json.dumps({**description, **points}, indent=1) + "\n")


def panel(title, axis, points):
    styles = [
        Series("lambent", "Lambent", "ours"),
        Series("lambent, 1 thread", "Lambent, 1 thread", "ours", dashed=True),
        Series("embree medium", "Embree, medium tree + trace", "peer"),
        Series("embree medium, 1 thread", "Embree, medium, 1 thread", "peer", dashed=True),
        Series("embree low", "Embree, low tree + trace", "second"),
        Series("embree trace", "Embree, trace alone", "third"),
    ]
    for series in styles:
        series.points = [(point["x"], point["ms"][series.key]) for point in points]
    return Panel(title, axis, "milliseconds", styles)


def speed_up(points):
    ratios = [p["ms"]["lambent, 1 thread"] / p["ms"]["lambent"] for p in points]
    return statistics.median(ratios)


def draw(source, target):
    data = json.loads(pathlib.Path(source).read_text())
    both = data["triangles"] + data["pixels"]
    machine = data["machine"]
    note = (
        f"{machine['processor']}, {machine['cores']} cores, load {machine['load'][0]:.1f}. "
        f"Two threads unless it says one; Lambent's second thread brings "
        f"×{speed_up(both):.2f} (median of all points)."
    )
    width, height = data["size"]
    panels = [
        panel(f"A bumpy ball at {width} × {height}", "triangles", data["triangles"]),
        panel(f"The ball of {data['fixed triangles']:,} triangles", "pixels", data["pixels"]),
    ]
    pathlib.Path(target).write_text(page(panels, note))


if __name__ == "__main__":
    draw(*sys.argv[1:])
