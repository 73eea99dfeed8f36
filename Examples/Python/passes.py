# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Passes as NumPy arrays: the picture, its depth as grey, white where the surface is nearest, and
its normal m as the colour (1 + m) / 2."""

import gallery
import numpy as np
from lambent import vtkLambentRayTracer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource

ring = vtkSuperquadricSource()
ring.ToroidalOn()
ring.SetThetaResolution(64)
ring.SetPhiResolution(32)
ring.SetSize(1.25)
ring.SetThickness(0.25)
orange, blue = gallery.surface(1, 0.7, 0.3), gallery.surface(0.5, 0.8, 1)
for surface in (orange, blue):
    surface.SetDiffuse(0.85)
    surface.SetAmbient(0.15)

tracer = vtkLambentRayTracer()
gallery.add_surface(tracer, gallery.on_grid(ring), orange)
gallery.add_surface(tracer, gallery.sphere(0), blue)
gallery.add_light(tracer, (1, 3, 3))
gallery.look_from(tracer, (2, 2.5, 5), 240, 240)

# Row 0 is at the bottom. Values are NaN where no surface is hit.
tracer.GenerateNormalsOn()
tracer.GenerateDepthOn()
tracer.Update()
depth = vtk_to_numpy(tracer.GetOutput().GetPointData().GetArray("Depth")).reshape(240, 240)
normals = vtk_to_numpy(tracer.GetOutput().GetPointData().GetArray("Normals")).reshape(240, 240, 3)

near, far = np.nanmin(depth.astype(float)), np.nanmax(depth.astype(float))
nearness = 1 - 0.8 * (depth.astype(float) - near) / (far - near)
both = vtkImageAppend()
both.AddInputConnection(tracer.GetOutputPort())
for values in (np.dstack([nearness] * 3), (1 + normals.astype(float)) / 2):
    pixels = np.where(np.isnan(values), 64, np.floor(255 * values + 0.5)).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(240, 240, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    both.AddInputData(image)
gallery.save(both, "Passes.png")
