# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the command: running it, small meshes, reading pictures."""

import os
import shutil
import struct
import subprocess
import tempfile
import unittest

COMMAND = os.environ["LAMBENT_COMMAND"]

# A square of side 2 in the plane z = 0 about the origin, counter-clockwise when seen from +z.
SQUARE = ([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2), (0, 2, 3)])

# A tetrahedron whose faces have different brightness from every side.
TETRAHEDRON = ([(0, 0, 0), (2, 0, 0.5), (0.25, 1.5, 0), (0.5, 0.5, 1.75)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


class CommandTest(unittest.TestCase):
    """Runs the command in a new, empty folder."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="lambent ", dir=os.getcwd())  # the name has a space
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self):
        return sorted(os.listdir(self.folder))

    def write(self, name, content):
        mode = "wb" if isinstance(content, bytes) else "w"
        with open(self.path(name), mode) as file:
            file.write(content)
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_command(self, *arguments, **keywords):
        return subprocess.run([COMMAND, *map(str, arguments)], cwd=self.folder, timeout=120,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, **keywords)

    def succeed(self, *arguments, **keywords):
        """The command succeeds without any message."""
        done = self.run_command(*arguments, **keywords)
        self.assertEqual((done.returncode, done.stderr), (0, b""), arguments)
        return done.stdout

    def fail_with(self, status, *arguments, **keywords):
        """The command fails with one line (and a hint after wrong usage) and leaves no file. Returns the
        line."""
        before = self.files()
        done = self.run_command(*arguments, **keywords)
        lines = done.stderr.decode().splitlines()
        self.assertEqual((done.returncode, done.stdout), (status, b""), (arguments, lines))
        if status == 2:
            self.assertEqual(lines[1:], ["Try 'lambent --help'."], arguments)
        else:
            self.assertEqual(len(lines), 1, lines)
        self.assertTrue(lines[0].startswith("lambent: "), lines)
        self.assertEqual(self.files(), before, arguments)
        return lines[0]

    def pixels(self, *arguments):
        """Renders 9 x 9 pixels with one sample each, unless the arguments set more. Returns rows of
        (r, g, b), the top row first."""
        if "--supersampling" not in arguments:
            arguments += ("--supersampling", "1")
        self.succeed(*arguments, "-o", "pixels.pnm", "--size", "9x9", "--quiet")
        return read_pnm(self.read("pixels.pnm"))

    def center(self, *arguments):
        return self.pixels(*arguments)[4][4]


def read_pnm(content):
    """Rows of (r, g, b), the top row first."""
    fields = []
    at = 0
    while len(fields) < 4:
        end = content.index(b"\n", at)
        line = content[at:end]
        at = end + 1
        if not line.startswith(b"#"):
            fields += line.split()
    assert fields[0] == b"P6" and fields[3] == b"255", fields
    width, height = int(fields[1]), int(fields[2])
    body = content[at:]
    assert len(body) == 3 * width * height, len(body)
    return [[tuple(body[3 * (row * width + i):3 * (row * width + i) + 3]) for i in range(width)]
            for row in range(height)]


def flat_list(items):
    return " ".join(str(value) for item in items for value in item)


def obj(mesh):
    points, faces = mesh
    return ("".join("v %r %r %r\n" % point for point in points) +
            "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces))


def ply_header(encoding, mesh, coordinate="float", name="vertex_indices"):
    points, faces = mesh
    return ("ply\nformat %s 1.0\ncomment made by a test\nelement vertex %d\n" %
            (encoding, len(points)) +
            "".join("property %s %s\n" % (coordinate, axis) for axis in "xyz") +
            "element face %d\nproperty list uchar int %s\nend_header\n" % (len(faces), name))


def ply_text(mesh, coordinate="float", name="vertex_indices"):
    points, faces = mesh
    return (ply_header("ascii", mesh, coordinate, name) +
            "".join("%r %r %r\n" % point for point in points) +
            "".join("%d %s\n" % (len(face), " ".join(map(str, face))) for face in faces))


def ply_binary(mesh, order="<", coordinate="float"):
    points, faces = mesh
    encoding = "binary_little_endian" if order == "<" else "binary_big_endian"
    kind = "f" if coordinate == "float" else "d"
    return (ply_header(encoding, mesh, coordinate).encode() +
            b"".join(struct.pack(order + 3 * kind, *point) for point in points) +
            b"".join(struct.pack(order + "B%di" % len(face), len(face), *face) for face in faces))


def triangles(mesh):
    points, faces = mesh
    return [[points[i] for i in face] for face in faces]


def stl_text(mesh):
    return "solid test\n" + "".join(
        "facet normal 0 0 0\n outer loop\n" +
        "".join("  vertex %r %r %r\n" % corner for corner in triangle) +
        " endloop\nendfacet\n" for triangle in triangles(mesh)) + "endsolid test\n"


def stl_binary(mesh):
    return b"made by a test".ljust(80) + struct.pack("<I", len(mesh[1])) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *[x for corner in triangle for x in corner], 0)
        for triangle in triangles(mesh))


def vtk_text(mesh):
    points, faces = mesh
    return ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\n" +
            "POINTS %d float\n%s\n" % (len(points), flat_list(points)) +
            "POLYGONS %d %d\n" % (len(faces), sum(len(face) + 1 for face in faces)) +
            "".join("%d %s\n" % (len(face), " ".join(map(str, face))) for face in faces))


def vtk_binary(mesh):
    points, faces = mesh
    return (b"# vtk DataFile Version 3.0\ntest\nBINARY\nDATASET POLYDATA\n" +
            b"POINTS %d float\n" % len(points) +
            b"".join(struct.pack(">3f", *point) for point in points) +
            b"\nPOLYGONS %d %d\n" % (len(faces), sum(len(face) + 1 for face in faces)) +
            b"".join(struct.pack(">%di" % (len(face) + 1), len(face), *face) for face in faces) +
            b"\n")


def vtk_grid(points, cells, cell_type):
    """Volume cells of a single type, in the legacy format."""
    return ("# vtk DataFile Version 3.0\ntest\nASCII\nDATASET UNSTRUCTURED_GRID\n" +
            "POINTS %d float\n%s\n" % (len(points), flat_list(points)) +
            "CELLS %d %d\n" % (len(cells), sum(len(cell) + 1 for cell in cells)) +
            "".join("%d %s\n" % (len(cell), " ".join(map(str, cell))) for cell in cells) +
            "CELL_TYPES %d\n" % len(cells) + "%d\n" % cell_type * len(cells))


def xml_array(name, kind, values, components=1):
    return ('<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="ascii">%s</DataArray>'
            % (kind, name, components, " ".join(map(str, values))))


def xml_cells(cells):
    offsets = [sum(len(cell) for cell in cells[:i + 1]) for i in range(len(cells))]
    return (xml_array("connectivity", "Int64", [i for cell in cells for i in cell]) +
            xml_array("offsets", "Int64", offsets))


def vtp(mesh, coordinate="Float32", point_data=""):
    points, faces = mesh
    return ('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>'
            '<Piece NumberOfPoints="%d" NumberOfPolys="%d">' % (len(points), len(faces)) +
            point_data + "<Points>" +
            xml_array("Points", coordinate, [x for point in points for x in point], 3) +
            "</Points><Polys>" + xml_cells(faces) + "</Polys></Piece></PolyData></VTKFile>\n")


def vtu(points, cells, cell_type):
    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">'
            '<UnstructuredGrid><Piece NumberOfPoints="%d" NumberOfCells="%d">' %
            (len(points), len(cells)) + "<Points>" +
            xml_array("Points", "Float32", [x for point in points for x in point], 3) +
            "</Points><Cells>" + xml_cells(cells) +
            xml_array("types", "UInt8", [cell_type] * len(cells)) +
            "</Cells></Piece></UnstructuredGrid></VTKFile>\n")
