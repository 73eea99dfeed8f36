# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""lambent FILE --list prints what files hold. TestDataOptions.cxx has the details of the table."""

import gzip
import unittest

from commandline import CommandTest, SQUARE, obj, vtp, vtu, xml_array

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]


def rows(text):
    """The rows of the table of arrays, without its header."""
    return [line.split(None, 6) for line in text.split("\n\n")[2].splitlines()[1:]]


class TestListing(CommandTest):

    def setUp(self):
        super().setUp()
        data = "<PointData>%s</PointData>" % xml_array("a name", "Float32", (1, 2, 3, 4.5))
        self.write("a.vtp", vtp(SQUARE, point_data=data))

    def listed(self, *arguments):
        return self.succeed(*arguments, "--list").decode()

    def test_points_cells_and_arrays(self):
        text = self.listed("a.vtp")
        self.assertTrue(text.startswith("a.vtp: 4 points, 2 cells, 1 block\nx -1 to 1, y -1 to 1, "
                                        "z 0 to 0\n\n"), text)
        self.assertEqual(rows(text), [["point", "float32", "1", "1", "4.5", "1", "a name"]])
        self.assertEqual(self.files(), ["a.vtp"])

    def test_all_kinds_of_readers(self):
        self.write("a.obj", obj(SQUARE))
        self.assertIn("4 points, 2 cells", self.listed("a.obj"))
        self.write("a.vtu", vtu(CUBE, [range(8)], 11))  # the volume, not its surface
        self.assertIn("8       1      unstructured  0\n", self.listed("a.vtu"))
        self.write("b.vtp.gz", gzip.compress(self.read("a.vtp")))
        self.assertEqual(self.listed("b.vtp.gz"),
                         self.listed("a.vtp").replace("a.vtp", "b.vtp.gz"))
        # An image has no surface, but can be listed. It is read in a separate process.
        self.write("a.vti", '<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">'
                   '<ImageData WholeExtent="0 1 0 1 0 0" Origin="0 0 0" Spacing="1 1 1">'
                   '<Piece Extent="0 1 0 1 0 0"><CellData>' + xml_array("density", "UInt16", (7,)) +
                   "</CellData></Piece></ImageData></VTKFile>\n")
        text = self.listed("a.vti")
        self.assertIn("4       1      image  0\n", text)
        self.assertEqual(rows(text), [["cell", "uint16", "1", "7", "7", "1", "density"]])

    def test_several_files_and_blocks(self):
        self.write("b.vtp", vtp(SQUARE))
        self.write("all.vtm", '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                   '<DataSet index="0" file="a.vtp"/><DataSet index="1" file="b.vtp"/>'
                   "</vtkMultiBlockDataSet></VTKFile>\n")
        text = self.listed("all.vtm")
        self.assertTrue(text.startswith("all.vtm: 8 points, 4 cells, 2 blocks\n"), text)
        self.assertEqual(rows(text)[0][5], "1")  # one of two blocks has the array
        self.assertEqual(self.listed("a.vtp", "b.vtp"),
                         self.listed("a.vtp") + "\n" + self.listed("b.vtp"))
        self.assertIn("no arrays", self.listed("b.vtp"))

    def test_errors(self):
        self.assertIn("cannot read 'none.vtp'", self.fail_with(1, "none.vtp", "--list"))
        self.assertIn("INPUT", self.fail_with(2, "--list"))
        for more in (("-o", "x.png"), ("--color", "red"), ("--compare", "x.png")):
            self.assertIn("--list excludes " + more[0].replace("-o", "--output"),
                          self.fail_with(2, "a.vtp", "--list", *more))
        self.succeed("a.vtp", "--list", "--quiet")


if __name__ == "__main__":
    unittest.main()
