# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point normals for a mesh without them: a box of 8 points as one smooth surface (left), and split
along its sharp edges (right)."""

import gallery
from lambent import vtkLambentNormals, vtkLambentRayTracer
from vtkmodules.vtkFiltersSources import vtkTessellatedBoxSource

tracer = vtkLambentRayTracer()
for splitting in (False, True):
    x = 1.25 if splitting else -1.25
    box = vtkTessellatedBoxSource()
    box.SetBounds(x - 0.75, x + 0.75, -0.75, 0.75, -0.75, 0.75)
    box.DuplicateSharedPointsOff()
    box.QuadsOn()

    normals = vtkLambentNormals()
    normals.SetInputConnection(box.GetOutputPort())
    normals.SetSplitting(splitting)
    normals.SetFeatureAngle(30)
    normals.Update()
    mesh = normals.GetOutput()
    print("%d points, normals: %s" % (mesh.GetNumberOfPoints(),
                                      mesh.GetPointData().GetNormals().GetName()))

    green = gallery.surface(0.7, 0.9, 0.6)
    green.SetDiffuse(0.9)
    green.SetAmbient(0.1)
    gallery.add_surface(tracer, mesh, green)
gallery.add_light(tracer, (1, 5, 3))
gallery.look_from(tracer, (0, 2.5, 5.5), 640, 360)
gallery.save(tracer, "SharpEdges.png")
