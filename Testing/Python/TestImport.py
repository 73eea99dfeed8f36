# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package can be imported beside vtkmodules, and its classes are VTK classes. All of its parts exist, and
pytest can find the plugin."""

import importlib.metadata
import importlib.util
import os

from lambent import vtkLambentAlgorithm, vtkLambentNormals, vtkLambentRayTracer
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkImageAlgorithm

import lambent
import lambent.testing.report

normals = vtkLambentNormals()
tracer = vtkLambentRayTracer()
assert isinstance(normals, vtkAlgorithm)
assert isinstance(tracer, vtkImageAlgorithm)
assert isinstance(tracer, vtkLambentAlgorithm)
assert (vtkLambentRayTracer.PER_LIGHT, vtkLambentRayTracer.SCENE) == (0, 1)
try:
    vtkLambentAlgorithm()
    raise SystemExit("vtkLambentAlgorithm is abstract")
except (TypeError, NotImplementedError):
    pass

tracer.SetInputConnection(normals.GetOutputPort())
tracer.SetImageSize(64, 48)
assert tracer.GetImageSize() == (64, 48)
assert vtkLambentRayTracer.GetImageContractVersion() >= 1
assert lambent.__version__.count(".") == 2

assert importlib.metadata.version("lambent") == lambent.__version__
plugins = [point for point in importlib.metadata.entry_points(group="pytest11")
           if point.name == "lambent"]
home = os.path.dirname(os.path.dirname(lambent.__file__))
for plugin in plugins:
    assert importlib.util.find_spec(plugin.value).origin.startswith(home + os.sep), plugin
assert plugins
assert os.path.isfile(os.path.join(home, "lambent", "testing", "report.html"))
