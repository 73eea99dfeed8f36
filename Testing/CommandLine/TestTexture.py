#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""--texture: an image that covers all inputs with texture coordinates."""

import unittest

from commandline import CommandTest
from TestMaterials import BLUE, FRONT, GREEN, QUADRANTS, RED, SQUARES
from TestRecreating import COMMAND_KEY, texts
from pictures import read_png

PLAIN = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"  # without coordinates


class Texture(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("squares.obj", SQUARES)
        self.write("plain.obj", PLAIN)
        self.write("my materials.mtl", "newmtl left\nKd 0 0.5 0\nnewmtl right\nmap_Kd none.png\n")
        self.write("q.png", QUADRANTS)

    def rows(self, *arguments):
        self.succeed(*arguments, "-o", "picture.png", *FRONT)
        return read_png(self.read("picture.png"))

    def test_it_covers_all_faces_instead_of_materials(self):
        rows = self.rows("squares.obj", "--texture", "q.png")
        for left in (0, 20):
            self.assertEqual([rows[15][left + 4], rows[5][left + 4], rows[15][left + 15]],
                             [RED, GREEN, BLUE])

    def test_it_multiplies_the_colour(self):
        rows = self.rows("squares.obj", "--texture", "q.png", "--color", "0.4,1,0")
        self.assertEqual([rows[15][4], rows[5][4], rows[15][15]], [(102, 0, 0), GREEN, (0, 0, 0)])

    def test_other_formats(self):
        image = [[GREEN] * 4 + [BLUE] * 4] * 4 + [[RED] * 4 + [BLUE] * 4] * 4
        body = b"".join(bytes(colour) for row in image for colour in row)
        self.write("q.pnm", b"P6\n8 8\n255\n" + body)
        rows = self.rows("squares.obj", "--texture", "q.pnm")
        self.assertEqual([rows[18][1], rows[1][1], rows[15][18]], [RED, GREEN, BLUE])

    def test_inputs_without_coordinates(self):
        done = self.run_command("plain.obj", "squares.obj", "--texture", "q.png", "-o", "a.png", *FRONT)
        self.assertEqual((done.returncode, done.stderr.decode()),
                         (0, "lambent: warning: 'plain.obj': --texture does not cover it, because it "
                          "has no texture coordinates; add them to the file\n"))
        self.assertEqual(read_png(self.read("a.png"))[15][4], RED)
        self.succeed("plain.obj", "squares.obj", "--texture", "q.png", "-o", "a.png", "--quiet", *FRONT)
        line = self.fail_with(2, "plain.obj", "-o", "b.png", "--texture", "q.png")
        self.assertIn("--texture q.png: no input has faces with texture coordinates", line)

    def test_spheres_and_lines_have_no_texture(self):
        for other in ("--spheres 0.1", "--representation wireframe", "--representation points --point-size 9"):
            with self.subTest(other):
                done = self.run_command("squares.obj", "--texture", "q.png", *other.split(), "-o",
                                        "a.png", *FRONT)
                self.assertEqual((done.returncode, done.stderr.decode()),
                                 (0, "lambent: warning: --texture has no effect with %s; omit one of "
                                  "them\n" % other.replace(" 0.1", "").replace(" --point-size 9", "")))

    def test_broken_images_are_errors(self):
        self.write("short.png", QUADRANTS[:70])
        for name, status, part in (("short.png", 1, "cannot read 'short.png'"),
                                   ("none.png", 1, "cannot read 'none.png'"),
                                   ("q.tga", 2, "--texture"), ("", 2, "--texture")):
            with self.subTest(name):
                line = self.fail_with(status, "squares.obj", "-o", "b.png", "--texture", name)
                self.assertIn(part, line)

    def test_it_is_never_overwritten(self):
        line = self.fail_with(1, "squares.obj", "--texture", "q.png", "-o", "q.png")
        self.assertIn("cannot write 'q.png': it is the texture", line)
        self.assertEqual(self.read("q.png"), QUADRANTS)

    def test_it_is_recreated(self):
        self.rows("squares.obj", "--texture", "q.png")
        self.assertIn(" --texture q.png", texts(self.read("picture.png"))[COMMAND_KEY])
        self.succeed("--recreate", "picture.png")
        self.rows("squares.obj", "--color", "white")
        self.assertNotIn("--texture", texts(self.read("picture.png"))[COMMAND_KEY])

    def test_black_textures_are_no_mistake(self):
        self.write("black.pnm", b"P6\n1 1\n255\n\0\0\0")
        self.assertEqual(self.rows("squares.obj", "--texture", "black.pnm")[10][10], (0, 0, 0))


if __name__ == "__main__":
    unittest.main()
