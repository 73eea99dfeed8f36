# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""One cylinder of 16 sides, flat (left) and smooth, with interpolated point normals (right)."""

import gallery
from lambent import vtkLambentRayTracer
from vtkmodules.vtkFiltersSources import vtkCylinderSource

tracer = vtkLambentRayTracer()
for smooth in (False, True):
    cylinder = vtkCylinderSource()  # has normals, and separate points for its caps
    cylinder.SetResolution(16)
    cylinder.SetRadius(0.9)
    cylinder.SetHeight(1.8)
    cylinder.SetCenter(1.25 if smooth else -1.25, 0, 0)

    blue = gallery.surface(0.6, 0.8, 1)
    if smooth:
        blue.SetInterpolationToPhong()
    else:
        blue.SetInterpolationToFlat()
    blue.SetDiffuse(0.9)
    blue.SetAmbient(0.1)
    gallery.add_surface(tracer, gallery.on_grid(cylinder), blue)
gallery.add_light(tracer, (-2, 3, 2.5))
gallery.look_from(tracer, (0, 2.5, 5.5), 640, 360)
gallery.save(tracer, "FlatAndSmooth.png")
