# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each kind of file in the folder Formats gives the picture of the same shape in a simple format.

tetrahedron.* is commandline.TETRAHEDRON (rotated in 3DS, where z is up). box.* and *.vtk are a box of
2 x 1 x 1 in two cells, with the point data x and the cell data cell, 1 and 2. TestBrokenFormats.cxx damages
these files.
"""

import glob
import gzip
import os
import shutil
import unittest

import commandline as make
from commandline import CommandTest, TETRAHEDRON

FORMATS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Formats")
# A fixed camera, so that the position of a surface is visible.
VIEW = ("--camera-position", "4,5,7", "--focal-point", "1,0.6,0.6", "--size", "64x48")
FLAT = ("--shading", "flat")

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CUBE_FACES = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
BOX = [(2 * x, y, z) for x, y, z in CUBE], CUBE_FACES

IMAGES = ("box.vti", "box.pvti", "image.vtk")
GRIDS = ("box.vtr", "box.vts", "box.pvtr", "box.pvts", "box.pvtu", "structured.vtk",
         "rectilinear.vtk", "box.e", "box.case", "foam/box.foam")


class FormatsTest(CommandTest):

    def setUp(self):
        super().setUp()
        shutil.copytree(FORMATS, self.folder, dirs_exist_ok=True)
        self.temporary = self.path("temporary")
        os.mkdir(self.temporary)
        self.environment = dict(os.environ, TMPDIR=self.temporary)

    def picture(self, *arguments):
        self.succeed(*arguments, *VIEW, "-o", "picture.pnm", env=self.environment)
        self.assertEqual(os.listdir(self.temporary), [])
        return self.read("picture.pnm")

    def fail_to_read(self, name, *arguments):
        line = self.fail_with(1, name, "-o", "x.png", *arguments, env=self.environment)
        self.assertIn("cannot read '" + name + "': ", line)
        self.assertNotIn("0x", line)
        self.assertEqual(os.listdir(self.temporary), [])
        return line

    def readable(self, names):
        """The names whose kind this build of the command reads."""
        listed = self.succeed("--formats").decode()
        lacking = [line for line in listed.splitlines() if "not in this build" in line]
        return [name for name in names
                if not any("." + name.rsplit(".", 1)[1] in line.split() for line in lacking)]


class TestKinds(FormatsTest):

    def test_all_surface_formats_give_the_same_picture(self):
        self.write("expected.ply", make.ply_text(TETRAHEDRON))
        names = self.readable(sorted(map(os.path.basename,
                                         glob.glob(self.path("tetrahedron.*")))))
        self.assertGreaterEqual(len(names), 9)
        # Shared points decide where surfaces are smooth. Faces of two parts share none; those of 3DS
        # share them only within a smoothing group.
        apart = (".vtm", ".vtmb", ".vtpd", ".vtpc", ".pvtp", ".pvd", ".3ds")
        for shading in ("flat", "smooth"):
            expected = self.picture("expected.ply", "--shading", shading)
            for name in names:
                if shading == "flat" or not name.endswith(apart):
                    self.assertEqual(self.picture(name, "--shading", shading), expected, name)

    def test_all_volume_formats_give_the_same_picture(self):
        self.write("expected.obj", make.obj(BOX))
        expected = self.picture("expected.obj", *FLAT)
        for name in self.readable(GRIDS + ("box.msh",)):
            self.assertEqual(self.picture(name, *FLAT), expected, name)

    def test_walls_between_cells_are_not_drawn(self):
        # If the two cells are in one grid, the wall between them is not drawn.
        for name, count in (("tetrahedron.vtm", 4), ("tetrahedron.pvd", 4), ("box.vts", 20),
                            ("box.pvts", 20), ("box.pvtr", 20), ("box.pvtu", 24)):
            done = self.run_command(name, "-o", "x.png", "--verbose", *VIEW)
            self.assertIn(b"triangles  %d\n" % count, done.stderr, name)

    def test_contours_of_point_data_are_drawn(self):
        square = [(0.75, y, z) for y, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
        self.write("expected.obj", make.obj((square, [(0, 1, 2, 3)])))
        expected = self.picture("expected.obj", *FLAT)
        for name in IMAGES + GRIDS:
            if name in self.readable([name]) and "foam" not in name:
                self.assertEqual(self.picture(name, "--contour", "0.75,x", *FLAT), expected, name)
                if name != "structured.vtk":
                    self.assertEqual(self.picture(name, "--contour", "0.75", *FLAT), expected, name)

    def test_contours_of_cell_data_are_drawn(self):
        # Averaged at the points, the values of cell are 1, 1.5 and 2 along x.
        square = [(0.5, y, z) for y, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
        self.write("expected.obj", make.obj((square, [(0, 1, 2, 3)])))
        expected = self.picture("expected.obj", *FLAT)
        for name in ("box.vti", "box.vts", "image.vtk"):
            self.assertEqual(self.picture(name, "--contour", "1.25,cell", *FLAT), expected, name)

    def test_all_formats_can_be_gzipped(self):
        names = ["tetrahedron.ply", "tetrahedron.vtp", *sorted(os.listdir(FORMATS))]
        self.write(names[0], make.ply_binary(TETRAHEDRON))
        self.write(names[1], make.vtp(TETRAHEDRON))
        names = [name for name in self.readable(filter(lambda name: "." in name, names))]
        self.assertGreater(len(names), 20)
        for name in names:
            options = FLAT + (("--contour", "0.75,x") if name in IMAGES else ())
            expected = self.picture(name, *options)
            self.write(name + ".GZ", gzip.compress(self.read(name)))
            self.assertEqual(self.picture(name + ".GZ", *options), expected, name)
            os.remove(self.path(name + ".GZ"))

    def test_files_of_different_formats_form_one_scene(self):
        self.write("moved.off", self.read("tetrahedron.off").decode().replace("0 0 0", "-4 0 0"))
        self.write("moved.ply", make.ply_text((
            [(-4, 0, 0)] + TETRAHEDRON[0][1:], TETRAHEDRON[1])))
        self.write("box.obj", make.obj(BOX))
        self.assertEqual(self.picture("moved.off", "box.vts", *FLAT),
                         self.picture("moved.ply", "box.obj", *FLAT))

    def test_a_recreated_picture_has_its_contour(self):
        self.succeed("box.vti", "--contour", "0.75,x", *VIEW, "-o", "contour.png")
        self.assertIn(b"--contour 0.75,x", self.read("contour.png"))
        self.succeed("--recreate", "contour.png")


class TestFormatsList(FormatsTest):

    def test_all_formats_are_listed(self):
        text = self.succeed("--formats").decode()
        for extension in (".vtp .vtk .vtu .ply .stl .obj .off .vti .vtr .vts .pvtp .pvtu .vtm .pvd "
                          ".gii .msh .inp .gltf .glb .dae .3ds .fbx .3mf .amf .e .case .foam .gz .png").split():
            self.assertRegex(text, r"(?m)\%s\b" % extension)

    def test_unknown_extensions_are_refused(self):
        for name in ("letter.txt", "letter", "letter.gz", "mesh.ply.zip", "letter.txt.gz"):
            self.write(name, "Dear reader")
            line = self.fail_to_read(name)
            self.assertIn("its format is unknown", line)
            self.assertIn(".vtp .vtk .vtu", line)

    def test_unsupported_formats_are_refused_with_advice(self):
        for name, remedy in (("mesh.MED", "meshio"), ("part.step", "CAD"),
                             ("mesh.bdf.gz", "meshio")):
            self.write(name, "Dear reader")
            line = self.fail_to_read(name)
            self.assertIn("cannot be read; ", line)
            self.assertIn(remedy, line)
            self.assertIn(".vtp .vtk .vtu", line)

    def test_formats_that_this_build_lacks_are_refused(self):
        for name in set(os.listdir(FORMATS)) - set(self.readable(
                [name for name in os.listdir(FORMATS) if "." in name])):
            if "." in name:
                self.assertIn("without", self.fail_to_read(name))


class TestContourOptions(FormatsTest):

    def test_images_need_a_contour(self):
        for name in IMAGES:
            line = self.fail_to_read(name)
            self.assertIn("--contour VALUE[,ARRAY]", line)
            self.assertIn("cell from 1 to 2, x from 0 to 2", line)

    def test_wrong_values_and_arrays_are_refused(self):
        self.assertIn("no surface in it has x = 2.5; its arrays: cell from 1 to 2, x from 0 to 2",
                      self.fail_to_read("box.vti", "--contour", "2.5,x"))
        self.assertIn("no array 'y'", self.fail_to_read("box.vtr", "--contour", "1,y"))
        text = self.read("box.vti").decode()
        array = text[text.index("<DataArray"):text.index("</DataArray>")] + "</DataArray>"
        self.write("two.vti", text.replace(array, array + array.replace('"x"', '"y,z"')))
        self.assertIn("--contour does not name one of its arrays; its arrays: cell from 1 to 2, "
                      "x from 0 to 2, y,z from 0 to 2",
                      self.fail_to_read("two.vti", "--contour", "1"))
        self.picture("two.vti", "--contour", "0.75,y,z")

    def test_a_flat_image_has_no_contour_surface(self):
        text = self.read("image.vtk").decode().replace("3 2 2", "3 4 1")
        self.write("flat.vtk", text[:text.index("CELL_DATA")])
        self.assertIn("no surface", self.fail_to_read("flat.vtk", "--contour", "0.5,x"))

    def test_polygons_are_drawn_unchanged_with_contour(self):
        done = self.run_command("tetrahedron.off", "--contour", "1", "-o", "x.pnm", *VIEW)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (0, 1), done.stderr)
        self.assertIn(b"no volume", done.stderr)
        self.assertEqual(self.read("x.pnm"), self.picture("tetrahedron.off"))

    def test_invalid_contours_are_refused(self):
        for value in ("", "x", "nan", "inf", "1,", ",x"):
            self.assertIn("--contour", self.fail_with(2, "box.vti", "-o", "x.png", "--contour", value))


class TestParts(FormatsTest):

    def test_unreadable_parts_are_errors(self):
        for name, part in (("tetrahedron.vtm", "parts/back.vtp"), ("box.pvti", "parts/right.vti"),
                           ("tetrahedron.pvtp", "parts/back.vtp"), ("box.pvtu", "parts/right.vtu"),
                           ("tetrahedron.pvd", "parts/back.vtp"), ("box.pvts", "parts/right.vts")):
            whole = self.read(part)
            self.write(part, whole[:len(whole) // 2])
            self.assertIn("its part '%s': " % part, self.fail_to_read(name, "--contour", "1,x"))
            os.remove(self.path(part))
            self.assertIn("its part '%s': there is no such file" % part, self.fail_to_read(name))
            self.write(part, whole)

    def test_parts_may_have_other_formats(self):
        text = self.read("tetrahedron.vtm").decode()
        self.write("mixed.vtm", text.replace("parts/back.vtp", "box.pvts"))
        self.write("box.obj", make.obj(BOX))
        self.write("front.ply", make.ply_text((TETRAHEDRON[0], TETRAHEDRON[1][:2])))
        self.assertEqual(self.picture("mixed.vtm", *FLAT),
                         self.picture("front.ply", "box.obj", *FLAT))
        self.write("wrong.vtm", text.replace("parts/back.vtp", "letter.txt"))
        self.write("letter.txt", "Dear reader")
        self.assertIn("its part 'letter.txt': its format is unknown", self.fail_to_read("wrong.vtm"))

    def test_circular_references_are_errors(self):
        text = self.read("tetrahedron.vtm").decode()
        self.write("circle.vtm", text.replace("parts/back.vtp", "circle.vtm"))
        self.assertIn("in a circle", self.fail_to_read("circle.vtm"))

    def test_ghost_cells_are_not_drawn_twice(self):
        # The front declares that its second cell belongs to its neighbour, which has it, too.
        front = self.read("parts/front.vtp").decode()
        ghosts = ('<CellData><DataArray type="UInt8" Name="vtkGhostType" format="ascii">0 1'
                  '</DataArray></CellData>')
        self.write("parts/front.vtp", front.replace("<Points>", ghosts + "<Points>"))
        done = self.run_command("tetrahedron.pvtp", "-o", "x.png", "--verbose", *VIEW)
        self.assertIn(b"triangles  3\n", done.stderr)

    def test_files_without_a_mesh_are_errors(self):
        text = self.read("tetrahedron.vtm").decode()
        self.write("empty.vtm", text.replace("back", "empty").replace("front", "empty"))
        self.assertIn("no mesh", self.fail_to_read("empty.vtm"))


class TestGzip(FormatsTest):

    def setUp(self):
        super().setUp()
        self.packed = gzip.compress(self.read("tetrahedron.off"))

    def test_truncated_and_corrupt_gzip_files_are_errors(self):
        for size in range(1, len(self.packed)):
            self.write("cut.off.gz", self.packed[:size])
            self.assertIn("incomplete", self.fail_to_read("cut.off.gz"))
        for k in (0, 1, 2, 12, len(self.packed) // 2, len(self.packed) - 7, len(self.packed) - 1):
            wrong = bytearray(self.packed)
            wrong[k] ^= 0x10
            self.write("wrong.off.gz", bytes(wrong))
            self.fail_to_read("wrong.off.gz")

    def test_files_that_are_not_gzipped_are_refused(self):
        self.write("plain.off.gz", self.read("tetrahedron.off"))
        self.assertIn("not compressed", self.fail_to_read("plain.off.gz"))

    def test_several_members_and_trailing_bytes_are_handled(self):
        expected = self.picture("tetrahedron.off")
        text = self.read("tetrahedron.off")
        self.write("two.off.gz", gzip.compress(text[:20]) + gzip.compress(text[20:]))
        self.assertEqual(self.picture("two.off.gz"), expected)
        self.write("zeros.off.gz", self.packed + bytes(512))
        self.assertEqual(self.picture("zeros.off.gz"), expected)
        self.write("more.off.gz", self.packed + b"more")
        done = self.run_command("more.off.gz", "-o", "x.pnm", *VIEW, env=self.environment)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (0, 1), done.stderr)
        self.assertEqual(self.read("x.pnm"), expected)

    def test_decompression_bombs_are_refused(self):
        self.write("bomb.off.gz", gzip.compress(bytes(200 << 20)))  # 200 MiB of zeros as 200 kB
        self.assertIn("256 times", self.fail_to_read("bomb.off.gz"))

    def test_errors_name_the_compressed_file(self):
        self.write("wrong.vtp.gz", gzip.compress(b"Dear reader"))
        line = self.fail_to_read("wrong.vtp.gz")
        self.assertNotIn(self.temporary, line)
        self.assertNotIn(".lambent-", line)

    def test_a_missing_temporary_folder_is_an_error(self):
        self.environment["TMPDIR"] = self.path("nowhere")
        self.write("a.off.gz", self.packed)
        self.assertIn("TMPDIR", self.fail_to_read("a.off.gz"))

    def test_compressed_parts_are_refused(self):
        text = self.read("tetrahedron.vtm").decode()
        self.write("packed.vtm", text.replace("back.vtp", "back.vtp.gz"))
        self.write("parts/back.vtp.gz", gzip.compress(self.read("parts/back.vtp")))
        self.assertIn("gunzip", self.fail_to_read("packed.vtm"))


if __name__ == "__main__":
    unittest.main()
