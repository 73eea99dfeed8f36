# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders scenes with Lambent."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkRenderingCore import vtkCompositeDataDisplayAttributes, vtkProperty

from lambent import vtkLambentRayTracer
from scene import BACKGROUNDS, SIZE, apply, camera_of, lights_of, property_of
import meshes


def render(scene, settings):
    """The pictures over both backgrounds, and the messages of the filter. `settings` are further ones of
    vtkLambentRayTracer."""
    tracer, messages = new_tracer()
    tracer.SetImageSize(*SIZE)
    tracer.SetTwoSidedLighting(scene.two_sided)
    tracer.SetCamera(camera_of(scene))
    for light in lights_of(scene):
        tracer.AddLight(light)
    for number, actor in enumerate(scene.actors):
        add_actor(tracer, number, actor)
    apply(tracer, settings)
    return np.stack([picture(tracer, colour) for colour in BACKGROUNDS]), messages


def new_tracer():
    tracer, messages = vtkLambentRayTracer(), []

    def note(_caller, _event, text):
        if text not in messages:
            messages.append(text)

    note.CallDataType = VTK_STRING
    for event in ("WarningEvent", "ErrorEvent"):
        tracer.AddObserver(event, note)
        tracer.GetExecutive().AddObserver(event, note)
    return tracer, messages


def picture(tracer, background):
    tracer.SetBackground(*background)
    tracer.Update()
    colours = tracer.GetOutput().GetPointData().GetScalars()
    if colours is None:  # after an error; the messages say why
        return np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    return vtk_to_numpy(colours).reshape(SIZE[1], SIZE[0], 3).copy()


def add_actor(tracer, number, actor):
    data = actor.data()
    producer = vtkTrivialProducer()
    producer.SetOutput(data)
    tracer.AddInputConnection(producer.GetOutputPort())
    tracer.SetInputProperty(number, property_of(actor))
    if actor.matrix:
        tracer.SetInputTransform(number, actor.matrix)
    if actor.blocks:
        attributes = vtkCompositeDataDisplayAttributes()
        actor.blocks(attributes, data)
        tracer.SetInputBlockAttributes(number, attributes)
    if actor.texture:
        tracer.SetInputTexture(number, actor.texture())
    if actor.radius:
        tracer.SetInputSphereRadius(number, actor.radius)
    if actor.radii:
        tracer.SetInputSphereRadiusArray(number, actor.radii)
    if actor.colours:
        set_colours(tracer, number, actor.colours)


def set_colours(tracer, number, colours):
    tracer.SetInputScalarVisibility(number, True)
    association = (vtkDataObject.FIELD_ASSOCIATION_CELLS if colours.cells
                   else vtkDataObject.FIELD_ASSOCIATION_POINTS)
    tracer.SetInputColorArray(number, association, colours.array)
    tracer.SetInputColorComponent(number, colours.component)
    tracer.SetInputInterpolateScalarsBeforeMapping(number, colours.before)
    if colours.table:
        tracer.SetInputLookupTable(number, colours.table())
    if colours.range:
        tracer.SetInputScalarRange(number, *colours.range)


def accepts(**values):
    """Whether these settings of vtkProperty cause no warning."""
    tracer, messages = new_tracer()
    tracer.SetInputData(meshes.layers())
    tracer.SetProperty(apply(vtkProperty(), values))
    tracer.Update()
    return not messages


# Features that may be missing, and how to find out.
FEATURES = {
    "opacity": lambda: accepts(Opacity=0.5),
    "specular": lambda: accepts(Specular=0.5),
    "edges": lambda: accepts(EdgeVisibility=True),
    "lines": lambda: accepts(Representation=1),
    "textures": lambda: hasattr(vtkLambentRayTracer, "SetInputTexture"),
}


def missing_features():
    return {name for name, is_there in FEATURES.items() if not is_there()}
