# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coloured light on coloured surfaces: I = rho_d I_s cos(theta), separately in each channel."""

import gallery
from lambent import vtkLambentRayTracer
from vtkmodules.vtkFiltersCore import vtkImageAppend

WHITE, RED, GREEN, BLUE, ORANGE = (1, 1, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0.5, 0)

rows = vtkImageAppend()
rows.SetAppendAxis(1)
for light in (BLUE, GREEN, RED, WHITE):  # the bottom row first
    tracer = vtkLambentRayTracer()
    for i, colour in enumerate((WHITE, RED, GREEN, BLUE, ORANGE)):
        gallery.add_surface(tracer, gallery.sphere(gallery.STEP * i), gallery.surface(*colour))
    gallery.add_light(tracer, (-1, 1, 2), light)
    gallery.show_places(tracer, 5, 128)
    rows.AddInputConnection(tracer.GetOutputPort())
gallery.save(rows, "ColouredLight.png")
