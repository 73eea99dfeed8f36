# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The lookup tables and textures of the scenes, and how they show blocks. Each function returns a new object."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVariant
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkTexture

from scene import apply


def table(count=256, **values):
    result = apply(vtkLookupTable(), {"NumberOfTableValues": count, **values})
    result.Build()
    return result


def logarithmic():
    result = table(HueRange=(0.66, 0.0))
    result.SetTableRange(0.02, 30.0)
    result.SetScaleToLog10()
    return result


def limited(**values):
    """With colours of their own for NaN and for numbers outside the range."""
    return table(HueRange=(0.3, 0.1), NanColor=(1, 0, 1, 1), UseBelowRangeColor=True, UseAboveRangeColor=True,
                 BelowRangeColor=(0, 0, 0.6, 1), AboveRangeColor=(1, 1, 0.9, 1), **values)


def function():
    result = vtkColorTransferFunction()
    for x, colour in ((-1.4, (0.1, 0.1, 0.6)), (0.0, (0.9, 0.9, 0.9)), (0.3, (0.3, 0.8, 0.2)), (2.2, (0.7, 0, 0))):
        result.AddRGBPoint(x, *colour)
    result.SetNanColor(1, 0, 1)
    return result


def diverging():
    result = function()
    result.SetColorSpaceToDiverging()
    return result


def annotated():
    """Colours for the numbers 0, 1, 3 and 4; 2 has none."""
    result = vtkLookupTable()
    result.SetIndexedLookup(True)
    result.SetNumberOfTableValues(4)
    result.SetNanColor(0.2, 0.2, 0.2, 1)
    for index, (value, colour) in enumerate((
            (0, (1, 0, 0)), (1, (0, 1, 0)), (3, (0, 0, 1)), (4, (1, 1, 0)))):
        result.SetAnnotation(vtkVariant(value), str(value))
        result.SetTableValue(index, *colour, 1)
    return result


def translucent():
    return table(AlphaRange=(0.1, 0.9))


def texture(texels, smooth=False, wrap=vtkTexture.Repeat, **values):
    """A texture of an array (rows from the bottom, columns, components)."""
    image = vtkImageData()
    image.SetDimensions(texels.shape[1], texels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, texels.shape[2]), deep=True))
    result = apply(vtkTexture(), {"Interpolate": smooth, "Wrap": wrap, **values})
    result.SetInputDataObject(image)
    return result


def chequers(smooth=False, wrap=vtkTexture.Repeat, alpha=False, **values):
    """Eight by eight texels of many colours."""
    j, i = np.meshgrid(np.arange(8), np.arange(8), indexing="ij")
    texels = np.stack([30 * i + 20, 30 * j + 20, np.where((i + j) % 2, 230, 90)], 2)
    if alpha:
        texels = np.dstack([texels, 255 - 30 * i])
    return texture(texels.astype(np.uint8), smooth, wrap, **values)


def grey_bytes():
    return texture(np.arange(0, 250, 10, dtype=np.uint8).reshape(5, 5, 1))


def numbers():
    """Numbers, which a texture maps through a table."""
    return texture(np.linspace(0.0, 2.0, 30).reshape(5, 6, 1), LookupTable=table(TableRange=(0.3, 1.6)))


def turned():
    transform = vtkTransform()
    transform.Translate(0.2, 0.1, 0)
    transform.RotateZ(30)
    transform.Scale(0.8, 1.3, 1)
    return chequers(Transform=transform)


def block_colours(attributes, data):
    """The first two blocks green; one of the two has a colour of its own."""
    attributes.SetBlockColor(data.GetBlock(0), (0.2, 0.8, 0.3))
    attributes.SetBlockColor(data.GetBlock(0).GetBlock(1), (0.9, 0.2, 0.1))


def block_visibility(attributes, data):
    attributes.SetBlockVisibility(data.GetBlock(0), False)
    attributes.SetBlockVisibility(data.GetBlock(0).GetBlock(1), True)


def block_opacity(attributes, data):
    attributes.SetBlockOpacity(data.GetBlock(0), 0.4)
