# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders scenes with VTK's OpenGL, on Mesa's llvmpipe, on a screen of its own (Xvfb)."""

import os
import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCompositeDataDisplayAttributes, vtkCompositePolyDataMapper, vtkGlyph3DMapper, vtkPolyDataMapper,
    vtkRenderer, vtkRenderWindow)

from scene import BACKGROUNDS, SIZE, camera_of, lights_of, property_of

# The order in which Mesa's threads work does not matter to the pictures.
SOFTWARE = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe", "LP_NUM_THREADS": "2"}


class Missing(Exception):
    """A reason why OpenGL cannot be compared on this machine."""


class Screen:
    """An X server without a screen, for the time of a with statement."""

    def __enter__(self):
        if not shutil.which("Xvfb"):
            raise Missing("Xvfb is not installed")
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "640x480x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()  # empty if the server ends
        os.environ.update(SOFTWARE, DISPLAY=":" + number)
        try:
            if not number:
                raise Missing("Xvfb does not start")
            check_driver()
        except Missing:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def check_driver():
    """VTK aborts the process if there is no driver, so another one tries."""
    tried = subprocess.run([sys.executable, "-B", os.path.abspath(__file__)], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, check=False)
    if tried.returncode or b"llvmpipe" not in tried.stdout:
        raise Missing("VTK does not draw with OpenGL on Mesa's llvmpipe (libgl1-mesa-dri)")


class OpenGL:
    """One window, in which one scene after the other is rendered."""

    def __init__(self):
        import vtkmodules.vtkRenderingOpenGL2 as opengl2  # only here, since Lambent does not need it
        self.opengl2 = opengl2
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetAlphaBitPlanes(1)
        self.window.SetSize(*SIZE)
        self.window.Render()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.window.Finalize()  # before its screen ends

    def render(self, scene):
        """The pictures over both backgrounds: arrays of bytes, row 0 at the bottom."""
        renderer = vtkRenderer()
        renderer.SetTwoSidedLighting(scene.two_sided)
        renderer.SetActiveCamera(camera_of(scene))
        renderer.SetUseDepthPeeling(True)
        renderer.SetMaximumNumberOfPeels(50)
        renderer.SetOcclusionRatio(0.0)
        for light in lights_of(scene):
            renderer.AddLight(light)
        for described in scene.actors:
            actor = vtkActor()
            actor.SetProperty(property_of(described))
            actor.SetMapper(self.mapper(described))
            if described.matrix:
                actor.SetUserMatrix(described.matrix)
            if described.texture:
                actor.SetTexture(described.texture())
            renderer.AddActor(actor)
        self.window.AddRenderer(renderer)
        if "ClippingRange" not in scene.camera:
            renderer.ResetCameraClippingRange()
        try:
            return np.stack([self.picture(renderer, colour) for colour in BACKGROUNDS])
        finally:
            self.window.RemoveRenderer(renderer)

    def picture(self, renderer, background):
        renderer.SetBackground(*background)
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 3).copy()

    def mapper(self, actor):
        data = actor.data()
        mapper = self.empty_mapper(actor, data)
        mapper.SetInputDataObject(0, data)
        set_colours(mapper, actor.colours)
        if actor.blocks:
            actor.blocks(mapper.GetCompositeDataDisplayAttributes(), data)
        return mapper

    def empty_mapper(self, actor, data):
        if isinstance(data, vtkCompositeDataSet):
            old = getattr(self.opengl2, "vtkCompositePolyDataMapper2", None)  # its name before VTK 9.3
            mapper = (old or vtkCompositePolyDataMapper)()
            mapper.SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes())
        elif actor.impostors:
            mapper = self.opengl2.vtkOpenGLSphereMapper()
            mapper.SetRadius(actor.radius)
            if actor.radii:
                mapper.SetScaleArray(actor.radii)
        elif actor.radius or actor.radii:
            mapper = vtkGlyph3DMapper()
            ball = vtkSphereSource()
            ball.SetRadius(1.0)
            ball.SetThetaResolution(180)
            ball.SetPhiResolution(180)
            mapper.SetSourceConnection(ball.GetOutputPort())
            mapper.SetScaleFactor(actor.radius or 1.0)
            mapper.SetScaling(True)
            if actor.radii:
                mapper.SetScaleModeToScaleByMagnitude()
                mapper.SetScaleArray(actor.radii)
        else:
            mapper = vtkPolyDataMapper()
        return mapper


def set_colours(mapper, colours):
    mapper.SetScalarVisibility(colours is not None)
    if colours is None:
        return
    if colours.cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(colours.array)
    table = colours.table() if colours.table else mapper.GetLookupTable()
    if colours.component < 0:
        table.SetVectorModeToMagnitude()
    else:
        table.SetVectorModeToComponent()
        table.SetVectorComponent(colours.component)
    mapper.SetLookupTable(table)
    mapper.SetInterpolateScalarsBeforeMapping(colours.before)
    if colours.range:
        mapper.SetScalarRange(*colours.range)
    else:
        mapper.UseLookupTableScalarRangeOn()


if __name__ == "__main__":
    with OpenGL() as found:
        print(found.window.ReportCapabilities())
