# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""GIFTI files in each way to write them: the picture of the same shape, or one true line.

TestFormats.py reads one whole file of each kind, TestBrokenFormats.cxx breaks it.
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
        """Draws it, and returns the only warning."""
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

    def test_encodings(self):
        expected = self.reference()
        for encoding, endian, order in itertools.product(
                ("ASCII", "Base64Binary", "GZipBase64Binary"), ("Little", "Big"), ("Row", "Column")):
            content = gifti(array("POINTSET", TETRAHEDRON[0], "FLOAT32", encoding, endian, order),
                            array("TRIANGLE", TETRAHEDRON[1], "INT32", encoding, endian, order))
            self.assertEqual(self.picture("a.gii", content), expected, (encoding, endian, order))

    def test_types(self):
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

    def test_no_surface(self):
        values = gifti(array("SHAPE", TETRAHEDRON[0], "FLOAT32"))
        self.assertIn(".surf.gii", self.failure("brain.func.gii", values))
        self.assertIn("1 arrays of points and 0 of triangles", self.failure("a.gii", gifti(POINTS)))
        self.assertIn("1 arrays of points and 2 of triangles",
                      self.failure("a.gii", gifti(POINTS, TRIANGLES, TRIANGLES)))
        self.assertIn("not a GIFTI file", self.failure("a.gii", "<VTKFile/>"))
        self.assertIn("is it whole", self.failure("a.gii", "Dear reader"))

    def test_triangles_that_name_no_point(self):
        for wrong in (4, -1, 2000000000):
            faces = TETRAHEDRON[1][:3] + [(2, wrong, 3)]
            line = self.failure("a.gii", gifti(POINTS, array("TRIANGLE", faces, "INT32")))
            self.assertIn("triangle 3 names a point that does not exist; there are 4", line)

    def test_points_that_are_not_finite(self):
        points = TETRAHEDRON[0][:2] + [(0, float("nan"), 0), (float("inf"), 0, 0)]
        content = gifti(array("POINTSET", points, "FLOAT32", "GZipBase64Binary"), TRIANGLES)
        self.assertIn("point 2 has a coordinate that is not a finite number",
                      self.failure("a.gii", content))

    def test_sizes_that_do_not_fit(self):
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

    def test_words_that_are_not_known(self):
        whole = array("TRIANGLE", TETRAHEDRON[1], "INT32", "Base64Binary")
        for old, new, word in (
                ("Base64Binary", "ExternalFileBinary", "wb_command"), ("INT32", "RGB24", "DataType"),
                ("LittleEndian", "MiddleEndian", "Endian"), ("RowMajor", "Major", "ArrayIndexingOrder"),
                ("Base64Binary", "Base85", "Encoding")):
            self.assertIn(word, self.failure("a.gii", gifti(POINTS, whole.replace(old, new))))

    def test_data_that_are_broken(self):
        for encoding, data, word in (
                ("ASCII", "0 2 1 x 1 3 1 2 3 2 0 3", "number 3"), ("Base64Binary", "AAAA*AAA", "base64"),
                ("Base64Binary", "AAA", "base64"), ("Base64Binary", "A===", "base64"),
                ("GZipBase64Binary", "AAAAAAAA", "packed"), ("Base64Binary", "", "fewer"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(48))[:-3]).decode(), "packed"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(47))).decode(), "fewer"),
                ("GZipBase64Binary", base64.b64encode(zlib.compress(bytes(1 << 24))).decode(), "more")):
            triangles = array("TRIANGLE", TETRAHEDRON[1], "INT32", encoding, data=data)
            self.assertIn(word, self.failure("a.gii", gifti(POINTS, triangles)), (encoding, data[:20]))


if __name__ == "__main__":
    unittest.main()
