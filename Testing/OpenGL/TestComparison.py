# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The comparison finds what it should find. OpenGL is not needed: Lambent renders both sides."""

import os
import re
import unittest
from dataclasses import replace

import numpy as np

import lambent_side
from comparison import compare
from known import KNOWN, Known
from scene import BACKGROUNDS, SIZE, Actor, Colours, Scene, with_property
from scenes import LIGHTS, SCENES
from suite import Suite
import meshes

BY_NAME = {scene.name: scene for scene in SCENES}


def rendered(scene):
    return lambent_side.render(scene, {})[0]


def moved(scene, pixels):
    """The scene, moved on the screen by so many pixels."""
    return replace(scene, camera={**scene.camera, "WindowCenter": (2.0 * pixels / SIZE[0], 0)})


class Pictures(unittest.TestCase):

    def setUp(self):
        self.scene = BY_NAME["light-several"]
        self.pictures = rendered(self.scene)

    def expect(self, same, other, thin=""):
        for one, two in ((self.pictures, other), (other, self.pictures)):
            self.assertEqual(compare(one, two, BACKGROUNDS, thin).is_same, same)

    def test_equal_pictures_are_the_same(self):
        self.expect(True, self.pictures)
        self.expect(True, self.pictures, thin="lines")
        result = compare(self.pictures, self.pictures, BACKGROUNDS)
        shown = (self.pictures[0] != self.pictures[1]).any(-1)
        self.assertEqual(result.covered, shown.size - np.count_nonzero(shown))
        self.assertEqual((result.at_edges, result.largest), (0, 0))

    def test_colours_may_differ_by_two(self):
        is_shown = (self.pictures[:1] == self.pictures[1:]).all(-1, keepdims=True)
        for step, same in ((2, True), (3, False)):
            other = np.where(is_shown, np.minimum(self.pictures, 250) + step, self.pictures).astype(np.uint8)
            self.pictures = np.where(is_shown, np.minimum(self.pictures, 250), self.pictures)
            self.expect(same, other)

    def test_shifted_pictures_differ(self):
        for pixels in (0.5, 1.0, 2.0):
            self.expect(False, rendered(moved(self.scene, pixels)))
        self.expect(True, rendered(moved(self.scene, 0.001)))

    def test_one_missing_pixel_inside_is_found(self):
        other = self.pictures.copy()
        other[:, SIZE[1] // 2, SIZE[0] // 2] = self.pictures[:, 0, 0]
        self.expect(False, other)

    def test_one_pixel_of_another_colour_inside_is_found(self):
        self.pictures = rendered(BY_NAME["unlit"])
        other = self.pictures.copy()
        other[:, SIZE[1] // 2, SIZE[0] // 2] += 3
        self.expect(False, other)

    def test_a_surface_too_faint_to_see_is_none(self):
        self.pictures = self.pictures.copy()
        self.pictures[:, 10:14, 10:30] -= 1
        other = self.pictures.copy()
        other[:, 10:14, 10:30] -= 1
        self.expect(True, other)
        other[:, 10:14, 10:30] -= 2
        self.expect(False, other)

    def test_a_rougher_outline_is_found(self):
        self.pictures = rendered(Scene("fine", [Actor(lambda: meshes.sphere(48), {"Lighting": False})]))
        self.expect(False, rendered(Scene("rough", [Actor(lambda: meshes.sphere(20), {"Lighting": False})])))

    def test_another_alpha_is_found_over_the_other_background(self):
        other = self.pictures.copy()
        other[1, 80:90, 110:130] = 255 - 20
        self.expect(False, other)

    def test_thin_things_may_move_by_a_pixel_but_keep_their_colour(self):
        def line(x, colour):
            result = np.empty_like(self.pictures)
            result[:] = np.round(255 * np.array(BACKGROUNDS))[:, None, None, :]
            result[:, 20:150, x] = colour
            return result

        self.pictures = line(100, (200, 40, 40))
        self.expect(True, line(100, (205, 45, 38)), thin="lines")
        self.expect(False, line(100, (240, 40, 40)), thin="lines")
        self.expect(False, line(103, (200, 40, 40)), thin="lines")


class FakeOpenGL:
    """Renders with Lambent."""

    def __init__(self, change=lambda scene: scene):
        self.change = change

    def render(self, scene):
        return rendered(self.change(scene))


class Verdicts(unittest.TestCase):

    def verdict(self, name, change=lambda scene: scene):
        return Suite(FakeOpenGL(change)).row(BY_NAME[name]).verdict

    def test_a_renderer_equals_itself(self):
        suite = Suite(FakeOpenGL())
        for scene in SCENES:
            if not scene.awaits:
                expected = "STALE" if scene.name in KNOWN else "same"
                self.assertEqual(suite.row(scene).verdict, expected, scene.name)

    def test_scenes_may_await_a_feature(self):
        suite = Suite(FakeOpenGL())
        suite.missing = {"opacity"}
        row = suite.row(replace(BY_NAME["flat"], awaits=("opacity",)))
        self.assertEqual((row.verdict, row.failed, row.note), ("not yet", False, "awaits opacity"))
        suite.missing = set()
        self.assertEqual(suite.row(replace(BY_NAME["flat"], awaits=("opacity",))).verdict, "same")

    def test_other_lights_are_different(self):
        for scene in LIGHTS[1:8]:
            self.assertEqual(self.verdict(scene.name, lambda other: replace(other, lights=())), "DIFFERENT")

    def test_other_colours_are_different(self):
        self.assertEqual(self.verdict("flat", lambda scene: with_property(scene, Color=(0.9, 0.8, 0.72))),
                         "DIFFERENT")

    def test_a_known_difference_must_be_as_described(self):
        suite = Suite(FakeOpenGL(lambda scene: replace(scene, two_sided=True)))
        scene = BY_NAME["back-one-sided"]
        self.assertEqual(suite.row(scene).verdict, "known")
        suite.opengl = FakeOpenGL(lambda scene: with_property(replace(scene, two_sided=True), Diffuse=0.9))
        self.assertEqual(suite.row(scene).verdict, "DIFFERENT")

    def test_a_limit_is_a_limit(self):
        scene = BY_NAME["unlit"]
        pictures = {"OpenGL": rendered(scene), "Lambent": rendered(scene)}
        pictures["Lambent"][:, 80:82, 110:112] += 9
        result = compare(*pictures.values(), BACKGROUNDS)
        for pixels, byte, verdict in ((4, 9, "known"), (3, 9, "DIFFERENT"), (4, 8, "DIFFERENT")):
            known = Known("a spot", pixels=pixels, bytes=byte)
            row = Suite(FakeOpenGL()).row_of_known(scene, known, result, dict(pictures))
            self.assertEqual(row.verdict, verdict)

    def test_messages_are_failures(self):
        scene = Scene("wrong", [Actor(meshes.coarse, colours=Colours("no such array"))])
        row = Suite(FakeOpenGL()).row(scene)
        self.assertEqual((row.verdict, row.failed), ("MESSAGES", True))
        self.assertIn("no such array", row.note)


class Lists(unittest.TestCase):

    def test_scenes_have_names_of_their_own(self):
        self.assertEqual(len(BY_NAME), len(SCENES))
        self.assertGreaterEqual(len(SCENES), 100)

    def test_known_differences_belong_to_scenes(self):
        self.assertLessEqual(set(KNOWN), set(BY_NAME))

    def test_known_differences_are_documented(self):
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "README.md"), encoding="utf-8") as file:
            rows = re.findall(r"^\| (`.*?) \|", file.read(), re.MULTILINE)
        self.assertEqual(set(re.findall(r"`([\w-]+)`", " ".join(rows))), set(KNOWN))

    def test_awaited_features_exist(self):
        self.assertLessEqual({name for scene in SCENES for name in scene.awaits}, set(lambent_side.FEATURES))


if __name__ == "__main__":
    unittest.main()
