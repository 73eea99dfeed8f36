# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Diffuse reflection: I = rho_d I_s cos(theta), for rho_d = 0, 0.2, 0.4, 0.6, 0.8, 1."""

import gallery
from lambent import vtkLambentRayTracer

tracer = vtkLambentRayTracer()
for i in range(6):
    white = gallery.surface(1, 1, 1)
    white.SetDiffuse(i / 5)
    gallery.add_surface(tracer, gallery.sphere(gallery.STEP * i), white)
gallery.add_light(tracer, (-1, 1, 2))
gallery.show_places(tracer, 6, 160)
gallery.save(tracer, "Diffuse.png")
