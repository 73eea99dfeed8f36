# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures with an alpha channel: each kind of file holds the same pixels, and edges keep their
colour."""

import os
import struct
import unittest

from commandline import CommandTest, SQUARE, TETRAHEDRON, obj
from pictures import read_png, read_tiff, read_vti

SIZE = ("--size", "40x30")


class TestAlpha(CommandTest):

    def setUp(self):
        super().setUp()
        self.environment = {key: value for key, value in os.environ.items()
                            if key not in ("LAMBENT_UPDATE_BASELINES", "DASHBOARD_TEST_FROM_CTEST",
                                           "CTEST_INTERACTIVE_DEBUG_MODE")}
        self.write("mesh.obj", obj(TETRAHEDRON))

    def draw(self, name, *arguments):
        return self.succeed("mesh.obj", "-o", name, *SIZE, "--alpha", *arguments)

    def test_every_format_has_the_same_pixels(self):
        self.draw("x.png")
        rows = read_png(self.read("x.png"))
        self.assertEqual((len(rows), len(rows[0]), len(rows[0][0])), (30, 40, 4))
        alphas = {pixel[3] for row in rows for pixel in row}
        self.assertEqual(alphas & {0, 255}, {0, 255})
        self.assertLessEqual(alphas, {255 * k // 9 + (255 * k % 9 > 4) for k in range(10)})
        self.assertGreater(len(alphas), 5)
        for name in ("x.tif", "X.TIFF"):
            self.draw(name)
            self.assertEqual(read_tiff(self.read(name)), rows)
        self.draw("x.vti")
        self.assertEqual(read_vti(self.read("x.vti")), ({"Color": rows}, "Color"))
        self.assertEqual(self.draw("-"), self.read("x.png"))

    def test_edges_keep_their_colour(self):
        """Composited over black, the picture equals the one without alpha, up to rounding, and no
        pixel is darker than the surfaces."""
        self.draw("x.png", "--shading", "unlit", "--color", "0.8,0.6,0.4")
        self.succeed("mesh.obj", "-o", "y.png", *SIZE, "--shading", "unlit", "--color", "0.8,0.6,0.4")
        for row, on_black in zip(read_png(self.read("x.png")), read_png(self.read("y.png"))):
            for pixel, other in zip(row, on_black):
                self.assertEqual(pixel[:3], (204, 153, 102) if pixel[3] else (0, 0, 0))
                for value, seen in zip(pixel[:3], other):
                    self.assertLess(abs(value * pixel[3] / 255 - seen), 1)

    def test_alpha_of_one_sample_is_0_or_255(self):
        self.draw("x.png", "--supersampling", "1")
        self.assertEqual({pixel[3] for row in read_png(self.read("x.png")) for pixel in row}, {0, 255})

    def test_formats_without_alpha_are_refused(self):
        for name in ("x.jpg", "x.jpeg", "x.bmp", "x.pnm", "x.ppm"):
            line = self.fail_with(2, "mesh.obj", "-o", name, "--alpha")
            self.assertIn("--alpha: '%s' cannot hold alpha; choose a name that ends in .png, .tif or "
                          ".vti" % name, line)

    def test_backgrounds_are_refused(self):
        self.write("b.png", self.draw("-"))
        for option, value in (("--background", "red"), ("--background-image", "b.png")):
            line = self.fail_with(2, "mesh.obj", "-o", "x.png", "--alpha", option, value)
            self.assertIn("--alpha", line)
            self.assertIn(option + " ", line)

    def test_recreated_pictures_have_alpha(self):
        self.draw("x.png", "--color", "tomato")
        drawn = self.read("x.png")
        self.assertIn(b"lambent mesh.obj --alpha --direction 2,1.5,4 --color tomato --size", drawn)
        self.assertIn(b"all of 1200 pixels are the same", self.succeed("--recreate", "x.png"))
        self.succeed("--recreate", "x.png", "-o", "y.png")
        self.assertEqual(self.read("y.png"), drawn)
        self.assertIn("'x.jpg' cannot hold alpha", self.fail_with(1, "--recreate", "x.png", "-o",
                                                                  "x.jpg"))

    def compare(self, status, *arguments, **environment):
        done = self.run_command("mesh.obj", "--compare", "base.png", *arguments,
                                env={**self.environment, **environment})
        self.assertEqual((done.returncode, done.stderr), (status, b""), done.stdout)
        return done.stdout.decode()

    def test_pictures_with_alpha_can_be_compared(self):
        self.draw("base.png")
        self.assertIn("all of 1200 pixels are the same", self.compare(0, "--alpha"))
        self.assertIn("3 components of unsigned char, but the baseline is 40 x 30, 4 components",
                      self.compare(1))
        line = self.compare(1, "--alpha", "--zoom", "1.1", "--difference", "d.png", "--report", "r.html")
        self.assertIn("pixels differ", line)
        self.assertGreater(max(max(pixel) for row in read_png(self.read("d.png")) for pixel in row), 0)
        self.compare(0, "--alpha", "--zoom", "1.1", LAMBENT_UPDATE_BASELINES="1")
        self.compare(0, "--alpha", "--zoom", "1.1")
        self.assertIn(b"--alpha", self.read("base.png"))

    def test_differences_in_alpha_are_found(self):
        """The surface is black, so only alpha differs."""
        def draw(name, size):
            points = [(x * size, y * size, z) for x, y, z in SQUARE[0]]
            self.write("mesh.obj", obj((points, SQUARE[1])))
            self.draw(name, "--shading", "unlit", "--color", "black", "--camera-position", "0,0,5",
                      "--focal-point", "0,0,0", "--quiet")
        draw("base.png", 1)
        draw("same.png", 1)
        draw("other.png", 0.9)
        for name, status in (("same.png", 0), ("other.png", 1)):
            done = self.run_command("compare", name, "base.png", env=self.environment)
            self.assertEqual(done.returncode, status, done.stdout)

    def test_a_warning_explains_invisible_or_black_surfaces(self):
        for arguments, reason in (
                (("--camera-position", "0,0,9", "--focal-point", "0,0,20"),
                 "the picture shows nothing: "),
                (("--color", "black"), "the surfaces show only black: all visible faces are black")):
            for samples in ("1", "3"):
                done = self.run_command("mesh.obj", "-o", "x.png", *SIZE, "--alpha", *arguments,
                                        "--supersampling", samples)
                self.assertEqual(done.returncode, 0)
                line, = done.stderr.decode().splitlines()
                self.assertIn("lambent: warning: " + reason, line)
                self.draw("x.png", *arguments, "--quiet")

    def test_tiff_files_have_the_right_size_and_orientation(self):
        """The picture has several strips and is not symmetric to a horizontal axis."""
        self.write("mesh.obj", obj(([(0, 0, 0), (2, 0, 0), (0, 1, 0)], [(0, 1, 2)])))
        view = ("--direction", "0,0,1", "--size", "200x151")
        self.succeed("mesh.obj", "-o", "x.tif", "--alpha", *view)
        self.succeed("mesh.obj", "-o", "x.png", "--alpha", *view)
        rows = read_tiff(self.read("x.tif"))
        self.assertEqual(rows, read_png(self.read("x.png")))
        self.assertLess(sum(pixel[3] for pixel in rows[60]), sum(pixel[3] for pixel in rows[90]))
        self.assertGreater(len(self.read("x.tif")), 65536)
        self.assertEqual(struct.unpack("<H", self.read("x.tif")[2:4]), (42,))


if __name__ == "__main__":
    unittest.main()
