#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders each scene with VTK's OpenGL and with Lambent, and compares the pictures.

    suite.py [--output FOLDER] [PART OF A SCENE'S NAME]...

Writes FOLDER/report.html with the pictures. Exit status: 0 if all differences are known, 1 if not, 77 if there is no
software OpenGL. Needs the folder python of the build in PYTHONPATH.

The verdicts: "same"; "known", a difference of known.py that is as it says there; "not yet", the library lacks the
feature; and the failures "DIFFERENT", "STALE", a known difference that is gone, and "MESSAGES", unexpected warnings
or errors.
"""

import argparse
import sys
from dataclasses import dataclass, field
from typing import Optional

import lambent_side
from comparison import Result, compare
from known import KNOWN
from opengl_side import Missing, OpenGL, Screen
from report import print_row, print_title, write_report
from scene import BACKGROUNDS
from scenes import SCENES

FAILURES = "DIFFERENT", "STALE", "MESSAGES"


@dataclass
class Row:
    """One line of the table, and the pictures of the report by their captions."""
    name: str
    verdict: str
    result: Optional[Result] = None
    note: str = ""
    pictures: dict = field(default_factory=dict)

    @property
    def failed(self):
        return self.verdict in FAILURES


class Suite:

    def __init__(self, opengl):
        self.opengl = opengl
        self.missing = lambent_side.missing_features()

    def row(self, scene):
        pictures = {"OpenGL": self.opengl.render(scene)}
        awaited = sorted(self.missing.intersection(scene.awaits))
        if awaited:
            return Row(scene.name, "not yet", note="awaits " + ", ".join(awaited), pictures=pictures)
        pictures["Lambent"], messages = lambent_side.render(scene, {})
        result = compare(*pictures.values(), BACKGROUNDS, scene.thin)
        if messages:
            return Row(scene.name, "MESSAGES", result, "; ".join(messages), pictures)
        if scene.name in KNOWN:
            return self.row_of_known(scene, KNOWN[scene.name], result, pictures)
        return Row(scene.name, "same" if result.is_same else "DIFFERENT", result, pictures=pictures)

    def row_of_known(self, scene, known, result, pictures):
        if result.is_same:
            return Row(scene.name, "STALE", result, "no longer differs: " + known.reason, pictures)
        one, other = pictures.values()
        if known.opengl:
            one = pictures["OpenGL, changed"] = self.opengl.render(known.opengl(scene))
        if known.lambent or known.settings:
            changed = known.lambent(scene) if known.lambent else scene
            other, messages = lambent_side.render(changed, known.settings)
            pictures["Lambent, changed"] = other
            if messages:
                return Row(scene.name, "MESSAGES", result, "; ".join(messages), pictures)
        result = compare(one, other, BACKGROUNDS, scene.thin)
        return Row(scene.name, "known" if known.allows(result) else "DIFFERENT", result, known.reason, pictures)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", help="folder for the report and its pictures")
    parser.add_argument("names", nargs="*", metavar="NAME", help="parts of the names of scenes; default: all")
    options = parser.parse_args()
    chosen = [scene for scene in SCENES
              if not options.names or any(name in scene.name for name in options.names)]
    if not chosen:
        parser.error("no scene has such a name")
    rows = []
    try:
        with Screen(), OpenGL() as opengl:
            suite = Suite(opengl)
            print_title()
            for scene in chosen:
                rows.append(suite.row(scene))
                print_row(rows[-1])
    except Missing as reason:
        print("Skipped: %s." % reason)
        return 77
    if options.output:
        print("Pictures: " + write_report(options.output, rows))
    failed = [row.name for row in rows if row.failed]
    print("%d scenes: %s" % (len(rows), ", ".join("%d %s" % (count, verdict) for verdict, count in tally(rows))))
    return 1 if failed else 0


def tally(rows):
    verdicts = [row.verdict for row in rows]
    return [(verdict, verdicts.count(verdict)) for verdict in dict.fromkeys(verdicts)]


if __name__ == "__main__":
    sys.exit(main())
