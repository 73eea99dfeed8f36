# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline as in ParaView, but without a window: source, filters, picture, writer. VTK's filters
connect to Lambent's. Each stage is set up once and runs when the writer requests its output."""

from lambent import vtkLambentNormals, vtkLambentRayTracer
from vtkmodules.vtkCommonDataModel import vtkQuadric
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkCamera, vtkProperty

# The source: a hyperboloid of one sheet, x^2 - y^2 + z^2 = 1/4, sampled on a grid.
quadric = vtkQuadric()
quadric.SetCoefficients(1, -1, 1, 0, 0, 0, 0, 0, 0, -0.25)
sample = vtkSampleFunction()
sample.SetImplicitFunction(quadric)
sample.SetModelBounds(-1, 1, -1, 1, -1, 1)
sample.SetSampleDimensions(33, 33, 33)
sample.ComputeNormalsOff()

# The filters: extract its surface, and compute point normals.
contour = vtkContourFilter()
contour.SetInputConnection(sample.GetOutputPort())
contour.SetValue(0, 0)
contour.ComputeNormalsOff()
normals = vtkLambentNormals()
normals.SetInputConnection(contour.GetOutputPort())

# The picture. A scene without lights gets a headlight.
camera = vtkCamera()
camera.SetPosition(2, 2, 4)
camera.SetFocalPoint(0, 0, 0)
surface = vtkProperty()
surface.SetColor(0.4, 0.8, 0.7)
surface.SetDiffuse(0.9)
surface.SetAmbient(0.1)
tracer = vtkLambentRayTracer()
tracer.SetInputConnection(normals.GetOutputPort())
tracer.SetCamera(camera)
tracer.SetProperty(surface)
tracer.SetBackground(0.1, 0.1, 0.15)
tracer.GradientBackgroundOn()
tracer.SetBackground2(0.4, 0.5, 0.6)
tracer.SetImageSize(480, 360)

# The writer, which runs the whole pipeline.
writer = vtkPNGWriter()
writer.SetInputConnection(tracer.GetOutputPort())
writer.SetFileName("pipeline.png")
writer.Write()
