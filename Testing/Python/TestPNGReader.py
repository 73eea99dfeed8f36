# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkLambentPNGReader gives the same result as vtkPNGReader, for PNG files of all kinds."""

import os
import random
import struct
import tempfile
import unittest
import zlib

from vtkmodules.vtkIOImage import vtkPNGReader

from lambent import vtkLambentPNGReader

WIDTH, HEIGHT = 11, 6
GREY, RGB, PALETTE, GREY_ALPHA, RGBA = 0, 2, 3, 4, 6
CHANNELS = {GREY: 1, RGB: 3, PALETTE: 1, GREY_ALPHA: 2, RGBA: 4}
DEPTHS = {GREY: (1, 2, 4, 8, 16), RGB: (8, 16), PALETTE: (1, 2, 4, 8), GREY_ALPHA: (8, 16),
          RGBA: (8, 16)}
ADAM7 = ((0, 8, 0, 8), (4, 8, 0, 8), (0, 4, 4, 8), (2, 4, 0, 4), (0, 2, 2, 4), (1, 2, 0, 2),
         (0, 1, 1, 2))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def packed(values, depth):
    """A row of samples with this number of bits each, after the byte for no filter."""
    bits = "".join(format(value, "0%db" % depth) for value in values)
    bits += "0" * (-len(bits) % 8)
    return b"\0" + bytes(int(bits[k:k + 8], 2) for k in range(0, len(bits), 8))


def png(colour, depth, is_interlaced=False, transparency=b""):
    random.seed(depth)
    channels = CHANNELS[colour]
    rows = [[[random.randrange(1 << depth) for _ in range(channels)] for _ in range(WIDTH)]
            for _ in range(HEIGHT)]
    body = b""
    for x, dx, y, dy in ADAM7 if is_interlaced else ((0, 1, 0, 1),):
        for row in rows[y::dy]:
            if row[x::dx]:
                body += packed([value for pixel in row[x::dx] for value in pixel], depth)
    content = chunk(b"IHDR", struct.pack(">2I5B", WIDTH, HEIGHT, depth, colour, 0, 0, is_interlaced))
    content += chunk(b"gAMA", struct.pack(">I", 45455))
    if colour == PALETTE:
        content += chunk(b"PLTE", bytes(random.randrange(256) for _ in range(3 << depth)))
    if transparency:
        content += chunk(b"tRNS", transparency)
    content += chunk(b"tEXt", b"Title\0a picture") + chunk(b"zTXt", b"Long\0\0" + zlib.compress(b"x" * 99))
    return (b"\x89PNG\r\n\x1a\n" + content + chunk(b"IDAT", zlib.compress(body)) +
            chunk(b"tEXt", b"Last\0behind the pixels") + chunk(b"IEND", b""))


class Kinds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "some.png")

    def read(self, reader, content):
        with open(self.path, "wb") as file:
            file.write(content)
        reader.SetFileName(self.path)
        reader.Update()
        image = reader.GetOutput()
        scalars = image.GetPointData().GetScalars()
        return (image.GetExtent(), image.GetSpacing(), image.GetOrigin(), scalars.GetName(),
                scalars.GetDataTypeAsString(), scalars.GetNumberOfComponents(),
                bytes(memoryview(scalars)))

    def expect_the_same(self, *kind, **options):
        content = png(*kind, **options)
        reader = vtkLambentPNGReader()
        self.assertEqual(self.read(reader, content), self.read(vtkPNGReader(), content),
                         (kind, options))
        self.assertEqual([reader.GetText(key) for key in ("Title", "Long", "Last", "None")],
                         ["a picture", "x" * 99, "behind the pixels", None])

    def test_all_colour_types_are_read(self):
        for colour, depths in DEPTHS.items():
            for depth in depths:
                for is_interlaced in (False, True):
                    self.expect_the_same(colour, depth, is_interlaced)

    def test_transparent_colours_are_read(self):
        for depth in DEPTHS[GREY]:
            self.expect_the_same(GREY, depth, transparency=struct.pack(">H", 1))
        for depth in DEPTHS[RGB]:
            self.expect_the_same(RGB, depth, transparency=struct.pack(">3H", 1, 2, 3))
        for depth in DEPTHS[PALETTE]:
            self.expect_the_same(PALETTE, depth, transparency=b"\x07")


if __name__ == "__main__":
    unittest.main()
