# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Passes: what --pass stores, in which files, and what it refuses."""

import math
import os
import resource
import subprocess
import unittest

from commandline import COMMAND, CommandTest, SQUARE, vtk_text, vtp, xml_array
from pictures import read_png, read_tiff, read_vti

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# A view along z in which the square covers the middle 4 x 4 of 8 x 8 pixels of side 0.5.
VIEW = ("--camera-position", "0,0,5", "--focal-point", "0,0,0", "--parallel-scale", "2", "--size",
        "8x8")
CENTRES = [-1.75 + 0.5 * k for k in range(8)]
NAN = float("nan")


def expected(see, miss):
    """The rows of a picture: see(x, y) on the square, and the tuple `miss` elsewhere."""
    return [[see(x, y) if max(abs(x), abs(y)) < 1 else miss for x in CENTRES]
            for y in reversed(CENTRES)]


def cell(x, y):
    return 0 if x >= y else 1  # both are hit where x = y; the smaller id wins


def with_data(point_arrays="", cell_arrays="", mesh=SQUARE):
    return vtp(mesh, point_data="<PointData>%s</PointData><CellData>%s</CellData>" % (
        point_arrays, cell_arrays))


class PassTest(CommandTest):

    def setUp(self):
        super().setUp()
        # x + 10 y at the points, 2 numbers per cell, and one name at both.
        points = [x + 10 * y for x, y, _ in SQUARE[0]]
        self.write("square.vtp", with_data(
            xml_array("plane", "Float32", points) + xml_array("both", "Float32", [1, 1, 1, 1]) +
            xml_array("doubles", "Float64", [0.1, 0.1, 0.1, 0.1]),
            xml_array("region", "Int32", [7, 16777216]) + xml_array("both", "Float32", [5, 6]) +
            xml_array("large", "Int32", [7, 16777217]) + xml_array("huge", "Float64", [1, 1e39]) +
            xml_array("pair", "Float32", [1, 2, 3, 4], 2) +
            xml_array("four", "Float32", [1, 2, 3, 4, 5, 6, 7, 8], 4)))

    def draw(self, *arguments):
        self.succeed("square.vtp", *VIEW, *arguments)

    def tiff(self, name):
        return read_tiff(self.read(name))

    def vti(self, name):
        return read_vti(self.read(name))

    def assert_rows(self, rows, wanted):
        """Equal to the bit, with NaN equal to NaN."""
        self.assertEqual(repr(rows), repr(wanted))

    def refuse(self, status, *arguments):
        return self.fail_with(status, "square.vtp", *VIEW, *arguments)


class TestFiles(PassTest):

    WANTED = {
        "depth": ("Depth", expected(lambda x, y: (5.0,), (NAN,))),
        "normals": ("Normals", expected(lambda x, y: (0.0, 0.0, 1.0), (NAN,) * 3)),
        "positions": ("Positions", expected(lambda x, y: (x, y, 0.0), (NAN,) * 3)),
        "ids": ("CellIds", expected(lambda x, y: (cell(x, y),), (-1,))),
        "input-ids": ("InputIds", expected(lambda x, y: (0,), (-1,))),
        "region": ("region", expected(lambda x, y: ((7.0, 16777216.0)[cell(x, y)],), (NAN,))),
        "plane": ("plane", expected(lambda x, y: (x + 10 * y,), (NAN,))),
        "cell:four": ("four", expected(
            lambda x, y: ((1.0, 2.0, 3.0, 4.0), (5.0, 6.0, 7.0, 8.0))[cell(x, y)], (NAN,) * 4)),
    }

    def test_tiff_and_vti_files_have_the_expected_values(self):
        for samples in ("1", "3"):
            passes = [("--pass", "%s=%s.tif" % (word, self.WANTED[word][0])) for word in self.WANTED]
            self.draw("-o", "x.png", "--supersampling", samples, *sum(passes, ()))
            for word, (name, wanted) in self.WANTED.items():
                as_floats = [[tuple(float(v) for v in pixel) for pixel in row] for row in wanted]
                self.assert_rows(self.tiff(name + ".tif"), as_floats)
                self.draw("-o", "x.png", "--supersampling", samples, "--pass", word + "=x.vti")
                arrays, scalars = self.vti("x.vti")
                self.assertEqual((list(arrays), scalars), ([name], name))
                self.assert_rows(arrays[name], wanted)

    def test_a_vti_picture_holds_exactly_the_requested_passes(self):
        words = list(self.WANTED)
        for asked in (words, ["depth"], ["ids"], ["input-ids"], ["plane", "ids"], []):
            self.draw("-o", "x.vti", *sum((("--pass", word) for word in asked), ()))
            arrays, scalars = self.vti("x.vti")
            self.assertEqual(scalars, "Color")
            self.assertEqual(set(arrays), {"Color", *(self.WANTED[word][0] for word in asked)})
            for word in asked:
                name, wanted = self.WANTED[word]
                self.assert_rows(arrays[name], wanted)

    def test_a_pass_may_be_in_a_file_and_in_the_picture(self):
        self.draw("-o", "x.vti", "--pass", "depth=d.TIF", "--pass", "ids")
        self.assertEqual(set(self.vti("x.vti")[0]), {"Color", "Depth", "CellIds"})
        self.assert_rows(self.tiff("d.TIF"), self.WANTED["depth"][1])

    def test_passes_do_not_change_the_picture(self):
        self.draw("-o", "x.png")
        self.draw("-o", "y.png", "--pass", "depth=d.tif", "--pass", "plane=p.tif")
        self.assertEqual(self.read("x.png"), self.read("y.png"))  # nor its recorded command
        self.draw("-o", "-", "--pass", "depth=d.vti")

    def test_doubles_are_rounded_only_in_tiff_files(self):
        self.draw("-o", "x.vti", "--pass", "doubles=d.tif")
        self.assertEqual(self.tiff("d.tif")[4][4], (0.10000000149011612,))
        self.assertEqual(self.vti("x.vti")[0]["doubles"][4][4], (0.1,))

    def test_pictures_with_several_strips_are_written(self):
        """Several strips, the last of which is shorter."""
        self.draw("-o", "x.vti", "--size", "300x301", "--pass", "positions=p.tif", "--pass",
                  "depth=d.tif")
        arrays, _ = self.vti("x.vti")
        self.assert_rows(self.tiff("d.tif"), arrays["Depth"])
        self.assertEqual(len(self.tiff("p.tif")), 301)


class TestInputs(PassTest):

    def test_a_prefix_selects_between_point_and_cell_arrays(self):
        self.draw("-o", "x.png", "--pass", "point:both=p.tif")
        self.draw("-o", "x.png", "--pass", "cell:both=c.tif")
        self.assert_rows(self.tiff("p.tif"), expected(lambda x, y: (1.0,), (NAN,)))
        self.assert_rows(self.tiff("c.tif"), expected(lambda x, y: ((5.0, 6.0)[cell(x, y)],), (NAN,)))
        line = self.refuse(1, "-o", "y.png", "--pass", "both=b.tif")
        self.assertIn("--pass both: the inputs have a point array and a cell array of that name; "
                      "write point:both or cell:both", line)

    def test_missing_arrays_are_errors_that_list_the_arrays(self):
        for word in ("none", "cell:plane", "point:region", "Plane"):
            self.assertIn("--pass %s: no input has such an array; the arrays are: point:both, "
                          "point:doubles, point:plane, cell:both, cell:four, cell:huge, cell:large, "
                          "cell:pair, cell:region" % word,
                          self.refuse(1, "-o", "y.png", "--pass", word + "=b.tif"))
        self.write("bare.vtp", vtp(SQUARE))
        self.assertIn("the arrays are: none; other passes are: depth, normals, positions, ids, input-ids",
                      self.fail_with(1, "bare.vtp", "-o", "y.png", "--pass", "plane=b.tif"))

    def test_inputs_without_the_array_are_nan(self):
        points, faces = SQUARE
        beside = [(x + 2, y, z) for x, y, z in points]
        self.write("beside.vtp", vtp((beside, faces)))
        self.succeed("beside.vtp", "square.vtp", *VIEW, "-o", "x.png", "--pass", "plane=p.tif",
                     "--pass", "input-ids=i.tif")
        row = self.tiff("p.tif")[4]
        self.assertEqual(row[2:6], [(x - 2.5,) for x in CENTRES[2:6]])
        self.assertTrue(math.isnan(row[7][0]))
        self.assertEqual(self.tiff("i.tif")[4], [(v,) for v in (-1, -1, 1, 1, 1, 1, 0, 0)])

    def test_all_arrays_of_legacy_files_are_read(self):
        points = [x for x, _, _ in SQUARE[0]]
        self.write("square.vtk", vtk_text(SQUARE) + "CELL_DATA 2\nSCALARS a float 1\n"
                   "LOOKUP_TABLE default\n1 2\nSCALARS b float 1\nLOOKUP_TABLE default\n3 4\n"
                   "POINT_DATA 4\nVECTORS v float\n" + "0 0 1 " * 4 + "\nVECTORS w float\n" +
                   "".join("%r 0 2 " % x for x in points) + "\n")
        self.succeed("square.vtk", *VIEW, "-o", "x.png", "--pass", "b=b.tif", "--pass", "w=w.tif")
        self.assert_rows(self.tiff("b.tif"), expected(lambda x, y: (3.0 + cell(x, y),), (NAN,)))
        self.assert_rows(self.tiff("w.tif"), expected(lambda x, y: (x, 0.0, 2.0), (NAN,) * 3))

    def test_inputs_with_different_components_are_errors(self):
        self.write("other.vtp", with_data("", xml_array("region", "Float32", [1, 2, 3, 4], 2)))
        line = self.fail_with(1, "square.vtp", "other.vtp", "-o", "x.png", "--pass", "region=r.vti")
        self.assertIn("components", line)

    def test_contours_keep_the_other_point_arrays(self):
        image = ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_POINTS\n"
                 "DIMENSIONS 3 3 3\nORIGIN -1 -1 -1\nSPACING 1 1 1\nPOINT_DATA 27\n"
                 "SCALARS height float 1\nLOOKUP_TABLE default\n" + "0 " * 9 + "1 " * 9 + "2 " * 9 +
                 "\nSCALARS x float 1\nLOOKUP_TABLE default\n" + "-1 0 1 " * 9 + "\n")
        self.write("image.vtk", image)
        self.succeed("image.vtk", *VIEW, "--contour", "1,height", "-o", "x.png", "--pass", "x=x.tif",
                     "--pass", "depth=d.tif")
        self.assertEqual(self.tiff("x.tif")[4][2:6], [(x,) for x in CENTRES[2:6]])
        self.assertEqual(self.tiff("d.tif")[4][2:6], [(5.0,)] * 4)


class TestRefusing(PassTest):

    def test_invalid_passes_are_refused(self):
        for value, words in (
                ("depth", "needs a file, such as depth=FILE.tif"), ("", "needs a name"),
                ("d.tif", "'d.tif' is only a file; name the pass to store in it, such as depth=d.tif"),
                ("=x.tif", "needs a name"), ("point:=x.tif", "needs a name"),
                ("depth=", "does not end in .tif, .tiff or .vti"), ("depth=x.png", "'x.png' does not"),
                ("depth=-", "'-' does not end in"),
                ("Normals=x.tif", "an array that the picture itself has"),
                ("cell:Color=x.tif", "to store an input's array of that name, rename it")):
            line = self.refuse(2, "-o", "x.png", "--pass", value)
            self.assertIn("--pass: ", line)
            self.assertIn(words, line)
        for first, second in (("depth", "depth"), ("plane", "point:plane"), ("point:b", "cell:b")):
            self.assertIn("is requested twice", self.refuse(
                2, "-o", "x.png", "--pass", first + "=1.tif", "--pass", second + "=2.tif"))

    def test_values_that_floats_cannot_hold_are_refused(self):
        for word, words in (
                ("large", "the value 16777217 would be rounded to the 32-bit floats of a .tif"),
                ("huge", "is beyond the range of the 32-bit floats of a .tif"),
                ("pair", "holds 1, 3 or 4 numbers per pixel, and this array has 2")):
            done = self.run_command("square.vtp", *VIEW, "-o", "y.png", "--pass", word + "=x.tif")
            self.assertEqual(done.returncode, 1)
            line, = done.stderr.decode().splitlines()
            self.assertIn("--pass %s: " % word, line)
            self.assertIn(words, line)
            self.assertIn("choose a name that ends in .vti", line)
            self.assertFalse(os.path.exists(self.path("x.tif")))
            self.draw("-o", "y.png", "--pass", word + "=x.vti")
        self.assertEqual(self.vti("x.vti")[0]["pair"][3][2], (3.0, 4.0))

    def test_no_file_is_written_twice_or_over_an_input(self):
        os.link(self.path("square.vtp"), self.path("link.tif"))
        os.symlink("new.tif", self.path("new link.tif"))
        for arguments, words in (
                (("-o", "x.tif", "--pass", "depth=./x.tif"), "it is the output, 'x.tif'"),
                (("-o", "x.png", "--pass", "depth=d.tif", "--pass", "ids=./d.tif"),
                 "cannot write './d.tif': it is the pass depth, 'd.tif'"),
                (("-o", "new.tif", "--pass", "depth=new link.tif"), "it is the output"),
                (("-o", "x.png", "--pass", "depth=link.tif"), "it is an input, 'square.vtp'"),
                (("--compare", "b.vti", "--pass", "depth=b.vti"), "it is the baseline"),
                (("--compare", "b.vti", "--pass", "depth=d.tif", "--difference", "d.tif"),
                 "it is the pass depth")):
            self.assertIn(words, self.refuse(1, *arguments))

    def test_missing_folders_are_errors_before_anything_is_written(self):
        line = self.refuse(1, "-o", "x.png", "--pass", "depth=nowhere/d.tif")
        self.assertIn("cannot write 'nowhere/d.tif': there is no folder 'nowhere'", line)

    @unittest.skipIf("TSAN_OPTIONS" in os.environ, "the thread sanitizer writes its own files")
    def test_a_full_disk_leaves_the_old_file(self):
        self.write("d.tif", "old")
        done = self.run_command("square.vtp", *VIEW, "-o", "-", "--pass", "depth=d.tif",
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                                      (100, 100)))
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"--pass depth: cannot write 'd.tif': ", done.stderr)
        self.assertEqual(self.read("d.tif"), b"old")


class TestTogether(PassTest):

    def test_a_recreated_picture_can_have_passes(self):
        self.draw("-o", "x.png")
        self.assertIn(b"all of 64 pixels are the same",
                      self.succeed("--recreate", "x.png", "--pass", "depth=d.tif"))
        self.assert_rows(self.tiff("d.tif"), TestFiles.WANTED["depth"][1])
        self.succeed("--recreate", "x.png", "-o", "x.vti", "--pass", "plane")
        self.assertIn("plane", self.vti("x.vti")[0])
        self.assertIn("needs a file", self.fail_with(2, "--recreate", "x.png", "--pass", "depth"))

    def test_a_comparison_can_have_passes(self):
        self.draw("-o", "base.png")
        output = self.succeed("square.vtp", *VIEW, "--compare", "base.png", "--pass", "ids=i.tif",
                              "--pass", "depth=d.vti")
        self.assertIn(b"all of 64 pixels are the same", output)
        self.assert_rows(self.vti("d.vti")[0]["Depth"], TestFiles.WANTED["depth"][1])
        self.succeed("square.vtp", *VIEW, "--compare", "base.png", "-o", "x.vti", "--pass", "depth")
        self.assertEqual(set(self.vti("x.vti")[0]), {"Color", "Depth"})  # not the comparison's ids

    def test_passes_can_be_compared(self):
        self.draw("-o", "x.png", "--pass", "depth=a.vti")
        self.draw("-o", "x.png", "--pass", "depth=b.vti")
        self.assertIn(b"all of 64 pixels are the same", self.succeed("compare", "a.vti", "b.vti"))

    def test_verbose_lists_the_files_of_passes(self):
        done = self.run_command("square.vtp", *VIEW, "-o", "x.png", "--pass", "depth=d.tif",
                                "--verbose")
        self.assertIn("\npass       depth in %s\n" % os.path.realpath(self.path("d.tif")),
                      done.stderr.decode())
        self.succeed("square.vtp", *VIEW, "-o", "x.png", "--pass", "depth=d.tif", "--quiet")


class TestExample(CommandTest):

    def test_the_commands_of_the_readme_work(self):
        """Examples/CommandLine/passes.sh, which Rendering/CommandLine/README.md quotes."""
        os.symlink(os.path.join(ROOT, "Data"), self.path("Data"))
        os.mkdir(self.path("bin"))
        os.symlink(COMMAND, self.path("bin/lambent"))
        subprocess.run(["sh", "-e", os.path.join(ROOT, "Examples/CommandLine/passes.sh")], check=True,
                       cwd=self.folder,
                       env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        depth = read_tiff(self.read("depth.tif"))
        cells = read_tiff(self.read("cells.tif"))
        alpha = [pixel[3] for row in read_png(self.read("seashell.png")) for pixel in row]
        normals, _ = read_vti(self.read("normals.vti"))
        picture, _ = read_vti(self.read("seashell.vti"))
        self.assertEqual(set(picture), {"Color", "Depth", "Positions"})
        self.assertEqual(repr(picture["Depth"]), repr(depth))
        self.assertEqual((len(depth), len(depth[0])), (270, 480))
        hits = 0
        for (z,), (cell,), normal, a in zip(*[sum(rows, []) for rows in (
                depth, cells, normals["Normals"])], alpha):
            self.assertEqual(math.isnan(z), cell < 0)
            if cell >= 0:
                hits += 1
                self.assertGreater(a, 0)
                self.assertAlmostEqual(sum(v * v for v in normal), 1, 5)
        self.assertGreater(hits, 10000)


if __name__ == "__main__":
    unittest.main()
