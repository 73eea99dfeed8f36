# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by the examples of the gallery; Examples/Gallery/Gallery.h explains them."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkProperty

STEP = 2.5  # between neighbouring objects in a row


def on_grid(source):
    """The output of a source, with points and normals rounded to multiples of 2^-12, so that they
    do not depend on the platform's sine."""
    source.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(source.GetOutput())
    for array in (mesh.GetPoints().GetData(), mesh.GetPointData().GetNormals()):
        if array:
            values = vtk_to_numpy(array)
            values[:] = np.floor(values.astype(float) * 4096 + 0.5) / 4096
    return mesh


def sphere(x, y=0, resolution=48):
    """A unit sphere about (x, y, 0) with point normals."""
    source = vtkSphereSource()
    source.SetRadius(1)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution // 2 + 1)
    source.SetCenter(x, y, 0)
    return on_grid(source)


def surface(*colour):
    prop = vtkProperty()
    prop.SetColor(colour)  # both diffuse and ambient
    return prop


def add_surface(tracer, mesh, prop):
    """Add a mesh with its own property to the scene."""
    connection = tracer.GetNumberOfInputConnections(0)
    tracer.AddInputDataObject(0, mesh)
    tracer.SetInputProperty(connection, prop)


def add_light(tracer, position, colour=(1, 1, 1)):
    """Add an infinitely distant light that shines from this direction."""
    light = vtkLight()
    light.SetPosition(position)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(colour)
    tracer.AddLight(light)


def show_places(tracer, columns, pixels):
    """Show a row of places, STEP apart, the first about the origin, each `pixels` pixels wide."""
    x = STEP * (columns - 1) / 2
    camera = vtkCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(STEP / 2)
    camera.SetFocalPoint(x, 0, 0)
    camera.SetPosition(x, 0, 10)
    tracer.SetCamera(camera)
    tracer.SetImageSize(columns * pixels, pixels)
    tracer.SetSupersampling(3)  # smooth edges
    tracer.SetBackground(0.25, 0.25, 0.25)


def look_from(tracer, position, width, height):
    """Look at the origin from this position, with a view angle of 30 degrees."""
    camera = vtkCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewAngle(30)
    tracer.SetCamera(camera)
    tracer.SetImageSize(width, height)
    tracer.SetSupersampling(3)
    tracer.SetBackground(0.25, 0.25, 0.25)


def save(picture, name):
    """Write the output of an algorithm to the PNG file that the first argument names, or else to
    `name`."""
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else name)
    writer.Write()
    if writer.GetErrorCode():
        sys.exit("could not write " + writer.GetFileName())
