# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the command line accepts, and the answer to wrong usage: status 2, one line, a hint."""

import unittest

from commandline import CommandTest, SQUARE, obj


class TestUsage(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))

    def reject(self, *arguments):
        return self.fail_with(2, "square.obj", "-o", "x.png", *arguments)

    def test_help_and_version_are_printed(self):
        text = self.succeed("--help").decode()
        for option in ("--output", "--size", "--supersampling", "--camera-position", "--focal-point", "--view-up",
                       "--view-angle", "--parallel-scale", "--direction", "--zoom", "--light",
                       "--headlight", "--diffuse", "--ambient", "--color", "--ambient-color",
                       "--shading", "--ambient-model", "--background", "--threads", "--quiet",
                       "--verbose", "--version", "--compare", "--metric", "--tolerance",
                       "--difference", "--report", "--name", "--recreate", "--contour",
                       "--formats", "--alpha", "--background-image", "--pass", "--color-by",
                       "--colormap", "--range", "--log", "--nan-color", "--opacity", "--edges",
                       "--edge-color", "--line-width", "--point-size", "--representation",
                       "--spheres", "--specular", "--specular-power", "--list", "--texture"):
            self.assertIn(option + " ", text.replace(",", " "))
        self.assertRegex(self.succeed("--version").decode(), r"\Alambent \d+\.\d+\.\d+ .*\n\Z")

    def test_missing_and_unknown_options_are_refused(self):
        self.fail_with(2)
        self.assertIn("--output", self.fail_with(2, "square.obj"))
        self.assertIn("INPUT", self.fail_with(2, "-o", "x.png"))
        self.assertIn("--nonsense", self.reject("--nonsense"))
        self.assertIn("--size", self.reject("--size"))

    def test_invalid_sizes_are_refused(self):
        for size in ("0x0", "0x5", "5x0", "-5x5", "5", "5x", "x5", "5x5x5", "axb", "5.5x5", "",
                     "nanxnan", "5 x5", "99999999999x1"):
            self.assertIn("--size", self.reject("--size", size))

    def test_sizes_beyond_memory_are_errors(self):
        line = self.fail_with(1, "square.obj", "-o", "x.png", "--size", "1000000x1000000")
        self.assertIn("1000000", line)
        self.assertIn(". Choose a smaller --size", line)
        self.assertNotIn("()", line)

    def test_numbers_are_finite_and_in_range(self):
        for option in ("--view-angle", "--parallel-scale", "--zoom", "--diffuse", "--ambient",
                       "--threads", "--supersampling", "--specular", "--specular-power", "--opacity",
                       "--line-width", "--point-size"):
            for value in ("nan", "inf", "-inf", "1e999", "-1", "one", "", "1,2", "1x"):
                self.assertIn(option, self.reject(option, value))
        for option, value in (("--view-angle", "0"), ("--view-angle", "180"),
                              ("--parallel-scale", "0"), ("--zoom", "0"), ("--diffuse", "1.1"),
                              ("--ambient", "2"), ("--threads", "0"), ("--threads", "1.5"),
                              ("--supersampling", "0"), ("--supersampling", "17"),
                              ("--supersampling", "2.5"), ("--specular", "1.5"),
                              ("--specular-power", "129"), ("--opacity", "2"),
                              ("--line-width", "0"), ("--point-size", "0")):
            self.assertIn(option, self.reject(option, value))

    def test_vectors_are_three_finite_numbers(self):
        for option in ("--camera-position", "--focal-point", "--view-up", "--direction"):
            for value in ("nan,0,0", "0,inf,0", "1,2", "1,2,3,4", "1,2,", "a,b,c", "", "1 2 3"):
                self.assertIn(option, self.reject(option, value))
        for option in ("--view-up", "--direction"):
            self.assertIn(option, self.reject(option, "0,0,0"))

    def test_invalid_colors_are_refused(self):
        for option in ("--color", "--ambient-color", "--background", "--nan-color", "--edge-color"):
            for value in ("nosuchcolour", "#12345", "#1234567", "#gggggg", "1,0", "2,0,0",
                          "-0.1,0,0", "nan,0,0", ""):
                self.assertIn(option, self.reject(option, value))

    def test_invalid_lights_are_refused(self):
        for light in ("", "0,0,1", "color=red", "position=1,2", "position=nan,0,0",
                      "direction=0,0,0", "position=0,0,1;direction=0,0,1", "position=0,0,1;size=2",
                      "position=0,0,1;intensity=-1", "position=0,0,1;intensity=inf",
                      "position=0,0,1;cone=181", "direction=0,0,1;cone=20",
                      "position=0,0,1;color=nosuchcolour", "position=0,0,1;attenuation=1"):
            self.assertIn("--light", self.reject("--light", light))

    def test_unknown_words_are_refused(self):
        self.assertIn("--shading", self.reject("--shading", "phong"))
        self.assertIn("--ambient-model", self.reject("--ambient-model", "lights"))
        self.assertIn("points, surface, wireframe", self.reject("--representation", "lines"))

    def test_contradictory_options_are_refused(self):
        self.reject("--camera-position", "0,0,5", "--direction", "0,0,1")
        self.reject("--view-angle", "20", "--parallel-scale", "2")
        self.reject("--quiet", "--verbose")

    def test_unknown_output_extensions_are_refused(self):
        for name in ("x", "x.gif", "x.png.txt", ".png", ""):
            line = self.fail_with(2, "square.obj", "-o", name)
            self.assertIn(".png .jpg", line)
            self.assertIn("'" + name + "'", line)

    def test_negative_numbers_and_any_order_are_accepted(self):
        first = self.succeed("square.obj", "-o", "-", "--size", "8x8",
                             "--camera-position", "-.5,0,-5", "--view-up", "-0.5,-1,0")
        second = self.succeed("--view-up=-0.5,-1,0", "--camera-position=-.5,0,-5",
                              "--light", "direction=0,0,1", "square.obj", "--size", "8x8",
                              "-o", "-")
        self.assertEqual(first[:8], second[:8])  # both are PNG: no option has consumed the input

    def test_an_input_may_follow_a_light(self):
        with_light_last = self.succeed("square.obj", "-o", "-", "--size", "8x8",
                                       "--light", "direction=0,0,-1")
        with_input_last = self.succeed("-o", "-", "--size", "8x8",
                                       "--light", "direction=0,0,-1", "square.obj")
        self.assertEqual(with_light_last, with_input_last)


if __name__ == "__main__":
    unittest.main()
