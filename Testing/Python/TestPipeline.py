# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of a pipeline renders what it says: a hyperboloid of one sheet in front of a gradient.

    TestPipeline.py SCRIPT
"""

import os
import runpy
import sys
import tempfile

from vtkmodules.vtkIOImage import vtkPNGReader

script = os.path.abspath(sys.argv[1])
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)
runpy.run_path(script)

reader = vtkPNGReader()
reader.SetFileName("pipeline.png")
reader.Update()
image = reader.GetOutput()
os.chdir("/")
assert image.GetDimensions() == (480, 360, 1), image.GetDimensions()


def pixel(x, y):
    return tuple(image.GetScalarComponentAsDouble(x, y, 0, c) for c in range(3))


def near(a, b):
    return all(abs(p - q) <= 2 for p, q in zip(a, b))


# The background at the left edge, by height: Background at the bottom, Background2 at the top.
for y in (0, 90, 180, 270, 359):
    t = (y + 0.5) / 360
    expected = [255 * ((1 - t) * b + t * b2) for b, b2 in zip((0.1, 0.1, 0.15), (0.4, 0.5, 0.6))]
    assert near(pixel(0, y), expected), (y, pixel(0, y), expected)

# In the middle, the ray from (2, 2, 4) to the origin hits x^2 - y^2 + z^2 = 1/4 at s (2, 2, 4) with
# 16 s^2 = 1/4. The normal there is along (2, -2, 4), so s.m = (4 - 4 + 16) / 24.
cosine = 16 / 24
expected = [255 * c * (0.9 * cosine + 0.1) for c in (0.4, 0.8, 0.7)]
assert near(pixel(240, 180), expected), (pixel(240, 180), expected)
