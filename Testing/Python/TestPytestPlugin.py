# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pytest plugin, tested by running small suites: the baselines of a test, its messages about wrong
pictures, and accepting new ones. Needs pytest."""

import os
import re
import unittest

from picture_suites import BOX, PytestSuiteTest, require_pytest

from lambent.testing import assert_images_equal

require_pytest()

ACCEPT = "run pytest --lambent-update to accept"


class Plugin(PytestSuiteTest):
    def test_the_plugin_does_not_load_vtk(self):
        self.write("test_nothing.py", """
            import sys
            def test_nothing(pytestconfig):
                assert pytestconfig.pluginmanager.hasplugin("lambent")
                assert not {"lambent", "vtkmodules"} & set(sys.modules)
            """)
        self.run_pytest()

    def test_help_lists_the_options(self):
        text = self.run_pytest("--help").text
        for option in ("--lambent-update", "--lambent-baselines=DIR", "--lambent-report=FILE",
                       "lambent_baselines (string)"):
            self.assertIn(option, text)

    def test_without_the_plugin_the_environment_variable_accepts(self):
        self.write_tests(BOX)
        run = self.run_pytest("-p", "no:lambent", status=1)
        self.assertIn("LAMBENT_UPDATE_BASELINES=1 to accept it", run.text)
        self.run_pytest("-p", "no:lambent", LAMBENT_UPDATE_BASELINES="1")
        self.run_pytest()


class Verdicts(PytestSuiteTest):
    def test_a_missing_baseline_fails_and_update_accepts_it(self):
        self.write_tests(BOX)
        run = self.run_pytest(status=1)
        self.assertIn("AssertionError: box: there is no baseline yet\n", run.text)
        self.assertIn("If the picture is right, %s it.\n" % ACCEPT, run.text)
        drawn = run.paths("picture")[0]
        self.assertEqual(self.baselines(), [])

        run = self.run_pytest("--lambent-update")
        self.assertRegex(run.text, r"=+ baselines written =+\n%s/baselines/box.png \(new\)\n"
                         % re.escape(self.suite))
        self.assertEqual(self.baselines(), ["box.png"])
        assert_images_equal(drawn, os.path.join(self.suite, "baselines", "box.png"))
        self.assertNotIn("lambent", self.run_pytest("-q").text)

    def test_a_different_picture_fails_and_its_files_are_listed(self):
        self.write_tests(BOX)
        self.run_pytest("--lambent-update")
        run = self.run_pytest(LENGTH="1.5", status=1)
        self.assertRegex(run.text,
                         r"AssertionError: box: \d+ of 2400 pixels differ, by at most \d+ of 255")
        baseline = os.path.join(self.suite, "baselines", "box.png")
        self.assertEqual(run.paths("baseline"), [baseline] * 2)  # in the failure and in the summary
        summary = run.text[run.text.index("= pictures that differ ="):]
        self.assertIn("test_box.py::test_box\n", summary)
        self.assertIn("If these pictures are right, %s them.\n" % ACCEPT, summary)
        for role in ("picture", "difference"):
            path, = set(run.paths(role))
            self.assertIn("/lambent-failures/test_box.py.test_box/box.%s.png" % role, path)
            self.assertTrue(os.path.isfile(path))
        self.assertIn("def test_box()", run.text)  # shows the test, not the functions that it calls
        self.assertNotIn("_conclude", run.text)

        run = self.run_pytest("--lambent-update", LENGTH="1.5")
        self.assertIn("box.png (changed)\n", run.text)
        assert_images_equal(path.replace("difference", "picture"), baseline)

    def test_on_a_build_server_failures_are_repeated(self):
        self.write_tests(BOX)
        self.run_pytest("--lambent-update")
        run = self.run_pytest(LENGTH="1.5", CI="true", status=1)
        baseline = os.path.join(self.suite, "baselines", "box.png")
        self.assertEqual(set(run.paths("baseline")), {baseline})

    def test_baselines_that_pass_are_not_rewritten(self):
        self.write_tests("""
            def test_box():
                assert_matches_baseline(box(), "box", tolerance=255)
            """)
        self.run_pytest("--lambent-update")
        baseline = os.path.join(self.suite, "baselines", "box.png")
        os.utime(baseline, (1, 1))
        for length in ("1", "1.5"):
            run = self.run_pytest("--lambent-update", LENGTH=length)
            self.assertNotIn("baselines written", run.text)
        self.assertEqual(os.stat(baseline).st_mtime, 1)

    def test_a_different_size_fails(self):
        self.write_tests(BOX)
        self.run_pytest("--lambent-update")
        self.write_tests(BOX.replace("box()", "box(width=61)"))
        run = self.run_pytest(status=1)
        self.assertIn("the picture is 61 x 40", run.text)
        self.assertEqual(run.paths("difference"), [])
        self.run_pytest("--lambent-update")
        self.run_pytest()

    def test_an_invalid_baseline_fails_and_can_be_replaced(self):
        self.write_tests(BOX)
        self.write("baselines/box.png", "version https://git-lfs.github.com/spec/v1\n")
        run = self.run_pytest(status=1)
        self.assertIn("baselines/box.png' is not a PNG file", run.text)
        self.assertIn(ACCEPT, run.text)
        self.run_pytest("--lambent-update")
        self.run_pytest()

    def test_two_pictures_with_the_same_name_are_refused(self):
        self.write_tests(BOX, """
            def test_other_box():
                assert_matches_baseline(box(2), "box")
            """)
        run = self.run_pytest("--lambent-update", status=1)
        self.assertIn("1 failed, 1 passed", run.text)
        self.assertIn("has accepted another picture under this name; give each its own name", run.text)

    def test_expected_failures_are_not_reported(self):
        self.write_tests("""
            def test_raises():
                for length in (2, 3):
                    with pytest.raises(AssertionError):
                        assert_images_equal(box(1), box(length))

            @pytest.mark.xfail
            def test_xfail():
                assert_images_equal(box(1), box(2))
            """)
        self.assertNotIn("pictures that differ", self.run_pytest().text)

    def test_failures_of_fixtures_are_reported_without_a_hint_to_accept(self):
        self.write_tests("""
            @pytest.fixture
            def checked():
                assert_images_equal(box(1), box(2))

            def test_box(checked):
                pass
            """)
        run = self.run_pytest(status=1)
        self.assertEqual(len(set(run.paths("baseline"))), 1)
        self.assertNotIn("to accept", run.text)

    def test_the_environment_variable_accepts_baselines(self):
        self.write_tests(BOX)
        self.run_pytest(LAMBENT_UPDATE_BASELINES="1")
        self.run_pytest()

    def test_temporary_folders_are_not_needed(self):
        self.write_tests(BOX)
        run = self.run_python("-m", "pytest", "-p", "no:tmpdir", "-p", "no:cacheprovider")
        self.assertEqual(run.status, 1)
        self.assertTrue(os.path.isfile(run.paths("picture")[0]))


class Names(PytestSuiteTest):
    def test_the_fixture_names_baselines_after_tests(self):
        text = """
            @pytest.mark.parametrize("length", [1, 1.5])
            def test_side(lambent_baseline, length):
                lambent_baseline(box(length))

            class TestBox:
                def test_front(self, lambent_baseline):
                    lambent_baseline(box())
                    lambent_baseline(box(2), "long")
                    lambent_baseline(box(3), "long/very.png", tolerance=1)

            @pytest.mark.parametrize("name", ["a::b", "a/b", "a.b", "../.."])
            def test_odd(lambent_baseline, name):
                lambent_baseline(box())
            """
        long = "def test_odd%s(lambent_baseline): lambent_baseline(box())" % ("y" * 250)
        self.write_tests(text, long)
        self.run_pytest("--lambent-update")
        self.run_pytest()
        names = self.baselines()
        for name in ("long.png", "long/very.png", "test_box/TestBox.test_front.png",
                     "test_box/test_side[1.5].png", "test_box/test_side[1].png",
                     "test_box/test_odd[a.b].png"):
            names.remove(name)
        self.assertEqual(len(names), 4)
        for name in names:
            self.assertRegex(name, r"^test_box/test_odd[\w.\[\]]{1,100}-[0-9a-f]{8}\.png$")
        self.assertFalse(set(os.listdir(self.folder)) - {"suite", "temporary"})

    def test_baselines_are_next_to_the_test_even_if_a_helper_compares(self):
        self.write("helper.py", """
            from lambent.testing import assert_matches_baseline
            def check(picture):
                assert_matches_baseline(picture, "box")
            """)
        self.write("deep/test_deep.py", """
            import unittest
            from drawing import box
            from helper import check
            class Box(unittest.TestCase):
                def test_box(self):
                    check(box())
            """)
        self.run_pytest("--lambent-update")
        self.assertEqual(self.baselines("deep/baselines"), ["box.png"])
        self.assertEqual(self.baselines(), [])

    def test_all_baselines_can_be_in_one_folder(self):
        text = """
            def test_box(lambent_baseline):
                lambent_baseline(box())
            """
        self.write_tests(text, name="one/test_one.py")
        self.write_tests(text, name="two/test_two.py")
        expected = ["one/test_one/test_box.png", "two/test_two/test_box.png"]
        self.run_pytest("--lambent-update", "--lambent-baselines", "all")
        self.assertEqual(self.baselines("all"), expected)

        # The ini-file's folder is relative to it; the option takes precedence.
        self.write("one/pytest.ini", "[pytest]\nlambent_baselines = of_ini\n")
        self.run_pytest("--lambent-update", "one")
        self.assertEqual(self.baselines("one/of_ini"), ["test_one/test_box.png"])
        self.run_pytest("--lambent-update", "--lambent-baselines", "of_option", "one")
        self.assertEqual(self.baselines("of_option"), ["test_one/test_box.png"])
        self.run_pytest("--lambent-update", "-o", "lambent_baselines=instead", "two")
        self.assertEqual(self.baselines("instead"), ["two/test_two/test_box.png"])

    def test_invalid_baseline_names_are_errors(self):
        names = ["", ".", "..", "../box", "a/../../box", "/box", "a//b", "a/", ".png", ".hidden",
                 "a\\b", "c:box", "a\nb", "a\0", "end.", "end ", "a*", "a?", None, 3]
        self.write_tests("""
            @pytest.mark.parametrize("name", %r)
            def test_name(name):
                with pytest.raises((TypeError, ValueError), match="name of a baseline"):
                    assert_matches_baseline(box(), name)
            """ % names)
        self.assertIn("%d passed" % len(names), self.run_pytest("--lambent-update").text)
        self.assertFalse(os.path.exists(os.path.join(self.suite, "baselines")))
        self.assertEqual(set(os.listdir(self.folder)) - {"temporary"}, {"suite"})


if __name__ == "__main__":
    unittest.main()
