# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Changes of scenes that remove known differences between the two renderers."""

from dataclasses import replace

import numpy as np
from vtkmodules.vtkRenderingCore import VTK_LIGHT_TYPE_SCENE_LIGHT

import materials
from meshes import add, points_of
from scene import Actor, camera_of, matrix, with_data, with_property


def filtered(new, **values):
    """The data goes through a filter of VTK."""

    def apply(data):
        algorithm = new()
        for name, value in values.items():
            getattr(algorithm, "Set" + name)(value)
        algorithm.SetInputData(data)
        algorithm.Update()
        return algorithm.GetOutput()

    return lambda scene: with_data(scene, apply)


def with_actor(**values):
    """The only actor has other settings."""
    return lambda scene: replace(scene, actors=[replace(scene.actors[0], **values)])


def with_logarithms(scene):
    """The logarithms of an array on a linear scale, instead of the array on a logarithmic one."""

    def change(data):
        values = np.array([data.GetPointData().GetArray("positive").GetValue(k)
                           for k in range(data.GetNumberOfPoints())])
        add(data.GetPointData(), "logarithm", np.log10(values))
        return data

    actor, = scene.actors
    colours = replace(actor.colours, array="logarithm", range=tuple(np.log10(actor.colours.range)),
                      table=lambda: materials.table(HueRange=(0.66, 0.0)))
    return with_data(with_actor(colours=colours)(scene), change)


def with_range_of_array(scene):
    actor, = scene.actors
    heights = actor.data().GetPointData().GetArray(actor.colours.array).GetRange()
    return with_actor(colours=replace(actor.colours, range=heights))(scene)


def with_range_above(scene):
    return with_actor(colours=replace(scene.actors[0].colours, range=(1000, 1001)))(scene)


def with_light_of_scene(scene):
    """A light at the camera, instead of the headlight."""
    camera = camera_of(scene)
    return replace(scene, lights=({"LightType": VTK_LIGHT_TYPE_SCENE_LIGHT, "Position": camera.GetPosition(),
                                   "FocalPoint": camera.GetFocalPoint()},))


def with_specular_as_diffuse(scene):
    return replace(scene, lights=[{**each, "SpecularColor": each["DiffuseColor"]} for each in scene.lights])


def from_far(scene):
    """The camera of a parallel view, a thousand times as far away."""
    camera = camera_of(scene)
    camera.Dolly(0.001)
    return replace(scene, camera={**scene.camera, "Position": camera.GetPosition()})


def without_clipping(scene):
    return replace(scene, camera={name: value for name, value in scene.camera.items() if name != "ClippingRange"})


def unlit(scene):
    return with_property(scene, Lighting=False)


def towards_the_eye(scene, actor):
    """The actor, slightly closer to the eye, where it looks the same."""
    share = 0.01
    x, y, z = (share * each for each in camera_of(scene).GetPosition())
    return replace(actor, matrix=matrix(1 - share, 0, 0, x, 0, 1 - share, 0, y, 0, 0, 1 - share, z))


def with_last_in_front(scene):
    return replace(scene, actors=scene.actors[:-1] + [towards_the_eye(scene, scene.actors[-1])])


def with_vertices_in_front(scene):
    """The vertices of a surface are an actor of their own."""
    actor, = scene.actors
    vertices = Actor(actor.data, {"Representation": 0, "Lighting": False, "Color": actor.property["VertexColor"],
                                  "PointSize": actor.property["PointSize"]})
    return replace(with_property(scene, VertexVisibility=False),
                   actors=[actor, towards_the_eye(scene, vertices)])


def with_normals_to_the_eye(scene):
    def change(data):
        array = data.GetPointData().GetNormals()
        normals = np.array([array.GetTuple(k) for k in range(array.GetNumberOfTuples())])
        is_away = ((points_of(data) - camera_of(scene).GetPosition()) * normals).sum(1) > 0
        normals[is_away] *= -1
        data.GetPointData().SetNormals(add(data.GetPointData(), "Normals", normals.astype(np.float32)))
        return data

    return with_data(scene, change)
