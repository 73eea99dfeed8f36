# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data/seashell.vtp is the result of Data/make_seashell.py, and is closed and oriented outwards.

    TestSeashell.py FOLDER
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

sys.path.insert(0, sys.argv[1])
import make_seashell


def arrays(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points, triangles


reader = vtkXMLPolyDataReader()
reader.SetFileName(os.path.join(sys.argv[1], "seashell.vtp"))
reader.Update()
points, triangles = arrays(reader.GetOutput())
made_points, made_triangles = arrays(make_seashell.seashell())

assert np.array_equal(triangles, made_triangles)
assert points.shape == made_points.shape
# The platform's sine may move a coordinate to the next step of the script's grid.
assert abs(points - made_points).max() <= 2 ** -14

# Each edge occurs once in each direction: the mesh is closed and consistently oriented.
edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
there = edges[:, 0].astype(np.int64) * len(points) + edges[:, 1]
back = edges[:, 1].astype(np.int64) * len(points) + edges[:, 0]
assert len(np.unique(there)) == len(there)
assert np.array_equal(np.sort(there), np.sort(back))

# The enclosed volume is positive if the faces are counter-clockwise when seen from outside.
a, b, c = (points[triangles[:, i]] for i in range(3))
assert np.einsum("ij,ij->", a, np.cross(b, c)) > 0
# No face has zero area.
assert np.linalg.norm(np.cross(b - a, c - a), axis=1).min() > 0
