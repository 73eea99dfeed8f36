# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Known differences between the two renderers. README.md describes them.

Most entries change the scene or the settings of one side, so that what remains must be the same; without the change
it must differ. An entry with a limit allows this many pixels to differ by at most so much; some must differ without
the change.
"""

from dataclasses import dataclass, field, replace
from typing import Callable, Optional

import numpy as np
from vtkmodules.vtkFiltersCore import vtkReverseSense, vtkTriangleFilter
from vtkmodules.vtkRenderingCore import VTK_FLAT

import changes
from changes import filtered, with_actor
from comparison import TOLERANCE
from lambent import vtkLambentNormals, vtkLambentRayTracer
from meshes import in_reverse_order, without_ghosts
from scene import with_data, with_property


@dataclass
class Known:
    reason: str
    opengl: Optional[Callable] = None  # changes the scene that OpenGL renders
    lambent: Optional[Callable] = None  # changes the scene that Lambent renders
    settings: dict = field(default_factory=dict)  # further ones of vtkLambentRayTracer
    pixels: int = 0  # that may differ
    bytes: int = 0  # by which they may differ

    def allows(self, result):
        return (result.at_edges <= result.most_at_edges and np.count_nonzero(result.wrong) <= self.pixels and
                result.largest <= max(self.bytes, TOLERANCE))


def of_lines(pixels):
    return Known("OpenGL's lines of a width are thinner if they are oblique, and end squarely; Lambent's have the same "
                 "width in every direction, and round ends.", pixels=pixels, bytes=255)


def of_points(pixels):
    return Known("OpenGL's points are squares, Lambent's are discs.", pixels=pixels, bytes=255)


AMBIENT = Known("OpenGL adds the ambient colour once; Lambent adds it for each light, as much as there is light. "
                "AmbientModel SCENE is set.", settings={"AmbientModel": vtkLambentRayTracer.SCENE})
NORMALS = Known("Without point normals OpenGL draws flat faces; Lambent computes normals. OpenGL is given those of "
                "vtkLambentNormals.", opengl=filtered(vtkLambentNormals, Splitting=True))
REVERSED = filtered(vtkReverseSense, ReverseNormals=False)
MIRRORED = Known("A mirroring matrix turns a mesh inside out in OpenGL, and its point normals away from the viewer. "
                 "OpenGL is given the faces in reverse.", opengl=REVERSED)


def backwards(scene):
    return with_data(scene, in_reverse_order)


KNOWN = {
    "ambient-dim": AMBIENT,
    "ambient-several": AMBIENT,
    "light-none-is-on": Known(
        "If no light is on, vtkRenderer makes a headlight; in Lambent there is none. Lambent is given no lights, which "
        "means a headlight.", lambent=lambda scene: replace(scene, lights=())),
    "unlit-with-coefficients": Known(
        "Without lighting OpenGL adds the ambient and the diffuse colour with their coefficients; Lambent shows the "
        "diffuse colour. OpenGL is given the coefficients 0 and 1.",
        opengl=lambda scene: with_property(scene, Ambient=0.0, Diffuse=1.0)),
    "normals-missing": NORMALS,
    "normals-of-cells-only": Known(
        "Without point normals OpenGL uses those of cells, also with smooth shading; Lambent computes normals. Lambent "
        "is given flat shading.", lambent=lambda scene: with_property(scene, Interpolation=VTK_FLAT)),
    "normals-against-the-winding": Known(
        "Where point normals disagree with the winding, OpenGL turns them away from the viewer; Lambent trusts "
        "them. OpenGL is given the faces in reverse.", opengl=REVERSED),
    "back-one-sided": Known("OpenGL always lights both sides. TwoSidedLighting is on.",
                            settings={"TwoSidedLighting": True}),
    "polygons": Known("OpenGL cuts a polygon into a fan, which is wrong for concave ones. OpenGL is given triangles.",
                      opengl=filtered(vtkTriangleFilter)),
    "coincident": Known("Of coincident faces OpenGL shows the last, Lambent the first. OpenGL is given the cells "
                        "in reverse order.", opengl=backwards),
    "colours-default-range": Known(
        "Without a table and a range, OpenGL's mapper covers 0 to 1, Lambent the range of the array. OpenGL is given "
        "that.", opengl=changes.with_range_of_array),
    "colours-log-before": Known("OpenGL interpolates the logarithm, Lambent the number. Lambent is given logarithms.",
                                lambent=changes.with_logarithms),
    "colours-range-of-one-value-before": Known(
        "If scalars are interpolated before mapping, and the range is one value, OpenGL shows the lowest colour; "
        "Lambent shows what is below and above. Lambent is given a range above all values.",
        lambent=changes.with_range_above),
    "transform-mirrored": MIRRORED,
    "transform-mirrored-culled": MIRRORED,
    "ghosts": Known("OpenGL draws ghost cells of vtkPolyData. It is given the mesh without them.",
                    opengl=lambda scene: with_data(scene, without_ghosts)),
    "spheres-transformed": Known("A transform moves Lambent's spheres, but does not scale them. OpenGL is given the "
                                 "radius for its scaled spheres.", opengl=with_actor(radius=0.6)),
    "culled-both": Known("OpenGL culls the backs if both sides are culled, Lambent both. Lambent is given that.",
                         lambent=lambda scene: with_property(scene, FrontfaceCulling=False)),
    "clipping-range": Known("Lambent ignores the clipping range. OpenGL is given one around the scene.",
                            opengl=changes.without_clipping),
    "opacity-of-spheres": Known(
        "vtkGlyph3DMapper applies the opacity twice. OpenGL is given its square root.",
        opengl=lambda scene: with_property(scene, Opacity=0.5 ** 0.5)),
    "specular": Known(
        "For a single headlight, OpenGL's highlight has the cosine of the diffuse light; elsewhere, and in Lambent, "
        "it is that of the reflected ray. OpenGL is given another light at the camera.",
        opengl=changes.with_light_of_scene),
    "specular-parallel": Known(
        "In a parallel view, OpenGL's highlights are those that the camera's position sees; Lambent's those that the "
        "parallel rays see. OpenGL's camera is moved back.", opengl=changes.from_far),
    "specular-of-light": Known(
        "OpenGL's highlights have the diffuse colour of the light, Lambent's its specular colour. Lambent is given the "
        "same for both.", lambent=changes.with_specular_as_diffuse),
    "edges": Known("OpenGL blends the edges of faces with the faces; Lambent decides for each sample. It has more of "
                   "them.", settings={"Supersampling": 2}),
    "edges-coloured": Known("In OpenGL a few pixels of silhouettes, near corners, lack the edge.",
                            pixels=3, bytes=120),
    "lines-wide": of_lines(110),
    "lines-coloured": of_lines(15),
    "lines-with-normals": of_lines(5),
    "lines-as-tubes": of_lines(200),
    "lines-lit": Known("OpenGL does not light lines and points without normals; Lambent does. It has no lighting.",
                       lambent=changes.unlit, pixels=5, bytes=255),
    "lines-on-a-surface": Known(
        "OpenGL hides parts of lines that lie on a surface; Lambent's lines bulge towards the eye, and are seen. "
        "OpenGL's are moved towards the eye.", opengl=changes.with_last_in_front, pixels=8, bytes=255),
    "vertices": of_points(5),
    "mixed-cells": of_points(15),
    "vertices-as-spheres": Known(
        "In a perspective view, the front of OpenGL's points is the same all over the picture; that of Lambent's "
        "looks at the eye.", pixels=700, bytes=90),
    "vertices-of-a-surface": Known(
        "OpenGL of VTK 9.1 draws the vertices of a surface only if its edges are visible. It is given them as another "
        "actor.", opengl=changes.with_vertices_in_front),
    "wireframe": Known("A line of one pixel that passes half-way between two covers both in Lambent.",
                       pixels=5, bytes=255),
    "wireframe-with-normals": of_lines(5),
    "wireframe-of-cells": Known("A line that two cells share has the colour of the last in OpenGL, of the first in "
                                "Lambent. OpenGL is given the cells in reverse order.", opengl=backwards,
                                pixels=220, bytes=255),
    "points-with-normals": Known("OpenGL does not turn the normals of points to the viewer. It is given such.",
                                 opengl=changes.with_normals_to_the_eye, pixels=6, bytes=255),
}
