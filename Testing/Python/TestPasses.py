# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Passes, alpha and background images in Python, with NumPy arrays as input and output."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkCompositeDataDisplayAttributes

from lambent import vtkLambentRayTracer

# Centres of 8 x 8 pixels of side 0.5. The square covers the middle 4 x 4 of them.
CENTRES = -1.75 + 0.5 * np.arange(8)
X, Y = np.meshgrid(CENTRES, CENTRES)  # row 0 is at the bottom
HIT = np.maximum(abs(X), abs(Y)) < 1


class TestPasses(unittest.TestCase):
    def setUp(self):
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, -1, 0)
        plane.SetPoint1(1, -1, 0)
        plane.SetPoint2(-1, 1, 0)
        plane.Update()
        self.mesh = plane.GetOutput()
        camera = vtkCamera()
        camera.SetPosition(0, 0, 5)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(2)
        self.tracer = vtkLambentRayTracer()
        self.tracer.SetInputData(self.mesh)
        self.tracer.SetCamera(camera)
        self.tracer.SetImageSize(8, 8)

    def array(self, name):
        self.tracer.Update()
        return vtk_to_numpy(self.tracer.GetOutput().GetPointData().GetArray(name)).reshape(8, 8, -1)

    def expect(self, name, hit, kind, miss=np.nan):
        found = self.array(name)
        wanted = np.where(HIT[..., None], np.dstack(np.broadcast_arrays(*hit)), miss)
        self.assertEqual(found.dtype, kind)
        np.testing.assert_array_equal(found, wanted)

    def test_depth_normals_positions_and_ids_are_arrays(self):
        self.tracer.GenerateDepthOn()
        self.tracer.GenerateNormalsOn()
        self.tracer.GeneratePositionsOn()
        self.tracer.GenerateIdsOn()
        one = np.ones((8, 8))
        self.expect("Depth", [5 * one], np.float32)
        self.expect("Normals", [0 * one, 0 * one, one], np.float32)
        self.expect("Positions", [X, Y, 0 * one], np.float64)
        self.expect("CellIds", [0 * one], np.int64, -1)
        self.expect("InputIds", [0 * one], np.int64, -1)

    def test_blocks_of_composite_data_have_ids_and_attributes(self):
        inner, blocks = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        inner.SetBlock(1, self.mesh)
        blocks.SetBlock(2, inner)
        self.tracer.SetInputDataObject(blocks)
        self.tracer.GenerateIdsOn()
        one = np.ones((8, 8))
        self.expect("BlockIds", [5 * one], np.int64, -1)
        self.expect("InputIds", [0 * one], np.int64, -1)
        attributes = vtkCompositeDataDisplayAttributes()
        self.tracer.SetInputBlockAttributes(0, attributes)
        self.assertIs(self.tracer.GetInputBlockAttributes(0), attributes)
        attributes.SetBlockVisibility(inner, False)
        np.testing.assert_array_equal(self.array("BlockIds"), -np.ones((8, 8, 1)))

    def test_a_transform_moves_positions(self):
        matrix = vtkMatrix4x4()
        matrix.SetElement(2, 3, 1.5)
        self.tracer.SetInputTransform(0, matrix)
        self.assertIs(self.tracer.GetInputTransform(0), matrix)
        self.tracer.GenerateDepthOn()
        self.tracer.GeneratePositionsOn()
        one = np.ones((8, 8))
        self.expect("Positions", [X, Y, 1.5 * one], np.float64)
        self.expect("Depth", [3.5 * one], np.float32)

    def test_ghost_cells_are_not_drawn(self):
        flags = numpy_to_vtk(np.array([vtkDataSetAttributes.DUPLICATECELL], np.uint8), deep=True)
        flags.SetName(vtkDataSetAttributes.GhostArrayName())
        self.mesh.GetCellData().AddArray(flags)
        self.tracer.GenerateIdsOn()
        np.testing.assert_array_equal(self.array("CellIds"), -np.ones((8, 8, 1)))

    def test_arrays_of_the_mesh_become_passes(self):
        points = vtk_to_numpy(self.mesh.GetPoints().GetData())
        heights = numpy_to_vtk(np.ascontiguousarray(points[:, 0] + 10 * points[:, 1]), deep=True)
        heights.SetName("height")
        self.mesh.GetPointData().AddArray(heights)
        regions = numpy_to_vtk(np.array([7], np.int32), deep=True)
        regions.SetName("region")
        self.mesh.GetCellData().AddArray(regions)
        self.tracer.AddPassArray(vtkDataObject.FIELD_ASSOCIATION_POINTS, "height")
        self.tracer.AddPassArray(vtkDataObject.FIELD_ASSOCIATION_CELLS, "region")
        self.expect("height", [X + 10 * Y], np.float32)
        self.expect("region", [7 * np.ones((8, 8))], np.float64)
        self.tracer.RemoveAllPassArrays()
        self.tracer.Update()
        self.assertEqual(self.tracer.GetOutput().GetPointData().GetNumberOfArrays(), 1)

    def test_alpha_is_a_fourth_channel(self):
        self.tracer.OutputAlphaOn()
        color = self.array("Color")
        self.assertEqual(color.shape, (8, 8, 4))
        np.testing.assert_array_equal(color[..., 3], np.where(HIT, 255, 0))
        np.testing.assert_array_equal(color[~HIT], 0)

    def test_a_numpy_array_can_be_the_background_image(self):
        pixels = np.arange(8 * 8 * 3, dtype=np.uint8).reshape(8, 8, 3)
        image = vtkImageData()
        image.SetDimensions(8, 8, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
        self.tracer.SetBackgroundImage(image)
        np.testing.assert_array_equal(self.array("Color")[~HIT], pixels[~HIT])
        self.assertIs(self.tracer.GetBackgroundImage(), image)
        self.tracer.SetBackgroundImage(None)
        np.testing.assert_array_equal(self.array("Color")[~HIT], 0)


if __name__ == "__main__":
    unittest.main()
