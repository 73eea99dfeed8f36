# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""A thousand pictures, read as arrays, leak nothing in Python: no memory, and no mesh, image or filter that
something still references."""

import gc
import os
import unittest
import weakref

import numpy as np
from lambent import vtkLambentNormals, vtkLambentRayTracer
from lambent.testing import assert_images_equal
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

KILOBYTE = 1024


def resident_memory():
    """The memory in use, in bytes."""
    with open("/proc/self/statm") as pages:
        return int(pages.read().split()[1]) * os.sysconf("SC_PAGESIZE")


def wavy_sheet(k):
    """A mesh of n x n points from a NumPy array; bad for one k out of ten."""
    n = 12 + k % 9
    y, x = np.mgrid[0:n, 0:n].reshape(2, -1) * (2.0 / (n - 1)) - 1.0
    points = np.stack([x, y, 0.2 * np.sin(4.0 * x + 0.1 * k)], axis=1)
    a = (np.arange(n * (n - 1)).reshape(n - 1, n)[:, :-1]).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + n], axis=1),
                                np.stack([a + 1, a + n + 1, a + n], axis=1)])
    if k % 10 == 7:
        triangles[0, 0] = n * n
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(points))
    cells = vtkCellArray()  # it uses the memory, but holds no reference to NumPy's array
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3), deep=1),
                  numpy_to_vtkIdTypeArray(triangles.ravel(), deep=1))
    mesh.SetPolys(cells)
    return mesh


class Memory(unittest.TestCase):
    def draw(self, k, tracer):
        """One picture as an array, or None after an error."""
        errors = []
        stages = [tracer, tracer.GetExecutive()]
        mesh = wavy_sheet(k)
        if k % 3 == 0:
            normals = vtkLambentNormals()
            normals.SetInputData(mesh)
            normals.SetSplitting(k % 2)
            tracer.SetInputConnection(normals.GetOutputPort())
            stages += [normals, normals.GetExecutive()]
        else:
            tracer.SetInputData(mesh)
        tags = [(stage, stage.AddObserver("ErrorEvent", lambda caller, event: errors.append(event)))
                for stage in stages]
        tracer.SetImageSize(50 + k % 30, 40 + k % 20)
        tracer.SetOutputScalarType(VTK_FLOAT if k % 2 else VTK_UNSIGNED_CHAR)
        tracer.SetGenerateIds(k % 4 == 0)
        tracer.Update()
        for stage, tag in tags:
            stage.RemoveObserver(tag)
        self.assertEqual(bool(errors), k % 10 == 7)
        if errors:
            return None
        if k % 4 == 0:
            ids = vtk_to_numpy(tracer.GetOutput().GetPointData().GetArray("CellIds"))
            self.assertGreater((ids >= 0).sum(), 0)
        width, height = tracer.GetImageSize()
        scalars = tracer.GetOutput().GetPointData().GetScalars()
        return vtk_to_numpy(scalars).reshape(height, width, 3)[::-1].copy()

    def expect_flat_memory(self, step):
        """A leak of a few kilobytes in each of a thousand steps would show."""
        for k in range(300):
            step(k)
        gc.collect()
        before = resident_memory()
        for k in range(300, 1300):
            step(k)
        gc.collect()
        self.assertLess(resident_memory() - before, 4000 * KILOBYTE)

    def test_one_filter_does_not_leak(self):
        tracer = vtkLambentRayTracer()
        self.expect_flat_memory(lambda k: self.draw(k, tracer))

    def test_new_filters_do_not_leak(self):
        self.expect_flat_memory(lambda k: self.draw(k, vtkLambentRayTracer()))

    def test_comparing_does_not_leak(self):
        tracer = vtkLambentRayTracer()
        pictures = [self.draw(k, tracer) for k in (0, 2, 4)]
        self.expect_flat_memory(lambda k: assert_images_equal(pictures[k % 3], pictures[k % 3]))

    def test_no_object_is_kept_alive(self):
        tracer = vtkLambentRayTracer()
        mesh = wavy_sheet(0)
        tracer.SetInputData(mesh)
        tracer.Update()
        gone = [weakref.ref(thing) for thing in (mesh, tracer, tracer.GetOutput())]
        del mesh, tracer
        self.assertEqual([reference() for reference in gone], [None] * 3)


if __name__ == "__main__":
    unittest.main()
