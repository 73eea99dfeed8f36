# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of mesh file gives the same picture; every kind of bad file gives status 1 and one line."""

import os
import unittest

import commandline as make
from commandline import CommandTest, SQUARE, TETRAHEDRON

VIEW = ("--direction", "1,2,3", "--size", "64x48")

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CUBE_FACES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
VOXEL = 11  # its points are ordered by x, then y, then z


def moved(mesh, x):
    points, faces = mesh
    return [(point[0] + x, point[1], point[2]) for point in points], faces


KINDS = {
    "text.vtp": make.vtp(TETRAHEDRON),
    "double.vtp": make.vtp(TETRAHEDRON, "Float64"),
    "text.vtk": make.vtk_text(TETRAHEDRON),
    "binary.vtk": make.vtk_binary(TETRAHEDRON),
    "text.ply": make.ply_text(TETRAHEDRON),
    "little.ply": make.ply_binary(TETRAHEDRON, "<"),
    "big.ply": make.ply_binary(TETRAHEDRON, ">"),
    "double.ply": make.ply_binary(TETRAHEDRON, "<", "double"),
    "text.stl": make.stl_text(TETRAHEDRON),
    "binary.stl": make.stl_binary(TETRAHEDRON),
    "text.obj": make.obj(TETRAHEDRON),
}


class TestReading(CommandTest):

    def picture(self, *arguments):
        self.succeed(*arguments, *VIEW, "-o", "picture.pnm")
        return self.read("picture.pnm")

    def fail_to_read(self, name):
        line = self.fail_with(1, name, "-o", "x.png")
        self.assertIn("cannot read '" + name + "': ", line)
        self.assertNotIn("0x", line)  # no address
        self.assertNotIn(".cxx", line)  # no source file of VTK
        return line

    def test_every_format_gives_the_same_picture(self):
        for shading in ("flat", "smooth"):
            pictures = {}
            for name, content in KINDS.items():
                self.write(name, content)
                pictures.setdefault(self.picture(name, "--shading", shading), []).append(name)
            self.assertEqual(len(pictures), 1, pictures.values())

    def test_extensions_may_be_in_upper_case(self):
        self.write("a.OBJ", make.obj(TETRAHEDRON))
        self.write("a.obj", make.obj(TETRAHEDRON))
        self.assertEqual(self.picture("a.OBJ"), self.picture("a.obj"))

    def test_volumes_are_drawn_by_their_outer_surface(self):
        # Two adjacent cubes, each as a voxel; the wall between them is not drawn.
        points = CUBE + [(x + 1, y, z) for x, y, z in CUBE if x == 1]
        cells = [tuple(range(8)), (1, 8, 3, 9, 5, 10, 7, 11)]
        self.write("volume.vtk", make.vtk_grid(points, cells, VOXEL))
        self.write("volume.vtu", make.vtu(points, cells, VOXEL))
        box = [(2 * x, y, z) for x, y, z in CUBE]
        self.write("box.obj", make.obj((box, CUBE_FACES)))
        expected = self.picture("box.obj", "--shading", "flat")
        self.assertEqual(self.picture("volume.vtk", "--shading", "flat"), expected)
        self.assertEqual(self.picture("volume.vtu", "--shading", "flat"), expected)

    def test_several_inputs_are_one_scene(self):
        self.write("left.obj", make.obj(TETRAHEDRON))
        self.write("right.ply", make.ply_text(moved(TETRAHEDRON, 3)))
        points = TETRAHEDRON[0] + moved(TETRAHEDRON, 3)[0]
        faces = TETRAHEDRON[1] + [tuple(i + 4 for i in face) for face in TETRAHEDRON[1]]
        self.write("both.vtp", make.vtp((points, faces)))
        both = self.picture("both.vtp")
        self.assertEqual(self.picture("left.obj", "right.ply"), both)
        self.assertEqual(self.picture("right.ply", "left.obj"), both)
        self.assertNotEqual(self.picture("left.obj"), both)

    def test_double_coordinates_are_not_rounded_to_float(self):
        # 1e7 and beside it a triangle of size 1e-3: as floats all its points would coincide.
        points = [(1e7, 1e7, 0.0), (1e7 + 1e-3, 1e7, 0.0), (1e7, 1e7 + 1e-3, 0.0)]
        self.write("far.ply", make.ply_text((points, [(0, 1, 2)]), "double"))
        self.write("far.vtp", make.vtp((points, [(0, 1, 2)]), "Float64"))
        view = ("--camera-position", "10000000.00025,10000000.00025,1", "--focal-point",
                "10000000.00025,10000000.00025,0", "--parallel-scale", "0.0001")
        self.assertEqual(self.pixels("far.ply", *view), [[(255, 255, 255)] * 9] * 9)
        self.assertEqual(self.picture("far.ply"), self.picture("far.vtp"))

    def test_point_normals_of_the_file_are_used(self):
        header = ("ply\nformat ascii 1.0\nelement vertex 4\n" +
                  "".join("property float %s\n" % name for name in
                          ("x", "confidence", "y", "z", "nx", "ny", "nz")) +
                  "element edge 1\nproperty int a\nproperty list uchar int b\n"
                  "element face 1\nproperty uchar flags\n"
                  "property list uint8 uint32 vertex_index\nend_header\n")
        for normal, value in (((0, 0, 1), 255), ((0, 0.8, 0.6), 153)):
            body = "".join("%r 7 %r %r %r %r %r\n" % (*point, *normal) for point in SQUARE[0])
            self.write("normals.ply", header + body + "5 2 0 1\n9 4 0 1 2 3\n")
            # A light along -z and a normal (0, 0.8, 0.6): the cosine is 0.6.
            center = self.center("normals.ply", "--light", "direction=0,0,-1")
            self.assertEqual(center, (value, value, value))

    def test_truncated_files_are_errors(self):
        # TestBrokenFiles.cxx cuts more kinds after each byte, but only calls the readers.
        for name, content in KINDS.items():
            whole = content if isinstance(content, bytes) else content.encode()
            extension = name[name.index("."):]
            picture = self.picture(self.write(name, whole))
            for size in sorted({1, *range(2, len(whole), len(whole) // 12), len(whole) - 1}):
                self.write("cut" + extension, whole[:size])
                done = self.run_command("cut" + extension, "-o", "x.pnm", *VIEW)
                if done.returncode == 1:
                    self.fail_to_read("cut" + extension)
                    continue
                self.assertEqual(done.returncode, 0)
                if self.read("x.pnm") != picture:
                    self.assertEqual(extension, ".obj")  # which has no counts
                os.remove(self.path("x.pnm"))

    def test_impossible_sizes_are_refused(self):
        # VTK's XML readers trust these, and crash.
        text = make.vtp(TETRAHEDRON)
        for old, new in (('NumberOfPolys="4"', 'NumberOfPolys="4611686018427387904"'),
                         ('NumberOfPoints="4"', 'NumberOfPoints="6148914691236517206"'),
                         ("3 6 9 12", "3 6 9 4611686018427387904")):
            self.assertIn(old, text)
            self.write("wrong.vtp", text.replace(old, new))
            self.assertIn("is invalid", self.fail_to_read("wrong.vtp"))

    def test_cells_with_the_wrong_number_of_points_are_refused(self):
        tetrahedron = CUBE[:4], [(0, 1, 2, 3)]
        for cell_type, words in (
                (12, "its cell 0 of type 12 (vtkHexahedron) has 4 points instead of 8; correct"),
                (5, "its cell 0 of type 5 (vtkTriangle) has 4 points instead of 3; correct"),
                (250, "its cell 0 of type 250 has 4 points, but there is no such type; correct"),
                (36, "has 4 points; such cells have 6, 8, 10, ... points; correct"),
                (72, "(vtkLagrangeHexahedron) has 4 points; such cells have 8, 27, 64, ... points"),
                (74, "of type 74 has 4 points; such cells have 5, 14, 30, ... points; correct")):
            for name, text in (("wrong.vtk", make.vtk_grid(*tetrahedron, cell_type)),
                               ("wrong.vtu", make.vtu(*tetrahedron, cell_type))):
                self.write(name, text)
                line = self.fail_to_read(name)
                self.assertIn(words, line)
                self.assertNotIn("complete copy", line)  # a complete copy would have the same cell

    def test_cells_with_too_many_points_are_refused(self):
        # The second of several cells.
        cells = [(0, 1, 2), (1, 2, 3, 0), (0, 1, 3)]
        for name, text in (("wrong.vtk", make.vtk_grid(CUBE, cells, 5)),
                           ("wrong.vtu", make.vtu(CUBE, cells, 5))):
            self.write(name, text)
            self.assertIn("its cell 1 of type 5 (vtkTriangle) has 4 points instead of 3",
                          self.fail_to_read(name))

    def test_polyhedra_without_faces_are_refused(self):
        # VTK's filters follow the list of faces without checks.
        self.write("wrong.vtu", make.vtu(CUBE, [(0, 1, 2, 4)], 42))
        self.assertIn("its cell 0 of type 42 (vtkPolyhedron) has no faces; correct",
                      self.fail_to_read("wrong.vtu"))
        for stream in ((0,), (4, 3, 0, 1, 2), (1, 3, 0, 1, 9), (1, -3, 0, 1, 2), (1, 9, 0, 1, 2)):
            self.write("wrong.vtk", make.vtk_grid(CUBE, [stream], 42))
            self.assertIn("faces" if stream[-1] != 9 else "point 9, which does not exist",
                          self.fail_to_read("wrong.vtk"))

    def test_wrong_numbers_of_cell_types_are_refused(self):
        text = make.vtk_grid(CUBE, [tuple(range(8))] * 2, VOXEL)
        for types, words in (("1\n11\n", "2 CELLS and 1 CELL_TYPES"),
                             ("3\n11\n11\n11\n", "2 CELLS and 3 CELL_TYPES"),
                             ("2\n11\n300\n", "cell 1 is of type 300, but there is no such")):
            self.write("wrong.vtk", text[:text.index("CELL_TYPES ") + 11] + types)
            self.assertIn(words, self.fail_to_read("wrong.vtk"))

    def test_a_list_may_begin_on_the_line_of_its_keyword(self):
        text = make.vtk_text(TETRAHEDRON)
        picture = self.picture(self.write("lines.vtk", text))
        at = text.index("POLYGONS")
        end = text.index("\n", at)
        for separator in (" ", "\t", "\r\n", "\n\n"):
            self.write("line.vtk", text[:end] + separator + text[end + 1:])
            self.assertEqual(self.picture("line.vtk"), picture)
        self.write("line.vtk", text[:at] + text[at:].replace("\n", " "))
        self.assertEqual(self.picture("line.vtk"), picture)

    def test_lists_of_the_wrong_length_are_refused(self):
        text = make.vtk_text(TETRAHEDRON)
        for size, words in ((15, "at cell 3 of 4 of its POLYGONS"),
                            (17, "has 16 numbers, but its first line declares 17; correct that line"),
                            (99999, "too small for the count of 99999")):
            self.write("wrong.vtk", text.replace("POLYGONS 4 16", "POLYGONS 4 %d" % size))
            self.assertIn(words, self.fail_to_read("wrong.vtk"))

    def test_unknown_keywords_are_refused(self):
        self.write("wrong.vtk", make.vtk_text(TETRAHEDRON) + "TEXTURES 4\n")
        self.assertIn("it has 'textures' where a keyword such as POINTS is expected; correct",
                      self.fail_to_read("wrong.vtk"))

    def test_data_of_the_wrong_length_is_refused(self):
        text = make.vtk_text(TETRAHEDRON)
        for data, words in (("POINT_DATA 5\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3 4 5\n",
                             "POINT_DATA for 5 points, but 4 points; correct"),
                            ("CELL_DATA 3\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3\n",
                             "CELL_DATA for 3 cells, but 4 cells; correct")):
            self.write("wrong.vtk", text + data)
            self.assertIn(words, self.fail_to_read("wrong.vtk"))

    def test_the_last_line_end_may_be_missing(self):
        for name, text in (("a.vtk", make.vtk_text(TETRAHEDRON)),
                           ("b.vtk", make.vtk_grid(CUBE, [tuple(range(8))], VOXEL)),
                           ("c.vtp", make.vtp(TETRAHEDRON)),
                           ("d.vtu", make.vtu(CUBE, [tuple(range(8))], VOXEL))):
            expected = self.picture(self.write(name, text))
            self.write(name, text.rstrip("\n"))
            self.assertEqual(self.picture(name), expected)  # without any message

    def test_files_of_another_vtk_type_are_refused(self):
        multiblock = ('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                      '<DataSet index="0" file="a.vtp"/></vtkMultiBlockDataSet></VTKFile>\n')
        grid = make.vtu(CUBE, [tuple(range(8))], VOXEL)
        for name, text, words in (
                ("a.vtp", multiblock, "it holds vtkMultiBlockDataSet instead of PolyData; "),
                ("a.vtu", multiblock, "it holds vtkMultiBlockDataSet instead of UnstructuredGrid"),
                ("b.vtp", grid, "it holds UnstructuredGrid instead of PolyData; rename it so that "
                 "its name ends in .vtu"),
                ("b.vtu", make.vtp(TETRAHEDRON), "it holds PolyData instead of UnstructuredGrid; "
                 "rename it so that its name ends in .vtp"),
                ("c.vtp", "<html><body></body></html>\n", "begins with <html>"),
                ("d.vtp", make.vtk_text(TETRAHEDRON), "ends in .vtk"),
                ("e.vtk", make.vtp(TETRAHEDRON), "ends in .vtp"),
                ("f.vtk", grid, "ends in .vtu")):
            self.write(name, text)
            line = self.fail_to_read(name)
            self.assertIn(words, line)
            self.assertNotRegex(line, "whole|complete")

    def test_keywords_may_be_in_lower_case(self):
        # VTK's reader accepts these; there is also a title that looks like the line after it.
        for content in (make.vtk_text(TETRAHEDRON).replace("ASCII", "ascii"),
                        make.vtk_binary(TETRAHEDRON).replace(b"test\n", b"ASCII\n")):
            content = content if isinstance(content, bytes) else content.encode()
            content = content.replace(b"POLYGONS ", b"polygons\t")
            self.picture(self.write("small.vtk", content))
            self.write("small.vtk", content[:-6])
            self.assertIn("at cell 3 of 4", self.fail_to_read("small.vtk"))

    def test_truncation_after_the_cells_is_an_error(self):
        # VTK's reader only warns of this and continues.
        normals = "POINT_DATA 4\nNORMALS n float\n" + "0 0 1\n" * 4
        self.write("cut.vtk", make.vtk_text(TETRAHEDRON) + normals[:-9])
        self.fail_to_read("cut.vtk")
        self.write("cut.vtk", make.vtk_text(TETRAHEDRON) + normals)
        self.picture("cut.vtk")

    def test_files_that_are_not_meshes_are_errors(self):
        for extension in (".vtp", ".vtu", ".vtk", ".ply", ".stl", ".obj"):
            self.write("text" + extension, "Dear reader,\nthis is a letter.\n" * 20)
            self.fail_to_read("text" + extension)
            self.write("bytes" + extension, bytes(range(256)) * 20)
            self.fail_to_read("bytes" + extension)
            self.write("empty" + extension, b"")
            self.assertIn("empty", self.fail_to_read("empty" + extension))

    def test_wrong_extensions_are_errors(self):
        self.write("mesh.ply", make.stl_binary(TETRAHEDRON))
        self.assertIn("'ply'", self.fail_to_read("mesh.ply"))
        self.write("mesh.vtp", make.vtu(CUBE, [tuple(range(8))], VOXEL))
        self.fail_to_read("mesh.vtp")

    def test_missing_files_are_errors(self):
        self.assertIn("no such file", self.fail_to_read("missing.ply"))
        os.mkdir(self.path("folder.ply"))
        self.assertIn("folder", self.fail_to_read("folder.ply"))
        self.write("letter.txt", "Dear reader")
        self.assertIn(".vtp .vtk", self.fail_to_read("letter.txt"))
        os.mkfifo(self.path("pipe.ply"))
        self.fail_to_read("pipe.ply")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_unreadable_files_are_errors(self):
        self.write("secret.ply", make.ply_text(SQUARE))
        os.chmod(self.path("secret.ply"), 0)
        self.assertIn("ermission", self.fail_to_read("secret.ply"))

    def test_missing_points_are_refused(self):
        wrong = SQUARE[0], [(0, 1, 2), (0, 2, 4)]
        negative = SQUARE[0], [(0, 1, 2), (0, 2, -1)]
        for name, content in (("a.ply", make.ply_text(wrong)), ("b.ply", make.ply_text(negative)),
                              ("c.vtp", make.vtp(wrong)), ("d.vtp", make.vtp(negative)),
                              ("e.vtk", make.vtk_text(wrong)), ("f.vtk", make.vtk_binary(negative)),
                              ("g.vtu", make.vtu(CUBE, [(0, 1, 2, 3, 4, 5, 6, 8)], VOXEL))):
            self.write(name, content)
            line = self.fail_to_read(name)
            self.assertIn("does not exist", line)
            if name[-4:] in (".vtp", ".vtk", ".vtu"):
                self.assertRegex(line, "its (polygon 1|cell 0) uses point (4|-1|8), .* the file "
                                 "has (4|8) points, numbered from 0; correct it")

    def test_impossible_counts_are_refused(self):
        text = make.ply_text(SQUARE)
        for old, new in (("vertex 4", "vertex 4000000000"), ("face 2", "face 1e18"),
                         ("face 2", "face 99999999999999999999"), ("vertex 4", "vertex -4"),
                         ("vertex 4", "vertex"), ("3 0 1 2", "2000000000 0 1 2"),
                         ("3 0 1 2", "-3 0 1 2"), ("float x", "strange x"), ("float x", "float q"),
                         ("ascii", "ebcdic"), ("format ascii 1.0\n", ""), ("vertex_indices", "v"),
                         ("element vertex", "element corner")):
            self.assertIn(old, text)
            self.write("wrong.ply", text.replace(old, new))
            self.fail_to_read("wrong.ply")

    def test_the_first_invalid_input_is_reported(self):
        self.write("good.obj", make.obj(SQUARE))
        line = self.fail_with(1, "good.obj", "bad.obj", "worse.obj", "-o", "x.png")
        self.assertIn("'bad.obj'", line)

    def test_files_without_polygons_show_the_background(self):
        self.write("points.ply", make.ply_text((SQUARE[0], [])))
        done = self.run_command("points.ply", "-o", "x.pnm", "--size", "3x3",
                                "--background", "1,0,0")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn(b"no polygons", done.stderr)
        self.assertEqual(make.read_pnm(self.read("x.pnm")), [[(255, 0, 0)] * 3] * 3)


class TestDragon(CommandTest):

    def test_the_dragon_is_read(self):
        dragon = os.path.join(os.environ.get("LAMBENT_SHARED_DATA_DIR", ""), "dragon.ply")
        if not os.path.exists(dragon):
            self.skipTest("there is no dragon.ply here")
        done = self.run_command(dragon, "-o", "x.pnm", "--size", "192x108", "--verbose")
        self.assertEqual(done.returncode, 0)
        self.assertIn(b"triangles  871414\n", done.stderr)
        rows = make.read_pnm(self.read("x.pnm"))
        lit = sum(pixel != (0, 0, 0) for row in rows for pixel in row)
        self.assertGreater(lit, 192 * 108 // 10)
        self.assertEqual(rows[0], [(0, 0, 0)] * 192)  # it fits


if __name__ == "__main__":
    unittest.main()
