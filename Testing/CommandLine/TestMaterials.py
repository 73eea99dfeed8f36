#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials of OBJ files: colours and textures, and what happens if their files are broken."""

import gzip
import struct
import unittest
import zlib

from commandline import CommandTest, read_pnm
from pictures import read_tiff

RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)

# Two squares side by side, 4 x 2, of two materials. Each has all of its texture.
SQUARES = """mtllib my materials.mtl
v -2 -1 0\nv 0 -1 0\nv 2 -1 0\nv -2 1 0\nv 0 1 0\nv 2 1 0
vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1
usemtl left
f 1/1/1 2/2/1 5/4/1 4/3/1
usemtl right
f 2/1/1 3/2/1 6/4/1 5/3/1
"""
FRONT = ("--direction", "0,0,1", "--parallel-scale", "1", "--shading", "unlit", "--size", "40x20",
         "--supersampling", "1")


def png(rows):
    """An RGB PNG; the top row first."""
    def chunk(kind, body):
        return (struct.pack(">I", len(body)) + kind + body +
                struct.pack(">I", zlib.crc32(kind + body)))
    body = b"".join(b"\0" + b"".join(bytes(pixel) for pixel in row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b""))


# Red below, green above; blue on the right.
QUADRANTS = png([[GREEN] * 4 + [BLUE] * 4] * 4 + [[RED] * 4 + [BLUE] * 4] * 4)


class Materials(CommandTest):
    def rows(self, *arguments, messages=()):
        """The rows of a picture. The command warns once for each message, which has these parts."""
        done = self.run_command(*arguments, "-o", "picture.pnm", *FRONT)
        lines = done.stderr.decode().splitlines()
        self.assertEqual((done.returncode, len(lines)), (0, len(messages)), lines)
        for line, parts in zip(lines, messages):
            for part in parts:
                self.assertIn(part, line)
        return read_pnm(self.read("picture.pnm"))

    def middles(self, *arguments, messages=()):
        """The colours in the middle of both squares."""
        rows = self.rows(*arguments, messages=messages)
        return rows[10][10], rows[10][30]

    def write_squares(self, materials):
        self.write("squares.obj", SQUARES)
        self.write("my materials.mtl", materials)

    def test_colours(self):
        self.write_squares("Kd 9 9 9\nnewmtl left\nKd 1 0 0\nNs 5\nnewmtl right # it\nKd 0 1 0\n"
                           "newmtl right\nillum 1\n\tKd 0.2 .4 1e0 # r g b\nnewmtl left\nKd 0 0 0\n")
        self.assertEqual(self.middles("squares.obj"), (RED, (51, 102, 255)))
        self.assertEqual(self.middles("squares.obj", "--color", "lime"), (GREEN, GREEN))
        self.write_squares("newmtl left\nKd 0.4\nnewmtl right\nKd spectral file.rfl\n")
        self.assertEqual(self.middles("squares.obj"), ((102, 102, 102), WHITE))
        self.write_squares("newmtl left\nKd 7 -1 0\n")
        self.assertEqual(self.middles("squares.obj"), (RED, WHITE))

    def test_ambient_colours(self):
        self.write_squares("newmtl left\nKd 0 0 1\nKa 1 0 0\nnewmtl right\nKd 0 1 0\n")
        lit = ("squares.obj", "-o", "lit.pnm", "--direction", "0,0,1", "--parallel-scale", "1",
               "--size", "40x20", "--supersampling", "1", "--diffuse", "0", "--ambient", "1")
        self.succeed(*lit, "--quiet")
        rows = read_pnm(self.read("lit.pnm"))
        self.assertEqual((rows[10][10], rows[10][30]), (RED, GREEN))
        self.succeed(*lit, "--quiet", "--ambient-color", "blue")
        self.assertEqual(read_pnm(self.read("lit.pnm"))[10][10], BLUE)

    def test_opacity(self):
        for left, right, expected in (("d 0.4", "Tr 0.6", ((102, 0, 0), (0, 102, 0))),
                                      ("d 0.4\nTr 0", "Tr 1\nd 1", ((102, 0, 0), GREEN)),
                                      ("d -halo 0.4", "Tr 0", ((102, 0, 0), GREEN)),
                                      ("d 7", "map_d none.png", (RED, GREEN))):
            with self.subTest(left + right):
                self.write_squares(
                    "newmtl left\nKd 1 0 0\n%s\nnewmtl right\nKd 0 1 0\n%s\n" % (left, right))
                self.assertEqual(self.middles("squares.obj"), expected)
        self.write_squares("newmtl left\nd 0.5\nnewmtl right\nKd 0 1 0\n")
        self.assertEqual(self.middles("squares.obj", "--opacity", "0.4"), ((51, 51, 51), (0, 102, 0)))
        self.assertEqual(self.middles("squares.obj", "--color", "red"), (RED, RED))

    def highlights(self, left, right, *arguments):
        """The colours in the middle of both squares, without diffuse reflection."""
        self.write_squares("newmtl left\n%s\nnewmtl right\n%s\n" % (left, right))
        self.succeed("squares.obj", "-o", "lit.pnm", "--direction", "0,0,1", "--parallel-scale", "1",
                     "--size", "40x20", "--supersampling", "1", "--diffuse", "0", *arguments)
        rows = read_pnm(self.read("lit.pnm"))
        return rows[10][10], rows[10][30]

    def test_highlights(self):
        seen = (51, 102, 255)
        for left, right, expected in (
                ("Ks 0.2 0.4 1\nNs 30", "Ks 0 1 0\nNs 1000\nillum 2", (seen, GREEN)),
                ("Ks 1 1 1", "Ks 1 1 1\nNs 0", ((0, 0, 0), (0, 0, 0))),
                ("Ks 1 1 1\nNs 5\nillum 1", "Ks 1 1 1\nNs 5\nillum 0", ((0, 0, 0), (0, 0, 0)))):
            with self.subTest(left + right):
                self.assertEqual(self.highlights(left, right, "--quiet"), expected)

    def test_options_of_highlights(self):
        material = "Ks 0.2 0.4 1"
        self.assertEqual(self.highlights(material, material, "--specular-power", "5"),
                         ((51, 102, 255),) * 2)
        self.assertEqual(self.highlights(material, material + "\nNs 5", "--specular", "0.4"),
                         ((102, 102, 102),) * 2)
        self.assertEqual(self.highlights(material + "\nNs 5", "Ns 9", "--specular", "0", "--quiet"),
                         ((0, 0, 0),) * 2)

    def test_exponents_make_highlights_small(self):
        lamp = ("--light", "position=-1,0,0.5", "--quiet")  # above the left square's middle
        self.highlights("Ks 1 1 1\nNs 2", "Ks 1 1 1\nNs 2", *lamp)
        wide = read_pnm(self.read("lit.pnm"))
        self.highlights("Ks 1 1 1\nNs 20", "Ks 1 1 1\nNs 20", *lamp)
        narrow = read_pnm(self.read("lit.pnm"))
        self.assertLess(narrow[10][14], wide[10][14])
        self.assertGreater(narrow[10][10], (200, 200, 200))

    def test_textures(self):
        self.write("my image.png", QUADRANTS)
        self.write_squares("newmtl left\nmap_Kd -bm 1 my image.png \n"
                           "newmtl right\nKd 1 0.4 1\nmap_Kd .\\textures\\my image.png\n")
        rows = self.rows("squares.obj")
        self.assertEqual([rows[15][4], rows[5][4], rows[15][15]], [RED, GREEN, BLUE])
        self.assertEqual([rows[15][24], rows[5][24], rows[15][35]], [RED, (0, 102, 0), BLUE])
        self.assertEqual(self.rows("squares.obj", "--color", "lime")[15][4], GREEN)

    def test_options_of_textures(self):
        self.write("q.png", QUADRANTS)
        self.write_squares("newmtl left\nmap_Kd -s 2 1 1 -o 0.5 -clamp on q.png\n"
                           "newmtl right\nmap_Kd -s 2 2 -cc on q.png\n")
        rows = self.rows("squares.obj")
        self.assertEqual([rows[15][k] for k in (2, 10, 18)], [BLUE] * 3)
        self.assertEqual([rows[18][k] for k in (22, 28, 32, 38)], [RED, BLUE, RED, BLUE])
        self.assertEqual([rows[k][22] for k in (18, 12, 8, 2)], [RED, GREEN, RED, GREEN])

    def test_numbers_are_those_of_the_file(self):
        self.write_squares("newmtl left\nKd 1 0 0\nnewmtl right\nKd 0 1 0\n")
        self.write("first.obj", "v -1 -1 -1\nv 1 -1 -1\nv 0 1 -1\nf 1 2 3\n")
        self.succeed("squares.obj", "first.obj", "-o", "picture.png", *FRONT, "--pass",
                     "ids=ids.tif", "--pass", "input-ids=inputs.tif")
        seen = {name: {pixel[0] for row in read_tiff(self.read(name)) for pixel in row}
                for name in ("ids.tif", "inputs.tif")}
        self.assertEqual(seen, {"ids.tif": {0, 1}, "inputs.tif": {0}})

    def test_computed_normals_do_not_break(self):
        points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        faces = ["1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"]
        text = "mtllib m.mtl\n" + "".join("v %d %d %d\n" % point for point in points)
        one = text + "usemtl a\n" + "".join("f %s\n" % face for face in faces)
        two = text + "".join("usemtl %s\nf %s\n" % ("ab"[k % 2], faces[k]) for k in range(8))
        self.write("m.mtl", "newmtl a\nKd 0.5 0.25 1\nnewmtl b\nKd 0.5 0.25 1\n")
        pictures = []
        for name, content in (("one.obj", one), ("two.obj", two)):
            self.write(name, content)
            self.succeed(name, "-o", "picture.pnm", "--size", "64x64", "--feature-angle", "180")
            pictures.append(read_pnm(self.read("picture.pnm")))
        self.assertEqual(pictures[0], pictures[1])

    def test_gzipped(self):
        self.write_squares("newmtl left\nKd 1 0 0\nnewmtl right\nKd 0 1 0\n")
        self.write("squares.obj.gz", gzip.compress(SQUARES.encode()))
        self.assertEqual(self.middles("squares.obj.gz"), (RED, GREEN))

    def test_missing_library(self):
        self.write("squares.obj", SQUARES)
        self.assertEqual(
            self.middles("squares.obj", messages=[("warning", "squares.obj", "my materials.mtl")]),
            (WHITE, WHITE))

    def test_broken_library(self):
        self.write_squares("newmtl left\nKd 1 0 0\nnewmtl right\nKd 0 1 x\n")
        self.assertEqual(
            self.middles("squares.obj", messages=[("my materials.mtl", "line 4", "'x'")]),
            (WHITE, WHITE))

    def test_broken_images(self):
        for name, content, part in (("a.png", QUADRANTS[:70], "a.png"),
                                    ("b.jpg", b"\xff\xd8\xff\xe0", "b.jpg"),
                                    ("c.tga", b"abc", "unknown"), ("d.png", b"", "d.png")):
            self.write(name, content)
            self.write_squares("newmtl left\nKd 0 1 0\nmap_Kd %s\nnewmtl right\nKd 1 0 0\n" % name)
            with self.subTest(name):
                self.assertEqual(
                    self.middles("squares.obj", messages=[("cannot use the texture", part)]),
                    (GREEN, RED))

    def test_missing_image(self):
        self.write_squares("newmtl left\nKd 0 1 0\nmap_Kd none.png\nnewmtl right\nmap_Kd none.png\n")
        self.assertEqual(self.middles("squares.obj", messages=[("none.png",)]), (GREEN, WHITE))

    def test_no_texture_coordinates(self):
        self.write("q.png", QUADRANTS)
        self.write_squares("newmtl left\nKd 0 1 0\nmap_Kd q.png\n")
        self.write("squares.obj", SQUARES.replace("/1", "").replace("/2", "").replace("/3", "")
                   .replace("/4", ""))
        self.assertEqual(self.middles("squares.obj", messages=[("q.png", "(vt)")]), (GREEN, WHITE))

    def test_black_materials_are_no_mistake(self):
        self.write_squares("newmtl left\nKd 0 0 0\nnewmtl right\nKd 0 0 0\n")
        self.assertEqual(self.middles("squares.obj"), ((0, 0, 0), (0, 0, 0)))


if __name__ == "__main__":
    unittest.main()
