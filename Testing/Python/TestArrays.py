# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""lambent.testing: arrays of all types and layouts, Pillow images (skipped without Pillow), and invalid
settings."""

import os
import re
import tempfile
import unittest
from fractions import Fraction

import numpy as np

from lambent.testing import assert_images_equal, assert_matches_baseline
from lambent.testing.pictures import as_image, png_of

try:
    from PIL import Image
except ImportError:
    Image = None

RED, BLUE, GREEN = (255, 0, 0), (0, 0, 255), (0, 255, 0)


class PictureTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = tempfile.tempdir = folder.name
        self.addCleanup(setattr, tempfile, "tempdir", None)

    def differ(self, one, other):
        with self.assertRaises(AssertionError) as caught:
            assert_images_equal(one, other)
        return str(caught.exception)

    def refuse(self, picture, error, words):
        with self.assertRaisesRegex(error, re.escape(words)):
            assert_images_equal(picture, np.zeros((2, 2, 3), np.uint8))


class Arrays(PictureTest):
    GREY = np.array([[1, 256, 3], [65535, 5, 770]], np.uint16)

    def test_byte_order_does_not_matter(self):
        for order in "<>=":
            array = self.GREY.astype(order + "u2")
            assert_images_equal(array, self.GREY)
            self.assertIn("by at most 1 of 65535", self.differ(array, self.GREY ^ 1))
        self.assertEqual(as_image(self.GREY.astype(">u2")).GetScalarComponentAsDouble(1, 1, 0, 0), 256)

    def test_memory_layout_does_not_matter(self):
        whole = np.arange(5 * 7 * 3, dtype=np.uint8).reshape(5, 7, 3)
        read_only = whole.copy()
        read_only.flags.writeable = False
        one_row = whole[:1].copy()
        one_row.flags.writeable = False
        padded = np.zeros((5, 9, 4), np.uint8)
        padded[:, 1:8, :3] = whole
        for array in (read_only, np.asfortranarray(whole), padded[:, 1:8, :3],
                      whole[::-1].copy()[::-1], whole[:, ::-1].copy()[:, ::-1],
                      np.ma.masked_array(whole), memoryview_of(whole)):
            assert_images_equal(array, whole)
        assert_images_equal(one_row, whole[:1])
        assert_images_equal(np.broadcast_to(np.uint8(9), (5, 7, 3)), np.full((5, 7, 3), 9, np.uint8))

    def test_the_array_is_neither_changed_nor_kept(self):
        array = self.GREY.astype(">u2")
        image = as_image(array)
        self.assertEqual(array.dtype.str, ">u2")
        array[:] = 0
        assert_images_equal(image, self.GREY)

    def test_arrays_that_are_not_images_are_refused(self):
        for kind in ("f2", ">f4", "f8", "i1", "i2", "i4", "u4", "u8", "bool", "c8", "O", "S1", "M8[s]"):
            array = np.zeros((2, 2, 3)).astype(kind)
            self.refuse(array, TypeError, "values are %s; they must be uint8" % array.dtype)
        self.refuse(np.zeros((2, 2), [("r", "u1"), ("g", "u1")]), TypeError, "('r', 'u1')")
        self.refuse(np.ma.masked_equal(np.eye(2, dtype=np.uint8), 0), ValueError, "masked; fill them")
        self.refuse(np.uint8(3), ValueError, "shape is ()")
        self.refuse(np.zeros(3, np.uint8), ValueError, "shape is (3,)")


def memoryview_of(array):
    """An object that returns its array on request."""
    class Giving:
        __array_interface__ = array.__array_interface__
        kept = array
    return Giving()


@unittest.skipUnless(Image, "there is no Pillow")
class Pillow(PictureTest):
    def palette(self, *colours, transparency=None, pixels=(0, 1, 1, 0)):
        image = Image.new("P", (2, 2))
        image.putdata(pixels)
        image.putpalette([value for colour in colours for value in colour])
        if transparency is not None:
            image.info["transparency"] = transparency
        return image

    def colours(self, *colours):
        return np.array(colours, np.uint8).reshape(2, 2, -1)

    def test_palettes_are_compared_by_colour(self):
        red_blue = self.palette(RED, BLUE)
        assert_images_equal(red_blue, self.colours(RED, BLUE, BLUE, RED))
        self.differ(red_blue, self.palette(BLUE, RED))  # the same indices
        assert_images_equal(red_blue, self.palette(GREEN, BLUE, RED, pixels=(2, 1, 1, 2)))

    def test_transparent_colours_become_alpha(self):
        for transparency in (1, b"\xff\x00"):
            assert_images_equal(self.palette(RED, BLUE, transparency=transparency),
                                self.colours(RED + (255,), BLUE + (0,), BLUE + (0,), RED + (255,)))
        image = Image.new("RGB", (2, 2), RED)
        image.info["transparency"] = RED
        assert_images_equal(image, self.colours(*4 * (RED + (0,),)))
        image = Image.new("L", (2, 2), 7)
        image.info["transparency"] = 7
        assert_images_equal(image, self.colours(*4 * ((7, 0),)))

    def test_colour_modes_are_supported(self):
        for mode, value in (("L", (200,)), ("LA", (200, 9)), ("RGB", RED), ("RGBA", RED + (9,))):
            image = Image.new(mode, (2, 2), value if len(value) > 1 else value[0])
            assert_images_equal(image, self.colours(*4 * (value,)))
        assert_images_equal(Image.new("1", (2, 2), 1), self.colours(*4 * ((255,),)))
        wide = np.full((2, 2), 770, np.uint16)
        assert_images_equal(Image.fromarray(wide), wide)
        swapped = Image.frombytes("I;16B", (2, 2), wide.astype(">u2").tobytes())
        assert_images_equal(swapped, wide)

    def test_files_read_by_pillow_are_equal(self):
        path = os.path.join(self.folder, "palette.png")
        self.palette(RED, BLUE, transparency=1).save(path)
        with Image.open(path) as image:
            self.assertEqual(image.mode, "P")
            assert_images_equal(image, path)
        for mode in ("1", "L", "LA", "RGB", "RGBA"):
            Image.new(mode, (2, 2), 1).save(path)
            with Image.open(path) as image:
                assert_images_equal(image, path)

    def test_other_colour_spaces_are_refused(self):
        for mode in ("CMYK", "YCbCr", "HSV", "LAB"):
            image = Image.new(mode, (2, 2))
            self.refuse(image, TypeError, "the image's mode is %s; convert it to RGB" % mode)
        assert_images_equal(Image.new("CMYK", (2, 2), (0, 255, 255, 0)).convert("RGB"),
                            self.colours(*4 * (RED,)))
        self.refuse(Image.new("F", (2, 2)), TypeError, "float32")
        self.refuse(Image.new("I", (2, 2)), TypeError, "int32")


class Settings(PictureTest):
    IMAGE = np.zeros((2, 2, 3), np.uint8)

    def test_unknown_metrics_are_refused(self):
        for metric in ([], {}, None, 1, ["max"], np.zeros(2), b"max", "MAX"):
            words = re.escape("the metric is %r; it must be one of 'max', 'rmse', 'ssim'" % (metric,))
            with self.assertRaisesRegex(ValueError, words):
                assert_images_equal(self.IMAGE, self.IMAGE, metric=metric)
            with self.assertRaisesRegex(ValueError, words):
                assert_matches_baseline(self.IMAGE, "never", metric=metric)

    def test_only_numbers_are_accepted_as_tolerance(self):
        for tolerance in ([], None, 1j, 10 ** 400, -1, float("nan"), np.zeros(2)):
            with self.assertRaisesRegex(ValueError, "the tolerance is .*; it must be a number, 0 or larger"):
                assert_images_equal(self.IMAGE, self.IMAGE, tolerance=tolerance)
        for tolerance in (1, np.float32(1), np.int64(1), Fraction(1), True):
            assert_images_equal(self.IMAGE, self.IMAGE + np.uint8(1), tolerance=tolerance)


class Baselines(PictureTest):
    def test_a_baseline_is_not_compared_with_itself(self):
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "baselines")
        self.assertFalse(os.path.exists(folder))
        missing = os.path.join(folder, "none.png")  # nor created from itself
        link = os.path.join(self.folder, "link.png")
        os.symlink(missing, link)
        for path in (missing, os.path.relpath(missing), link, os.fsencode(link)):
            with self.assertRaisesRegex(ValueError, "is the baseline itself"):
                assert_matches_baseline(path, "none")

    def test_paths_that_are_not_png_files_are_errors(self):
        for path in (self.folder, "/dev/null"):
            with self.assertRaisesRegex(ValueError, "'%s' cannot be read: it is " % path):
                assert_images_equal(path, path)
        path = os.path.join(self.folder, "cut.png")
        with open(path, "wb") as file:
            file.write(png_of(as_image(Settings.IMAGE))[:-5])
        with self.assertRaisesRegex(ValueError, "'%s' cannot be read: it is not a complete PNG file" % path):
            assert_images_equal(path, path)


if __name__ == "__main__":
    unittest.main()
