# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Comparing pictures: messages, exit status, and the files that are written."""

import base64
import os
import re
import struct
import subprocess
import unittest
import zlib

from commandline import COMMAND, CommandTest, SQUARE, TETRAHEDRON, obj, xml_array


def png_file(width, height, compressed, depth=8):
    """A PNG file with this header and these pixels, and correct check sums."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">2I5B", width, height, depth, 2, 0, 0, 0)) +
            chunk(b"IDAT", compressed) + chunk(b"IEND", b""))


def png(rows, depth=8):
    """A PNG file with rows of (r, g, b), of 8 or 16 bits, the top row first."""
    kind = ">%dB" if depth == 8 else ">%dH"
    body = b"".join(b"\0" + struct.pack(kind % (3 * len(row)), *[v for pixel in row for v in pixel])
                    for row in rows)
    return png_file(len(rows[0]), len(rows), zlib.compress(body), depth)


def vti(pixels):
    """A VTK image of floats with one row of (r, g, b). Without any, it has no scalars."""
    extent = "0 %d 0 0 0 0" % (max(len(pixels), 1) - 1)
    scalars = xml_array("Color", "Float32", [v for pixel in pixels for v in pixel], 3)
    return ('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
            '<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="%s">' %
            (extent, extent) +
            ('<PointData Scalars="Color">%s</PointData>' % scalars if pixels else "") +
            "</Piece></ImageData></VTKFile>\n")


def grey(width, height, changes=()):
    """All channels are 100, except for {(x, y): (r, g, b)}, with y from the bottom."""
    changes = dict(changes)
    return png([[changes.get((x, y), (100, 100, 100)) for x in range(width)]
                for y in reversed(range(height))])


class CompareTest(CommandTest):

    def setUp(self):
        super().setUp()
        self.environment = {key: value for key, value in os.environ.items()
                            if key not in ("LAMBENT_UPDATE_BASELINES", "DASHBOARD_TEST_FROM_CTEST",
                                           "CTEST_INTERACTIVE_DEBUG_MODE")}
        self.write("base.png", grey(7, 5))
        self.write("same.png", grey(7, 5))
        self.write("other.png", grey(7, 5, {(5, 1): (103, 100, 96), (2, 3): (100, 90, 100)}))

    def compare(self, status, *arguments, **environment):
        """Expects this exit status and these lines on standard output."""
        done = self.run_command(*arguments, env={**self.environment, **environment})
        self.assertEqual((done.returncode, done.stderr), (status, b""), done.stdout)
        return done.stdout.decode().splitlines()

    def fail_with(self, status, *arguments):
        return super().fail_with(status, *arguments, env=self.environment)


class TestPictures(CompareTest):

    def test_equal_pictures_pass(self):
        self.assertEqual(self.compare(0, "compare", "same.png", "base.png"),
                         ["all of 35 pixels are the same"])
        self.assertEqual(self.compare(0, "compare", "same.png", "base.png", "--quiet"), [])

    def test_different_pictures_fail(self):
        line = "2 of 35 pixels differ, by at most 10 of 255; the first is (5, 1)"
        self.assertEqual(self.compare(1, "compare", "other.png", "base.png"), [line])
        self.assertEqual(self.compare(1, "compare", "base.png", "other.png"), [line])

    def test_the_tolerance_applies_to_the_metric(self):
        for tolerance, status in (("10", 0), ("9.9", 1), ("255", 0)):
            lines = self.compare(status, "compare", "other.png", "base.png", "--tolerance", tolerance)
            self.assertIn("the tolerance of " + tolerance, lines[0])
        rmse = ("compare", "other.png", "base.png", "--metric", "rmse", "--tolerance")
        self.compare(0, *rmse, "1.092")  # the root of (9 + 16 + 100) / 105 is 1.0911
        self.compare(1, *rmse, "1.091")

    def test_pictures_of_different_sizes_fail(self):
        self.write("base.png", grey(5, 7))
        lines = self.compare(1, "compare", "same.png", "base.png", "--tolerance", "255",
                             "--difference", "d.png", "--report", "r.html")
        self.assertIn("7 x 5", lines[0])
        self.assertIn("5 x 7", lines[0])
        self.assertNotIn("d.png", self.files())
        self.assertEqual(self.read("r.html").count(b"<img "), 2)

    def test_structural_similarity_works_or_is_a_clear_error(self):
        done = self.run_command("compare", "other.png", "base.png", "--metric", "ssim",
                                "--tolerance", "0.5", env=self.environment)
        if done.returncode == 0:
            self.assertIn(b"structural similarity is", done.stdout)
        else:
            self.assertEqual(done.returncode, 1)
            self.assertIn(b"needs vtkImageSSIM", done.stderr)

    def test_a_missing_baseline_fails(self):
        lines = self.compare(1, "compare", "same.png", "new.png")
        self.assertIn("there is no baseline 'new.png'", lines[0])
        self.assertIn("look at 'same.png'", lines[1])
        self.assertIn("LAMBENT_UPDATE_BASELINES=1", lines[1])

    def test_the_environment_variable_accepts_baselines(self):
        environment = {"LAMBENT_UPDATE_BASELINES": "1"}
        for baseline in ("base.png", "new.png", "a/new/folder/new.png"):
            lines = self.compare(0, "compare", "other.png", baseline, **environment)
            self.assertEqual(lines, ["accepted as the baseline '%s'" % baseline])
            self.assertEqual(self.read(baseline), self.read("other.png"))
        self.assertEqual(self.compare(0, "compare", "other.png", "base.png", **environment),
                         ["all of 35 pixels are the same"])
        self.compare(1, "compare", "same.png", "base.png", LAMBENT_UPDATE_BASELINES="0")
        self.compare(0, "compare", "other.png", "new.vti", **environment)  # another kind of file
        self.compare(0, "compare", "other.png", "new.vti")

    def test_the_difference_is_written(self):
        self.compare(1, "compare", "other.png", "base.png", "--difference", "d.png")
        self.compare(0, "compare", "d.png", "expected.png", LAMBENT_UPDATE_BASELINES="1")
        self.write("expected.png", png([[{(5, 1): (115, 0, 135), (2, 3): (0, 255, 0)}.get(
            (x, y), (0, 0, 0)) for x in range(7)] for y in (4, 3, 2, 1, 0)]))
        self.compare(0, "compare", "d.png", "expected.png")

    def test_broken_files_are_errors(self):
        whole = grey(7, 5)
        damaged = whole[:45] + bytes([whole[45] ^ 1]) + whole[46:]  # within the pixels
        for content, words in ((whole[:-1], "complete PNG"), (whole[:50], "complete PNG"),
                               (whole[:8], "complete PNG"), (damaged, "check sum"), (b"", "empty"),
                               (b"not a picture", "not a PNG")):
            self.write("broken.png", content)
            for names in (("broken.png", "base.png"), ("base.png", "broken.png")):
                line = self.fail_with(1, "compare", *names)
                self.assertIn("'broken.png'", line)
                self.assertIn(words, line)
        self.assertIn("XML", self.fail_with(1, "compare", self.write("a.vti", "<VTKFile>"), "base.png"))
        self.assertIn("no point scalars",
                      self.fail_with(1, "compare", self.write("a.vti", vti([])), "base.png"))
        os.mkdir(self.path("folder.png"))
        self.assertIn("folder", self.fail_with(1, "compare", "folder.png", "base.png"))
        self.assertIn("no such file", self.fail_with(1, "compare", "none.png", "base.png"))

    def test_undecodable_pixels_are_errors(self):
        """In complete chunks. vtkPNGReader crashes on some of these."""
        rows = zlib.compress(5 * (b"\0" + 21 * b"d"))
        for compressed in (b"these are no pixels", rows[:-8], zlib.compress(b"\0" + 21 * b"d"),
                           zlib.compress(5 * (b"\7" + 21 * b"d"))):  # filters are 0 to 4
            self.write("broken.png", png_file(7, 5, compressed))
            for names in (("compare", "broken.png", "base.png"), ("--recreate", "broken.png"),
                          ("compare", "base.png", "broken.png", "--report", "r.html")):
                line = self.fail_with(1, *names)
                self.assertIn("'broken.png'", line)
                self.assertIn("damaged", line)
        self.assertIn("damaged", self.fail_with(1, "compare", "base.png", self.write(
            "broken.png", png_file(0, 5, rows))))
        self.write("other.png", png_file(7, 5, rows))
        self.compare(0, "compare", "other.png", "base.png")

    def test_wrong_usage_is_refused(self):
        for arguments in ((), ("same.png",), ("same.png", "base.png", "third.png"),
                          ("same.jpg", "base.png"), ("same.png", "base.gif"),
                          ("same.png", "base.png", "--tolerance", "-1"),
                          ("same.png", "base.png", "--tolerance", "nan"),
                          ("same.png", "base.png", "--metric", "psnr"),
                          ("same.png", "base.png", "--difference", "d.gif"),
                          ("same.png", "base.png", "--report", "r.txt"),
                          ("same.png", "base.png", "--size", "5x5")):
            done = self.run_command("compare", *arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stderr.decode().splitlines()[1:],
                             ["Try 'lambent compare --help'."])
        self.assertIn("--tolerance", self.succeed("compare", "--help").decode())

    def test_measurements_for_cdash_are_printed(self):
        lines = self.compare(1, "compare", "other.png", "base.png", "--difference", "d.png",
                             CTEST_INTERACTIVE_DEBUG_MODE="1")
        tags = [re.fullmatch(r'<DartMeasurementFile name="(\w+)" type="image/png">(.*)'
                             r"</DartMeasurementFile>", line) for line in lines]
        self.assertEqual([(tag[1], tag[2]) for tag in tags if tag],
                         [("TestImage", self.path("other.png")),
                          ("ValidImage", self.path("base.png")),
                          ("DifferenceImage", self.path("d.png"))])
        self.assertEqual(len(self.compare(0, "compare", "same.png", "base.png",
                                          CTEST_INTERACTIVE_DEBUG_MODE="1")), 1)


class TestReport(CompareTest):

    def sections(self):
        return re.findall(r'<section class="(\w+)">\n<h2>(.*?)</h2>\n<div>(.*?)</div>',
                          self.read("r.html").decode())

    def test_failures_show_their_pictures(self):
        self.compare(1, "compare", "other.png", "base.png", "--report", "r.html")
        page = self.read("r.html").decode()
        self.assertEqual(page.count("src=\"data:image/png;base64,"), 3)
        self.assertNotIn("http", page)
        self.assertEqual(self.sections(), [
            ("failed", "other.png",
             "2 of 35 pixels differ, by at most 10 of 255; the first is (5, 1)")])

    def test_pictures_of_other_types_are_shown_as_bytes(self):
        grey16 = (0, 128, 129, 257, 25700, 65535)
        of_floats = (-1, 0, 0.5, 1, 2)
        cases = (("x.png", png([[(v, v, v) for v in grey16]], 16), png([6 * [(9, 9, 9)]], 16),
                  (0, 0, 1, 1, 100, 255)),
                 ("x.vti", vti([(v, v, v) for v in of_floats]), vti(5 * [(9, 9, 9)]),
                  (0, 0, 128, 255, 255)))
        for name, picture, baseline, shown in cases:
            self.write(name, picture)
            self.write("b" + name, baseline)
            self.compare(1, "compare", name, "b" + name, "--report", "r.html", "--name", name)
            page = self.read("r.html").decode()
            first = page[page.index("<h2>" + name):].split("base64,")[1].split('"')[0]
            self.write("shown.png", base64.b64decode(first))
            self.write("expected.png", png([[(v, v, v) for v in shown]]))
            self.assertEqual(self.compare(0, "compare", "shown.png", "expected.png"),
                             ["all of %d pixels are the same" % len(shown)])

    def test_names_are_escaped(self):
        self.compare(0, "compare", "same.png", "base.png", "--report", "r.html", "--name",
                     '<b> & "c"')
        self.assertEqual(self.sections()[0][1], "&lt;b&gt; &amp; &quot;c&quot;")

    def test_a_name_has_one_section(self):
        self.compare(1, "compare", "other.png", "base.png", "--report", "r.html", "--name", "a & b")
        self.compare(1, "compare", "other.png", "base.png", "--report", "r.html", "--name", "a")
        self.compare(0, "compare", "same.png", "base.png", "--report", "r.html", "--name", "a & b")
        self.assertEqual([(state, name) for state, name, _ in self.sections()],
                         [("passed", "a &amp; b"), ("failed", "a")])

    def test_processes_share_a_page(self):
        count = 24
        processes = [subprocess.Popen(
            [COMMAND, "compare", "other.png", "base.png", "--report", "r.html", "--name", str(k)],
            cwd=self.folder, stdout=subprocess.DEVNULL, env=self.environment) for k in range(count)]
        self.assertEqual([process.wait() for process in processes], count * [1])
        self.assertEqual(sorted(int(name) for _, name, _ in self.sections()), list(range(count)))

    def test_files_that_are_not_reports_are_not_overwritten(self):
        self.write("r.html", "<html>my own page</html>")
        line = self.fail_with(1, "compare", "same.png", "base.png", "--report", "r.html")
        self.assertIn("r.html", line)
        self.assertEqual(self.read("r.html"), b"<html>my own page</html>")
        line = self.fail_with(1, "compare", "same.png", "base.png", "--report", "no/r.html")
        self.assertIn("cannot write the report 'no/r.html': No such file", line)


class TestDrawing(CompareTest):
    """Renders and compares in one call. The square, two triangles, fills the view. It is divided from lower
    left to upper right."""

    SQUARE_VIEW = ("square.obj", "--direction", "0,0,1", "--parallel-scale", "1")

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))
        self.write("tetrahedron.obj", obj(TETRAHEDRON))

    def test_the_default_size_is_that_of_the_baseline(self):
        self.compare(0, *self.SQUARE_VIEW, "--compare", "b.png", "--size", "13x9",
                     LAMBENT_UPDATE_BASELINES="1")
        self.assertEqual(self.compare(0, *self.SQUARE_VIEW, "--compare", "b.png"),
                         ["all of 117 pixels are the same"])
        self.assertIn("10 x 10", self.compare(1, *self.SQUARE_VIEW, "--compare", "b.png",
                                              "--size", "10x10")[0])

    def test_cells_of_changed_pixels_are_listed(self):
        # Of the 8 x 8 pixels, the lower right half shows cell 0.
        self.succeed(*self.SQUARE_VIEW, "-o", "b.png", "--size", "8x8")
        self.assertEqual(
            self.compare(1, *self.SQUARE_VIEW, "--color", "red", "--compare", "b.png"),
            ["64 of 64 pixels differ, by at most 255 of 255; the first is (0, 0)",
             "the changed pixels show cells 0-1 of 'square.obj'"])
        rows = [[(255, 255, 255)] * 8 for _ in range(8)]
        rows[7][6] = rows[4][7] = (255, 255, 254)  # (6, 0) and (7, 3) from the bottom
        self.write("b.png", png(rows))
        self.assertEqual(self.compare(1, *self.SQUARE_VIEW, "--compare", "b.png", "--report",
                                      "r.html")[1],
                         "the changed pixels show cell 0 of 'square.obj'")
        self.assertIn("<tr><td>square.obj</td><td>0</td><td>2</td><td>(6, 0)</td></tr>",
                      self.read("r.html").decode())
        rows[0][0] = rows[0][1] = rows[1][0] = (0, 0, 0)
        self.write("b.png", png(rows))
        self.compare(1, *self.SQUARE_VIEW, "--compare", "b.png", "--report", "r.html")
        self.assertIn("<tr><td>square.obj</td><td>1</td><td>3</td><td>(0, 6)</td></tr>\n"
                      "<tr><td>square.obj</td><td>0</td><td>2</td><td>(6, 0)</td></tr>",
                      self.read("r.html").decode())  # the cell with the most pixels first
        lines = self.compare(1, *self.SQUARE_VIEW, "tetrahedron.obj",
                             "--focal-point", "0,0,0", "--compare", "b.png")
        self.assertEqual(  # all of the tetrahedron but the base
            lines[1], "the changed pixels show cells 0-1 of 'square.obj' and cells 1-3 of "
            "'tetrahedron.obj'")

    def test_baselines_store_commands_without_absolute_paths(self):
        for mesh, says in (("square.obj", True), (self.path("square.obj"), False)):
            self.compare(0, mesh, "--compare", "new.png", "--size", "9x9",
                         LAMBENT_UPDATE_BASELINES="1")
            self.assertEqual(b"Lambent command" in self.read("new.png"), says)
            os.remove(self.path("new.png"))

    def test_changed_background_pixels_are_reported(self):
        self.succeed("square.obj", "-o", "b.png", "--size", "8x8", "--parallel-scale", "2",
                     "--supersampling", "1")  # otherwise the edges show both
        lines = self.compare(1, "square.obj", "--parallel-scale", "2", "--background", "blue",
                             "--compare", "b.png")
        self.assertEqual(lines[1], "the changed pixels show the background")

    def test_the_default_supersampling_is_that_of_the_baseline(self):
        # A .vti has no number of samples and counts as one, as does a PNG from other software.
        for name, samples in (("b.png", "3"), ("b.png", "1"), ("b.png", "5"), ("b.vti", "1")):
            view = (*self.SQUARE_VIEW[:1], "--direction", "1,2,3")
            self.succeed(*view, "-o", name, "--size", "20x20", "--supersampling", samples)
            self.compare(0, *view, "--compare", name)
            other = "2" if samples == "3" else "3"
            self.compare(1, *view, "--compare", name, "--supersampling", other)

    def test_the_output_is_also_written(self):
        lines = self.compare(1, *self.SQUARE_VIEW, "--compare", "new.png", "-o", "x.png",
                             "--size", "4x4")
        self.assertEqual(lines[0], "there is no baseline 'new.png'")
        self.assertIn("look at 'x.png'", lines[1])
        self.compare(0, *self.SQUARE_VIEW, "--compare", "x.png")

    def test_ids_are_not_written_to_the_output(self):
        self.succeed(*self.SQUARE_VIEW, "-o", "a.vti", "--size", "4x4")
        self.compare(0, *self.SQUARE_VIEW, "--compare", "a.vti", "-o", "b.vti")
        self.assertEqual(self.read("a.vti"), self.read("b.vti"))
        self.compare(0, "compare", "a.vti", "b.vti")

    def test_standard_output_gets_only_the_picture(self):
        self.succeed(*self.SQUARE_VIEW, "-o", "b.png", "--size", "4x4")
        done = self.run_command(*self.SQUARE_VIEW, "-o", "-", "--compare", "b.png",
                                env=self.environment)
        self.assertEqual((done.returncode, done.stdout), (0, self.read("b.png")))
        self.assertEqual(done.stderr, b"all of 16 pixels are the same\n")

    def test_wrong_usage_is_refused(self):
        for option, value in (("--tolerance", "1"), ("--metric", "max"), ("--difference", "d.png"),
                              ("--report", "r.html"), ("--name", "x")):
            self.assertIn("--compare", self.fail_with(2, "square.obj", "-o", "x.png", option, value))
        self.assertIn("--compare", self.fail_with(2, "square.obj", "--compare", "b.gif"))


if __name__ == "__main__":
    unittest.main()
