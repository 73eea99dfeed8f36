# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""EnSight Gold geometry, complete and truncated, as text and as C binary in both byte orders.

VTK's reader does not report a file that ends too early.
"""

import struct
import unittest

import commandline as make
from commandline import CommandTest

VIEW = ("--camera-position", "4,5,7", "--focal-point", "1,0.6,0.6", "--size", "32x24", "--shading",
        "flat")
CUBE = [(2 * x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]

# A file is a list of lines, rows of integers, and rows of real numbers.
HEAD = ["box", "of a test", "node id off", "element id off"]
PART = ["part", (1,), "box"]
POINTS = ["coordinates", (8,)] + [[p[axis]] for axis in range(3) for p in CUBE]
HEXAHEDRON = ["hexa8", (1,), tuple(i + 1 for i in (0, 1, 3, 2, 4, 5, 7, 6))]
ROWS = [tuple(i + 1 for i in face) for face in FACES]
IDS = [(k,) for k in range(1, 9)]

KINDS = {
    "hexahedron": HEAD + PART + POINTS + HEXAHEDRON,
    "extents": HEAD + ["extents", [0, 2], [0, 1], [0, 1]] + PART + POINTS + HEXAHEDRON,
    "quads": HEAD + PART + POINTS + ["quad4", (6,)] + ROWS,
    "polygons": HEAD + PART + POINTS + ["nsided", (6,)] + [(4,)] * 6 + ROWS,
    "polyhedron": HEAD + PART + POINTS + ["nfaced", (1,), (6,)] + [(4,)] * 6 + ROWS,
    "numbers": HEAD[:2] + ["node id given", "element id given"] + PART + POINTS[:2] + IDS +
               POINTS[2:] + ["quad4", (6,)] + [(k,) for k in range(1, 7)] + ROWS,
    "curvilinear": HEAD + PART + ["block", (2, 2, 2)] + POINTS[2:],
    "rectilinear": HEAD + PART + ["block rectilinear", (2, 2, 2), [0], [2], [0], [1], [0], [1]],
    "uniform": HEAD + PART + ["block uniform", (2, 2, 2), [0], [0], [0], [2], [1], [1]],
}


def text(items):
    return "".join(item + "\n" if isinstance(item, str) else
                   "".join("%10d" % n if isinstance(item, tuple) else "%12.5e" % n for n in item) +
                   "\n" for item in items).encode()


def binary(items, order):
    return b"".join(item.encode().ljust(80) if isinstance(item, str) else
                    struct.pack(order + str(len(item)) + "if"[isinstance(item, list)], *item)
                    for item in ["C Binary"] + items)


ENCODINGS = {"text": text, "little": lambda items: binary(items, "<"),
             "big": lambda items: binary(items, ">")}


class TestEnSight(CommandTest):

    def setUp(self):
        super().setUp()
        if b".case" not in self.succeed("--formats") or any(
                ".case" in line and "not in this build" in line
                for line in self.succeed("--formats").decode().splitlines()):
            self.skipTest("VTK was built without its reader of EnSight")
        self.write("box.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: box.geo\n")

    def picture(self, name):
        self.succeed(name, *VIEW, "-o", "picture.pnm")
        return self.read("picture.pnm")

    def failure_when_cut(self, content, size):
        self.write("box.geo", content[:size])
        return self.fail_with(1, "box.case", "-o", "x.png")

    def test_complete_files_are_read(self):
        self.write("expected.obj", make.obj((CUBE, FACES)))
        expected = self.picture("expected.obj")
        for kind, items in KINDS.items():
            if kind == "uniform":  # an image has no surface
                continue
            for encoding, write in ENCODINGS.items():
                with self.subTest(kind=kind, encoding=encoding):
                    self.write("box.geo", write(items))
                    self.assertEqual(self.picture("box.case"), expected)
            with self.subTest(kind=kind):
                self.write("box.geo", text(items)[:-1])  # without the last line end
                self.assertEqual(self.picture("box.case"), expected)

    def test_files_truncated_within_the_last_numbers_are_errors(self):
        for kind, items in KINDS.items():
            for encoding, write in ENCODINGS.items():
                with self.subTest(kind=kind, encoding=encoding):
                    content = write(items)
                    for less in (2, 5, 13, 21):
                        self.assertIn("its geometry file 'box.geo' is incomplete; use a "
                                      "complete copy", self.failure_when_cut(content, len(content) - less))

    def test_files_truncated_anywhere_are_errors(self):
        items = KINDS["polyhedron"]
        for encoding, write in ENCODINGS.items():
            content = write(items)
            # If it ends after the points there is nothing to draw, which causes a warning.
            behind = [len(write(items[:k])) for k in (7, 7 + len(POINTS))]
            for size in range(1, len(content) - 1, 29):
                if not any(end - 1 <= size <= end for end in behind):
                    with self.subTest(encoding=encoding, size=size):
                        self.failure_when_cut(content, size)

    def test_unknown_content_is_left_to_the_reader(self):
        content = text(KINDS["hexahedron"])
        self.write("box.geo", content)
        for case in ("model: 1 box.geo", "model: 1 1 box.geo", "model:\tbox.geo"):
            self.write("box.case", "FORMAT\ntype: ensight gold\nGEOMETRY\n" + case + "\n")
            self.write("box.geo", content[:-30])
            self.assertIn("incomplete", self.fail_with(1, "box.case", "-o", "x.png"))
        self.write("box.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: box.geo\n")
        self.write("box.geo", content + b"something\nelse\n")
        self.assertNotIn("incomplete", self.fail_with(1, "box.case", "-o", "x.png"))
        for counts in ("-1", "x", "99999999999999999999"):
            self.write("box.geo", content.replace(b"         8\n", counts.encode() + b"\n"))
            self.assertNotIn("incomplete", self.fail_with(1, "box.case", "-o", "x.png"))
        for size in ("-1 2 2", "2147483647 2147483647 2147483647"):
            self.write("box.geo", text(HEAD + PART + ["block", size]) + b"0\n")
            self.assertNotIn("incomplete", self.fail_with(1, "box.case", "-o", "x.png"))
        self.write("box.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: none.geo\n")
        self.assertNotIn("incomplete", self.fail_with(1, "box.case", "-o", "x.png"))

    def test_truncated_variables_are_skipped(self):
        self.write("box.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: box.geo\nVARIABLE\n"
                   "scalar per node: x box.x\nvector per element: v box.v\n")
        items = KINDS["hexahedron"]
        x = ["x"] + PART[:2] + ["coordinates"] + [[p[0]] for p in CUBE]
        v = ["v"] + PART[:2] + ["hexa8", [1], [2], [3]]
        for encoding, write in ENCODINGS.items():
            header = 80 if encoding != "text" else 0  # it declares the geometry as binary
            self.write("box.geo", write(items))
            whole = {"box.x": write(x)[header:], "box.v": write(v)[header:]}
            for name, content in whole.items():
                self.write(name, content)
            surface = self.picture("box.case")
            self.succeed("box.case", "--contour", "0.5,x", "-o", "x.png")
            for name, content in whole.items():
                variable = name[-1]
                for size in (len(content) - 2, len(content) - 7, len(content) - 20, 5):
                    with self.subTest(encoding=encoding, name=name, size=size):
                        self.write(name, content[:size])
                        done = self.run_command("box.case", *VIEW, "-o", "picture.pnm")
                        self.assertEqual(
                            (done.returncode, done.stderr.decode()),
                            (0, "lambent: warning: 'box.case': its variable %s is skipped: the file "
                             "'%s' is incomplete\n" % (variable, name)))
                        self.assertEqual(self.read("picture.pnm"), surface)
                        done = self.run_command("box.case", "--contour", "0.5,x", "-o", "x.png")
                        self.assertEqual(done.returncode, variable == "x", done.stderr)
                self.write(name, content)


if __name__ == "__main__":
    unittest.main()
