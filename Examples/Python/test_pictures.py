# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause

import pytest
from lambent import vtkLambentRayTracer
from lambent.testing import assert_matches_baseline
from vtkmodules.vtkFiltersGeneral import vtkShrinkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkCamera


def picture_of(mesh):
    camera = vtkCamera()
    camera.SetPosition(1.5, 2, 3)
    tracer = vtkLambentRayTracer()
    tracer.SetInputConnection(mesh.GetOutputPort())
    tracer.SetCamera(camera)
    tracer.SetImageSize(160, 120)
    return tracer


def test_box():
    assert_matches_baseline(picture_of(vtkCubeSource()), "box")  # baselines/box.png


@pytest.mark.parametrize("factor", [0.5, 0.75])
def test_shrunk(factor, lambent_baseline):
    box = vtkCubeSource()
    filter_under_test = vtkShrinkPolyData()
    filter_under_test.SetInputConnection(box.GetOutputPort())
    filter_under_test.SetShrinkFactor(factor)
    lambent_baseline(picture_of(filter_under_test))  # named after the test
