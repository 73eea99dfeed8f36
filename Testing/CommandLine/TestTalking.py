# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command's messages: none, unless they are requested, there is a problem, or it takes long."""

import os
import pty
import subprocess
import unittest

from commandline import COMMAND, CommandTest, SQUARE, obj, ply_text

ERASE = "\r\x1b[K"


class TestTalking(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))

    def on_terminal(self, *arguments):
        """The output on a terminal that is the command's standard error."""
        try:
            leader, follower = pty.openpty()
        except OSError as error:  # some containers have none
            self.skipTest(f"no terminal can be made here: {error}")
        # Without vectors, long work takes seconds on any machine.
        process = subprocess.Popen([COMMAND, *arguments], cwd=self.folder, stderr=follower,
                                   stdout=subprocess.DEVNULL,
                                   env={**os.environ, "LAMBENT_SIMD": "plain"})
        os.close(follower)
        shown = b""
        while True:
            try:
                part = os.read(leader, 4096)
            except OSError:  # the other end of the terminal is closed
                break
            if not part:
                break
            shown += part
        os.close(leader)
        self.assertEqual(process.wait(), 0)
        return shown.decode()

    LONG = ("square.obj", "-o", "x.png", "--size", "7000x7000", "--threads", "1")
    SHORT = ("square.obj", "-o", "x.png", "--size", "70x70")

    def test_a_progress_bar_is_shown_on_a_terminal(self):
        shown = self.on_terminal(*self.LONG)
        steps = shown.split(ERASE)
        self.assertEqual(steps[0], "")
        self.assertEqual(steps[-1], "")  # the bar is erased at the end
        self.assertGreater(len(steps), 2)
        for step in steps[1:-1]:
            self.assertRegex(step, r"\A(\[#* *\] +\d+ % [a-z].*)?\Z")
        self.assertNotIn("\n", shown)

    def test_no_progress_bar_for_short_work(self):
        self.assertEqual(self.on_terminal(*self.SHORT), "")

    def test_no_progress_bar_with_quiet(self):
        self.assertEqual(self.on_terminal(*self.LONG, "--quiet"), "")

    def test_no_progress_bar_in_a_pipe(self):
        self.assertEqual(self.succeed(*self.LONG), b"")

    def test_verbose_reports_steps_and_times(self):
        done = self.run_command(*self.SHORT, "--verbose")
        self.assertEqual((done.returncode, done.stdout), (0, b""))
        text = done.stderr.decode()
        folder = os.path.realpath(self.folder)
        self.assertRegex(text.replace(folder, "FOLDER"),
                         r"\Apicture    FOLDER/x.png\n"
                         r"size       70 x 70\n"
                         r"samples    3 x 3 per pixel\n"
                         r"triangles  2\n"
                         r"reading    \d+\.\d ms\n"
                         r"normals    \d+\.\d ms\n"
                         r"rendering  \d+\.\d ms\n"
                         r"writing    \d+\.\d ms\n\Z")

    def test_polygons_are_counted_as_triangles(self):
        self.write("quad.obj", obj((SQUARE[0], [(0, 1, 2, 3)])))
        done = self.run_command("quad.obj", "square.obj", "-o", "x.png", "--verbose")
        self.assertIn(b"\ntriangles  4\n", done.stderr)

    def test_a_warning_is_one_line_unless_quiet(self):
        points = SQUARE[0] + [(float("nan"), 0, 0)]
        self.write("nan.ply", ply_text((points, [(0, 1, 2), (0, 2, 4)])))
        for shading in ("flat", "smooth"):
            arguments = ("nan.ply", "-o", "x.png", "--size", "9x9", "--shading", shading)
            done = self.run_command(*arguments)
            self.assertEqual((done.returncode, done.stdout), (0, b""))
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertRegex(done.stderr, rb"\Alambent: warning: .*finite")
            self.assertEqual(self.succeed(*arguments, "--quiet"), b"")

    def test_a_feature_angle_without_effect_causes_a_warning_unless_quiet(self):
        points, faces = SQUARE
        self.write("normals.obj", "".join("v %r %r %r\n" % p for p in points) + "vn 0 0 1\n" +
                   "".join("f " + " ".join(f"{i + 1}//1" for i in face) + "\n" for face in faces))
        self.write("cubes.vtk", "# vtk DataFile Version 3.0\ncubes\nASCII\nDATASET "
                   "STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA "
                   "27\nSCALARS s float 1\nLOOKUP_TABLE default\n" + "0 1 3 " * 9 + "\n")
        picture = ("-o", "x.png", "--size", "9x9")
        angle = ("--feature-angle", "30")
        said = "lambent: warning: --feature-angle has no effect"
        own = said + (": all meshes have point normals; omit it, or remove the normals from the "
                      "files\n")
        for arguments, expected in (
                (("normals.obj", *angle), own),
                (("normals.obj", "normals.obj", *angle), own),
                (("square.obj", "--shading", "flat", *angle),
                 said + " with --shading flat; omit one of them\n"),
                (("square.obj", "--shading", "unlit", *angle),
                 said + " with --shading unlit; omit one of them\n"),
                (("cubes.vtk", "--contour", "0.5", *angle), said + ": the contour has its own "
                 "normals, from the array's gradient; omit it\n")):
            done = self.run_command(*arguments, *picture)
            self.assertEqual((done.returncode, done.stderr.decode()), (0, expected))
            self.succeed(*arguments, *picture, "--quiet")
            without = self.read("x.png")
            at = arguments.index("--feature-angle")
            self.succeed(*arguments[:at], *arguments[at + 2:], "-o", "y.pnm", "--size", "9x9")
            self.succeed(*arguments, "-o", "x.pnm", "--size", "9x9", "--quiet")
            self.assertEqual(self.read("x.pnm").splitlines()[-1], self.read("y.pnm").splitlines()[-1])
            done = self.run_command("--recreate", "x.png", "-o", "z.png")
            self.assertEqual((done.stderr.decode(), self.read("z.png")), (expected, without))
        self.succeed("square.obj", *angle, *picture)
        self.succeed("square.obj", "normals.obj", *angle, *picture)

    def test_errors_are_printed_even_with_quiet(self):
        self.fail_with(1, "missing.obj", "-o", "x.png", "--quiet")
        self.fail_with(1, "missing.obj", "-o", "x.png", "--verbose")


if __name__ == "__main__":
    unittest.main()
