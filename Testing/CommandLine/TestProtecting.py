# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command never overwrites a baseline, an input or another picture, under any of its names, and no
picture passes a comparison with itself."""

import os
import unittest

from TestComparing import CompareTest, grey, vti
from commandline import SQUARE, obj

UPDATE = {"LAMBENT_UPDATE_BASELINES": "1"}


class ProtectingTest(CompareTest):

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("folder"))
        self.write("square.obj", obj(SQUARE))

    def spellings(self, name):
        """Other names of a file; some of them are new files in the folder."""
        stem, extension = os.path.splitext(name)
        links = [stem + " link" + extension, "folder/" + stem + extension, stem + " hard" + extension]
        for link in links:
            if os.path.lexists(self.path(link)):
                os.remove(self.path(link))
        os.symlink(name, self.path(links[0]))
        os.symlink("../" + links[0], self.path(links[1]))
        os.link(self.path(name), self.path(links[2]))
        names = [name, "./" + name, "folder/../" + name, ".//folder/.././" + name, self.path(name)]
        if os.path.exists(self.path(name.upper())):
            names.append(name.upper())
        return names + links

    def refuse(self, *arguments, kept, words=()):
        """The command refuses, however often it runs and whether or not it updates, and the files to keep
        do not change. Returns its message."""
        def state():
            return [(self.read(name), os.stat(self.path(name)).st_mtime_ns) for name in kept]
        before, files = state(), self.files()
        for environment in ({}, {}, UPDATE):
            done = self.run_command(*arguments, env={**self.environment, **environment})
            self.assertEqual((done.returncode, done.stdout), (1, b""), (arguments, done.stderr))
            line, = done.stderr.decode().splitlines()
            for word in words:
                self.assertIn(word, line)
            self.assertEqual(state(), before, arguments)
            self.assertEqual(self.files(), files, arguments)
        return line


class TestBaselines(ProtectingTest):

    def test_the_output_must_not_be_the_baseline(self):
        for name in self.spellings("base.png"):
            self.refuse("square.obj", "-o", name, "--compare", "base.png", kept=["base.png"],
                        words=["cannot write '%s': it is the baseline" % name,
                               "choose another name"])
            self.refuse("square.obj", "-o", "base.png", "--compare", name, kept=["base.png"],
                        words=["cannot write 'base.png': it is the baseline"])

    def test_the_output_must_not_be_a_missing_baseline(self):
        os.symlink("new.png", self.path("link.png"))
        for output, baseline in (("new.png", "new.png"), ("./new.png", "new.png"),
                                 ("new.png", "folder/../new.png"), ("link.png", "new.png"),
                                 ("new.png", "link.png")):
            self.refuse("square.obj", "-o", output, "--compare", baseline, kept=[],
                        words=["it is the baseline"])
            self.assertFalse(os.path.exists(self.path("new.png")))

    def test_difference_and_report_must_not_be_the_baseline(self):
        for name in self.spellings("base.png"):
            self.refuse("square.obj", "--compare", "base.png", "--difference", name,
                        kept=["base.png"], words=["it is the baseline"])
            self.refuse("compare", "other.png", "base.png", "--difference", name,
                        kept=["base.png", "other.png"], words=["it is the baseline"])
        os.symlink("base.png", self.path("r.html"))
        self.refuse("compare", "other.png", "base.png", "--report", "r.html", kept=["base.png"],
                    words=["cannot write 'r.html': it is the baseline, 'base.png'"])

    def test_a_picture_is_not_compared_with_itself(self):
        for name in self.spellings("base.png"):
            line = self.refuse("compare", name, "base.png", kept=["base.png"],
                               words=["cannot compare '%s' with " % name, "name two files"])
            self.assertIn("itself" if name == "base.png" else "they are the same file", line)

    def test_similar_names_are_different_files(self):
        os.mkdir(self.path("new"))
        self.compare(0, "square.obj", "-o", "new/base.png", "--compare", "expected.png", "--size",
                     "7x5", **UPDATE)
        self.compare(0, "compare", "same.png", "base.png", "--difference", "folder/base.png")
        self.compare(0, "square.obj", "-o", "new/expected.png", "--compare", "expected.png")


class TestOtherFiles(ProtectingTest):

    def test_the_difference_must_not_be_the_picture(self):
        for name in self.spellings("other.png"):
            self.refuse("compare", "other.png", "base.png", "--difference", name,
                        kept=["base.png", "other.png"], words=["it is the picture to compare"])

    def test_outputs_must_differ_from_each_other(self):
        os.symlink("x.png", self.path("y.png"))
        os.symlink("x.png", self.path("x.html"))
        for outputs in (("-o", "x.png", "--difference", "./x.png"),
                        ("-o", "x.png", "--difference", "y.png")):
            self.refuse("square.obj", "--compare", "base.png", *outputs, kept=["base.png"],
                        words=["it is the output"])
        self.refuse("compare", "other.png", "base.png", "--difference", "x.png", "--report", "x.html",
                    kept=["base.png"], words=["cannot write 'x.html': it is the difference, 'x.png'"])

    def test_the_output_must_not_be_an_input(self):
        os.symlink("square.obj", self.path("x.png"))
        os.link(self.path("square.obj"), self.path("h.png"))
        for name in ("x.png", "h.png"):
            for arguments in (("-o", name), ("--compare", "base.png", "--difference", name)):
                self.refuse("square.obj", *arguments, kept=["square.obj"],
                            words=["cannot write '%s': it is an input, 'square.obj'" % name])

    def test_a_recreated_picture_may_replace_itself(self):
        self.succeed("square.obj", "-o", "p.png", "--size", "8x8")
        before = self.read("p.png")
        self.succeed("--recreate", "p.png", "-o", "p.png")  # on request
        self.assertEqual(self.read("p.png"), before)
        self.assertEqual(self.compare(0, "--recreate", "p.png"),
                         ["all of 64 pixels are the same"])
        os.symlink("square.obj", self.path("x.png"))
        self.refuse("--recreate", "p.png", "-o", "x.png", kept=["square.obj"],
                    words=["it is an input"])


class TestUpdating(ProtectingTest):

    def test_unwritable_baselines_are_not_accepted(self):
        self.write("floats.vti", vti([(0.25, 0.5, 1)]))
        os.mkdir(self.path("dir.png"))
        before = self.read("base.png")
        for arguments in (("floats.vti", "base.png"), ("floats.vti", "new.png"),
                          ("same.png", "dir.png"), ("same.png", "/proc/x/a.png"),
                          ("same.png", "square.obj/a.png"), ("same.png", 300 * "n" + ".png")):
            done = self.run_command("compare", *arguments, env={**self.environment, **UPDATE})
            self.assertEqual((done.returncode, done.stdout), (1, b""), (arguments, done.stderr))
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertEqual(self.read("base.png"), before)
        self.assertFalse(os.path.exists(self.path("new.png")))

    def test_a_symbolic_link_to_a_baseline_is_kept(self):
        os.symlink("../base.png", self.path("folder/link.png"))
        self.compare(0, "compare", "other.png", "folder/link.png", **UPDATE)
        self.assertTrue(os.path.islink(self.path("folder/link.png")))
        self.assertEqual(self.read("base.png"), self.read("other.png"))

    def test_a_truncated_baseline_is_an_error_and_is_kept(self):
        self.write("base.png", grey(7, 5)[:-20])
        for arguments in (("compare", "same.png", "base.png"),
                          ("square.obj", "--compare", "base.png", "--size", "7x5"),
                          ("square.obj", "--compare", "base.png")):
            line = self.refuse(*arguments, kept=["base.png"])
            self.assertIn("cannot read 'base.png': it is not a complete PNG file", line)


if __name__ == "__main__":
    unittest.main()
