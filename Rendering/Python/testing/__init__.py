# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Image tests: compare a picture with another one or with a baseline, exactly by default.

    from lambent.testing import assert_images_equal, assert_matches_baseline

    def test_box():
        assert_matches_baseline(tracer, "box")  # baselines/box.png beside this file

A *picture* is one of

* a vtkImageData of one slice, whose active point scalars are compared;
* a vtkAlgorithm whose first output is such an image; it is updated, and an error that it
  reports fails the test;
* the path of a PNG file;
* a NumPy array, or an object that converts to one: height x width, or height x width x 1 to 4
  components, of uint8 or uint16 in any byte order, the top row first;
* a Pillow image: grey or RGB, with or without alpha, or with a palette, whose colours are
  compared. Convert other modes (CMYK, YCbCr, HSV, LAB) to RGB.

The plugin pytest_lambent controls where the pictures of a failure go, and whether new baselines
are accepted (`--lambent-update`, `--lambent-baselines DIR`, `--lambent-report FILE`, the
fixture `lambent_baseline`). Without pytest the environment does
(LAMBENT_UPDATE_BASELINES=1). With pytest, a picture is accepted only if its test passes: not if
the test fails for another reason, is skipped, or is expected to fail (xfail,
unittest.expectedFailure). Without pytest, it is accepted immediately, unless
unittest.expectedFailure marks the test.
"""

from .assertions import assert_images_equal, assert_matches_baseline

__all__ = ["assert_images_equal", "assert_matches_baseline"]
