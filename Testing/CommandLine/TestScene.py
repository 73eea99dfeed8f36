# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Camera, lights and surface do what their options say; expected values are calculated by hand.

The square covers -1..1 in x and y at z = 0. A picture has 9 x 9 pixels, so that the centre of one of them
is on the view axis.
"""

import math
import unittest

from commandline import CommandTest, SQUARE, TETRAHEDRON, obj

WHITE = (255, 255, 255)
BLACK = (0, 0, 0)


def byte(value):
    return math.floor(255 * min(max(value, 0), 1) + 0.5)


class TestCamera(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))
        self.write("mesh.obj", obj(TETRAHEDRON))

    def covered(self, *arguments):
        """The columns and rows that show the square, unlit so that every hit is white."""
        if "--camera-position" not in arguments:
            arguments += ("--direction", "0,0,1")
        rows = self.pixels("square.obj", "--shading", "unlit", *arguments)
        self.assertLessEqual({pixel for row in rows for pixel in row}, {WHITE, BLACK})
        columns = [i for i in range(9) if any(row[i] == WHITE for row in rows)]
        return columns, [j for j in range(9) if WHITE in rows[j]]

    def picture(self, *arguments):
        self.succeed("mesh.obj", "-o", "picture.pnm", "--size", "32x24", *arguments)
        return self.read("picture.pnm")

    def test_the_parallel_scale_is_half_the_height(self):
        # The picture is 2 s high, a pixel 2 s / 9; the centre of pixel i is at (i - 4) 2 s / 9.
        self.assertEqual(self.covered("--parallel-scale", "4.5"), ([3, 4, 5], [3, 4, 5]))
        self.assertEqual(self.covered("--parallel-scale", "2"), ([2, 3, 4, 5, 6], [2, 3, 4, 5, 6]))
        self.assertEqual(self.covered("--parallel-scale", "9", "--zoom", "2"),
                         self.covered("--parallel-scale", "4.5"))

    def test_the_camera_position_sets_a_perspective_view(self):
        # 90 degrees at a distance of 4.5: the view is 9 high there, and a pixel 1.
        near = ("--camera-position", "0,0,4.5", "--view-angle", "90")
        self.assertEqual(self.covered(*near), ([3, 4, 5], [3, 4, 5]))
        # Looking at another point at the same depth moves the square to the left and down.
        self.assertEqual(self.covered("--camera-position", "2,1,4.5", "--focal-point", "2,1,0",
                                      "--view-angle", "90"), ([1, 2, 3], [4, 5, 6]))

    def test_supersampling_averages_edges(self):
        # The square ends at the centre of the pixels 2 and 6: half of their samples hit it.
        view = ("square.obj", "--shading", "unlit", "--direction", "0,0,1", "--parallel-scale",
                str(9 / 4))
        grey = (byte(0.5),) * 3
        for samples in ("2", "4", "16"):
            row = self.pixels(*view, "--supersampling", samples)[4]
            self.assertEqual(row, [BLACK] * 2 + [grey] + [WHITE] * 3 + [grey] + [BLACK] * 2)
        # The default is three samples.
        self.succeed(*view, "-o", "a.pnm", "--size", "9x9")
        self.succeed(*view, "-o", "b.pnm", "--size", "9x9", "--supersampling", "3")
        self.assertEqual(self.read("a.pnm"), self.read("b.pnm"))

    def test_zoom_divides_the_angle(self):
        self.assertEqual(self.picture("--camera-position", "1,2,9", "--view-angle", "40",
                                      "--zoom", "2"),
                         self.picture("--camera-position", "1,2,9", "--view-angle", "20"))

    def test_the_default_view_is_from_the_front_right_and_above(self):
        self.assertEqual(self.picture(), self.picture("--direction", "2,1.5,4"))
        self.assertEqual(self.picture("--direction", "4,3,8"), self.picture())
        self.assertNotEqual(self.picture("--direction", "0,0,1"), self.picture())
        self.assertEqual(self.picture("--direction", "0,0,5"), self.picture("--direction", "0,0,1"))

    def test_the_default_view_frames_the_bounding_sphere(self):
        # The radius is sqrt(2), so the distance is sqrt(2) / sin(15 degrees).
        distance = math.sqrt(2) / math.sin(math.radians(15))
        self.assertEqual(self.covered(),
                         self.covered("--camera-position", "0,0,%r" % distance))
        wide = math.sqrt(2) / math.sin(math.radians(45))
        self.assertEqual(self.covered("--view-angle", "90"),
                         self.covered("--view-angle", "90", "--camera-position", "0,0,%r" % wide))

    def test_everything_is_in_view_for_all_directions_and_angles(self):
        for size in ("90x40", "40x90"):
            for direction in ("1,1,1", "-3,1,-2", "0,1,0", "0,-2,0", "1,0,0"):
                for angle in ("5", "30", "120"):
                    self.succeed("mesh.obj", "-o", "x.pnm", "--size", size, "--direction",
                                 direction, "--view-angle", angle, "--shading", "unlit")
                    body = self.read("x.pnm")[-3 * 90 * 40:]
                    width = 3 * int(size.split("x")[0])
                    rows = [body[i:i + width] for i in range(0, len(body), width)]
                    edge = rows[0] + rows[-1] + b"".join(r[:3] + r[-3:] for r in rows)
                    self.assertEqual(set(edge), {0}, (size, direction, angle))
                    self.assertIn(255, body)

    def test_view_up_rotates_the_view(self):
        self.assertEqual(self.picture("--view-up", "0,1,0"), self.picture())
        self.assertEqual(self.picture("--direction", "0,1,0"),
                         self.picture("--direction", "0,1,0", "--view-up", "0,0,1"))
        self.assertNotEqual(self.picture("--view-up", "1,0,0"), self.picture())

    def test_a_view_up_along_the_view_is_refused(self):
        line = self.fail_with(1, "mesh.obj", "-o", "x.png", "--view-up", "0,0,1",
                              "--direction", "0,0,1")
        self.assertIn("cannot render: ", line)
        self.assertIn("parallel to its view direction. Choose another --view-up", line)

    def test_a_camera_that_is_too_far_away_is_refused(self):
        line = self.fail_with(1, "mesh.obj", "-o", "x.png", "--camera-position", "0,0,1e300")
        self.assertIn("coincide. Move --camera-position or --focal-point", line)

    def test_a_camera_at_its_focal_point_is_refused(self):
        line = self.fail_with(1, "mesh.obj", "-o", "x.png", "--camera-position", "1,2,3",
                              "--focal-point", "1,2,3")
        self.assertIn("--focal-point", line)

    def test_a_focal_point_without_a_position_moves_the_camera(self):
        # At 9 pixels and 30 degrees a move by one width of the square shows at its left edge.
        columns, rows = self.covered("--focal-point", "1,0,0")
        centered = self.covered()
        self.assertEqual(rows, centered[1])
        self.assertLess(columns[0], centered[0][0])


class TestLight(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))

    def lit(self, *arguments):
        # From a distance, with a small angle: the ray through the central pixel is the z axis.
        return self.center("square.obj", "--camera-position", "0,0,10", *arguments)

    def test_a_headlight_is_the_default(self):
        self.assertEqual(self.lit(), WHITE)
        self.assertEqual(self.lit("--headlight"), WHITE)

    def test_the_direction_of_a_light_is_its_direction_of_travel(self):
        self.assertEqual(self.lit("--light", "direction=0,0,-1"), WHITE)
        self.assertEqual(self.lit("--light", "direction=0,0,1"), BLACK)  # from behind
        value = byte(0.6)
        self.assertEqual(self.lit("--light", "direction=4,0,-3"), (value, value, value))

    def test_a_light_across_a_ridge_lights_one_side(self):
        # The left side has the normal (-1, 0, 1), the right side (1, 0, 1). Light that travels to the
        # right falls on the left side and grazes the right one.
        points = [(-1, -1, -1), (0, -1, 0), (1, -1, -1), (-1, 1, -1), (0, 1, 0), (1, 1, -1)]
        self.write("ridge.obj", obj((points, [(0, 1, 4, 3), (1, 2, 5, 4)])))
        row = self.pixels("ridge.obj", "--direction", "0,0,1", "--parallel-scale", "0.9",
                          "--shading", "flat", "--light", "direction=1,0,-1")[4]
        self.assertEqual(row[:4] + row[5:], [WHITE] * 4 + [BLACK] * 4)

    def test_lights_at_a_position_shine_in_all_directions(self):
        value = byte(2 / 3)  # the length of (1,2,2) is 3
        self.assertEqual(self.lit("--light", "position=1,2,2"), (value, value, value))
        # It shines in all directions, also backwards.
        self.assertEqual(self.lit("--light", "position=0,0,1;focal=0,0,2"), WHITE)

    def test_cones_limit_the_light(self):
        spot = "position=0,0,2;cone=20;focal="
        self.assertEqual(self.lit("--light", spot + "0,0,0"), WHITE)
        self.assertEqual(self.lit("--light", spot + "2,0,0"), BLACK)  # 45 degrees off
        self.assertEqual(self.lit("--light", "position=0,0,2;cone=20"), WHITE)  # at the focal point
        value = byte(0.8 ** 2)  # the cosine between (-4,0,-3) x 0.5 and the aim, squared
        self.assertEqual(self.lit("--light", "position=0,0,3;cone=60;exponent=2;focal=2.25,0,0"),
                         (value, value, value))

    def test_attenuation_divides_the_light(self):
        value = byte(1 / (0.5 + 0.25 * 2 + 0.125 * 4))
        self.assertEqual(self.lit("--light", "position=0,0,2;attenuation=0.5,0.25,0.125"),
                         (value, value, value))

    def test_color_and_intensity_add_up(self):
        red = "direction=0,0,-1;color=1,0,0;intensity=0.5"
        blue = "direction=0,0,-1;color=#0000ff;intensity=0.25"
        self.assertEqual(self.lit("--light", red, "--light", blue), (byte(0.5), 0, byte(0.25)))
        self.assertEqual(self.lit("--light", red, "--headlight"), WHITE)

    def test_ambient_models_add_the_term_per_light_or_once(self):
        from_behind = ("--light", "direction=0,0,1;intensity=0.5",
                       "--light", "direction=0,0,2;intensity=0.5", "--ambient", "0.2")
        for model, value in (("per-light", 0.2), ("scene", 0.2)):
            gray = byte(value)
            self.assertEqual(self.lit(*from_behind, "--ambient-model", model), (gray,) * 3)
        third = (*from_behind, "--light", "direction=0,0,1")
        self.assertEqual(self.lit(*third), (byte(0.4),) * 3)
        self.assertEqual(self.lit(*third, "--ambient-model", "scene"), (byte(0.2),) * 3)


class TestSurface(CommandTest):

    def setUp(self):
        super().setUp()
        self.write("square.obj", obj(SQUARE))

    def lit(self, *arguments):
        return self.center("square.obj", "--camera-position", "0,0,10", *arguments)

    def test_coefficients_scale_the_light(self):
        self.assertEqual(self.lit("--diffuse", "0.5"), (byte(0.5),) * 3)
        self.assertEqual(self.lit("--diffuse", "0.5", "--ambient", "0.3"), (byte(0.8),) * 3)
        self.assertEqual(self.lit("--diffuse", "0", "--ambient", "0"), BLACK)

    def test_the_color_applies_to_both_reflections(self):
        self.assertEqual(self.lit("--color", "1,0.5,0", "--diffuse", "0.5", "--ambient", "0.25"),
                         (byte(0.75), byte(0.375), 0))
        self.assertEqual(self.lit("--color", "1,0.5,0", "--ambient-color", "0,0,1",
                                  "--diffuse", "0.5", "--ambient", "0.25"),
                         (byte(0.5), byte(0.25), byte(0.25)))

    def test_colors_can_be_names_or_hexadecimal(self):
        for color in ("#ff6347", "#FF6347", "tomato", "Tomato"):
            self.assertEqual(self.lit("--color", color, "--shading", "unlit"), (255, 99, 71))
            corner = self.pixels("square.obj", "--background", color, "--zoom", "0.5")[0][0]
            self.assertEqual(corner, (255, 99, 71))

    def test_unlit_surfaces_ignore_lights(self):
        self.assertEqual(self.lit("--shading", "unlit", "--color", "0.2,0.4,0.6", "--light",
                                  "direction=0,0,1"), (byte(0.2), byte(0.4), byte(0.6)))

    def test_flat_and_smooth_shading_differ_at_a_ridge(self):
        # A ridge along y with sides at 45 degrees. Flat, both sides have the cosine sqrt(1/2); smooth,
        # the ridge itself has a normal along z. It is an edge of 90 degrees.
        points = [(-1, -1, -1), (0, -1, 0), (1, -1, -1), (-1, 1, -1), (0, 1, 0), (1, 1, -1)]
        self.write("ridge.obj", obj((points, [(0, 1, 4, 3), (1, 2, 5, 4)])))
        view = ("ridge.obj", "--direction", "0,0,1", "--parallel-scale", "0.9",
                "--light", "direction=0,0,-1")
        side = (byte(math.sqrt(0.5)),) * 3
        self.assertEqual(self.pixels(*view, "--shading", "flat")[4], [side] * 9)
        self.assertEqual(self.pixels(*view)[4], [side] * 9)
        self.assertEqual(self.pixels(*view, "--feature-angle", "89")[4], [side] * 9)
        smooth = self.pixels(*view, "--feature-angle", "91")[4]
        self.assertEqual(self.pixels(*view, "--feature-angle", "180")[4], smooth)
        self.assertEqual(smooth[4], WHITE)
        self.assertEqual([pixel[0] for pixel in smooth[:5]],
                         sorted({pixel[0] for pixel in smooth}))
        self.assertEqual(smooth, smooth[::-1])

    def test_the_number_of_threads_does_not_matter(self):
        self.write("mesh.obj", obj(TETRAHEDRON))
        pictures = {self.succeed("mesh.obj", "-o", "-", "--threads", n) for n in (1, 2, 3, 8)}
        self.assertEqual(len(pictures), 1)


if __name__ == "__main__":
    unittest.main()
