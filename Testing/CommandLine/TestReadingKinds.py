# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""OBJ, PLY and STL files as other programs write them: the command gives the right picture, or one correct
line. TestReadObj.cxx, TestObjNormals.cxx, TestReadPly.cxx and TestReadStl.cxx have the details."""

import unittest

import commandline as make
from commandline import CommandTest, SQUARE, TETRAHEDRON

VIEW = ("--direction", "1,2,3", "--size", "64x48")
BLACK, WHITE = (0, 0, 0), (255, 255, 255)

# The corners (0, 0), (1, 0), (0, 1), (1, 1) in the plane z = 0, as OBJ text.
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
FACE_ON = ("--camera-position", "0.5,0.5,9", "--focal-point", "0.5,0.5,0", "--parallel-scale", "0.5")

PLY_CORNERS = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\n%send_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
PLY_FACES = "element face %d\nproperty list uchar int vertex_indices\n"
PLY_STRIPS = "element tristrips 1\nproperty list int int vertex_indices\n"

# The two sides of a roof, at a right angle.
ROOF = "v 0 0 0\nv 1 0 0\nv 0 1 -1\nv 1 1 -1\nv 0 -1 -1\nv 1 -1 -1\n"


class TestReadingKinds(CommandTest):

    def picture(self, name, content, *arguments):
        self.write(name, content)
        self.succeed(name, *(arguments or VIEW), "-o", "picture.pnm")
        return self.read("picture.pnm")

    def warnings(self, name, content, *arguments):
        self.write(name, content)
        done = self.run_command(name, *arguments, "-o", "picture.pnm", "--size", "9x9")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr.decode().splitlines()

    def failure(self, name, content):
        self.write(name, content)
        line = self.fail_with(1, name, "-o", "x.png")
        start = "lambent: cannot read '%s': " % name
        self.assertEqual(line[:len(start)], start)
        return line[len(start):]

    def test_all_kinds_of_faces_are_read(self):
        plain = "f 1 2 3\nf 2 4 3\n"
        contents = {
            "plain.obj": CORNERS + plain,
            "material.obj": CORNERS + "usemtl \n" + plain,
            "mixed.obj": CORNERS + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 2 4 3\n",
            "within.obj": CORNERS + "vt 0 0\nvn 0 0 1\nf 1 2//1 3/1/1\nf 2/1 4// 3/1/\n",
            "slash.obj": CORNERS + "vt 0 0\nf 1/1/ 2/1/ 3/1/\nf 2/1/ 4/1/ 3/1/\n",
            "end.obj": (CORNERS + plain)[:-1],
            "mac.obj": (CORNERS + plain).replace("\n", "\r").encode(),
            "back.obj": CORNERS + "f -4 -3 -2 # first\nf -3 \\\n-1 -2 # second\n",
            "mark.obj": b"\xef\xbb\xbf" + (CORNERS + plain).encode(),
            "groups.obj": CORNERS + "g a\ns 1\nf 1 2 3\no b\ns off\nf 2 4 3\n",
            "colours.obj": CORNERS.replace("\n", " 1 0.5 0\n") + plain,
            "empty.ply": PLY_CORNERS % (PLY_FACES % 3) + "0\n3 0 1 2\n3 1 3 2\n",
            "mac.ply": (PLY_CORNERS % (PLY_FACES % 2) + "3 0 1 2\n3 1 3 2\n").replace(
                "\n", "\r").encode(),
            "strips.ply": PLY_CORNERS % PLY_STRIPS + "4 0 1 2 3\n",
            "runs.ply": PLY_CORNERS % PLY_STRIPS + "8 0 1 2 -1 1 3 2 -1\n",
            "both.ply": PLY_CORNERS % (PLY_FACES % 1 + PLY_STRIPS) + "3 0 1 2\n3 1 3 2\n",
            "capitals.stl": make.stl_text(
                ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 1, 2), (1, 3, 2)])).upper(),
            "name.stl": make.stl_text(
                ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)],
                 [(0, 1, 2), (1, 3, 2)])).replace("test", "Würfel").encode(),
        }
        for name, content in contents.items():
            with self.subTest(name):
                self.write(name, content)
                for shading in ("smooth", "flat"):
                    rows = self.pixels(name, *FACE_ON, "--shading", shading, "--color", "white")
                    self.assertEqual(rows, [[WHITE] * 9] * 9)

    def test_smoothing_groups_become_normals(self):
        # s 1 across the ridge has the effect of the same normals as vn; without either the picture differs.
        faces = "f 1 2 4 3\nf 2 1 5 6\n"
        view = ("--direction", "0.3,0,1", "--size", "32x32", "--light", "direction=0,-1,-1")
        smooth = self.picture("s.obj", ROOF + "s 1\n" + faces, *view)
        half = repr(0.5 ** 0.5)
        normals = "vn 0 0 1\nvn 0 %s %s\nvn 0 -%s %s\n" % (half, half, half, half)
        self.assertEqual(smooth, self.picture(
            "n.obj", ROOF + normals + "f 1//1 2//1 4//2 3//2\nf 2//1 1//1 5//3 6//3\n", *view))
        flat = self.picture("off.obj", ROOF + "s off\n" + faces, *view)
        self.assertEqual(flat, self.picture("s12.obj", ROOF + "s 1\nf 1 2 4 3\ns 2\nf 2 1 5 6\n",
                                            *view))
        self.assertEqual(flat, self.picture("flat.obj", ROOF + faces, *view, "--shading", "flat"))
        self.assertNotEqual(smooth, flat)

    def test_points_with_several_normals_leave_no_crack(self):
        # Each corner has its own normal, but all are the same, so no pixel differs.
        points, faces = TETRAHEDRON
        text = make.obj((points, [])) + "".join("vn 0 0 1\n" for _ in range(12))
        own = text + "".join("f %s\n" % " ".join("%d//%d" % (i + 1, 3 * k + c + 1)
                                                 for c, i in enumerate(face))
                             for k, face in enumerate(faces))
        one = text + "".join("f %s\n" % " ".join("%d//1" % (i + 1) for i in face)
                             for face in faces)
        self.assertEqual(self.picture("own.obj", own), self.picture("one.obj", one))

    def test_coordinates_in_text_are_doubles(self):
        # 1e7 and beside it a triangle of size 1e-3: as floats all its points would coincide.
        points = [(1e7, 1e7, 0.0), (1e7 + 1e-3, 1e7, 0.0), (1e7, 1e7 + 1e-3, 0.0)]
        view = ("--camera-position", "10000000.00025,10000000.00025,1", "--focal-point",
                "10000000.00025,10000000.00025,0", "--parallel-scale", "0.0001")
        for name, writer in (("far.obj", make.obj), ("far.stl", make.stl_text)):
            self.write(name, writer((points, [(0, 1, 2)])))
            self.assertEqual(self.pixels(name, *view), [[WHITE] * 9] * 9)

    def test_invalid_indices_are_refused(self):
        end = "; correct the line, or use a complete copy"
        for text, line in (
                ("f 1//1 2//1 3//1\n", "line 5 uses normal 1, but the file has no normals (vn)"),
                ("vn 0 0 1\nf 1//1 2//9 3//40\n",
                 "line 6 uses normal 9, but the file has 1 normal (vn)"),
                ("f 1/1 2/2 3/3\n", "line 5 uses texture coordinate 1, but the file has no texture "
                                    "coordinates (vt)"),
                ("f 1 2 5\n", "line 5 uses point 5, but the file has 4 points (v)"),
                ("f 0 1 2\n", "line 5 uses point 0, but indices start at 1; so far the file has "
                              "4 points (v)"),
                ("f 1 2 -5\n", "line 5 uses point -5, but before that line it has 4 points (v)")):
            self.assertEqual(self.failure("wrong.obj", CORNERS + text), line + end)

    def test_invalid_numbers_are_refused(self):
        self.assertEqual(self.failure("wrong.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"),
                         "line 2: 'nan' is not a finite number")
        text = make.stl_text(TETRAHEDRON)
        self.assertEqual(self.failure("wrong.stl", text.replace("vertex 2", "vertex two", 1)),
                         "line 6: found 'two' where a number is expected")
        self.assertEqual(self.failure("cut.stl", text[:text.rindex("vertex")]),
                         "line 27: it is incomplete: it ends where 'vertex' is expected")

    def test_skipped_elements_are_counted(self):
        lines = self.warnings("few.obj", CORNERS + "f 1 2\nf 1 2 3\nf 3\n")
        self.assertEqual(lines, ["lambent: warning: 'few.obj': faces (f) of fewer than 3 points and "
                                 "lines (l) of fewer than 2 are skipped; it has 2 of them"])
        faces = PLY_CORNERS % (PLY_FACES % 2)
        lines = self.warnings("more.ply", faces + "3 0 1 2 255 0 0\n3 1 3 2 255 0 0\n")
        self.assertEqual(lines, ["lambent: warning: 'more.ply': numbers left over on a line are "
                                 "ignored, since each element has its own line; it has 6 of them, "
                                 "the first in line 14"])
        self.assertEqual(self.read("picture.pnm"), self.picture(
            "whole.ply", faces + "3 0 1 2\n3 1 3 2\n", "--size", "9x9"))
        lines = self.warnings("rest.ply", faces + "3 0 1 2\n3 1 3 2\n3 0 1 3\n")
        self.assertEqual(lines, ["lambent: warning: 'rest.ply': ignored 8 bytes after the last "
                                 "element that its header declares"])

    def test_a_missing_last_line_end_causes_no_warning(self):
        for name, content in (("end.obj", make.obj(SQUARE)), ("end.ply", make.ply_text(SQUARE)),
                              ("end.stl", make.stl_text(SQUARE))):
            self.assertEqual(self.warnings(name, content[:-1]), [])

    def test_files_without_polygons_and_lines_cause_a_warning(self):
        last = ", and no polygons, lines or vertices, which are what is drawn"
        for name, content, holds in (
                ("points.obj", CORNERS, "4 points"),
                ("point.ply", make.ply_text(([(0, 0, 0)], [])), "1 point"),
                ("thin.ply", make.ply_text((SQUARE[0], [(0, 1), ()])),
                 "4 points and 2 cells of fewer than 3 points"),
                ("grid.vtk", make.vtk_grid(SQUARE[0], [], 3), "4 points"),
                ("grid.vtu", make.vtu(SQUARE[0], [], 3), "4 points")):
            lines = self.warnings(name, content, "--background", "1,0,0")
            self.assertEqual(lines[:1],
                             ["lambent: warning: '%s': it holds %s" % (name, holds) + last])
            rows = make.read_pnm(self.read("picture.pnm"))
            self.assertEqual(rows, [[(255, 0, 0)] * 9] * 9)

    def test_lines_are_drawn(self):
        for name, content in (
                ("lines.obj", CORNERS + "l 1 2\nl 1 3 4\nl 2 4\n"),
                ("line.obj", CORNERS + "l 1 2\np 1 2\n"),
                ("lines.vtu", make.vtu(SQUARE[0], [(0, 1), (2, 3)], 3)),
                ("both.vtk", make.vtk_text((SQUARE[0], [(0, 1)])) + "LINES 1 3\n2 0 2\n"),
                ("lines.vtk", make.vtk_text((SQUARE[0], [(0, 1), (2, 3)])).replace(
                    "POLYGONS", "LINES"))):
            with self.subTest(name):
                self.assertEqual(self.warnings(name, content, "--background", "1,0,0"), [])
                rows = make.read_pnm(self.read("picture.pnm"))
                self.assertNotEqual(rows, [[(255, 0, 0)] * 9] * 9)

    def test_triangles_are_counted(self):
        for name, content, count in (
                ("empty.ply", PLY_CORNERS % (PLY_FACES % 4) + "0\n4 0 1 3 2\n1 0\n2 0 1\n", 2),
                ("strips.ply", PLY_CORNERS % PLY_STRIPS + "7 0 1 2 3 -1 0 1\n", 2),
                ("square.obj", CORNERS + "f 1 2 4 3\nf 1 2\nl 1 2\n", 2)):
            self.write(name, content)
            done = self.run_command(name, "-o", "x.pnm", "--size", "9x9", "--verbose")
            self.assertIn(b"triangles  %d\n" % count, done.stderr)


if __name__ == "__main__":
    unittest.main()
