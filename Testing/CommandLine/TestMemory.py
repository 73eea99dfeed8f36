# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Too little memory, wherever it runs out, gives status 1 and one line."""

import resource
import unittest

from commandline import CommandTest, TETRAHEDRON, obj

MEGABYTE = 1 << 20


def limited(megabytes):
    """Limits the address space of a process that is about to start."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes * MEGABYTE,) * 2)
    return limit


class TestMemory(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("mesh.obj", obj(TETRAHEDRON))

    def least(self):
        """The address space that the command needs to start."""
        for megabytes in range(32, 2048, 8):
            done = self.run_command("--version", preexec_fn=limited(megabytes))
            if done.returncode == 0:
                return megabytes
        self.skipTest("the command needs very much address space; it has a sanitizer in it")

    def test_too_little_memory_for_the_picture_is_an_error(self):
        least = self.least()
        line = self.fail_with(1, "mesh.obj", "-o", "x.png", "--threads", "1", "--size",
                              "30000x20000", preexec_fn=limited(least + 512))
        self.assertRegex(line, "cannot render: .*(memory|allocate)")  # one is VTK's own message

    def test_too_little_memory_for_anything_is_an_error(self):
        least = self.least()
        self.write("x.png", "old")
        statuses = set()
        for more in (8, 32, 64, 96, 128, 160, 192, 256, 384):
            done = self.run_command("mesh.obj", "-o", "x.png", "--threads", "1", "--size",
                                    "4000x4000", preexec_fn=limited(least + more))
            statuses.add(done.returncode)
            self.assertIn(done.returncode, (0, 1), (more, done.stderr))
            self.assertEqual(len(done.stderr.splitlines()), done.returncode, (more, done.stderr))
            self.assertEqual(self.files(), ["mesh.obj", "x.png"])
            self.assertEqual(self.read("x.png") == b"old", done.returncode == 1)
            self.write("x.png", "old")
        self.assertEqual(statuses, {0, 1})


if __name__ == "__main__":
    unittest.main()
