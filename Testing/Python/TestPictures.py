# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""lambent.testing without pytest: what counts as a picture, what is equal, the messages if not, and unittest
with baselines."""

import os
import re
import stat
import tempfile
import unittest

import numpy as np
from picture_suites import SuiteTest
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkImagingCore import vtkImageFlip
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera

from lambent import vtkLambentImageComparison, vtkLambentRayTracer
from lambent.testing import assert_images_equal, assert_matches_baseline
from lambent.testing.pictures import write_file

WIDTH, HEIGHT = 3, 2


def image(change=0, kind=VTK_UNSIGNED_CHAR, components=3):
    """A picture with the values 0, 10, 20 ...; green is changed in the middle of the top row."""
    picture = vtkImageData()
    picture.SetDimensions(WIDTH, HEIGHT, 1)
    picture.AllocateScalars(kind, components)
    for i in range(WIDTH * HEIGHT * components):
        value = 10 * i + (change if i == (WIDTH + 1) * components + 1 else 0)
        picture.GetPointData().GetScalars().SetValue(i, value)
    return picture


def array(change=0):
    """The same as an array, whose first row is the top one."""
    values = 10 * np.arange(WIDTH * HEIGHT * 3).reshape(HEIGHT, WIDTH, 3)[::-1]
    values[0, 1, 1] += change
    return values.astype(np.uint8)


class Equality(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = tempfile.tempdir = folder.name
        self.addCleanup(setattr, tempfile, "tempdir", None)

    def path(self, name, content=None):
        path = os.path.join(self.folder, name)
        if content is not None:
            with open(path, "wb") as file:
                file.write(content)
        return path

    def png(self, picture):
        writer = vtkPNGWriter()
        writer.SetInputData(picture)
        writer.SetFileName(self.path("some.png"))
        writer.Write()
        return writer.GetFileName()

    def message(self, *arguments, **options):
        with self.assertRaises(AssertionError) as caught:
            assert_images_equal(*arguments, **options)
        return str(caught.exception)

    def test_all_kinds_of_pictures_can_be_compared(self):
        reader = vtkPNGReader()  # a filter like any other
        reader.SetFileName(self.png(image()))
        kinds = [image(), array(), self.path("some.png"), reader]
        for one in kinds:
            for other in kinds:
                assert_images_equal(one, other)
            self.assertTrue(self.message(one, image(1)).startswith(
                "1 of 6 pixels differ, by at most 1 of 255; the first is (1, 1)\n"))
            self.assertIn("1 of 6 pixels differ", self.message(array(1), one))

    def test_grey_and_16_bit_arrays_are_compared(self):
        grey = np.array([[1, 2, 3], [4, 5, 6]], np.uint8)
        assert_images_equal(grey, grey[:, :, np.newaxis])
        self.assertIn("(0, 1)", self.message(grey, np.array([[9, 2, 3], [4, 5, 6]], np.uint8)))
        deep = np.full((2, 3, 4), 60000, np.uint16)
        assert_images_equal(deep, deep.copy())
        self.assertIn("by at most 1 of 65535", self.message(deep, deep + np.uint16(1)))

    def test_a_failure_shows_the_three_pictures(self):
        message = self.message(image(30), image())
        files = dict(re.findall(r"^  (\w+): +(\S.*)$", message, re.MULTILINE))
        self.assertEqual(list(files), ["picture", "baseline", "difference"])
        assert_images_equal(files["picture"], image(30))
        assert_images_equal(files["baseline"], image())
        expected = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
        expected[0, 1, 1] = 255
        assert_images_equal(files["difference"], expected)

    def test_failures_do_not_overwrite_one_another(self):
        messages = [self.message(image(change), image()) for change in (1, 2)]
        for change, message in zip((1, 2), messages):
            file = re.search(r"picture: +(\S.*)", message).group(1)
            assert_images_equal(file, image(change))

    def test_the_largest_difference_is_compared_with_the_tolerance(self):
        assert_images_equal(image(3), image(), tolerance=3)
        self.message(image(3), image(), tolerance=2.9)

    def test_the_root_mean_square_is_compared_with_the_tolerance(self):
        root = (3 ** 2 / 18) ** 0.5
        assert_images_equal(image(3), image(), tolerance=root * 1.0001, metric="rmse")
        self.assertIn("root mean square", self.message(
            image(3), image(), tolerance=root * 0.9999, metric="rmse"))
        self.message(image(3), image(), metric="rmse")

    def test_structural_similarity_works_or_is_refused(self):
        if vtkLambentImageComparison.HasStructuralSimilarity():
            assert_images_equal(image(1), image(), tolerance=0.5, metric="ssim")
            self.message(image(1), image(), metric="ssim")
        else:
            with self.assertRaisesRegex(RuntimeError, "VTK 9.4"):
                assert_images_equal(image(), image(), metric="ssim")

    def test_images_of_different_size_or_type_differ(self):
        wide = np.zeros((HEIGHT, WIDTH + 1, 3), np.uint8)
        message = self.message(wide, image())
        self.assertIn("the picture is 4 x 2, 3 components of unsigned char, but the baseline is "
                      "3 x 2", message)
        self.assertNotIn("difference:", message)
        self.message(image(), image(components=4))
        self.message(image(), image(kind=VTK_FLOAT))

    def test_floats_are_compared(self):
        assert_images_equal(image(kind=VTK_FLOAT), image(kind=VTK_FLOAT))
        message = self.message(image(0.25, VTK_FLOAT), image(kind=VTK_FLOAT))
        self.assertIn("by at most 0.25", message)
        self.assertNotIn("picture:", message)  # a PNG cannot hold it
        self.assertIn("difference:", message)

    def test_a_filter_may_release_its_picture_after_use(self):
        reader = vtkPNGReader()
        reader.SetFileName(self.png(image()))
        reader.ReleaseDataFlagOn()
        same = vtkImageFlip()  # along z, which has one slice
        same.SetFilteredAxis(2)
        same.SetInputConnection(reader.GetOutputPort())
        assert_images_equal(reader, same)

    def test_a_changed_filter_is_updated(self):
        tracer = vtkLambentRayTracer()
        tracer.AddInputDataObject(0, vtkPolyData())
        tracer.SetImageSize(WIDTH, HEIGHT)
        for value in (0, 255):
            tracer.SetBackground([value / 255] * 3)
            assert_images_equal(tracer, np.full((HEIGHT, WIDTH, 3), value, np.uint8))

    def test_invalid_settings_are_errors(self):
        for options, error, text in (
                ({"metric": "rsme"}, ValueError, "'rsme'; it must be one of 'max', 'rmse', 'ssim'"),
                ({"tolerance": -1}, ValueError, "-1; it must be a number, 0 or larger"),
                ({"tolerance": float("nan")}, ValueError, "nan"),
                ({"tolerance": float("inf")}, ValueError, "inf"),
                ({"tolerance": "1"}, ValueError, "'1'")):
            with self.assertRaisesRegex(error, re.escape(text)):
                assert_images_equal(image(), image(), **options)
            with self.assertRaisesRegex(error, re.escape(text)):
                assert_matches_baseline(image(), "never", **options)

    @unittest.skipUnless(hasattr(os, "mkfifo"), "needs pipes with a name")
    def test_a_pipe_is_written_to_and_not_replaced(self):
        path = self.path("pipe")
        os.mkfifo(path)
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb") as reader:
            write_file(path, b"content")
            self.assertEqual(reader.read(), b"content")
        self.assertTrue(stat.S_ISFIFO(os.stat(path).st_mode))

    def test_objects_that_are_not_images_are_refused(self):
        solid = vtkImageData()
        solid.SetDimensions(2, 2, 2)
        solid.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
        for picture, error, text in (
                (None, TypeError, "NoneType"),
                (vtkCubeSource(), TypeError, "the output of vtkCubeSource is"),
                (vtkImageData(), ValueError, "has no point scalars"),
                (solid, ValueError, "2 slices"),
                (array() / 255, TypeError, "float64"),
                (np.zeros((2, 3, 5), np.uint8), ValueError, "(2, 3, 5)"),
                (np.zeros((0, 3, 3), np.uint8), ValueError, "(0, 3, 3)"),
                (self.path("none.png"), FileNotFoundError, "none.png"),
                (self.path("text.png", b"version 1"), ValueError, "text.png' is not a PNG")):
            with self.assertRaisesRegex(error, re.escape(text)):
                assert_images_equal(picture, image())
            with self.assertRaisesRegex(error, re.escape(text)):
                assert_images_equal(image(), picture)

    def test_damaged_png_files_are_errors(self):
        with open(self.png(image()), "rb") as file:
            content = file.read()
        damaged = [content[:length] for length in range(8, len(content))]
        middle = content.index(b"IDAT") + 8
        damaged.append(content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1:])
        for content in damaged:
            with self.assertRaisesRegex(ValueError, "not a complete PNG file|the file is damaged: a check sum is wrong"):
                assert_images_equal(self.path("damaged.png", content), image())

    def test_errors_of_a_filter_are_raised(self):
        tracer = vtkLambentRayTracer()
        tracer.AddInputDataObject(0, vtkPolyData())
        tracer.SetImageSize(0, 5)
        with self.assertRaisesRegex(RuntimeError, "^vtkLambentRayTracer: .*SetImageSize"):
            assert_images_equal(tracer, image())
        tracer.RemoveAllInputConnections(0)
        with self.assertRaisesRegex(RuntimeError, "^vtkLambentRayTracer: Input port 0 .* 0 conn"):
            assert_images_equal(tracer, image())

    def test_upstream_errors_do_not_leave_an_old_picture(self):
        reader = vtkXMLPolyDataReader()
        source = vtkCubeSource()
        tracer = vtkLambentRayTracer()
        camera = vtkCamera()
        camera.SetPosition(2, 3, 4)
        tracer.SetCamera(camera)
        tracer.SetImageSize(WIDTH, HEIGHT)
        tracer.SetInputConnection(source.GetOutputPort())
        tracer.Update()
        before = vtkImageData()
        before.DeepCopy(tracer.GetOutput())
        reader.SetFileName(self.path("none.vtp"))
        tracer.SetInputConnection(reader.GetOutputPort())
        with self.assertRaisesRegex(RuntimeError, "could not be updated"):
            assert_images_equal(tracer, before)


class Baselines(SuiteTest):
    TESTS = """
        import unittest
        class Box(unittest.TestCase):
            def test_box(self):
                assert_matches_baseline(box(), "box")
        """

    def run_unittest(self, **variables):
        return self.run_python("-m", "unittest", **variables)

    def test_the_environment_variable_accepts_baselines(self):
        self.write_tests(self.TESTS)
        outcome = self.run_unittest()
        self.assertEqual(outcome.status, 1)
        self.assertIn("AssertionError: box: there is no baseline yet\n", outcome.text)
        self.assertIn("run the test with LAMBENT_UPDATE_BASELINES=1 to accept it.", outcome.text)
        drawn, = outcome.paths("picture")
        self.assertEqual(self.baselines(), [])

        outcome = self.run_unittest(LAMBENT_UPDATE_BASELINES="1")
        self.assertEqual(outcome.status, 0, outcome.text)
        self.assertIn("lambent: wrote %s/baselines/box.png (new)" % self.suite, outcome.text)
        self.assertEqual(self.baselines(), ["box.png"])
        assert_images_equal(drawn, os.path.join(self.suite, "baselines/box.png"))

        self.assertEqual(self.run_unittest().status, 0)
        outcome = self.run_unittest(LENGTH="1.5")
        self.assertEqual(outcome.status, 1)
        self.assertRegex(outcome.text, r"AssertionError: box: \d+ of 2400 pixels differ, by at")
        outcome = self.run_unittest(LENGTH="1.5", LAMBENT_UPDATE_BASELINES="1")
        self.assertIn("box.png (changed)", outcome.text)
        self.assertEqual(self.run_unittest(LENGTH="1.5").status, 0)

    def test_two_pictures_with_the_same_name_are_refused(self):
        self.write_tests(self.TESTS, """
            class Other(unittest.TestCase):
                def test_box(self):
                    assert_matches_baseline(box(2), "box")
            """)
        outcome = self.run_unittest(LAMBENT_UPDATE_BASELINES="1")
        self.assertEqual(outcome.status, 1)
        self.assertIn("has accepted another picture under this name; give each its own name", outcome.text)

    def test_only_the_value_1_accepts(self):
        self.write_tests(self.TESTS)
        for value in ("", "0", "yes"):
            self.assertEqual(self.run_unittest(LAMBENT_UPDATE_BASELINES=value).status, 1)
        self.assertEqual(self.baselines(), [])

    def test_float_pictures_are_refused_as_baselines(self):
        with self.assertRaisesRegex(ValueError, "3 of float.*SetOutputScalarTypeToUnsignedChar"):
            assert_matches_baseline(image(kind=VTK_FLOAT), "never")


if __name__ == "__main__":
    unittest.main()
