# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as tests: equal to one another or to an accepted one, exactly unless told otherwise.

    from lambent.testing import assert_images_equal, assert_matches_baseline

    def test_box():
        assert_matches_baseline(tracer, "box")  # baselines/box.png beside this file

A *picture* is one of

* a vtkImageData of one slice, of which the active point scalars are compared;
* a vtkAlgorithm whose first output is one; it is updated, and an error that it reports
  fails the test;
* the path of a PNG file;
* a NumPy array, or what gives one: height x width, or height x width x 1 to 4 components, of
  uint8 or uint16 in any order of bytes, the top row first;
* a Pillow image: grey, RGB, with or without alpha, or of a palette, which is compared by its
  colours. Convert others (CMYK, YCbCr, HSV, LAB) to RGB.

The names that lead a failure to its pictures, and the way to accept a new one, come from
the run of tests: with pytest from the plugin pytest_lambent (`--lambent-update`,
`--lambent-baselines DIR`, `--lambent-report FILE`, the fixture `lambent_baseline`),
otherwise from the environment (LAMBENT_UPDATE_BASELINES=1). A picture is accepted only if its
test passes: not in one that fails otherwise, is skipped, or is expected to fail (xfail,
unittest.expectedFailure).
"""

from .assertions import assert_images_equal, assert_matches_baseline

__all__ = ["assert_images_equal", "assert_matches_baseline"]
