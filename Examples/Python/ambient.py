# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ambient reflection: I = rho_d I_s max(0, cos(theta)) + rho_a I_s, for rho_a = 0, 0.1, 0.3, 0.5, 0.7
at rho_d = 0.6."""

import gallery
from lambent import vtkLambentRayTracer

tracer = vtkLambentRayTracer()
for i, ambient in enumerate((0, 0.1, 0.3, 0.5, 0.7)):
    white = gallery.surface(1, 1, 1)
    white.SetDiffuse(0.6)
    white.SetAmbient(ambient)
    gallery.add_surface(tracer, gallery.sphere(gallery.STEP * i), white)
gallery.add_light(tracer, (-1, 1, 0.5))
gallery.show_places(tracer, 5, 192)
gallery.save(tracer, "Ambient.png")
