# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a scene consists of. Both renderers are set up from it, each with objects of its own."""

from dataclasses import dataclass, field, replace
from typing import Callable, Optional

from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkProperty

SIZE = 240, 180
BACKGROUNDS = (0.2, 0.4, 0.6), (1.0, 1.0, 1.0)  # each scene is rendered over both


@dataclass
class Colours:
    """Colours from an array."""
    array: str
    cells: bool = False
    component: int = 0  # -1: the magnitude
    table: Optional[Callable] = None  # returns a new vtkScalarsToColors
    range: Optional[tuple] = None  # None: that of the table
    before: bool = False  # interpolate before mapping


@dataclass
class Actor:
    data: Callable  # returns a new vtkPolyData or composite data
    property: dict = field(default_factory=dict)  # of vtkProperty: {"Color": (1, 0, 0)}
    colours: Optional[Colours] = None
    matrix: Optional[vtkMatrix4x4] = None
    blocks: Optional[Callable] = None  # changes block attributes: blocks(attributes, data)
    texture: Optional[Callable] = None  # returns a new vtkTexture
    radius: float = 0.0  # of spheres at the points; with an array, its factor
    radii: Optional[str] = None
    impostors: bool = False  # OpenGL: spheres of vtkOpenGLSphereMapper, not tessellated ones


@dataclass
class Scene:
    """`awaits` names features that the library may not have yet; FEATURES in lambent_side.py lists
    them. `thin` says what is compared less strictly, as comparison.py describes."""
    name: str
    actors: list
    camera: dict = field(default_factory=dict)
    lights: tuple = ()
    two_sided: bool = True
    awaits: tuple = ()
    thin: str = ""


def scene(name, data, property=None, colours=None, matrix=None, blocks=None, texture=None, radius=0.0,
          radii=None, impostors=False, **others):
    """A scene with one actor; a list of actors may take the place of its data."""
    actors = data if isinstance(data, list) else [
        Actor(data, property or {}, colours, matrix, blocks, texture, radius, radii, impostors)]
    return Scene(name, actors, **others)


def with_data(found, change):
    """A copy of the scene whose data is changed by a function."""
    return replace(found, actors=[replace(actor, data=lambda actor=actor: change(actor.data()))
                                  for actor in found.actors])


def with_property(found, **values):
    return replace(found, actors=[replace(actor, property={**actor.property, **values})
                                  for actor in found.actors])


def apply(target, values):
    """Call the setters that a dictionary names. Tuples are several arguments."""
    for name, value in values.items():
        arguments = value if isinstance(value, tuple) else (value,)
        getattr(target, "Set" + name)(*arguments)
    return target


def camera_of(found):
    usual = {"Position": (0.9, -1.4, 3.6), "FocalPoint": (0, 0, 0), "ViewUp": (0, 1, 0), "ViewAngle": 34}
    return apply(vtkCamera(), {**usual, **found.camera})


def lights_of(found):
    return [apply(vtkLight(), values) for values in found.lights]


def property_of(actor):
    return apply(vtkProperty(), {"Color": (0.9, 0.8, 0.7), **actor.property})


def matrix(*rows):
    """A matrix whose last row is 0 0 0 1."""
    result = vtkMatrix4x4()
    result.DeepCopy(rows + (0, 0, 0, 1))
    return result
