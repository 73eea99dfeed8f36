# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command writes a complete picture, or leaves the existing file unchanged."""

import os
import resource
import signal
import struct
import subprocess
import time
import unittest

from commandline import COMMAND, CommandTest, TETRAHEDRON, obj, read_pnm

SIZE = ("--size", "64x48")


class TestWriting(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("mesh.obj", obj(TETRAHEDRON))

    def draw(self, name, *arguments, **keywords):
        return self.succeed("mesh.obj", "-o", name, *SIZE, *arguments, **keywords)

    def fail_to_write(self, name, *arguments, **keywords):
        line = self.fail_with(1, "mesh.obj", "-o", name, *arguments, **keywords)
        self.assertIn("cannot write '" + name + "': ", line)
        return line

    def test_every_format_is_written(self):
        starts = {"x.png": b"\x89PNG\r\n\x1a\n", "x.jpg": b"\xff\xd8\xff", "x.jpeg": b"\xff\xd8\xff",
                  "x.tif": b"II*\0", "x.tiff": b"II*\0", "x.bmp": b"BM", "x.pnm": b"P6\n",
                  "x.ppm": b"P6\n", "x.vti": b"<VTKFile"}
        for name, start in starts.items():
            self.draw(name)
            content = self.read(name)
            self.assertEqual(content[:len(start)], start)
            self.draw(name.upper())
            self.assertEqual(self.read(name.upper()), content)
        self.assertEqual(self.files(), sorted([*starts, *map(str.upper, starts), "mesh.obj"]))

    def test_pixels_are_the_same_in_every_format(self):
        self.draw("x.pnm", "--feature-angle", "180")
        rows = read_pnm(self.read("x.pnm"))
        flat = b"".join(bytes(pixel) for row in rows for pixel in row)
        self.assertGreater(len(set(flat)), 3)
        self.draw("x.tif", "--feature-angle", "180")
        self.assertIn(flat, self.read("x.tif"))  # not compressed, the top row first, as in PNM
        self.draw("x.bmp", "--feature-angle", "180")
        upside_down = b"".join(bytes(reversed(pixel)) for row in reversed(rows) for pixel in row)
        self.assertTrue(self.read("x.bmp").endswith(upside_down))  # blue, green, red

    def test_standard_output_gets_the_same_bytes(self):
        self.draw("x.png")
        self.assertEqual(self.draw("-"), self.read("x.png"))
        self.assertEqual(struct.unpack(">II", self.read("x.png")[16:24]), (64, 48))

    def test_standard_output_gets_only_the_picture(self):
        self.draw("x.png")
        done = self.run_command("mesh.obj", "-o", "-", *SIZE, "--verbose")
        self.assertEqual((done.returncode, done.stdout), (0, self.read("x.png")))

    def test_a_full_pipe_is_an_error(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([COMMAND, "mesh.obj", "-o", "-"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn(b"cannot write to standard output: No space left", done.stderr)

    def test_a_terminal_gets_no_picture(self):
        master, terminal = os.openpty()
        self.addCleanup(os.close, master)
        with open(terminal, "wb") as out:
            done = subprocess.run([COMMAND, "mesh.obj", "-o", "-"], cwd=self.folder, stdout=out,
                                  stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.decode(), "lambent: cannot write to standard output: it is a "
                                               "terminal; send it to a file or a pipe\n")

    def test_an_existing_picture_is_replaced_completely(self):
        self.write("x.png", "old")
        os.chmod(self.path("x.png"), 0o640)
        self.draw("x.png")
        self.assertEqual(self.read("x.png"), self.draw("-"))
        self.assertEqual(os.stat(self.path("x.png")).st_mode & 0o777, 0o640)
        self.assertEqual(self.files(), ["mesh.obj", "x.png"])

    def test_a_symbolic_link_is_kept(self):
        os.mkdir(self.path("there"))
        self.write("there/x.png", "old")
        os.symlink("there/x.png", self.path("x.png"))
        self.draw("x.png")
        self.assertTrue(os.path.islink(self.path("x.png")))
        self.assertEqual(self.read("there/x.png"), self.draw("-"))
        self.assertEqual(os.listdir(self.path("there")), ["x.png"])

    def test_an_existing_picture_survives_a_failure(self):
        self.write("x.png", "old")
        self.fail_with(1, "missing.obj", "-o", "x.png")
        self.fail_with(1, "mesh.obj", "-o", "x.png", "--size", "1000000x1000000")
        self.fail_with(2, "mesh.obj", "-o", "x.png", "--size", "0x0")
        self.assertEqual(self.read("x.png"), b"old")

    def test_missing_folders_are_errors(self):
        self.assertIn("no folder 'nowhere'", self.fail_to_write("nowhere/x.png"))
        self.assertIn("no folder", self.fail_to_write("mesh.obj/x.png"))
        os.mkdir(self.path("x.png"))
        self.fail_to_write("x.png")
        os.mkfifo(self.path("pipe.png"))
        self.fail_to_write("pipe.png")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_unwritable_folders_are_errors(self):
        os.mkdir(self.path("locked"), 0o500)
        self.assertIn("ermission", self.fail_to_write("locked/x.png"))

    @unittest.skipIf("TSAN_OPTIONS" in os.environ, "the thread sanitizer writes its own files")
    def test_a_full_disk_leaves_the_old_file(self):
        """A limit on the size of files simulates a full disk."""
        for name in ("x.png", "x.jpg", "x.tif", "x.bmp", "x.pnm", "x.vti"):
            self.draw(name)
            whole = len(self.read(name))
            self.write(name, "old")
            for limit in (0, 1, 100, whole // 2, whole - 1):
                self.fail_to_write(
                    name, *SIZE,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assertEqual(self.read(name), b"old")

    def test_an_interrupt_leaves_no_partial_file(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = subprocess.Popen(
                [COMMAND, "mesh.obj", "-o", "x.png", "--size", "6000x6000"], cwd=self.folder,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            part = ".lambent-%d.part" % process.pid
            deadline = time.monotonic() + 60
            seen = 0  # at the start it exists briefly, as a test of whether it can be written
            while seen < 5 and process.poll() is None and time.monotonic() < deadline:
                seen = seen + 1 if part in self.files() else 0
                time.sleep(0.01)
            process.send_signal(number)
            self.assertEqual(process.communicate(timeout=60), (b"", b""))
            self.assertEqual(process.returncode, -number)
            self.assertEqual(self.files(), ["mesh.obj"])


if __name__ == "__main__":
    unittest.main()
