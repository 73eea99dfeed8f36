# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours from data: arrays through a colour map, and colours that files have themselves."""

import base64
import math
import os
import struct
import subprocess
import unittest

from commandline import (COMMAND, CommandTest, SQUARE, obj, ply_text, vtk_text, vtp,
                         xml_array)
from pictures import read_png
from TestRecreating import COMMAND_KEY, texts, with_text

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
WHITE, RED, BLACK = (255, 255, 255), (255, 0, 0), (0, 0, 0)
VIRIDIS_0, VIRIDIS_255 = (0x44, 0x01, 0x54), (0xfd, 0xe7, 0x25)
VIEW = ("--direction", "0,0,1", "--shading", "unlit")


def with_arrays(point=(), cell=(), mesh=SQUARE, active=""):
    """A .vtp file of the mesh with arrays, each a name, a type, the values and their components."""
    data = ""
    for tag, arrays in (("PointData", point), ("CellData", cell)):
        data += "<%s%s>%s</%s>" % (tag, active, "".join(
            xml_array(name, kind, values, *components) for name, kind, values, *components in arrays),
            tag)
    return vtp(mesh, point_data=data)


def ply_with_colors(colors, mesh=SQUARE):
    """A .ply file with a colour for each vertex."""
    header, _, body = ply_text(mesh).partition("end_header\n")
    lines = body.splitlines()
    for k, color in enumerate(colors):
        lines[k] += " " + " ".join(map(str, color))
    properties = "".join("property uchar %s\n" % name for name in ("red", "green", "blue"))
    return header.replace("element face", properties + "element face") + "end_header\n" + "\n".join(
        lines) + "\n"


class ColorTest(CommandTest):

    def seen(self, *arguments):
        """The colour in the middle of an unlit picture; warnings are failures."""
        return self.center(*arguments, *VIEW)


class TestArrays(ColorTest):

    def setUp(self):
        super().setUp()
        self.write("t.vtp", with_arrays(
            point=(("t", "Float64", (0, 10, 10, 0)), ("same", "Float32", (4, 4, 4, 4)),
                   ("v", "Float32", (3, 0, 4) * 4, 3),
                   ("rgb", "UInt8", (10, 20, 30) * 4, 3), ("label", "UInt8", (7,) * 4)),
            cell=(("t", "Float64", (2, 2)), ("c", "Int32", (-5, 5)))))

    def test_numbers_are_mapped_over_the_range(self):
        for value, color in (("4,9", VIRIDIS_0), ("-1,4", VIRIDIS_255), ("5,9", VIRIDIS_0),
                             ("0,3", VIRIDIS_255)):
            self.assertEqual(self.seen("t.vtp", "--color-by", "same", "--range", value), color)
        # 4 lies in entry 102 of 256 over 0 to 10.
        gray = self.seen("t.vtp", "--color-by", "same", "--range", "0,10", "--colormap", "gray")
        self.assertEqual(gray, (102,) * 3)
        # Logarithms: 4 is in the middle of 1 to 16.
        gray = self.seen("t.vtp", "--color-by", "same", "--range", "1,16", "--colormap", "gray",
                         "--log")
        self.assertEqual(gray, (128,) * 3)

    def test_the_default_range_is_that_of_the_array(self):
        pixels = self.pixels("t.vtp", "--color-by", "t", *VIEW, "--colormap", "gray",
                             "--parallel-scale", "1")[4]
        self.assertEqual([pixel[0] for pixel in pixels], sorted(pixel[0] for pixel in pixels))
        for k, pixel in enumerate(pixels):  # the centres of the pixels are at (2 k + 1) / 18
            self.assertEqual(pixel, (int((2 * k + 1) / 18 * 256),) * 3)

    def test_maps_can_be_reversed_and_written_in_any_case(self):
        low = ("t.vtp", "--color-by", "same", "--range", "5,6", "--colormap")
        self.assertEqual(self.seen(*low, "Viridis_r"), VIRIDIS_255)
        self.assertEqual(self.seen(*low, "Cool to Warm"), (0x3b, 0x4c, 0xc0))
        self.assertEqual(self.seen(*low, "black-body"), BLACK)

    def test_components_and_magnitudes(self):
        scale = ("--range", "0,10", "--colormap", "gray")
        for name, value in (("v", 5), ("v:magnitude", 5), ("v:0", 3), ("v:1", 0), ("v:2", 4)):
            self.assertEqual(self.seen("t.vtp", "--color-by", name, *scale),
                             (int(value / 10 * 256),) * 3, name)

    def test_point_arrays_come_before_cell_arrays(self):
        scale = ("--range", "0,10", "--colormap", "gray")
        self.assertEqual(self.seen("t.vtp", "--color-by", "cell:t", *scale), (51,) * 3)
        self.assertEqual(self.seen("t.vtp", "--color-by", "t", *scale),
                         self.seen("t.vtp", "--color-by", "point:t", *scale))
        self.assertIn(self.seen("t.vtp", "--color-by", "c", "--range=-5,5", "--colormap", "gray"),
                      (BLACK, WHITE))

    def test_bytes_are_numbers_unless_they_are_colors(self):
        self.assertEqual(self.seen("t.vtp", "--color-by", "rgb"), (10, 20, 30))
        self.assertEqual(self.seen("t.vtp", "--color-by", "rgb:1", "--range", "0,256", "--colormap",
                                   "gray"), (20,) * 3)
        self.assertEqual(self.seen("t.vtp", "--color-by", "label", "--range", "0,256", "--colormap",
                                   "gray"), (7,) * 3)

    def test_nan_has_a_color_of_its_own(self):
        nan = base64.b64encode(struct.pack("<I4d", 32, *[math.nan] * 4)).decode()
        self.write("nan.vtp", vtp(SQUARE, point_data='<PointData><DataArray type="Float64" Name="nan" '
                                  'format="binary">%s</DataArray></PointData>' % nan))
        self.assertEqual(self.seen("nan.vtp", "--color-by", "nan"), (128, 0, 0))
        self.assertEqual(self.seen("nan.vtp", "--color-by", "nan", "--nan-color", "#102030"),
                         (0x10, 0x20, 0x30))

    def test_other_inputs_keep_their_color(self):
        moved = ([(x + 2, y, z) for x, y, z in SQUARE[0]], SQUARE[1])
        self.write("plain.obj", obj(moved))
        row = self.pixels("t.vtp", "plain.obj", "--color-by", "same", "--range", "5,6", "--color",
                          "red", *VIEW)[4]
        seen = [pixel for pixel in row if pixel != BLACK]
        self.assertEqual(seen, [VIRIDIS_0] * seen.count(VIRIDIS_0) + [RED] * seen.count(RED))
        self.assertGreater(min(seen.count(VIRIDIS_0), seen.count(RED)), 2)

    def test_the_light_shades_the_colors(self):
        lit = ("t.vtp", "--color-by", "rgb", "--direction", "0,0,1", "--parallel-scale", "2")
        self.assertEqual(self.center(*lit), (10, 20, 30))
        self.assertEqual(self.center(*lit, "--diffuse", "0.5"), (5, 10, 15))
        self.assertEqual(self.center(*lit, "--diffuse", "0", "--ambient", "0.5"), (5, 10, 15))

    def test_other_formats_have_arrays_too(self):
        scale = ("--color-by", "t", "--range", "0,10", "--colormap", "gray")
        text = vtk_text(SQUARE) + "POINT_DATA 4\nSCALARS t float 1\nLOOKUP_TABLE own\n5 5 5 5\n"
        self.write("a.vtk", text + "LOOKUP_TABLE own 2\n1 0 0 1 0 1 0 1\n")  # it is not used
        self.assertEqual(self.seen("a.vtk", *scale), (128,) * 3)
        # Read in a separate process, and contoured with all its arrays.
        names = ("s", "t")
        values = {"s": [0, 0, 0, 0, 1, 1, 1, 1], "t": [5] * 8}
        self.write("a.vti", '<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
                   '<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1">'
                   '<Piece Extent="0 1 0 1 0 1"><PointData>' +
                   "".join(xml_array(name, "Float32", values[name]) for name in names) +
                   "</PointData></Piece></ImageData></VTKFile>\n")
        self.assertEqual(self.seen("a.vti", "--contour", "0.5,s", *scale), (128,) * 3)


class TestFiles(ColorTest):

    ORANGE = (255, 128, 0)

    def test_colors_of_a_file_are_shown_unless_a_color_is_given(self):
        self.write("a.ply", ply_with_colors([self.ORANGE] * 4))
        self.write("a.obj", "".join("v %r %r %r 1 0.5 0\n" % point for point in SQUARE[0]) +
                   "f 1 2 3 4\n")
        self.write("a.vtp", with_arrays(point=(("c", "UInt8", self.ORANGE * 4, 3),),
                                        active=' Scalars="c"'))
        self.write("b.vtp", with_arrays(cell=(("c", "UInt8", (*self.ORANGE, 255) * 2, 4),),
                                        active=' Scalars="c"'))
        for name in ("a.ply", "a.obj", "a.vtp", "b.vtp"):
            self.assertEqual(self.seen(name), self.ORANGE, name)
            self.assertEqual(self.seen(name, "--color", "file"), self.ORANGE, name)
            self.assertEqual(self.seen(name, "--color", "white"), WHITE, name)
            self.assertEqual(self.seen(name, "--color", "red"), RED, name)

    def test_other_active_scalars_are_not_colors(self):
        for kind, values, components in (("UInt8", (7,) * 4, 1), ("Float32", (1, 0, 0) * 4, 3)):
            self.write("a.vtp", with_arrays(point=(("c", kind, values, components),),
                                            active=' Scalars="c"'))
            self.assertEqual(self.seen("a.vtp"), WHITE)

    def test_an_array_comes_before_the_colors_of_the_file(self):
        self.write("a.vtp", with_arrays(
            point=(("c", "UInt8", self.ORANGE * 4, 3), ("t", "Float32", (1, 1, 1, 1))),
            active=' Scalars="c"'))
        self.assertEqual(self.seen("a.vtp", "--color-by", "t", "--range", "2,3"), VIRIDIS_0)


class TestPictures(ColorTest):

    def setUp(self):
        super().setUp()
        self.write("t.vtp", with_arrays(point=(("t", "Float64", (1, 10, 100, 1000)),)))
        self.write("a.ply", ply_with_colors([RED, (0, 255, 0), (0, 0, 255), WHITE]))

    def test_recreating_keeps_the_colors(self):
        scenes = (("t.vtp", "--color-by", "t", "--colormap", "Cool to Warm_r", "--range", "1,500", "--log",
                   "--nan-color", "red"),
                  ("t.vtp", "--spheres", "0.001,t", "--color-by", "t:magnitude"),
                  ("a.ply",), ("a.ply", "--color", "file"), ("a.ply", "--color", "red"))
        for scene in scenes:
            self.succeed(*scene, "-o", "a.png", "--size", "40x30")
            self.succeed("--recreate", "a.png", "-o", "b.png")
            self.assertEqual(self.read("a.png"), self.read("b.png"), scene)
            self.assertIn("all of 1200 pixels are the same",
                          self.succeed(*scene, "--compare", "a.png").decode())
        for scene in (("--edges", "--edge-color", "red", "--line-width", "3"),
                      ("--specular", "0.5", "--specular-power", "20", "--opacity", "0.5"),
                      ("--representation", "points", "--point-size", "4")):
            self.succeed("t.vtp", *scene, "-o", "a.png", "--size", "8x8", "--quiet")
            self.assertIn(" " + " ".join(scene), texts(self.read("a.png"))[COMMAND_KEY])

    # Older versions of the command ignored the colours of files and recorded no colour.
    def test_pictures_without_a_stored_color_are_white(self):
        self.succeed("a.ply", "-o", "white.png", "--size", "40x30", "--color", "white")
        command = texts(self.read("white.png"))[COMMAND_KEY]
        self.assertIn(" --color white", command)
        self.write("old.png", with_text(self.read("white.png"), COMMAND_KEY,
                                        command.replace(" --color white", "")))
        self.assertIn(b"all of 1200 pixels are the same", self.succeed("--recreate", "old.png"))
        self.succeed("a.ply", "-o", "new.png", "--size", "40x30")
        self.assertIn(" --color file", texts(self.read("new.png"))[COMMAND_KEY])
        self.assertNotEqual(read_png(self.read("new.png")), read_png(self.read("white.png")))

    def test_the_report_names_array_and_range(self):
        done = self.run_command("t.vtp", "-o", "a.png", "--size", "8x8", "--color-by", "t", "--log",
                                "--verbose")
        self.assertIn("\ncolours    t from 1 to 1000, viridis, logarithmic\n", done.stderr.decode())

    def test_options_without_effect_cause_a_warning(self):
        self.write("rgb.vtp", with_arrays(point=(("rgb", "UInt8", (1, 2, 3) * 4, 3),)))
        for arguments, warning in (
                (("t.vtp", "--color-by", "t", "--color", "red"),
                 "--color has no effect, because all inputs have the array of --color-by; omit one "
                 "of them"),
                (("a.ply", "--ambient-color", "red"),
                 "--ambient-color has no effect, because colours from arrays replace it; omit it"),
                (("rgb.vtp", "--color-by", "rgb", "--colormap", "jet"),
                 "--colormap has no effect, because rgb holds colours; omit it, or choose a "
                 "component, such as --color-by rgb:0")):
            done = self.run_command(*arguments, "-o", "a.png", "--size", "8x8")
            self.assertEqual((done.returncode, done.stderr.decode()),
                             (0, "lambent: warning: %s\n" % warning))
            self.succeed(*arguments, "-o", "a.png", "--size", "8x8", "--quiet")

    def test_black_colors_are_a_reason_for_a_black_picture(self):
        for arguments in (("t.vtp", "--color-by", "t", "--range", "1e6,1e7", "--colormap", "gray"),
                          ("black.ply",)):
            self.write("black.ply", ply_with_colors([BLACK] * 4))
            done = self.run_command(*arguments, "-o", "a.png", "--size", "8x8")
            self.assertIn("the data has black colours where it is visible; try another --colormap, "
                          "--range or --color", done.stderr.decode())


class TestErrors(ColorTest):

    def setUp(self):
        super().setUp()
        self.write("t.vtp", with_arrays(point=(("temperature", "Float64", (-1, 10, 100, 1000)),
                                               ("v", "Float32", (3, 0, 4) * 4, 3))))

    def reject(self, *arguments):
        return self.fail_with(2, "t.vtp", "-o", "x.png", *arguments)

    def test_wrong_arrays_and_components(self):
        self.assertEqual(self.reject("--color-by", "temprature"),
                         "lambent: --color-by temprature: no input has such an array; the arrays of "
                         "numbers are: point:temperature, point:v")
        self.assertIn("write v, v:0 to v:2 or v:magnitude", self.reject("--color-by", "v:3"))
        self.assertIn("names no array", self.reject("--color-by", ""))
        self.assertIn("one of: point:temperature", self.reject("--spheres", "temp"))
        self.assertIn("point 0 has the value -1", self.reject("--spheres", "temperature"))

    def test_wrong_ranges(self):
        by = ("--color-by", "temperature")
        self.assertIn("write 1,5, and to reverse the colours add _r",
                      self.reject(*by, "--range", "5,1"))
        for text in ("nan,1", "1", "1,2,3", "", "0,inf"):
            self.assertIn("--range", self.reject(*by, "--range", text))
        self.assertIn("the numbers of --range must be above 0",
                      self.reject(*by, "--log", "--range", "0,1"))
        self.assertIn("temperature goes from -1 to 1000, but a logarithm needs numbers above 0; set "
                      "--range, such as --range 10,1000, or omit --log", self.reject(*by, "--log"))

    def test_wrong_maps_list_the_names(self):
        line = self.reject("--color-by", "v", "--colormap", "virdis")
        help_text = " ".join(self.succeed("--help").decode().split())
        names = line.split("the names are: ")[1].split(";")[0].split(", ")
        self.assertGreater(len(names), 15)
        self.assertIn(" ".join(names), help_text)

    def test_options_of_the_scale_need_an_array(self):
        for option in (("--colormap", "jet"), ("--range", "0,1"), ("--log",), ("--nan-color", "red")):
            line = self.reject(*option)
            self.assertIn(option[0] + ": it needs --color-by NAME; 'lambent FILE --list' shows", line)


class TestSpheres(ColorTest):

    def test_points_alone_are_drawn_without_a_warning(self):
        self.write("points.ply", ply_text(([(0, 0, 0), (4, 0, 0)], [])))
        row = self.pixels("points.ply", "--spheres", "1.2", *VIEW, "--parallel-scale", "4.5")[4]
        self.assertEqual(row, [BLACK] + [WHITE] * 3 + [BLACK] + [WHITE] * 3 + [BLACK])
        self.succeed("points.ply", "--spheres", "1", "-o", "x.png", "--size", "8x8")
        done = self.run_command("points.ply", "--spheres", "1", "-o", "x.png", "--feature-angle", "20")
        self.assertEqual(done.stderr, b"lambent: warning: --feature-angle has no effect with --spheres; "
                                      b"omit one of them\n")

    def test_spheres_that_are_not_seen_cause_a_warning(self):
        self.write("points.ply", ply_text(([(0, 0, 0), (4, 0, 0)], [])))
        done = self.run_command("points.ply", "--spheres", "1e-9", "-o", "x.png", "--zoom", "1.5")
        self.assertEqual(done.stderr, b"lambent: warning: the picture shows nothing: no sphere is hit; try "
                                      b"a larger radius in --spheres, or try without --zoom\n")

    def test_an_array_gives_the_radii(self):
        points = ([(0, 0, 0), (4, 0, 0)], [])
        self.write("points.vtp", with_arrays(point=(("r", "Float32", (0, 2)),), mesh=points))
        row = self.pixels("points.vtp", "--spheres", "r", *VIEW, "--parallel-scale", "4.5",
                          "--focal-point", "2,0,0")[4]
        self.assertEqual(row, [BLACK] * 5 + [WHITE] * 3 + [BLACK])
        self.assertEqual(self.pixels("points.vtp", "--spheres", "0.5,r", *VIEW, "--parallel-scale",
                                     "4.5", "--focal-point", "2,0,0")[4],
                         [BLACK] * 6 + [WHITE] + [BLACK] * 2)


class TestExample(CommandTest):

    def test_the_commands_of_the_readme_work(self):
        """Examples/CommandLine/colours.sh, which Rendering/CommandLine/README.md quotes."""
        self.write("engine.vtp", with_arrays(
            point=(("temperature", "Float64", (20, 90, 300, 1500)),
                   ("velocity", "Float32", (1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0), 3),
                   ("radius", "Float32", (0.1, 0.2, 0.3, 0.4)))))
        os.mkdir(self.path("bin"))
        os.symlink(COMMAND, self.path("bin/lambent"))
        done = subprocess.run(["sh", "-e", os.path.join(ROOT, "Examples/CommandLine/colours.sh")],
                              check=True, cwd=self.folder, stdout=subprocess.PIPE,
                              env={**os.environ,
                                   "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertIn("temperature", done.stdout.decode())
        for name in ("temperature.png", "flow.png", "points.png"):
            self.assertGreater(len({pixel for row in read_png(self.read(name)) for pixel in row}), 50)


if __name__ == "__main__":
    unittest.main()
