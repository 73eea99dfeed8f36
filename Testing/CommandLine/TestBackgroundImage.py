# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The background image: each kind of file is read exactly, or refused with a one-line error."""

import os
import struct
import unittest
import zlib

from TestComparing import png
from commandline import CommandTest, SQUARE, obj, read_pnm, xml_array
from pictures import read_png

# 4 x 3 pixels, all different, the top row first.
IMAGE = [[(10 * (4 * j + i), 250 - 10 * i, 200 - 50 * j) for i in range(4)] for j in range(3)]
GREY = [[(pixel[0],) for pixel in row] for row in IMAGE]
FLAT = b"".join(bytes(pixel) for row in IMAGE for pixel in row)

# A view without the square, so that only the background is visible.
AWAY = ("--camera-position", "0,0,5", "--focal-point", "100,0,5", "--supersampling", "1", "--quiet")


def png_of(rows, color_type, depth=8):
    """A PNG with any number of channels per pixel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    size = ">%d" % (len(rows[0]) * len(rows[0][0])) + ("B" if depth == 8 else "H")
    body = b"".join(b"\0" + struct.pack(size, *[v for pixel in row for v in pixel]) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(
        ">2I5B", len(rows[0]), len(rows), depth, color_type, 0, 0, 0)) +
        chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b""))


def tiff(rows, more=(), kind="B", order="<"):
    """A TIFF with one strip; `more` are tags to add or replace, with one number or several."""
    channels = len(rows[0][0])
    flat = [value for row in rows for pixel in row for value in pixel]
    data = struct.pack(order + "%d%s" % (len(flat), kind), *flat)
    tags = {256: len(rows[0]), 257: len(rows), 258: (8 * struct.calcsize(kind),) * channels, 259: 1,
            262: 2 if channels > 2 else 1, 273: 8, 277: channels, 278: len(rows), 279: len(data)}
    if kind in "fd":
        tags[339] = (3,) * channels
    tags.update(more)
    data += b"\0" * (len(data) % 2)
    values = b""
    entries = struct.pack(order + "H", len(tags))
    behind = 8 + len(data) + 2 + 12 * len(tags) + 4
    for tag, value in sorted(tags.items()):
        value = value if isinstance(value, tuple) else (value,)
        packed = struct.pack(order + "%dH" % len(value), *value)
        if len(packed) > 4:
            packed, values = struct.pack(order + "I", behind + len(values)), values + packed
        entries += struct.pack(order + "HHI", tag, 3, len(value)) + packed.ljust(4, b"\0")
    start = b"II" if order == "<" else b"MM"
    return start + struct.pack(order + "HI", 42, 8 + len(data)) + data + entries + bytes(4) + values


def tiled(rows):
    """A TIFF with one tile of 16 x 16 pixels, most of which lie outside the picture."""
    empty = (99,) * len(rows[0][0])
    tile = [row + [empty] * (16 - len(row)) for row in rows] + [[empty] * 16] * (16 - len(rows))
    return tiff(tile, {256: len(rows[0]), 257: len(rows), 322: 16, 323: 16, 324: 8,
                       325: 256 * len(empty)})


def bmp(rows, height=None, bits=24, compression=0):
    body = b"".join(b"".join(bytes(reversed(pixel)) for pixel in row).ljust((3 * len(row) + 3) // 4 * 4,
                                                                           b"\0")
                    for row in reversed(rows))
    return (b"BM" + struct.pack("<IIIIiiHHIIiiII", 54 + len(body), 0, 54, 40, len(rows[0]),
                                height or len(rows), 1, bits, compression, len(body), 0, 0, 0, 0) + body)


def vti(kind, rows, slices=1):
    values = [v for row in reversed(rows) for pixel in row for v in pixel] * slices
    extent = "0 %d 0 %d 0 %d" % (len(rows[0]) - 1, len(rows) - 1, slices - 1)
    return ('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
            '<ImageData WholeExtent="%s" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="%s">'
            '<PointData Scalars="a">%s</PointData></Piece></ImageData></VTKFile>\n' %
            (extent, extent, xml_array("a", kind, values, len(rows[0][0]))))


class BackgroundTest(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))

    def background(self, name, content=None, *arguments, size="4x3"):
        if content is not None:
            self.write(name, content)
        self.succeed("square.obj", "-o", "pixels.pnm", "--background-image", name, "--size", size,
                     *AWAY, *arguments)
        return read_pnm(self.read("pixels.pnm"))

    def refuse(self, name, content=None):
        if content is not None:
            self.write(name, content)
        line = self.fail_with(1, "square.obj", "-o", "x.png", "--background-image", name)
        self.assertIn("cannot read '%s': " % name, line)
        return line


class TestKinds(BackgroundTest):

    def test_colours_are_exact(self):
        wide = [[tuple(257 * v for v in pixel) for pixel in row] for row in IMAGE]
        floats = [[tuple(v / 255 for v in pixel) for pixel in row] for row in IMAGE]
        for name, content in (
                ("b.png", png(IMAGE)), ("wide.png", png(wide, 16)), ("b.tif", tiff(IMAGE)),
                ("b.TIFF", tiff(IMAGE)), ("big endian.tif", tiff(IMAGE, order=">")),
                ("b.bmp", bmp(IMAGE)), ("down.bmp", bmp(IMAGE[::-1], -3)),
                ("b.pnm", b"P6\n4 3\n255\n" + FLAT),
                ("b.ppm", b"P6 # comment\n4 3 # another\n255\n" + FLAT),
                ("wide.pnm", b"P6 4 3 65535 " + b"".join(struct.pack(">H", 257 * v) for v in FLAT)),
                ("b.vti", vti("UInt8", IMAGE)), ("wide.vti", vti("UInt16", wide)),
                ("floats.vti", vti("Float32", floats)), ("doubles.vti", vti("Float64", floats))):
            self.assertEqual(self.background(name, content), IMAGE, name)

    def test_grey_images_are_read(self):
        wanted = [[pixel * 3 for pixel in row] for row in GREY]
        wide = [[(257 * pixel[0],) for pixel in row] for row in GREY]
        floats = [[(pixel[0] / 255,) for pixel in row] for row in GREY]
        flat = bytes(pixel[0] for row in GREY for pixel in row)
        for name, content in (
                ("g.png", png_of(GREY, 0)), ("wide.png", png_of(wide, 0, 16)), ("g.tif", tiff(GREY)),
                ("wide.tif", tiff(wide, kind="H")), ("floats.tif", tiff(floats, kind="f")),
                ("white.tif", tiff([[(255 - p[0],) for p in row] for row in GREY], {262: 0})),
                ("g.pnm", b"P5 4 3 255\n" + flat), ("g.vti", vti("UInt8", GREY))):
            self.assertEqual(self.background(name, content), wanted, name)
        less = self.background("less.pnm", b"P5 4 3 200\n" + flat)  # 200 is white
        self.assertEqual(less, [[(min(int(255 * p[0] / 200 + 0.5), 255),) * 3 for p in row]
                                for row in GREY])

    def test_the_background_colour_shows_through_alpha(self):
        alphas = (255, 0, 51, 204)
        rgba = [[pixel + (alphas[i],) for i, pixel in enumerate(row)] for row in IMAGE]
        wide = [[tuple(257 * v for v in pixel) for pixel in row] for row in rgba]
        for name, content in (("a.png", png_of(rgba, 6)), ("a.tif", tiff(rgba, {338: 2})),
                              ("a.vti", vti("UInt8", rgba)),
                              ("wide.tif", tiff(wide, {338: 2}, "H"))):
            seen = self.background(name, content, "--background", "#204060")
            for row, wanted in zip(seen, rgba):
                for pixel, (r, g, b, a) in zip(row, wanted):
                    for value, front, behind in zip(pixel, (r, g, b), (32, 64, 96)):
                        self.assertLess(abs(value - (front * a + behind * (255 - a)) / 255), 0.51)

    def test_all_kinds_of_tiff_files_are_read(self):
        """VTK's reader misreads most of these."""
        wide = [[tuple(257 * v for v in pixel) for pixel in row] for row in IMAGE]
        floats = [[tuple(v / 255 for v in pixel) for pixel in row] for row in IMAGE]
        planes = [[(row[i][k],) for i in range(4)] for k in range(3) for row in IMAGE]
        colors = [pixel for row in wide for pixel in row] + [(9, 9, 9)] * 244
        palette = sum(zip(*colors), ())
        numbers = [[(4 * j + i,) for i in range(4)] for j in range(3)]
        more = [[pixel + (255, 7) for pixel in row] for row in IMAGE]
        for name, content in (
                ("up.tif", tiff(IMAGE[::-1], {274: 4})),
                ("left.tif", tiff([row[::-1] for row in IMAGE], {274: 2})),
                ("half turn.tif", tiff([row[::-1] for row in IMAGE[::-1]], {274: 3})),
                ("wide.tif", tiff(wide, kind="H")), ("big endian.tif", tiff(wide, (), "H", ">")),
                ("floats.tif", tiff(floats, kind="f")), ("doubles.tif", tiff(floats, kind="d")),
                ("unknown tag.tif", tiff(IMAGE, {65001: 7})),
                ("five channels.tif", tiff(more, {338: (2, 0)})), ("tiles.tif", tiled(IMAGE)),
                ("planes.tif", tiff(planes, {257: 3, 258: (8, 8, 8), 262: 2, 277: 3, 278: 3, 284: 2,
                                             273: (8, 20, 32), 279: (12, 12, 12)})),
                ("palette.tif", tiff(numbers, {262: 3, 320: palette}))):
            self.assertEqual(self.background(name, content), IMAGE, name)
        bits = self.background("bits.tif", tiff([[(0b10100000,)], [(0b01010000,)]], {256: 4, 258: 1}),
                               size="4x2")
        self.assertEqual(bits, [[(255,) * 3, (0,) * 3] * 2, [(0,) * 3, (255,) * 3] * 2])
        ink = [[tuple(255 - v for v in pixel) + (0,) for pixel in row] for row in IMAGE]
        self.assertEqual(self.background("cmyk.tif", tiff(ink, {262: 5})), IMAGE)

    def test_premultiplied_alpha_is_divided_out(self):
        """The last of 4 x 1 colours exceeds its alpha."""
        seen = self.background("m.tif", tiff([[(0, 0, 0, 0), (51, 0, 25, 51), (204, 102, 0, 204),
                                               (255, 0, 0, 51)]], {338: 1}),
                               "--background", "#204060", size="4x1")
        for pixel, wanted in zip(seen[0], (
                (32, 64, 96), (51 + 25.6, 51.2, 25 + 76.8), (210.4, 102 + 12.8, 19.2),
                (51 + 25.6, 51.2, 76.8))):
            for value, one in zip(pixel, wanted):
                self.assertLess(abs(value - one), 0.51)

    def test_jpeg_files_are_read_approximately(self):
        """The command writes the JPEG itself. JPEG is never exact."""
        self.succeed("square.obj", "-o", "b.jpg", "--size", "64x48", "--background", "0.2,0.4,0.6",
                     "--camera-position", "0,0,9", "--quiet")
        self.succeed("square.obj", "-o", "b.pnm", "--size", "64x48", "--background", "0.2,0.4,0.6",
                     "--camera-position", "0,0,9", "--quiet")
        one, other = self.background("b.jpg", size="64x48"), read_pnm(self.read("b.pnm"))
        for row, column in ((0, 0), (24, 32)):
            for value, wanted in zip(one[row][column], other[row][column]):
                self.assertLessEqual(abs(value - wanted), 2)

    def test_files_written_by_the_command_are_read(self):
        for name in ("b.png", "b.tif", "b.bmp", "b.pnm", "b.vti"):
            self.succeed("square.obj", "-o", name, "--size", "16x9", "--background", "teal")
            self.succeed("square.obj", "-o", "same.pnm", "--size", "16x9", "--background", "teal")
            self.assertEqual(self.background(name, size="16x9"), read_pnm(self.read("same.pnm")))
        self.succeed("square.obj", "-o", "b.tif", "--size", "16x9", "--alpha", "--color", "red")
        self.succeed("square.obj", "-o", "b.png", "--size", "16x9", "--alpha", "--color", "red")
        self.assertEqual(self.background("b.tif", size="16x9"), self.background("b.png", size="16x9"))

    def test_the_image_is_stretched(self):
        rows = self.background("b.png", png([[(0, 0, 0), (255, 255, 255)]]), size="8x2")
        self.assertEqual(rows[0], rows[1])
        self.assertEqual([pixel[0] for pixel in rows[0]], [0, 0, 32, 96, 159, 223, 255, 255])

    def test_each_sample_has_its_own_colour(self):
        """As README.md says: an image of the picture's size has softer edges, and one with a pixel per
        sample is averaged."""
        rows = self.background("b.png", png([[(v,) * 3 for v in (0, 0, 255, 255)]]), "--supersampling",
                               "3", size="4x1")
        self.assertEqual([pixel[0] for pixel in rows[0]], [0, 28, 227, 255])  # (0 + 0 + 1/3) / 3
        large = [[(10 * i + 3 * j,) * 3 for i in range(12)] for j in range(9)]
        mean = [[(10 * (3 * i + 1) + 3 * (3 * j + 1),) * 3 for i in range(4)] for j in range(3)]
        self.assertEqual(self.background("large.png", png(large), "--supersampling", "3"), mean)

    def test_surfaces_are_in_front(self):
        self.write("b.png", png([[(0, 0, 255)]]))
        self.succeed("square.obj", "-o", "x.png", "--background-image", "b.png", "--size", "9x9",
                     "--camera-position", "0,0,5", "--parallel-scale", "2", "--shading", "unlit")
        rows = read_png(self.read("x.png"))
        self.assertEqual((rows[4][4], rows[0][0]), ((255, 255, 255), (0, 0, 255)))


class TestColours(BackgroundTest):

    def test_a_colour_shows_only_through_an_image_with_alpha(self):
        self.write("rgb.png", png([[(0, 0, 255)]]))
        self.write("rgba.png", png_of([[(0, 0, 255, 0)]], 6))
        view = ("-o", "x.pnm", "--background", "red", "--size", "9x9", "--camera-position", "0,0,5",
                "--parallel-scale", "2")
        self.succeed("square.obj", "--background-image", "rgba.png", *view)
        self.assertEqual(read_pnm(self.read("x.pnm"))[0][0], (255, 0, 0))
        done = self.run_command("square.obj", "--background-image", "rgb.png", *view)
        self.assertEqual((done.returncode, done.stderr.decode()),
                         (0, "lambent: warning: --background has no effect, because 'rgb.png' has no alpha channel; "
                             "omit one of them\n"))
        self.assertEqual(read_pnm(self.read("x.pnm"))[0][0], (0, 0, 255))
        self.succeed("square.obj", "--background-image", "rgb.png", "--quiet", *view)


class TestRefusing(BackgroundTest):

    def test_missing_and_empty_files_are_errors(self):
        for name in ("b.png", "b.jpg", "b.tif", "b.bmp", "b.pnm", "b.vti"):
            self.assertIn("no such file", self.refuse(name))
            self.assertIn("it is empty", self.refuse(name, b""))
            self.refuse(name, b"what is this? " * 20)
            os.mkdir(self.path("folder" + name))
            self.refuse("folder" + name)

    def test_truncated_files_are_errors(self):
        self.succeed("square.obj", "-o", "b.jpg", "--size", "64x48")
        for name, content in (("c.png", png(IMAGE)), ("c.tif", tiff(IMAGE)), ("c.bmp", bmp(IMAGE)),
                              ("c.pnm", b"P6 4 3 255 " + FLAT), ("c.jpg", self.read("b.jpg"))):
            for length in (len(content) - 1, len(content) * 3 // 4, len(content) // 3, 9, 2):
                if name != "c.tif" or length < len(content) - 30:  # its last tag values are not needed
                    self.refuse(name, content[:length])

    def test_files_that_cannot_be_read_correctly_are_refused(self):
        for name, content, words in (
                ("whole.tif", tiff(GREY, kind="I"), "can not handle images with 32-bit samples"),
                ("packed.tif", tiff(GREY, {259: 65000}), "libtiff cannot read it: "),
                ("rotated.tif", tiff(IMAGE, {274: 6}),
                 "its orientation is rotated by 90 degrees; convert it to .png"),
                ("none.tif", tiff(IMAGE, {256: 0}), "libtiff cannot read it: "),
                ("large.tif", b"II+\0" + bytes(20), "libtiff cannot read it: "),
                ("deep.bmp", bmp(IMAGE, bits=32), "BMP of 32 bits per pixel"),
                ("packed.bmp", bmp(IMAGE, bits=8, compression=1), "BMP with compression"),
                ("text.pnm", b"P3 1 1 255 1 2 3\n", "not a binary PNM"),
                ("none.pnm", b"P6 0 3 255 ", "no valid size"),
                ("many.pnm", b"P6 999999999 999999999 65535 " + FLAT, "incomplete"),
                ("far.pnm", b"P5 1 1 65536 \1\1", "largest value"),
                ("half.pnm", b"P5 4", "no valid size")):
            self.assertIn(words, self.refuse(name, content), name)

    def test_unsupported_sizes_and_types_are_refused(self):
        many = [[(1, 2, 3, 4, 5)]]
        for name, content, words in (
                ("slices.vti", vti("UInt8", IMAGE, 2), "2 slices; a background image has one"),
                ("ints.vti", vti("Int32", IMAGE), "of the type int"),
                ("many.vti", vti("UInt8", many), "5 numbers per pixel"),
                ("huge.vti", vti("Float64", [[(1,), (1e300,)]]), "pixel 1 is not finite")):
            self.assertIn(words, self.refuse(name, content), name)

    def test_unknown_extensions_are_refused(self):
        line = self.fail_with(2, "square.obj", "-o", "x.png", "--background-image", "b.gif")
        self.assertIn("'b.gif' does not end in one of .png .jpg", line)

    def test_the_background_image_is_not_overwritten(self):
        self.write("b.png", png(IMAGE))
        os.symlink("b.png", self.path("link.png"))
        os.link(self.path("b.png"), self.path("hard.tif"))
        for arguments in (("-o", "b.png"), ("-o", "./b.png"), ("-o", "link.png"),
                          ("-o", "x.png", "--pass", "depth=hard.tif"),
                          ("--compare", "base.png", "--difference", "b.png")):
            line = self.fail_with(1, "square.obj", "--background-image", "b.png", *arguments)
            self.assertIn("it is the background image", line)
        self.assertEqual(self.read("b.png"), png(IMAGE))


class TestTogether(BackgroundTest):

    def setUp(self):
        super().setUp()
        self.write("it's b.png", png(IMAGE))

    def test_recreating_reads_the_image_again(self):
        draw = ("square.obj", "--background-image", "it's b.png", "--size", "20x20")
        self.succeed(*draw, "-o", "x.png")
        drawn = self.read("x.png")
        self.assertIn(b"lambent square.obj --background-image 'it'\\''s b.png' --direction", drawn)
        self.assertIn(b"all of 400 pixels are the same", self.succeed("--recreate", "x.png"))
        self.succeed("--recreate", "x.png", "-o", "y.png")
        self.assertEqual(self.read("y.png"), drawn)
        self.assertIn("it is the background image",
                      self.fail_with(1, "--recreate", "x.png", "-o", "it's b.png"))
        os.remove(self.path("it's b.png"))
        self.assertIn("cannot read 'it's b.png': there is no such file",
                      self.fail_with(1, "--recreate", "x.png", "-o", "z.png"))

    def test_baselines_do_not_store_absolute_paths(self):
        for path, is_recorded in (("it's b.png", True), (self.path("it's b.png"), False)):
            self.run_command("square.obj", "--background-image", path, "--compare", "base.png",
                             "--size", "9x9", env={**os.environ, "LAMBENT_UPDATE_BASELINES": "1"})
            self.assertEqual(b"--background-image" in self.read("base.png"), is_recorded)
            os.remove(self.path("base.png"))

    def test_a_warning_explains_invisible_or_black_surfaces(self):
        away = ("--camera-position", "0,0,5", "--focal-point", "100,0,5")
        for arguments, reason in (
                (away, "the picture shows only the background image: no face lies in the view"),
                (("--color", "black"), "the surfaces show only black: all visible faces are black"),
                (("--light", "direction=0,0,1"), "the surfaces show only black: ")):
            done = self.run_command("square.obj", "--background-image", "it's b.png", "-o", "x.png",
                                    "--size", "20x20", *arguments)
            self.assertEqual(done.returncode, 0)
            line, = done.stderr.decode().splitlines()
            self.assertIn("lambent: warning: " + reason, line)
        self.succeed("square.obj", "--background-image", "it's b.png", "-o", "x.png")


if __name__ == "__main__":
    unittest.main()
