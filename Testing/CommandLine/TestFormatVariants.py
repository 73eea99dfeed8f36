# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""GIFTI, Gmsh and Abaqus files in all variants give the picture of the same shape, or one correct line.

TestFormats.py reads one whole file of each kind; TestBrokenFormats.cxx damages it.
"""

import base64
import itertools
import struct
import unittest
import zlib

import commandline as make
from commandline import CommandTest, TETRAHEDRON

VIEW = ("--camera-position", "4,5,7", "--focal-point", "1,0.6,0.6", "--size", "64x48",
        "--shading", "flat")


class VariantsTest(CommandTest):

    def picture(self, name, content):
        self.write(name, content)
        self.succeed(name, *VIEW, "-o", "picture.pnm")
        return self.read("picture.pnm")

    def warning(self, name, content):
        """Renders it, and returns the only warning."""
        self.write(name, content)
        done = self.run_command(name, *VIEW, "-o", "picture.pnm")
        lines = done.stderr.decode().splitlines()
        self.assertEqual((done.returncode, len(lines)), (0, 1), lines)
        return lines[0]

    def failure(self, name, content):
        self.write(name, content)
        line = self.fail_with(1, name, "-o", "x.png")
        self.assertIn("cannot read '" + name + "': ", line)
        return line

    def reference(self, mesh=TETRAHEDRON):
        return self.picture("reference.obj", make.obj(mesh))


CODES = {"FLOAT32": "f", "FLOAT64": "d", "UINT8": "B", "INT8": "b", "INT16": "h", "UINT16": "H",
         "INT32": "i", "UINT32": "I", "INT64": "q", "UINT64": "Q"}


def encode(values, kind, encoding, endian):
    if encoding == "ASCII":
        return " ".join(map(str, values))
    raw = struct.pack({"Little": "<", "Big": ">"}[endian] + "%d%s" % (len(values), CODES[kind]), *values)
    if encoding.startswith("GZip"):
        raw = zlib.compress(raw)
    text = base64.b64encode(raw).decode()
    return "\n " + "\n".join(text[k:k + 60] for k in range(0, len(text), 60)) + " \n"


def array(intent, rows, kind, encoding="ASCII", endian="Little", order="Row", data=None):
    rows = list(rows)
    values = list(itertools.chain(*(rows if order == "Row" else zip(*rows))))
    return ('<DataArray Intent="NIFTI_INTENT_%s" DataType="NIFTI_TYPE_%s" Dimensionality="2" '
            'ArrayIndexingOrder="%sMajorOrder" Dim0="%d" Dim1="3" Encoding="%s" Endian="%sEndian">'
            '<Data>%s</Data></DataArray>\n' % (
                intent, kind, order, len(rows), encoding, endian,
                encode(values, kind, encoding, endian) if data is None else data))


def gifti(*arrays):
    return '<?xml version="1.0"?>\n<GIFTI Version="1.0">' + "".join(arrays) + "</GIFTI>\n"


POINTS = array("POINTSET", TETRAHEDRON[0], "FLOAT32")
TRIANGLES = array("TRIANGLE", TETRAHEDRON[1], "INT32")


class TestGifti(VariantsTest):

    def test_all_encodings_are_read(self):
        expected = self.reference()
        for encoding, endian, order in itertools.product(
                ("ASCII", "Base64Binary", "GZipBase64Binary"), ("Little", "Big"), ("Row", "Column")):
            content = gifti(array("POINTSET", TETRAHEDRON[0], "FLOAT32", encoding, endian, order),
                            array("TRIANGLE", TETRAHEDRON[1], "INT32", encoding, endian, order))
            self.assertEqual(self.picture("a.gii", content), expected, (encoding, endian, order))

    def test_all_number_types_are_read(self):
        expected = self.reference()
        for kind in CODES:
            points = "FLOAT32" if kind != "FLOAT64" else kind
            triangles = kind if "INT" in kind else "UINT8"
            content = gifti(array("TRIANGLE", TETRAHEDRON[1], triangles, "Base64Binary", "Big"),
                            array("POINTSET", TETRAHEDRON[0], points, "Base64Binary", "Big"))
            self.assertEqual(self.picture("a.gii", content), expected, kind)

    def test_several_surfaces_are_one_mesh(self):
        moved = [(x - 3, y, z) for x, y, z in TETRAHEDRON[0]]
        content = gifti(POINTS, TRIANGLES, array("POINTSET", moved, "FLOAT64"), TRIANGLES)
        expected = self.reference((TETRAHEDRON[0] + moved, TETRAHEDRON[1] + [
            tuple(4 + k for k in face) for face in TETRAHEDRON[1]]))
        self.assertEqual(self.picture("two.gii", content), expected)

    def test_files_without_a_surface_are_refused(self):
        values = gifti(array("SHAPE", TETRAHEDRON[0], "FLOAT32"))
        self.assertIn(".surf.gii", self.failure("brain.func.gii", values))
        self.assertIn("1 arrays of points and 0 of triangles", self.failure("a.gii", gifti(POINTS)))
        self.assertIn("1 arrays of points and 2 of triangles",
                      self.failure("a.gii", gifti(POINTS, TRIANGLES, TRIANGLES)))
        self.assertIn("not a GIFTI file", self.failure("a.gii", "<VTKFile/>"))
        self.assertIn("check that the file is complete", self.failure("a.gii", "Dear reader"))

    def test_triangles_with_missing_points_are_refused(self):
        for wrong in (4, -1, 2000000000):
            faces = TETRAHEDRON[1][:3] + [(2, wrong, 3)]
            line = self.failure("a.gii", gifti(POINTS, array("TRIANGLE", faces, "INT32")))
            self.assertIn("triangle 3 uses a point that does not exist; there are 4", line)

    def test_points_that_are_not_finite_are_refused(self):
        points = TETRAHEDRON[0][:2] + [(0, float("nan"), 0), (float("inf"), 0, 0)]
        content = gifti(array("POINTSET", points, "FLOAT32", "GZipBase64Binary"), TRIANGLES)
        self.assertIn("point 2 has a coordinate that is not a finite number",
                      self.failure("a.gii", content))

    def test_wrong_sizes_are_refused(self):
        for encoding in ("ASCII", "Base64Binary", "GZipBase64Binary"):
            whole = array("TRIANGLE", TETRAHEDRON[1], "INT32", encoding)
            for rows, word in ((3, "more"), (5, "fewer"), (2000000, "fewer"), (2000000000, "Dim0"),
                               (-4, "Dim0"), (4000000000, "Dim0"), ("4x", "Dim0"), ("", "Dim0")):
                line = self.failure(
                    "a.gii", gifti(POINTS, whole.replace('Dim0="4"', 'Dim0="%s"' % rows)))
                self.assertIn("data array 1 (NIFTI_INTENT_TRIANGLE): ", line)
                self.assertIn(word, line, (encoding, rows))
            for wrong in ('Dim1="2"', 'Dim1="4"', ''):
                self.assertIn("3 columns", self.failure(
                    "a.gii", gifti(POINTS, whole.replace('Dim1="3"', wrong))))

    def test_unknown_attributes_are_refused(self):
        whole = array("TRIANGLE", TETRAHEDRON[1], "INT32", "Base64Binary")
        for old, new, word in (
                ("Base64Binary", "ExternalFileBinary", "wb_command"), ("INT32", "RGB24", "DataType"),
                ("LittleEndian", "MiddleEndian", "Endian"), ("RowMajor", "Major", "ArrayIndexingOrder"),
                ("Base64Binary", "Base85", "Encoding")):
            self.assertIn(word, self.failure("a.gii", gifti(POINTS, whole.replace(old, new))))

    def test_corrupt_data_is_refused(self):
        for encoding, data, word in (
                ("ASCII", "0 2 1 x 1 3 1 2 3 2 0 3", "value 3"), ("Base64Binary", "AAAA*AAA", "base64"),
                ("Base64Binary", "AAA", "base64"), ("Base64Binary", "A===", "base64"),
                ("GZipBase64Binary", "AAAAAAAA", "compressed"), ("Base64Binary", "", "fewer"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(48))[:-3]).decode(), "compressed"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(47))).decode(), "fewer"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(1 << 24))).decode(), "more")):
            triangles = array("TRIANGLE", TETRAHEDRON[1], "INT32", encoding, data=data)
            self.assertIn(word, self.failure("a.gii", gifti(POINTS, triangles)), (encoding, data[:20]))


CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CUBE_FACES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
HEXAHEDRON = (0, 1, 3, 2, 4, 5, 7, 6)
TRIANGLE, QUAD, TETRAHEDRAL, HEXAHEDRAL = 2, 3, 4, 5
NODES = {15: 1, 1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 9: 6, 10: 9, 16: 8, 11: 10, 17: 20}
ORDERS = {"text": None, "little": "<", "big": ">"}


class Gmsh:
    """Writes a file as text, or as binary in a byte order. Nodes have the numbers 7, 10, 13, ... and the
    elements are (type, corners)."""

    def __init__(self, way, version):
        self.order = ORDERS[way]
        self.content = b"$MeshFormat\n%s %d 8\n" % (version.encode(), way != "text")
        if way != "text":
            self.put("i", 1)
            self.content += b"\n"
        self.content += b"$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"shell\"\n$EndPhysicalNames\n"

    def put(self, codes, *values):
        if self.order:
            self.content += struct.pack(self.order + codes, *values)
        else:
            self.content += " ".join(map(repr, values)).encode() + b"\n"

    def section(self, name, write, *arguments):
        self.content += b"$%s\n" % name
        write(*arguments)
        self.content += b"%s$End%s\n" % (b"\n" if self.order else b"", name)


def gmsh2(points, elements, way="text"):
    file = Gmsh(way, "2.2")

    def nodes():
        file.content += b"%d\n" % len(points)
        for k, point in enumerate(points):
            file.put("iddd", 7 + 3 * k, *point)

    def cells():
        file.content += b"%d\n" % len(elements)
        for k, (kind, corners) in enumerate(elements):
            ids = [7 + 3 * corner for corner in corners]
            if file.order:
                file.put("iii", kind, 1, 2)
                file.put("iii%di" % len(ids), k + 1, 0, 1, *ids)
            else:
                file.put("", k + 1, kind, 2, 0, 1, *ids)

    file.section(b"Nodes", nodes)
    file.section(b"Elements", cells)
    return file.content


def gmsh4(points, elements, way="text"):
    file = Gmsh(way, "4.1")
    last = 7 + 3 * (len(points) - 1)

    def nodes():
        file.put("qqqq", 2, len(points), 7, last)
        for part, parameters in ((range(1), 0), (range(1, len(points)), 1)):
            file.put("iiiq", 2, 1, parameters, len(part))
            for k in part:
                file.put("q", 7 + 3 * k)
            for k in part:
                file.put("ddd" + "dd" * parameters, *map(float, points[k]), *[0.5, 0.25] * parameters)

    def cells():
        file.put("qqqq", len(elements), len(elements), 1, len(elements))
        for k, (kind, corners) in enumerate(elements):
            file.put("iiiq", 2, 1, kind, 1)
            file.put("q%dq" % len(corners), k + 1, *[7 + 3 * corner for corner in corners])

    file.section(b"Nodes", nodes)
    file.section(b"Elements", cells)
    return file.content


class TestGmsh(VariantsTest):

    def ways(self, points, elements):
        for write, way in itertools.product((gmsh2, gmsh4), ORDERS):
            yield (write.__name__, way), write(points, elements, way)

    def test_surface_elements_are_read(self):
        expected = self.reference((CUBE, CUBE_FACES[1:] + [(0, 4, 6), (0, 6, 2)]))
        elements = [(QUAD, face) for face in CUBE_FACES[1:]] + [
            (15, (0,)), (1, (0, 1)), (TRIANGLE, (0, 4, 6)), (TRIANGLE, (0, 6, 2))]
        for way, content in self.ways(CUBE, elements):
            self.assertEqual(self.picture("a.msh", content), expected, way)

    def test_the_surface_of_volume_elements_is_read(self):
        expected = self.reference((CUBE, CUBE_FACES))
        for way, content in self.ways(CUBE, [(HEXAHEDRAL, HEXAHEDRON)]):
            self.assertEqual(self.picture("a.msh", content), expected, way)
        expected = self.reference()
        for way, content in self.ways(TETRAHEDRON[0], [(TETRAHEDRAL, (0, 1, 2, 3))]):
            self.assertEqual(self.picture("a.msh", content), expected, way)

    def test_second_order_elements_are_drawn_by_their_corners(self):
        for kind, corners in ((9, (0, 1, 3)), (10, (0, 1, 3, 2)), (16, (0, 1, 3, 2)),
                              (11, (0, 1, 2, 4)), (17, HEXAHEDRON)):
            first = {9: TRIANGLE, 10: QUAD, 16: QUAD, 11: TETRAHEDRAL, 17: HEXAHEDRAL}[kind]
            expected = self.picture("a.msh", gmsh2(CUBE, [(first, corners)]))
            nodes = corners + (5,) * (NODES[kind] - len(corners))
            for way, content in self.ways(CUBE, [(kind, nodes)]):
                self.assertEqual(self.picture("a.msh", content), expected, (kind, way))

    def test_files_with_only_lines_cause_a_warning(self):
        for way, content in self.ways(CUBE, [(1, (0, 1))]):
            self.warning("a.msh", content)

    def test_wrong_numbers_are_refused(self):
        text = gmsh2(*TETRAHEDRON[:1], [(TRIANGLE, face) for face in TETRAHEDRON[1]]).decode()
        for old, new, word in (
                ("4 2 2 0 1 13 7 16", "4 2 2 0 1 13 8 16", "element 4 uses node 8, which does not exist"),
                ("\n10 2", "\n7 2", "two nodes with the number 7"),
                ("\n10 2", "\n10 nan", "node 10 has a coordinate that is not a finite number"),
                ("\n10 2", "\n10 x", "line 11: there is no number where a coordinate"),
                ("$Nodes\n4", "$Nodes\n3", "line 13: the section $Nodes does not have the length"),
                ("$Nodes\n4", "$Nodes\n9000000000000000000", "line 14: there is no number"),
                ("$Nodes\n4", "$Nodes\n-4", "is negative"),
                ("$Elements\n4", "$Elements\n5", "there is no number"),
                ("4 2 2 0 1", "4 2 -2 0 1", "is negative"),
                ("4 2 2 0 1", "4 34 2 0 1", "element 4 is of type 34, which cannot be read"),
                ("2.2", "4.0", "msh41"), ("2.2", "1", "msh41"), ("2.2 0 8", "2.2 0 4", "8 bytes"),
                ("$MeshFormat", "$NOD", "meshio"), ("$MeshFormat", "(0 \"grid\")", "ANSYS Fluent")):
            self.assertIn(old, text)
            self.assertIn(word, self.failure("a.msh", text.replace(old, new, 1)), (old, new))

    def test_counts_beyond_the_file_are_refused(self):
        # The file has no count of corners.
        content = gmsh4(TETRAHEDRON[0] + [(0, 0, 0)], [(TRIANGLE, (0, 1, 2))] * 4, "little")
        for count in (4, 5):
            for wrong in (1 << 62, (1 << 63) - 1, -1):
                old, new = struct.pack("<q", count), struct.pack("<q", wrong)
                self.assertIn(old, content)
                self.assertIn("byte ", self.failure("a.msh", content.replace(old, new)))



def abaqus(points, *blocks):
    """Nodes have the numbers 10, 20, 30, ...; the blocks are (type, elements)."""
    text = "*Heading\n1, 2, 3\n*Node\n"
    text += "".join("%d, %r, %r, %r\n" % (10 * k + 10, *point) for k, point in enumerate(points))
    for kind, elements in blocks:
        text += "*Element, type=%s\n" % kind
        for k, corners in enumerate(elements):
            text += ", ".join(map(str, (k + 1, *[10 * corner + 10 for corner in corners]))) + "\n"
    return text


class TestAbaqus(VariantsTest):

    def test_surface_elements_are_read(self):
        expected = self.reference((CUBE, CUBE_FACES[1:] + [(0, 4, 6), (0, 6, 2)]))
        triangles = [(0, 4, 6), (0, 6, 2)]
        for quad in ("S4", "S4R", "s4r5", "CPS4", "CPE4R", "M3D4", "R3D4", "CAX4"):
            for triangle in ("S3", "S3R", "STRI3", "CPS3", "CPE3", "M3D3", "R3D3"):
                text = abaqus(CUBE, (quad, CUBE_FACES[1:]), (triangle, triangles))
                self.assertEqual(self.picture("a.inp", text), expected, (quad, triangle))
        for lines in (text.replace("\n", "\r\n"), text.replace("\n", "\r"), text.lower(), text.upper(),
                      "\ufeff" + text, text.replace("\n", "\n** comment,\n"), text.rstrip()):
            self.assertEqual(self.picture("a.inp", lines.encode()), expected)

    def test_the_surface_of_volume_elements_is_read(self):
        for kind, more, corners, faces in (
                ("C3D8", 0, HEXAHEDRON, CUBE_FACES), ("C3D8R", 0, HEXAHEDRON, CUBE_FACES),
                ("C3D20", 12, HEXAHEDRON, CUBE_FACES), ("SC8R", 0, HEXAHEDRON, CUBE_FACES),
                ("C3D4", 0, (0, 1, 2, 4), [(0, 2, 1), (0, 1, 4), (1, 2, 4), (2, 0, 4)]),
                ("C3D10M", 6, (0, 1, 2, 4), [(0, 2, 1), (0, 1, 4), (1, 2, 4), (2, 0, 4)]),
                ("C3D6", 0, (0, 1, 2, 4, 5, 6), [(0, 2, 1), (4, 5, 6), (0, 1, 5, 4), (1, 2, 6, 5), (2, 0, 4, 6)])):
            text = abaqus(CUBE, (kind, [corners + (5,) * more]))
            expected = self.reference((CUBE, faces))
            self.assertEqual(self.picture("a.inp", text), expected, kind)
            lines = text.rsplit(",", 2)
            self.assertEqual(self.picture("a.inp", lines[0] + ",\n" + lines[1] + "," + lines[2]), expected)

    def test_second_order_surfaces_are_drawn_by_their_corners(self):
        for kind, first in (("STRI65", "S3"), ("CPS6", "S3"), ("M3D6", "S3"), ("S8R", "S4"), ("CPE8", "S4"),
                            ("S9R5", "S4")):
            corners = (0, 4, 6) if first == "S3" else (0, 4, 6, 2)
            nodes = corners + (5,) * {"STRI65": 3, "S9R5": 5}.get(kind, len(corners))
            self.assertEqual(self.picture("a.inp", abaqus(CUBE, (kind, [nodes]))),
                             self.picture("a.inp", abaqus(CUBE, (first, [corners]))), kind)

    def test_other_elements_are_skipped_with_a_warning(self):
        text = abaqus(CUBE, ("B31", [(0, 1), (1, 2)]), ("S4", CUBE_FACES), ("T3D2", [(0, 3)]))
        line = self.warning("a.inp", text)
        self.assertIn("elements of unsupported types, such as 'B31', are skipped; they take up 3 lines", line)
        self.assertEqual(self.read("picture.pnm"), self.reference((CUBE, CUBE_FACES)))

    def test_all_parts_are_read(self):
        moved = [(x - 3, y, z) for x, y, z in TETRAHEDRON[0]]
        parts = "".join("*Part, name=P%d\n%s*End Part\n" % (k, abaqus(points, ("S3", TETRAHEDRON[1])))
                        for k, points in enumerate((TETRAHEDRON[0], moved)))
        expected = self.reference((TETRAHEDRON[0] + moved, TETRAHEDRON[1] + [
            tuple(4 + k for k in face) for face in TETRAHEDRON[1]]))
        instance = "*Assembly\n*Instance, name=A, part=P0\n%s*End Instance\n*Node\n10, 9, 9, 9\n*End Assembly\n"
        self.assertEqual(self.picture("a.inp", parts + instance % ""), expected)
        self.assertIn("not moved", self.warning("a.inp", parts + instance % "1, 0, 0\n"))
        self.assertEqual(self.read("picture.pnm"), expected)

    def test_unsupported_keywords_are_refused(self):
        whole = abaqus(*TETRAHEDRON[:1], ("S3", TETRAHEDRON[1]))
        for old, new, word in (
                ("*Node\n", "*Include, input=a.txt\n", "line 3: *INCLUDE refers to another file"),
                ("*Node\n", "*Node, input=a.txt\n", "line 3: *NODE refers to another file"),
                ("*Node\n", "*Node, system=C\n", "rectangular coordinates"),
                ("*Element", "*Ngen\n1, 5, 1\n*Element", "line 8: *NGEN creates or moves"),
                ("*Heading", "8 12 0 0 0", "AVS"), ("*Heading", "# made by AVS\n8 12 0 0 0", "AVS"),
                ("*Heading", "[TITLE]", "does not begin with a keyword"),
                ("*Element", "*Elset", "it has no elements"),
                (", type=S3", "", "line 8: *ELEMENT has no TYPE"),
                ("4, 30, 10, 40", "4, 30, 11, 40", "its element 4 uses node 11, which does not exist"),
                ("4, 30, 10, 40", "4, 30, 10, 40, 20", "line 12: element 4 has more than the 3 nodes"),
                ("4, 30, 10, 40", "4, 30, 10", "line 12: element 4 has only 2 of the 3 nodes of its type 'S3'"),
                ("4, 30, 10, 40", "4, 30, x, 40", "line 12: found 'X' where the number of an element or node"),
                ("20, 2", "20, two", "line 5: found 'TWO' where a coordinate of node 20"),
                ("20, 2", "20, inf", "node 20 has a coordinate that is not a finite number"),
                ("20, 2", "x, 2", "line 5: found 'X' where the number of a node")):
            self.assertIn(old, whole)
            self.assertIn(word, self.failure("a.inp", whole.replace(old, new, 1)), (old, new))


if __name__ == "__main__":
    unittest.main()
