# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes seashell.vtp, the mesh of the examples: a wentletrap.

    python3 make_seashell.py [FILE]

A shell grows by adding to its mouth, always in the same proportions. So the tube
is a circle that rotates about the axis, while its size and its distance from the
apex grow by the same factor each turn (D'Arcy Thompson, "On Growth and Form",
1917). Where growth pauses, the wentletrap leaves behind the flared rim of its mouth
as a thin rib. At the mouth the wall turns and runs back inside, so the mesh is
closed.
"""

import sys
from math import pi

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

TURNS = 7.5          # turns of the outer wall, from the apex to the mouth
GROWTH = 1.37        # factor of all lengths per turn
RADIUS = 1.7        # of the spiral around the axis, in radii of the tube
HEIGHT = 6.2        # of the spiral below the apex, in radii of the tube
RIBS = 12            # per turn; they meet those of the turn above
RIB_HEIGHT = 0.30    # in radii of the tube
WALL = 0.07          # thickness of the wall, in radii of the tube
INSIDE = 0.9         # turns by which the inner wall runs back
AROUND = 40          # points around the tube

# A rib from back to front: positions along the tube, as fractions of the distance from rib to rib, and
# heights, as fractions of RIB_HEIGHT. The blade leans back, away from the mouth.
RIB = [(-0.32, 0.0), (-0.13, 0.0), (-0.085, 0.05), (-0.07, 0.45), (-0.09, 0.85), (-0.075, 1.0),
       (-0.045, 0.97), (-0.005, 0.5), (0.05, 0.07), (0.3, 0.0)]

# The same for the mouth: out to a broad rim, over it, and in to the inner wall.
RIM = [(-0.32, 0.0), (-0.15, 0.0), (-0.08, 0.05), (-0.02, 0.3), (0.01, 0.75), (0.03, 1.1),
       (0.08, 1.25), (0.14, 1.15), (0.16, 0.85), (0.13, 0.45), (0.07, 0.1), (0.0, -0.15)]


def stations():
    """The rings of the tube from the apex to the mouth and back inside: the turn of each ring, the
    height of its rib, and how much of the wall lies outside of it."""
    rows = []
    last = round(TURNS * RIBS)
    for rib in range(1, last):
        rows += [((rib + place) / RIBS, height, 0.0) for place, height in RIB]
    rows += [((last + place) / RIBS, height, 0.0) for place, height in RIM]
    steps = round(INSIDE * RIBS * 3)
    rows += [((last - k / 3) / RIBS, 0.0, 1.0) for k in range(1, steps + 1)]
    return np.array(rows).T


def bump(angle, centre, width):
    """A bell around an angle (radians) with this centre and width (in units of pi)."""
    away = (angle - centre * pi + pi) % (2 * pi) - pi
    return np.exp(-(away / width) ** 2)


def rings():
    """The points of all rings, as an array of (ring, point on the ring, axis)."""
    turn, rib, inside = (row[:, None] for row in stations())
    size = GROWTH ** (turn - TURNS)
    round_tube = np.linspace(0, 2 * pi, AROUND, endpoint=False)[None, :]
    out, up = np.cos(round_tube), np.sin(round_tube)

    # Ribs are highest on the shoulder, where they end in a small hook, and low beside the next turn, so
    # that they do not penetrate its wall.
    rib_height = RIB_HEIGHT * ((0.75 + 0.25 * out) * (1 - 0.85 * bump(round_tube, -0.55, 0.6)) +
                               0.5 * bump(round_tube, 0.25, 0.35))
    tube = 1 + rib * rib_height - WALL * inside

    angle = 2 * pi * (turn - TURNS)
    from_axis = size * (RADIUS + tube * out)
    return np.stack([from_axis * np.cos(angle), size * (tube * up - HEIGHT),
                     from_axis * np.sin(angle)], axis=-1)


def faces(ring_count):
    """Two triangles for each four neighbouring points, and a fan at each end."""
    ring = np.arange(ring_count - 1)[:, None] * AROUND
    here = np.arange(AROUND)[None, :]
    following = (here + 1) % AROUND
    a, b = ring + here, ring + following
    c, d = b + AROUND, a + AROUND
    sides = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)

    around, onward = here[0], following[0]
    first, last = ring_count * AROUND, ring_count * AROUND + 1
    end = (ring_count - 1) * AROUND
    apex = np.stack([onward, around, np.full(AROUND, first)], axis=-1)
    back = np.stack([end + around, end + onward, np.full(AROUND, last)], axis=-1)
    return np.concatenate([sides, apex, back])


def posed(points):
    """Lay the shell down with its mouth towards the viewer, who looks along -z with y up."""
    def rotation(axis, degrees):
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        matrix = np.roll(np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), (axis, axis), (0, 1))
        return matrix
    turned = points @ (rotation(2, 50) @ rotation(0, 10) @ rotation(1, 322)).T
    low, high = turned.min(axis=0), turned.max(axis=0)
    return (turned - (low + high) / 2) * (4 / (high - low).max())


def seashell():
    """The mesh as vtkPolyData."""
    tube = rings()
    ends = tube[[0, -1]].mean(axis=1)
    points = posed(np.concatenate([tube.reshape(-1, 3), ends]))
    # On a grid of 2^-14 the coordinates are short numbers, and the file compresses better.
    points = (np.round(points * 2 ** 14) / 2 ** 14).astype(np.float32)
    triangles = faces(len(tube)).astype(np.int64)

    mesh = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    mesh.SetPoints(vtk_points)
    cells = vtkCellArray()
    offsets = np.arange(0, triangles.size + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    mesh.SetPolys(cells)
    return mesh


def write(mesh, name):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(name)
    writer.SetIdTypeToInt32()
    writer.SetCompressionLevel(9)
    if not writer.Write():
        sys.exit("could not write " + name)


if __name__ == "__main__":
    write(seashell(), sys.argv[1] if len(sys.argv) > 1 else "seashell.vtp")
