# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The meshes of the scenes. Each function returns new data."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkFiltersSources import vtkSphereSource


def add(attributes, name, values):
    """Add an array to the point or cell data of a mesh."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)
    return array


def cell_array(cells):
    array = vtkCellArray()
    for cell in cells:
        ids = vtkIdList()
        for point in cell:
            ids.InsertNextId(int(point))
        array.InsertNextCell(ids)
    return array


def mesh(points, polygons=(), strips=(), lines=(), vertices=(), normals=None):
    result = vtkPolyData()
    held = vtkPoints()
    held.SetDataTypeToDouble()
    held.SetData(numpy_to_vtk(np.array(points, float), deep=True))
    result.SetPoints(held)
    for setter, cells in ((result.SetPolys, polygons), (result.SetStrips, strips),
                          (result.SetLines, lines), (result.SetVerts, vertices)):
        if len(cells):
            setter(cell_array(cells))
    if normals is not None:
        result.GetPointData().SetNormals(add(result.GetPointData(), "Normals",
                                             np.array(normals, np.float32)))
    return result


def add_arrays(result):
    """Arrays of all kinds, computed from the coordinates of the points and the numbers of the cells."""
    x, y, z = points_of(result).T
    points, cells = result.GetPointData(), result.GetCellData()
    height = np.sin(2 * x) + np.cos(3 * y) + 0.3 * z
    add(points, "height", height)
    add(points, "vector", np.stack([x, y, height], 1))
    add(points, "positive", 10 ** (1.5 * height))
    add(points, "holed", np.where(height > 1.2, np.nan, height))
    colours = np.stack([128 + 100 * np.sin(3 * x), 128 + 100 * np.cos(2 * y), 60 + 50 * (x + y + 2)], 1)
    colours = np.clip(colours, 0, 255).astype(np.uint8)
    add(points, "grey", colours[:, 0])
    add(points, "rgb", colours)
    alpha = np.clip(255 * (0.5 + 0.5 * np.sin(4 * x)), 0, 255).astype(np.uint8)
    add(points, "rgba", np.column_stack([colours, alpha]))
    add(points, "grey alpha", np.column_stack([colours[:, 0], alpha]))
    points.SetTCoords(add(points, "coordinates", np.stack([1.2 * x + 0.3, 1.2 * y + 0.4], 1).astype(np.float32)))
    number = np.arange(result.GetNumberOfCells())
    add(cells, "region", number * 7 % 5)
    add(cells, "number", np.where(number % 11 == 3, np.nan, number % 17 / 16.0))
    add(cells, "cell rgb", np.stack([number * 37 % 256, number * 59 % 256, number * 83 % 256], 1).astype(np.uint8))
    return result


def points_of(data):
    return np.array([data.GetPoint(k) for k in range(data.GetNumberOfPoints())])


def lattice(count):
    """The points of a square lattice over [-1, 1] x [-1, 1], and its triangles."""
    side = np.linspace(-1, 1, count)
    y, x = (each.ravel() for each in np.meshgrid(side, side, indexing="ij"))
    squares = [(j * count + i, j * count + i + 1, (j + 1) * count + i + 1, (j + 1) * count + i)
               for j in range(count - 1) for i in range(count - 1)]
    triangles = [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
    return x, y, squares, triangles


def wave(count=25, normals=True, quads=False):
    """A curved sheet that does not hide itself from the camera of the scenes."""
    x, y, squares, triangles = lattice(count)
    z = 0.15 * np.sin(3 * x) * np.cos(2.5 * y)
    slopes = np.stack([-0.45 * np.cos(3 * x) * np.cos(2.5 * y), 0.375 * np.sin(3 * x) * np.sin(2.5 * y),
                       np.ones_like(x)], 1)
    slopes /= np.linalg.norm(slopes, axis=1)[:, None]
    return add_arrays(mesh(np.stack([x, y, z], 1), polygons=squares if quads else triangles,
                           normals=slopes if normals else None))


def with_normals(change):
    """The wave with changed point normals."""
    result = wave()
    array = result.GetPointData().GetNormals()
    normals = np.array([array.GetTuple(k) for k in range(array.GetNumberOfTuples())])
    result.GetPointData().SetNormals(add(result.GetPointData(), "Normals", change(normals).astype(np.float32)))
    return result


def with_long_normals():
    return with_normals(lambda normals: normals * (0.2 + np.arange(len(normals)) % 7)[:, None])


def far_away(offset=2.0e5):
    result = wave()
    result.GetPoints().SetData(numpy_to_vtk(points_of(result) + offset, deep=True))
    return result


def coincident():
    """Three squares in the same place."""
    square = [(-0.8, -0.6, 0), (0.7, -0.6, 0), (0.7, 0.6, 0), (-0.8, 0.6, 0)]
    result = mesh(square, polygons=3 * [(0, 1, 2, 3)])
    add(result.GetCellData(), "region", np.arange(3))
    return result


def in_reverse_order(data):
    """The same cells, the last one first."""
    count = data.GetNumberOfCells()
    cells = [[data.GetCell(k).GetPointId(i) for i in range(data.GetCell(k).GetNumberOfPoints())]
             for k in reversed(range(count))]
    result = mesh(points_of(data), polygons=cells)
    numbers = data.GetCellData().GetArray("region")
    add(result.GetCellData(), "region", np.array([numbers.GetValue(k) for k in reversed(range(count))]))
    return result


def with_own_table():
    result = wave()
    own = vtkLookupTable()
    own.SetHueRange(0.1, 0.9)
    own.SetTableRange(-1.4, 2.2)
    own.Build()
    result.GetPointData().GetArray("height").SetLookupTable(own)
    return result


def coarse(normals=False):
    return wave(7, normals)


def strips():
    """The points of the wave as triangle strips, one a row."""
    data, count = wave(), 25
    rows = [[k for i in range(count) for k in ((j + 1) * count + i, j * count + i)] for j in range(count - 1)]
    result = mesh(points_of(data), strips=rows)
    result.GetPointData().ShallowCopy(data.GetPointData())
    add(result.GetCellData(), "region", np.arange(count - 1) * 7 % 5)
    return result


def sphere(resolution=48, radius=0.9):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(radius)
    source.Update()
    return add_arrays(source.GetOutput())


def bowl():
    """Half a sphere, open towards the camera, so that its back is seen."""
    source = vtkSphereSource()
    source.SetThetaResolution(48)
    source.SetPhiResolution(48)
    source.SetRadius(0.9)
    source.SetEndTheta(200)
    source.Update()
    return add_arrays(source.GetOutput())


def cube(normals=False):
    corners = [(x, y, z) for z in (-0.6, 0.6) for y in (-0.6, 0.6) for x in (-0.6, 0.6)]
    squares = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    result = mesh(corners, polygons=squares)
    add(result.GetCellData(), "region", np.arange(6))
    if normals:  # of the cells: tilted, so that they are not those of the faces
        tilted = np.array([(0.3, 0, -1), (0, 0.3, 1), (0, -1, 0.3), (0.3, 1, 0), (-1, 0.3, 0), (1, 0, 0.3)])
        tilted /= np.linalg.norm(tilted, axis=1)[:, None]
        result.GetCellData().SetNormals(add(result.GetCellData(), "Normals", tilted.astype(np.float32)))
    return result


def polygons():
    """Flat polygons with 3 to 9 corners, two of them concave."""
    points, cells = [], []

    def polygon(centre, corners):
        cells.append(range(len(points), len(points) + len(corners)))
        points.extend((centre[0] + x, centre[1] + y, 0.0) for x, y in corners)

    for k, count in enumerate((3, 4, 5, 6, 9)):
        angles = np.linspace(0, 2 * np.pi, count, endpoint=False) + 0.1
        polygon((-1.0 + 0.5 * k, 0.4), np.stack([0.24 * np.cos(angles), 0.24 * np.sin(angles)], 1))
    polygon((-0.6, -0.4), [(-0.4, -0.3), (0.4, -0.3), (0.0, -0.1), (0.35, 0.35), (-0.35, 0.3)])
    polygon((0.5, -0.4), [(-0.4, -0.3), (0.4, -0.3), (0.4, 0.3), (0.2, 0.3), (0.2, -0.1), (-0.2, -0.1),
                          (-0.2, 0.3), (-0.4, 0.3)])
    result = mesh(points, polygons=cells)
    add(result.GetCellData(), "region", np.arange(len(cells)))
    return result


def mixed(thin=True):
    """Polygons, strips and perhaps vertices and lines in one mesh, each cell with a colour of its own."""
    x = np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
    points = [(a, b, 0.0) for b in (-0.8, -0.3, 0.2, 0.7) for a in x]
    result = mesh(points, polygons=[(0, 1, 6, 5), (1, 2, 7), (3, 4, 9, 8)],
                  strips=[(10, 5, 11, 6, 12, 7), (13, 8, 14, 9)],
                  lines=[(15, 16, 17), (18, 13)] if thin else (), vertices=[(19,), (18, 12)] if thin else ())
    number = np.arange(result.GetNumberOfCells())
    add(result.GetCellData(), "number", number / 8.0)
    add(result.GetPointData(), "height", points_of(result)[:, 0])
    return result


def without_polygons(vertices=False, normals=False):
    data = mixed()
    cells = ([(k,) for k in range(data.GetNumberOfPoints())] if vertices else
             [(0, 1, 2, 3, 4), (5, 11), (6, 12, 8), (10, 16, 12, 18, 14), (7, 9)])
    given = [(0.15 * (k % 5) - 0.3, 0.1, 0.9) for k in range(data.GetNumberOfPoints())] if normals else None
    result = mesh(points_of(data), normals=given, **{"vertices" if vertices else "lines": cells})
    add(result.GetPointData(), "height", points_of(data)[:, 0])
    add(result.GetCellData(), "number", np.arange(len(cells)) / 8.0)
    return result


def layers(values=(-0.4, 0.0, 0.4)):
    """Parallel squares, one behind the other and to the side."""
    points, cells = [], []
    for k, z in enumerate(values):
        cells.append(range(4 * k, 4 * k + 4))
        points += [(x + z, y + 0.7 * z, z) for x, y in ((-0.6, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.6, 0.5))]
    result = mesh(points, polygons=cells, normals=[(0, 0, 1)] * len(points))
    add(result.GetCellData(), "region", np.arange(len(cells)))
    return result


def balls():
    """Points for spheres, with radii and colours."""
    points = [(-0.8, -0.4, 0.0), (-0.2, 0.3, 0.2), (0.35, -0.35, -0.3), (0.8, 0.35, 0.1), (0.1, -0.1, 0.6)]
    result = mesh(points, vertices=[(k,) for k in range(len(points))])
    add(result.GetPointData(), "radius", np.array([0.3, 0.4, 0.5, 0.25, 0.15]))
    add(result.GetPointData(), "height", np.arange(5) / 4.0)
    return result


def ghosts():
    """A sheet with duplicate, hidden and refined cells."""
    result = coarse(normals=True)
    flags = np.zeros(result.GetNumberOfCells(), np.uint8)
    flags[5:9] = vtkDataSetAttributes.DUPLICATECELL
    flags[30:36] = vtkDataSetAttributes.HIDDENCELL
    flags[60:61] = vtkDataSetAttributes.REFINEDCELL
    add(result.GetCellData(), vtkDataSetAttributes.GhostArrayName(), flags)
    return result


def without_ghosts(data):
    flags = data.GetCellData().GetArray(vtkDataSetAttributes.GhostArrayName())
    kept = [k for k in range(data.GetNumberOfCells()) if flags.GetValue(k) == 0]
    result = vtkPolyData()
    result.SetPoints(data.GetPoints())
    result.GetPointData().ShallowCopy(data.GetPointData())
    result.SetPolys(cell_array([[data.GetCell(k).GetPointId(i) for i in range(3)] for k in kept]))
    return result


def blocks():
    """[0: [0: cube, 1: sphere], 1: sheet], side by side."""

    def moved(data, x):
        data.GetPoints().SetData(numpy_to_vtk(0.5 * points_of(data) + (x, 0, 0), deep=True))
        return data

    inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    inner.SetBlock(0, moved(sphere(24), -0.8))
    inner.SetBlock(1, moved(sphere(48), 0.1))
    outer.SetBlock(0, inner)
    outer.SetBlock(1, moved(wave(), 0.95))
    return outer
