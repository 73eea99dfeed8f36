#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the surfaces' property that have no effect cause a warning; others do not."""

import unittest

from commandline import CommandTest, SQUARE, obj, vtk_text

LINES = vtk_text(([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [])).replace("POLYGONS 0 0\n",
                                                                  "LINES 1 4\n3 0 1 2\n")
NO_LINES = ("--line-width has no effect, because no lines are drawn; add --edges or "
            "--representation wireframe, or omit it")
NO_POINTS = ("--point-size has no effect, because no points are drawn; add --representation points, "
             "or omit it")


def conflict(option, other):
    return "%s has no effect with %s; omit one of them" % (option, other)


class TestIdleOptions(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))
        self.write("lines.vtk", LINES)

    def warnings(self, *arguments):
        """The warnings, without their beginnings."""
        done = self.run_command(*arguments, "-o", "x.png", "--size", "16x16")
        lines = done.stderr.decode().splitlines()
        self.assertEqual(done.returncode, 0, lines)
        return [line.replace("lambent: warning: ", "") for line in lines]

    def test_options_without_effect(self):
        for arguments, *expected in (
                ("--spheres 0.5 --edges", conflict("--edges", "--spheres")),
                ("--spheres 0.5 --edge-color red", conflict("--edge-color", "--spheres")),
                ("--spheres 0.5 --representation points",
                 conflict("--representation points", "--spheres")),
                ("--spheres 0.5 --line-width 2", NO_LINES),
                ("--representation points --edges",
                 conflict("--edges", "--representation points")),
                ("--representation wireframe --edges",
                 conflict("--edges", "--representation wireframe")),
                ("--representation points --point-size 3 --line-width 2", NO_LINES),
                ("--representation wireframe --feature-angle 20",
                 conflict("--feature-angle", "--representation wireframe")),
                ("--line-width 2 --point-size 3", NO_LINES, NO_POINTS),
                ("--specular 1 --shading unlit", conflict("--specular", "--shading unlit")),
                ("--specular-power 9", "--specular-power has no effect without --specular; add "
                 "one, such as --specular 0.3")):
            with self.subTest(arguments):
                self.assertEqual(self.warnings("square.obj", *arguments.split()), expected)

    def test_options_with_an_effect(self):
        for arguments in ("--edges --edge-color red --line-width 2",
                          "--edge-color red --line-width 2", "--specular 1 --specular-power 9",
                          "--representation wireframe --line-width 2",
                          "--representation points --point-size 5", "--opacity 0.4"):
            with self.subTest(arguments):
                self.assertEqual(self.warnings("square.obj", *arguments.split()), [])
        self.assertEqual(self.warnings("lines.vtk", "--line-width", "3"), [])
        self.assertEqual(self.warnings("lines.vtk", "--line-width", "3", "--representation", "points"),
                         [NO_LINES])

    def test_lines_that_are_not_seen(self):
        nothing = "the picture shows nothing: "
        self.assertEqual(
            self.warnings("lines.vtk", "--camera-position", "0,0,5", "--focal-point", "0,0,9"),
            [nothing + "all lines and vertices lie behind the camera; try without "
             "--camera-position or --focal-point"])
        self.assertEqual(
            self.warnings("lines.vtk", "--focal-point", "50,0,0"),
            [nothing + "no line or vertex lies in the view of the camera; try without --focal-point"])

    def test_spheres_have_no_colours_of_cells(self):
        self.write("cells.vtk", vtk_text(SQUARE) +
                   "CELL_DATA 2\nSCALARS t float 1\nLOOKUP_TABLE default\n1 2\n")
        line = self.fail_with(1, "cells.vtk", "-o", "y.png", "--spheres", "0.1", "--color-by", "t")
        self.assertTrue(line.endswith("Choose a point array in --color-by, or omit --spheres"), line)


if __name__ == "__main__":
    unittest.main()
