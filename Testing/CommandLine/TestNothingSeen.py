# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture that shows nothing causes one line with the reason and a remedy. Other pictures do not."""

import unittest

from commandline import CommandTest, SQUARE, TETRAHEDRON, obj

TWO_SHEETS = (SQUARE[0] + [(x, y, 1) for x, y, _ in SQUARE[0]], SQUARE[1] + [(4, 5, 6), (4, 6, 7)])
TILTED = ([(0, 0, 0), (1, 0, 1), (1, 1, 1), (0, 1, 0)], [(0, 1, 2, 3)])  # its normal is 1,0,-1
IN_A_LINE = ([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)])
TUBE = ([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (0.5, 1))],
        [(0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)])
AT_Z = ("--direction", "0,0,1")
FAR_LAMP = "position=0,0,9;"

FLAT = "the faces are flat and seen edge-on; try --direction "
OUTSIDE = "no face lies in the view of the camera; try without "
COLOURS = ("the light has none of the colours that the faces reflect; try another --color, or "
           "another color in --light")
NO_COLOUR = "all visible faces are black; try another --color, --diffuse or --ambient"
BEHIND = "the lights shine along the faces or from behind them; try --headlight or --ambient 0.2"
INVISIBLE = "the surfaces are invisible; try a larger --opacity"
TRANSPARENT = "the surfaces are too transparent to show; try a larger --opacity"

# A mesh, options, and the line that follows "the picture shows nothing: ".
CASES = (
    # The camera.
    (SQUARE, ("--direction", "1,0,0"), FLAT + "0,0,1"),
    (SQUARE, ("--direction", "0,1,0", "--parallel-scale", "2"), FLAT + "0,0,1"),
    (SQUARE, ("--camera-position", "5,0,0"), FLAT + "0,0,1 instead of --camera-position"),
    (SQUARE, ("--camera-position", "50,0,0.01"), FLAT + "0,0,1 instead of --camera-position"),
    (TWO_SHEETS, ("--direction", "1,0,0", "--parallel-scale", "2"), FLAT + "0,0,1"),
    (TILTED, ("--direction", "1,0,1"), FLAT + "-0.71,0,0.71"),
    (TUBE, AT_Z + ("--parallel-scale", "2"), FLAT),
    (IN_A_LINE, (), "none of the faces has an area; their corners lie on a line or at a point"),
    (TETRAHEDRON, ("--camera-position", "0,0,5", "--focal-point", "0,0,9"),
     "all faces lie behind the camera; try without --camera-position or --focal-point"),
    (TETRAHEDRON, ("--focal-point", "50,0,0"), OUTSIDE + "--focal-point"),
    (SQUARE, AT_Z + ("--focal-point", "30,0,0", "--zoom", "2"), OUTSIDE + "--focal-point or --zoom"),
    (SQUARE, AT_Z + ("--parallel-scale", "1e6"), "the faces appear so small that they fall "
     "between the pixels; try a larger --zoom or --size"),
    (SQUARE, AT_Z + ("--parallel-scale", "3", "--representation", "points", "--point-size", "0.1"),
     "the points fall between the pixels; try a larger --point-size"),
    (TETRAHEDRON, ("--representation", "wireframe", "--line-width", "1e-6"),
     "the lines fall between the pixels; try a larger --line-width"),
    # The surface.
    (TETRAHEDRON, ("--color", "black"), NO_COLOUR),
    (TETRAHEDRON, ("--diffuse", "0"), NO_COLOUR),
    (TETRAHEDRON, ("--shading", "unlit", "--color", "black"), NO_COLOUR),
    (TETRAHEDRON, ("--background", "white", "--shading", "unlit"),
     "all visible faces have the colour of the background; try another --background"),
    (TETRAHEDRON, ("--opacity", "0"), INVISIBLE),
    (TETRAHEDRON, ("--opacity", "0", "--background", "white"), INVISIBLE),
    (TETRAHEDRON, ("--opacity", "1e-3"), TRANSPARENT),
    (TETRAHEDRON, ("--opacity", "1e-4", "--shading", "unlit"), TRANSPARENT),
    (SQUARE, AT_Z + ("--edges", "--line-width", "500"), "the edges hide the faces; try a larger "
     "--size, a smaller --line-width or another --edge-color"),
    (SQUARE, AT_Z + ("--diffuse", "0", "--specular", "1", "--light", "direction=0,0,1"), BEHIND),
    # The light.
    (SQUARE, AT_Z + ("--light", "direction=0,0,1"), BEHIND),
    (SQUARE, AT_Z + ("--light", "position=0,0,-3", "--light", "position=1,0,-3"), BEHIND),
    (SQUARE, AT_Z + ("--light", "direction=0,0,-1;intensity=0"),
     "the lights have no intensity or colour; try another --light, or --headlight"),
    (SQUARE, AT_Z + ("--light", "direction=0,0,-1;color=black"),
     "the lights have no intensity or colour; try another --light, or --headlight"),
    (SQUARE, AT_Z + ("--light", FAR_LAMP + "cone=10;focal=9,0,9"),
     "no visible face lies in the cone of a light; try a wider cone or another focal point in "
     "--light"),
    (SQUARE, AT_Z + ("--light", FAR_LAMP + "cone=10;focal=9,0,9", "--light", "direction=0,0,1"),
     "no visible face lies in the cone of a light; try a wider cone or another focal point in "
     "--light"),
    (SQUARE, AT_Z + ("--light", FAR_LAMP + "attenuation=0,0,1000"),
     "the lights are too far away for their attenuation; try a smaller one in --light"),
    (SQUARE, AT_Z + ("--light", FAR_LAMP + "intensity=1e-4"),
     "the light is too weak to show; try a larger intensity in --light"),
    (SQUARE, AT_Z + ("--color", "red", "--light", "direction=0,0,-1;color=blue"), COLOURS),
)


class TestNothingSeen(CommandTest):

    def said(self, mesh, *arguments):
        self.write("mesh.obj", obj(mesh))
        done = self.run_command("mesh.obj", "-o", "picture.png", "--size", "40x30", *arguments)
        self.assertEqual(done.returncode, 0)
        self.assertIn("picture.png", self.files())
        return done.stderr.decode()

    def test_the_reason_is_given_in_one_line(self):
        for mesh, arguments, reason in CASES:
            text = self.said(mesh, *arguments)
            self.assertTrue(text.startswith("lambent: warning: the picture shows nothing: " + reason),
                            (arguments, text))
            self.assertEqual(text.count("\n"), 1, text)
            if reason != FLAT:
                self.assertTrue(text.endswith(reason + "\n"), text)

    def test_the_advice_makes_surfaces_visible(self):
        for mesh, arguments, reason in CASES:
            if reason.startswith(FLAT) and "--camera-position" not in arguments:
                text = self.said(mesh, *arguments)
                direction = text[text.index("--direction ") + 12:].split()[0]
                at = arguments.index("--direction")
                self.assertEqual(self.said(mesh, *arguments[:at], *arguments[at + 2:],
                                           "--direction=" + direction), "", direction)

    def test_black_faces_on_another_background_are_reported(self):
        self.assertIn("the picture shows only black: " + NO_COLOUR,
                      self.said(TETRAHEDRON, "--background", "white", "--color", "black"))

    def test_sideways_normals_are_reported(self):
        normals = "".join("vn 1 0 0\n" for _ in range(4))
        faces = "f 1//1 2//2 3//3\nf 1//1 3//3 4//4\n"
        points = "".join("v %r %r %r\n" % p for p in SQUARE[0])
        self.write("mesh.obj", points + normals + faces)
        done = self.run_command("mesh.obj", "-o", "picture.png", "--size", "40x30", *AT_Z)
        self.assertEqual(done.stderr.decode(), "lambent: warning: the picture shows nothing: the "
                         "normals of the mesh are invalid or point away from the light; try --shading flat\n")

    def test_triangle_strips_are_considered(self):
        self.write("strip.vtk", "# vtk DataFile Version 3.0\nstrip\nASCII\nDATASET POLYDATA\n"
                   "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n")
        done = self.run_command("strip.vtk", "-o", "picture.png", "--size", "40x30", "--direction",
                                "1,0,0")
        self.assertIn(FLAT + "0,0,1\n", done.stderr.decode())

    def test_quiet_suppresses_the_warning(self):
        for mesh, arguments, _ in CASES:
            self.assertEqual(self.said(mesh, *arguments, "--quiet"), "", arguments)

    def test_visible_surfaces_cause_no_warning(self):
        for mesh, arguments in (
                (SQUARE, ()), (TETRAHEDRON, ()), (TWO_SHEETS, ()), (TUBE, ()), (TILTED, ()),
                (TETRAHEDRON, ("--background", "white")),
                (TETRAHEDRON, ("--background", "white", "--color", "#fffffe")),
                (SQUARE, AT_Z + ("--light", "direction=0,0,1", "--ambient", "0.01")),
                (SQUARE, AT_Z + ("--light", "direction=0,0,1", "--headlight"))):
            self.assertEqual(self.said(mesh, *arguments), "", arguments)

    def test_warnings_about_the_file_are_not_repeated(self):
        self.write("mesh.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                   "float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n")
        done = self.run_command("mesh.ply", "-o", "picture.png", "--size", "40x30")
        self.assertNotIn("the picture shows nothing", done.stderr.decode())

    def test_comparisons_and_recreated_pictures_cause_the_warning(self):
        self.said(SQUARE, "--direction", "1,0,0")
        for arguments in (("mesh.obj", "--direction", "1,0,0", "--compare", "picture.png"),
                          ("--recreate", "picture.png")):
            done = self.run_command(*arguments)
            self.assertEqual(done.returncode, 0)
            self.assertIn(FLAT + "0,0,1\n", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
