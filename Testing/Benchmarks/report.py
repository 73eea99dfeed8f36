# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables: medians, ratios to the peers, and missed goals."""

import json
import pathlib

from results import SUPERSAMPLING

GOALS = json.loads(pathlib.Path(__file__).with_name("goals.json").read_text())
EVERYWHERE = GOALS["of each of them"]
SAMPLES = GOALS["supersampling"]
MISSED = " **missed**"
MAY_DIFFER = 0.005


def table(header, rows):
    """A Markdown table with aligned columns; the first column is aligned left."""
    rows = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[k]) for row in [header, *rows]) for k in range(len(header))]

    def line(cells):
        first, *others = [
            cell.ljust(width) if k == 0 else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(cells, widths))
        ]
        return "| " + " | ".join([first, *others]) + " |"

    rule = ["-" * widths[0]] + ["-" * (width - 1) + ":" for width in widths[1:]]
    return "\n".join([line(header), "| " + " | ".join(rule) + " |", *map(line, rows)])


def ms(time):
    if time is None:
        return "-"
    return f"{time:.2f}" if time < 1 else f"{time:.1f}" if time < 100 else f"{time:.0f}"


class Tally:
    """Marks ratios that miss their goals, and counts them."""

    def __init__(self):
        self.goals = 0
        self.missed = []

    def ratio(self, what, peer, ours, goal):
        """A table cell: the ratio, with a mark if it misses its goal."""
        if peer is None or ours is None:
            return "-"
        return f"{peer / ours:.1f}" + self._mark(what, peer / ours >= goal if goal else None)

    def limit(self, what, value, goal):
        if value is None:
            return "-"
        return f"{value:.0f}" + self._mark(what, value <= goal if goal else None)

    def most(self, what, value, goal):
        return f"{value:.2f}" + self._mark(what, value <= goal if goal else None)

    def _mark(self, what, is_met):
        if is_met is None:
            return ""
        self.goals += 1
        if not is_met:
            self.missed.append(what)
        return "" if is_met else MISSED


def goal_text(goal):
    return f"≥ {goal}" if goal else ""


def embree_table(scenes, tally):
    scenes = [scene for scene in scenes if scene.build("medium") is not None]
    header = ["scene", "triangles", "Lambent ms", "Embree medium build + trace", "ratio", "goal"]
    header += ["Embree fastest total", "ratio", "goal", "best trace alone", "ratio"]
    rows = []
    for scene in scenes:
        goals = GOALS["scenes"].get(scene.name, {})
        ours = scene.median("lambent")
        medium, fastest = goals.get("medium"), goals.get("fastest")
        quality, total = scene.fastest_total()
        trace, kind = scene.fastest_trace()
        _, medium_trace = scene.best_trace("medium")
        size = "" if scene.size == "1920x1080" else f" ({scene.size})"
        rows.append(
            [
                scene.name + size,
                f"{scene.triangles:,}",
                f"{ms(ours)} ±{100 * scene.spread('lambent'):.0f} %",
                f"{ms(scene.build('medium'))} + {ms(medium_trace)}",
                tally.ratio(f"{scene.name}: medium", scene.total("medium"), ours, medium),
                goal_text(medium),
                f"{ms(total)} ({quality})",
                tally.ratio(f"{scene.name}: fastest", total, ours, fastest),
                goal_text(fastest),
                f"{ms(trace)} ({kind})",
                tally.ratio(f"{scene.name}: trace", trace, ours, goals and EVERYWHERE["trace"]),
            ]
        )
    return table(header, rows)


def opengl_table(scenes, tally):
    drawn = [scene for scene in scenes if scene.median("opengl/first")]
    if not drawn:
        return ""
    header = ["scene", "OpenGL first frame ms", "ratio", "goal"]
    header += ["new mesh ms", "ratio", "goal", "next frame ms", "ratio", "goal"]
    rows = []
    for scene in drawn:
        goals = EVERYWHERE if scene.name in GOALS["scenes"] else {}
        row, ours = [scene.name], scene.median("lambent")
        for frame in ("first", "new-mesh", "next"):
            time, goal = scene.median(f"opengl/{frame}"), goals.get(f"opengl {frame}")
            row += [ms(time), tally.ratio(f"{scene.name}: OpenGL {frame}", time, ours, goal)]
            row += [goal_text(goal)]
        rows.append(row)
    return f"VTK's OpenGL renderer on {drawn[0].opengl}:\n\n" + table(header, rows)


def normals_table(scenes, tally):
    ours, peers = "vtkLambentNormals", ("vtkTriangleMeshPointNormals", "vtkPolyDataNormals")
    header = ["point normals", f"{ours} ms"]
    for peer in peers:
        header += [f"{peer} ms", "ratio"]
    rows = []
    for scene in scenes:
        mine = scene.median(f"normals/{ours}")
        if mine is None:
            continue
        row = [scene.name, f"{ms(mine)} ±{100 * scene.spread(f'normals/{ours}'):.0f} %"]
        for peer in peers:
            time = scene.median(f"normals/{peer}")
            goal = GOALS["scenes"].get(scene.name, {}).get("normals") if peer == peers[0] else None
            row += [ms(time), tally.ratio(f"{scene.name}: normals", time, mine, goal)]
        rows.append(row)
    return table(header, rows) if rows else ""


def surfaces_table(scenes, tally):
    """The same mesh as many surfaces."""
    header = ["many surfaces", "one mesh ms", "as inputs ms", "ratio", "VTK's executive ms"]
    header += ["ratio without it", "goal"]
    header += ["core, one surface ms", "core, many surfaces ms", "ratio", "goal"]
    rows = []
    for scene in scenes:
        one, many = scene.median("surfaces/one"), scene.median("surfaces/many")
        if many is None:
            continue
        mesh, inputs = scene.median("lambent"), scene.median("surfaces/inputs")
        executive = scene.median("surfaces/blind") - many
        goals = GOALS["surfaces"][scene.name]
        limits = {part: f"≤ {goals[part]}" if part in goals else "" for part in ("inputs", "core")}
        row = [scene.name, ms(mesh), ms(inputs), f"{inputs / mesh:.2f}", ms(executive)]
        ratio = (inputs - executive) / mesh
        row += [tally.most(f"{scene.name}: inputs", ratio, goals.get("inputs"))]
        row += [limits["inputs"]]
        row += [ms(one), ms(many)]
        row += [tally.most(f"{scene.name}: core", many / one, goals.get("core")), limits["core"]]
        rows.append(row)
    return table(header, rows) if rows else ""


def supersampling_table(scenes, tally):
    """Several samples per pixel, compared with one sample and with Embree."""
    header = ["several samples per pixel", "Lambent ms", "times one sample", "goal"]
    header += ["Embree medium build + trace", "ratio", "goal", "Embree fastest total", "ratio"]
    header += ["goal", "best trace alone", "ratio", "with one sample"]
    rows = []
    for scene in scenes:
        for n in (2, 4):
            prefix = f"{SUPERSAMPLING}{n}/"
            one, ours = scene.median("lambent"), scene.median(f"{prefix}lambent")
            if ours is None or scene.build("medium") is None:
                continue
            goal = SAMPLES.get(scene.name, {}).get(str(n))
            what = f"{scene.name}, {n} × {n}"
            row = [what, f"{ms(ours)} ±{100 * scene.spread(f'{prefix}lambent'):.0f} %"]
            row += [tally.most(f"{what} samples", ours / one, goal), f"≤ {goal}"]
            kept = SAMPLES["ratio kept"] / one
            total, before = scene.total("medium", prefix), scene.total("medium")
            row += [f"{ms(scene.build('medium'))} + {ms(scene.best_trace('medium', prefix)[1])}"]
            row += [tally.ratio(f"{what} samples: medium", total, ours, kept * before)]
            row += [f"≥ {kept * before:.1f}"]
            (quality, total), (_, before) = scene.fastest_total(prefix), scene.fastest_total()
            row += [f"{ms(total)} ({quality})"]
            row += [tally.ratio(f"{what} samples: fastest", total, ours, kept * before)]
            row += [f"≥ {kept * before:.1f}"]
            (trace, kind), (before, _) = scene.fastest_trace(prefix), scene.fastest_trace()
            row += [f"{ms(trace)} ({kind})", f"{trace / ours:.1f}", f"{before / one:.1f}"]
            rows.append(row)
    return table(header, rows) if rows else ""


def layers_table(scenes, tally):
    """Transparent surfaces: all hits of each ray."""
    header = ["transparent surfaces", "Lambent ms", "times opaque"]
    header += ["Embree fastest build + all hits", "ratio", "goal", "depth peeling ms", "ratio", "goal"]
    rows = []
    for scene in scenes:
        ours, opaque = scene.median("layers/lambent"), scene.median("lambent")
        found = [
            (scene.build(quality) + trace, quality)
            for quality in ("low", "medium", "high")
            if (trace := scene.median(f"layers/embree/trace/{quality}/packets")) is not None
            and scene.build(quality) is not None
        ]
        if ours is None or not found:
            continue
        goals = GOALS["layers"].get(scene.name, {})
        total, quality = min(found)
        peeled = scene.median("layers/opengl")
        row = [scene.name, f"{ms(ours)} ±{100 * scene.spread('layers/lambent'):.0f} %"]
        row += [f"{ours / opaque:.2f}", f"{ms(total)} ({quality})"]
        row += [tally.ratio(f"{scene.name}: all hits", total, ours, goals.get("embree"))]
        row += [goal_text(goals.get("embree")), ms(peeled)]
        row += [tally.ratio(f"{scene.name}: depth peeling", peeled, ours, goals.get("opengl"))]
        rows.append(row + [goal_text(goals.get("opengl"))])
    return table(header, rows) if rows else ""


def looks_table(scenes, tally):
    """A surface with other looks, compared with the plain one."""
    looks = ("colors", "texture", "edges")
    header = ["other looks", "plain ms"]
    for look in looks:
        header += [f"{look} ms", "ratio", "goal"]
    rows = []
    for scene in scenes:
        if scene.median("looks/colors") is None:
            continue
        plain = scene.median("lambent")
        row = [scene.name, ms(plain)]
        for look in looks:
            goal = GOALS["looks"].get(look)
            time = scene.median(f"looks/{look}")
            row += [ms(time), tally.most(f"{scene.name}: {look}", time / plain, goal)]
            row += [f"≤ {goal}" if goal else ""]
        rows.append(row)
    return table(header, rows) if rows else ""


def balls_table(scenes, tally):
    """Spheres, compared with Embree's sphere geometry."""
    header = ["spheres", "Lambent ms", "Embree fastest build + trace", "ratio", "goal"]
    rows = []
    for scene in scenes:
        ours = scene.median("balls/lambent")
        if ours is None:
            continue
        total, parts, quality = min(
            (scene.median(f"balls/build/{q}") + scene.median(f"balls/trace/{q}"),
             f"{ms(scene.median(f'balls/build/{q}'))} + {ms(scene.median(f'balls/trace/{q}'))}", q)
            for q in ("low", "medium")
        )
        goal = GOALS["balls"]
        row = [scene.name, f"{ms(ours)} ±{100 * scene.spread('balls/lambent'):.0f} %"]
        row += [f"{parts} ({quality})", tally.ratio(scene.name, total, ours, goal)]
        rows.append([*row, goal_text(goal)])
    return table(header, rows) if rows else ""


def further_table(scenes, tally):
    """Threads and memory."""
    header = ["scene", "1 thread ms", "2 threads are faster by", "peak MB beyond mesh and image"]
    embree = any("embree/build/medium" in scene.memory for scene in scenes)
    header += ["Embree's, low / medium / high"] if embree else []
    rows = []
    for scene in scenes:
        one, memory = scene.median("1-thread/lambent"), scene.memory.get("lambent")
        if one is None and memory is None:
            continue
        goals = GOALS["scenes"].get(scene.name, {})
        ours = scene.median("lambent")
        threads = tally.ratio(f"{scene.name}: threads", one, ours, goals.get("threads"))
        if one is not None:
            threads = threads.replace(f"{one / ours:.1f}", f"{one / ours:.2f}", 1)
        row = [scene.name, ms(one), threads]
        row += [tally.limit(f"{scene.name}: memory", memory, goals.get("megabytes"))]
        if embree:
            figures = [scene.memory.get(f"embree/build/{q}") for q in ("low", "medium", "high")]
            row += [" / ".join("-" if f is None else f"{f:.0f}" for f in figures)]
        rows.append(row)
    return table(header, rows) if rows else ""


def agreement(scenes):
    """A sentence on whether all peers render the same picture; names those that do not."""
    far = [
        f"{scene.name}, {peer}: {100 * part:.2f} %"
        for scene in scenes
        for peer, part in scene.differing.items()
        if "embree/" in peer and part > MAY_DIFFER
    ]
    if far:
        return "PICTURES DIFFER from Embree's, in bytes by more than 2: " + "; ".join(far) + "."
    worst = max((max(scene.differing.values(), default=0) for scene in scenes), default=0)
    return (
        "The peers drew the same pictures: at most "
        f"{100 * worst:.3f} % of the bytes differ by more than 2."
    )


def write(scenes, machine, load_after, quick):
    tally = Tally()
    tables = [
        embree_table(scenes, tally),
        opengl_table(scenes, tally),
        normals_table(scenes, tally),
        supersampling_table(scenes, tally),
        surfaces_table(scenes, tally),
        layers_table(scenes, tally),
        looks_table(scenes, tally),
        balls_table(scenes, tally),
        further_table(scenes, tally),
    ]
    load = f"load average {machine['load'][0]:.1f} before, {load_after[0]:.1f} after"
    head = f"{machine['processor']}, {machine['cores']} cores, two threads; {load}."
    if machine["load"][0] > 0.5:
        head += " Other programs were running: the times are not to be trusted, the ratios little."
    if quick:
        head += " Quick run: few repetitions; Embree without the high quality."
    goals = f"{tally.goals - len(tally.missed)} of {tally.goals} goals met."
    if tally.missed:
        goals += " Missed: " + "; ".join(tally.missed) + "."
    return "\n\n".join(part for part in [head, *tables, agreement(scenes), goals] if part) + "\n"
