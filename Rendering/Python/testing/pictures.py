# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convert any kind of picture to vtkImageData, and vtkImageData to PNG."""

import os
import re
import secrets

from vtkmodules.vtkCommonCore import VTK_STRING, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkIOImage import vtkPNGWriter

from .. import vtkLambentPNGReader
from .pillow import in_plain_colours, is_pillow


def as_image(picture):
    """A separate vtkImageData for any kind of picture; lambent.testing lists the kinds."""
    if isinstance(picture, (str, os.PathLike)):
        image = read_png(os.fspath(picture))
    elif isinstance(picture, vtkAlgorithm):
        image = _output_of(picture)
    elif isinstance(picture, vtkImageData):
        image = picture
    elif is_pillow(picture):
        image = _image_of_array(in_plain_colours(picture))
    elif hasattr(picture, "__array__") or hasattr(picture, "__array_interface__"):
        image = _image_of_array(picture)
    else:
        raise TypeError(
            "a picture must be a vtkImageData, a vtkAlgorithm that outputs one, the path of a PNG,"
            " or an array, not %s" % _kind(picture))
    if image.GetPointData().GetScalars() is None:
        raise ValueError("the picture (%s) is empty: it has no point scalars" % _kind(picture))
    if image.GetDimensions()[2] != 1:
        raise ValueError("the picture has %d slices; extract one, for example with vtkExtractVOI"
                         % image.GetDimensions()[2])
    own = vtkImageData()
    own.ShallowCopy(image)  # unaffected by later updates of an algorithm
    return own


def read_png(path):
    """The picture in a PNG file. Raises ValueError if the file is not a complete PNG."""
    path = os.fsdecode(path)
    os.stat(path)  # raises an error if it is missing
    reader = vtkLambentPNGReader()
    reader.SetFileName(path)
    if not reader.Read():
        problem = reader.GetMessage()
        if problem == "it is not a PNG file":
            raise ValueError("'%s' is not a PNG file" % path)
        raise ValueError("'%s' cannot be read: %s" % (path, problem))
    reader.Update()
    return reader.GetOutput()


def fits_png(image):
    """Whether the image has a picture that a PNG can hold without loss."""
    scalars = image.GetPointData().GetScalars()
    return (scalars is not None
            and scalars.GetDataType() in (VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT)
            and scalars.GetNumberOfComponents() <= 4)


def png_of(image):
    """The bytes of a PNG file of the picture."""
    writer = vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputData(image)
    writer.Write()
    if writer.GetErrorCode() or not writer.GetResult():
        raise RuntimeError("vtkPNGWriter could not write the picture")
    return bytes(memoryview(writer.GetResult()))


def write_file(path, content):
    """Write a file atomically: concurrent readers and writers see one complete version or the
    other. Links are followed, not replaced. A device or a pipe is written to directly."""
    path = os.path.realpath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "wb") as file:
            file.write(content)
        return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    part = "%s.%s.part" % (path, secrets.token_hex(4))
    try:
        with open(part, "xb") as file:
            file.write(content)
        os.replace(part, path)
    except BaseException:
        if os.path.exists(part):
            os.remove(part)
        raise


def _kind(picture):
    return "%s.%s" % (type(picture).__module__, type(picture).__qualname__)


def _output_of(algorithm):
    """Update an algorithm and return its first output. Raises the first error that it reports."""
    name = algorithm.GetClassName()
    errors = []

    def note(_caller, _event, text):
        errors.append(re.sub(r"\A(ERROR: .*\n)?\w+ \(0x\w+\): ", "", text).strip())

    note.CallDataType = VTK_STRING
    executive = algorithm.GetExecutive()
    observed = [(each, each.AddObserver("ErrorEvent", note)) for each in (algorithm, executive)]
    try:
        # If something upstream fails, the algorithm silently keeps its old output.
        is_current = algorithm.GetNumberOfOutputPorts() > 0 and executive.Update(0)
    finally:
        for each, observer in observed:
            each.RemoveObserver(observer)
    if errors:
        raise RuntimeError("%s: %s" % (name, errors[0]))
    if not is_current:
        raise RuntimeError("%s could not be updated; see VTK's output" % name)
    output = algorithm.GetOutputDataObject(0)
    if not isinstance(output, vtkImageData):
        raise TypeError("the output of %s is %s, not a vtkImageData"
                        % (name, _kind(output)))
    return output


def _image_of_array(picture):
    import numpy  # callers with an array have it
    from vtkmodules.util.numpy_support import numpy_to_vtk

    if numpy.ma.is_masked(picture):
        raise ValueError("some of the array's values are masked; fill them, for example with filled(0)")
    array = numpy.asarray(picture)
    native = array.dtype.newbyteorder("=")  # byte order does not change the values
    if native not in (numpy.uint8, numpy.uint16):
        raise TypeError("the array's values are %s; they must be uint8 (0 to 255) or uint16"
                        % array.dtype)
    if array.ndim == 2:
        array = array[:, :, numpy.newaxis]
    if array.ndim != 3 or not 1 <= array.shape[2] <= 4 or 0 in array.shape:
        raise ValueError("the array's shape is %s; it must be (height, width) or (height,"
                         " width, components), with 1 to 4 components" % (array.shape,))
    height, width, components = array.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    rows = array[::-1].astype(native, order="C").reshape(-1, components)  # VTK's begin at the bottom
    image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=True))
    return image
