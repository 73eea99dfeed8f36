# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

from lambent import vtkLambentRayTracer
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkProperty

mesh = vtkXMLPolyDataReader()
mesh.SetFileName("Data/seashell.vtp")

camera = vtkCamera()
camera.SetPosition(0, 0, 7.25)
camera.SetFocalPoint(0, 0, 0)

evening = vtkLight()  # infinitely far away, like the sun
evening.SetPosition(-5, 6, 7)
evening.SetColor(1, 0.7, 0.4)

sky = vtkLight()
sky.SetPosition(7, -1, 2.5)
sky.SetColor(0.2, 0.4, 1)

surface = vtkProperty()
surface.SetDiffuse(0.95)
surface.SetAmbient(0.05)

tracer = vtkLambentRayTracer()
tracer.SetInputConnection(mesh.GetOutputPort())
tracer.SetProperty(surface)
tracer.SetFeatureAngle(180)  # smooth everywhere: its ribs are round
tracer.SetCamera(camera)
tracer.AddLight(evening)
tracer.AddLight(sky)
tracer.SetImageSize(960, 540)
tracer.SetSupersampling(3)  # 3 x 3 samples per pixel: smooth edges

writer = vtkPNGWriter()
writer.SetInputConnection(tracer.GetOutputPort())
writer.SetFileName("seashell.png")
writer.Write()
