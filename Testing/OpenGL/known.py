# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Known differences between the two renderers. README.md describes them.

Most entries change the scene or the settings of one side, so that what remains must be the same; without the change
it must differ. An entry with a limit allows this many pixels to differ by at most so much; some must.
"""

from dataclasses import dataclass, field, replace
from typing import Callable, Optional

import numpy as np
from vtkmodules.vtkFiltersCore import vtkReverseSense, vtkTriangleFilter

from vtkmodules.vtkRenderingCore import VTK_LIGHT_TYPE_SCENE_LIGHT

import materials
from lambent import vtkLambentNormals, vtkLambentRayTracer
from meshes import add, in_reverse_order, without_ghosts
from scene import camera_of, with_data, with_property


@dataclass
class Known:
    reason: str
    opengl: Optional[Callable] = None  # changes the scene that OpenGL renders
    lambent: Optional[Callable] = None  # changes the scene that Lambent renders
    settings: dict = field(default_factory=dict)  # further ones of vtkLambentRayTracer
    pixels: int = 0  # that may differ
    bytes: int = 0  # by which they may differ

    @property
    def is_limit(self):
        return self.pixels > 0


def filtered(new, **values):
    """A change of a scene: its data goes through a filter of VTK."""

    def apply(data):
        algorithm = new()
        for name, value in values.items():
            getattr(algorithm, "Set" + name)(value)
        algorithm.SetInputData(data)
        algorithm.Update()
        return algorithm.GetOutput()

    return lambda scene: with_data(scene, apply)


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
    return with_data(replace(scene, actors=[replace(actor, colours=colours)]), change)


def with_actor(**values):
    """A change of a scene with one actor."""
    return lambda scene: replace(scene, actors=[replace(scene.actors[0], **values)])


def with_range_of_array(scene):
    actor, = scene.actors
    heights = actor.data().GetPointData().GetArray(actor.colours.array).GetRange()
    return with_actor(colours=replace(actor.colours, range=heights))(scene)


def with_light_of_scene(scene):
    """A light at the camera, instead of the headlight."""
    camera = camera_of(scene)
    return replace(scene, lights=({"LightType": VTK_LIGHT_TYPE_SCENE_LIGHT, "Position": camera.GetPosition(),
                                   "FocalPoint": camera.GetFocalPoint()},))


def from_far(scene):
    """The camera of a parallel view, a thousand times as far away."""
    camera = camera_of(scene)
    camera.Dolly(0.001)
    return replace(scene, camera={**scene.camera, "Position": camera.GetPosition()})


def with_specular_as_diffuse(scene):
    return replace(scene, lights=[{**each, "SpecularColor": each["DiffuseColor"]} for each in scene.lights])


def without_clipping(scene):
    return replace(scene, camera={name: value for name, value in scene.camera.items() if name != "ClippingRange"})


AMBIENT = Known("OpenGL adds the ambient colour once; Lambent adds it for each light, as much as there is light. "
                "AmbientModel SCENE is set.", settings={"AmbientModel": vtkLambentRayTracer.SCENE})
NORMALS = Known("Without point normals OpenGL draws flat faces; Lambent computes normals. OpenGL is given those of "
                "vtkLambentNormals.", opengl=filtered(vtkLambentNormals, Splitting=True))
REVERSED = filtered(vtkReverseSense, ReverseNormals=False)
MIRRORED = Known("A mirroring matrix turns a mesh inside out in OpenGL, and its point normals away from the viewer. "
                 "OpenGL is given the faces in reverse.", opengl=REVERSED)

KNOWN = {
    "ambient-dim": AMBIENT,
    "ambient-several": AMBIENT,
    "normals-missing": NORMALS,
    "normals-against-the-winding": Known(
        "Where point normals disagree with the winding, OpenGL turns them away from the viewer; Lambent trusts "
        "them. OpenGL is given the faces in reverse.", opengl=REVERSED),
    "unlit-with-coefficients": Known(
        "Without lighting OpenGL adds the ambient and the diffuse colour with their coefficients; Lambent shows the "
        "diffuse colour. OpenGL is given the coefficients 0 and 1.",
        opengl=lambda scene: with_property(scene, Ambient=0.0, Diffuse=1.0)),
    "back-one-sided": Known("OpenGL always lights both sides. TwoSidedLighting is on.",
                            settings={"TwoSidedLighting": True}),
    "polygons": Known("OpenGL cuts a polygon into a fan, which is wrong for concave ones. OpenGL is given triangles.",
                      opengl=filtered(vtkTriangleFilter)),
    "colours-log-before": Known(
        "OpenGL interpolates the logarithm, Lambent the number. Lambent is given logarithms.",
        lambent=with_logarithms),
    "coincident": Known("Of coincident faces OpenGL shows the last, Lambent the first. OpenGL is given the cells "
                        "in reverse order.", opengl=lambda scene: with_data(scene, in_reverse_order)),
    "colours-default-range": Known(
        "Without a table and a range, OpenGL's mapper covers 0 to 1, Lambent the range of the array. OpenGL is given "
        "that.", opengl=with_range_of_array),
    "transform-mirrored": MIRRORED,
    "transform-mirrored-culled": MIRRORED,
    "spheres-transformed": Known("A transform moves Lambent's spheres, but does not scale them. OpenGL is given the "
                                 "radius for its scaled spheres.", opengl=with_actor(radius=0.6)),
    "specular": Known(
        "For a single headlight, OpenGL's highlight has the cosine of the diffuse light; elsewhere, and in Lambent, "
        "it is that of the reflected ray. OpenGL is given another light at the camera.", opengl=with_light_of_scene),
    "specular-parallel": Known(
        "In a parallel view, OpenGL's highlights are those that the camera's position sees; Lambent's those that the "
        "parallel rays see. OpenGL's camera is moved back.", opengl=from_far),
    "specular-of-light": Known(
        "OpenGL's highlights have the diffuse colour of the light, Lambent's its specular colour. Lambent is given the "
        "same for both.", lambent=with_specular_as_diffuse),
    "edges": Known("OpenGL blends the edges of faces with the faces; Lambent decides for each sample. It has more of "
                   "them.", settings={"Supersampling": 2}),
    "edges-coloured": Known("In OpenGL a few pixels of silhouettes, near corners, lack the edge.",
                            pixels=3, bytes=120),
    "clipping-range": Known("Lambent ignores the clipping range. OpenGL is given one around the scene.",
                            opengl=without_clipping),
    "ghosts": Known("OpenGL draws ghost cells of vtkPolyData. It is given the mesh without them.",
                    opengl=lambda scene: with_data(scene, without_ghosts)),
}
