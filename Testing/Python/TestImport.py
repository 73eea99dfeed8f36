# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package imports beside vtkmodules, and its classes are VTK's own kind."""

from lambent import vtkLambentNormals, vtkLambentRayTracer
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkImageAlgorithm

import lambent

normals = vtkLambentNormals()
tracer = vtkLambentRayTracer()
assert isinstance(normals, vtkAlgorithm)
assert isinstance(tracer, vtkImageAlgorithm)

tracer.SetInputConnection(normals.GetOutputPort())
tracer.SetImageSize(64, 48)
assert tracer.GetImageSize() == (64, 48)
assert vtkLambentRayTracer.GetImageContractVersion() >= 1
assert lambent.__version__.count(".") == 2
