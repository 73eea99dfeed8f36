# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture records how it was rendered, and can be rendered again from that: the same file."""

import os
import struct
import subprocess
import unittest
import zlib

from commandline import CommandTest, SQUARE, TETRAHEDRON, obj

CONTRACT = "Lambent image contract"
COMMAND_KEY = "Lambent command"

# All options that describe the scene.
SCENES = (
    (),
    ("--size", "31x17", "--background", "0.1,0.2,1", "--direction", "1,0.5,2", "--view-angle", "20",
     "--zoom", "1.25", "--diffuse", "0.5", "--ambient", "0.25", "--color", "tomato",
     "--ambient-color", "#102030", "--shading", "flat", "--ambient-model", "scene"),
    ("--camera-position", "-3,2,5", "--focal-point=.1,0.2,-1e-3", "--view-up", "0.1,1,0",
     "--light", "position=3,4,5;color=gold;intensity=0.8;cone=40;focal=0,0,0;exponent=2",
     "--headlight", "--light", "direction=0,-1,-1e0;color=1,0.25,0.5"),
    ("--parallel-scale", "1.5", "--shading", "unlit"),
)


def chunks(png):
    at = 8
    while at < len(png):
        length = struct.unpack(">I", png[at:at + 4])[0]
        yield png[at + 4:at + 8], png[at + 8:at + 8 + length]
        at += 12 + length


def texts(png):
    return {key.decode(): value.decode() for key, value in (
        data.split(b"\0", 1) for kind, data in chunks(png) if kind == b"tEXt")}


def with_text(png, key, value):
    """The file with another text for a key, or without the key."""
    result = png[:8]
    for kind, data in chunks(png):
        if kind == b"tEXt" and data.startswith(key.encode() + b"\0"):
            if value is None:
                continue
            data = (key + "\0" + value).encode()
        result += (struct.pack(">I", len(data)) + kind + data +
                   struct.pack(">I", zlib.crc32(kind + data)))
    return result


class TestRecreating(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))
        self.write("it's a tetrahedron, é.obj", obj(TETRAHEDRON))

    def draw(self, *arguments):
        self.succeed("square.obj", "it's a tetrahedron, é.obj", "-o", "a.png", *arguments)
        return self.read("a.png")

    def test_the_stored_command_is_complete(self):
        text = texts(self.draw("--threads", "1", "--size", "16x9", "--color", "0.5,0.5,1", "--light",
                               "direction=0,0,-1;color=red"))
        self.assertEqual(text, {
            CONTRACT: "2",
            COMMAND_KEY: "lambent square.obj 'it'\\''s a tetrahedron, é.obj' --direction 2,1.5,4 "
                         "--color 0.5,0.5,1 "
                         "--light 'direction=0,0,-1;color=red' --size 16x9 --supersampling 3"})

    def test_the_stored_contract_is_current(self):
        version = self.succeed("--version").decode()
        self.assertIn("image contract %s," % texts(self.draw())[CONTRACT], version)

    def test_recreating_gives_the_same_file(self):
        for scene in SCENES:
            drawn = self.draw(*scene)
            self.succeed("--recreate", "a.png", "-o", "b.png", "--threads", "2")
            self.assertEqual(self.read("b.png"), drawn, scene)
            self.assertEqual(self.succeed("--recreate", "a.png", "-o", "-"), drawn, scene)

    def test_the_stored_command_works_in_a_shell(self):
        drawn = self.draw(*SCENES[2])
        os.mkdir(self.path("bin"))
        os.symlink(os.environ["LAMBENT_COMMAND"], self.path("bin/lambent"))
        self.write("again.sh", texts(drawn)[COMMAND_KEY] + " -o b.png\n")
        subprocess.run(["sh", "again.sh"], cwd=self.folder, check=True,
                       env={**os.environ, "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertEqual(self.read("b.png"), drawn)

    # Older versions of the command had another default and did not record it.
    def test_pictures_without_a_stored_view_look_from_plus_z(self):
        for more in ("", " --parallel-scale 1.5 --focal-point 0.5,0,0"):
            drawn = self.draw("--size", "30x20", "--direction", "0,0,1", *more.split())
            command = texts(drawn)[COMMAND_KEY].replace(" --direction 0,0,1", "")
            self.assertNotIn("direction", command)
            self.write("a.png", with_text(with_text(drawn, COMMAND_KEY, command), CONTRACT, "1"))
            done = self.run_command("--recreate", "a.png")
            self.assertEqual(done.returncode, 0)
            self.assertIn(b"all of 600 pixels are the same", done.stdout)
            # The new picture records it, so it is the file that was rendered first.
            self.succeed("--recreate", "a.png", "-o", "b.png", "--quiet")
            self.assertEqual(self.read("b.png"), drawn)

    # Older versions of the command used one sample per pixel and did not record the number.
    def test_pictures_without_stored_supersampling_have_one_sample(self):
        drawn = self.draw("--size", "30x20", "--supersampling", "1")
        command = texts(drawn)[COMMAND_KEY].replace(" --supersampling 1", "")
        self.assertNotIn("supersampling", command)
        self.write("a.png", with_text(drawn, COMMAND_KEY, command))
        self.assertIn(b"all of 600 pixels are the same", self.succeed("--recreate", "a.png"))
        self.succeed("--recreate", "a.png", "-o", "b.png")
        self.assertEqual(self.read("b.png"), drawn)

    def test_every_picture_stores_its_view(self):
        for arguments, view in (((), "--direction 2,1.5,4"),
                                (("--focal-point", "1,0,0"), "--direction 2,1.5,4"),
                                (("--direction", "0,2,1"), "--direction 0,2,1"),
                                (("--camera-position", "1,2,9"), "--camera-position 1,2,9")):
            command = texts(self.draw("--size", "9x9", *arguments))[COMMAND_KEY]
            self.assertIn(view, command)
            self.assertEqual(command.count("--direction") + command.count("--camera-position"), 1)

    def test_without_output_it_compares(self):
        self.draw("--size", "20x20", "--parallel-scale", "2")
        self.assertIn(b"all of 400 pixels are the same", self.succeed("--recreate", "a.png"))
        self.write("square.obj", obj(([(-1, -1, 1), (2, -1, 1), (2, 2, 1)], [(0, 1, 2)])))
        done = self.run_command("--recreate", "a.png")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"pixels differ", done.stdout)

    def test_a_different_contract_causes_a_warning(self):
        self.write("c.png", with_text(self.draw("--size", "9x9"), CONTRACT, "7"))
        done = self.run_command("--recreate", "c.png", "-o", "b.png")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr.decode(), r"warning: 'c.png' was rendered under image contract 7, "
                                               r"but this version has \d+; bits may differ")
        self.succeed("--recreate", "c.png", "-o", "b.png", "--quiet")

    def test_invalid_stored_commands_are_refused(self):
        drawn = self.draw("--size", "9x9")
        for value in ("", "lambent", "ls -l", "lambent square.obj -o x.png --size 9x9",
                      "lambent compare a.png a.png", "lambent --help", "lambent --recreate a.png",
                      "lambent square.obj --light", "lambent square.obj --size 0x9"):
            self.write("c.png", with_text(drawn, COMMAND_KEY, value))
            self.assertIn("cannot recreate 'c.png'",
                          self.fail_with(1, "--recreate", "c.png", "-o", "b.png"), value)
        for key in (CONTRACT, COMMAND_KEY):
            self.write("c.png", with_text(drawn, key, None))
            self.assertIn("does not store", self.fail_with(1, "--recreate", "c.png", "-o", "b.png"))
        self.write("c.png", drawn[:-20])
        self.assertIn("not a complete PNG file", self.fail_with(1, "--recreate", "c.png", "-o", "b.png"))
        self.assertIn("no such file", self.fail_with(1, "--recreate", "none.png"))

    def test_other_options_are_refused(self):
        for extra in (("square.obj",), ("--size", "9x9"), ("--color", "red"), ("--compare", "a.png")):
            self.assertIn("--recreate", self.fail_with(2, "--recreate", "a.png", *extra))
        self.assertIn("--recreate", self.fail_with(2, "--recreate", "a.jpg"))


if __name__ == "__main__":
    unittest.main()
