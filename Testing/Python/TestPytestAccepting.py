# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Accepting pictures: only those of passed tests. Needs pytest."""

import os
import unittest

from picture_suites import BOX, PytestSuiteTest, SuiteTest, require_pytest

require_pytest()


class Accepting(PytestSuiteTest):
    """The baseline is a box of length 1; then the test renders a box of length 2."""

    def setUp(self):
        super().setUp()
        self.write_tests(BOX)
        self.run_pytest("--lambent-update")
        self.baseline = os.path.join(self.suite, "baselines", "box.png")
        os.utime(self.baseline, (1, 1))
        with open(self.baseline, "rb") as file:
            self.content = file.read()
        os.remove(os.path.join(self.suite, "test_box.py"))

    def update(self, *texts, status=0, arguments=(), accepts=False, name="test_other.py"):
        self.write_tests(*texts, name=name)
        run = self.run_pytest("--lambent-update", *arguments, status=status)
        with open(self.baseline, "rb") as file:
            self.assertEqual(file.read() != self.content, accepts, run.text)
        self.assertEqual(os.stat(self.baseline).st_mtime != 1, accepts)
        self.assertEqual("baselines written" in run.text, accepts, run.text)
        self.assertEqual(self.baselines(), ["box.png"])
        return run.text

    TEST = """
        %s
        def test_box():
            assert_matches_baseline(box(2), "box")
            assert_matches_baseline(box(3), "new")
        """

    def test_expected_failures_are_not_accepted(self):
        for mark in ("@pytest.mark.xfail", "@pytest.mark.xfail(strict=True)",
                     "@pytest.mark.xfail(True, reason='now')",
                     "@pytest.mark.xfail('sys.version', reason='text')",
                     "@pytest.mark.xfail(raises=AssertionError)"):
            self.assertIn("1 xfailed", self.update(self.TEST % mark))

    def test_marks_of_modules_and_classes_and_dynamic_marks_count(self):
        self.assertIn("1 xfailed", self.update("pytestmark = pytest.mark.xfail", self.TEST % ""))
        self.assertIn("1 xfailed", self.update("""
            @pytest.mark.xfail
            class TestBox:
                def test_box(self):
                    assert_matches_baseline(box(2), "box")
            """))
        self.assertIn("1 xfailed", self.update("""
            @pytest.mark.parametrize("length", [pytest.param(2, marks=pytest.mark.xfail)])
            def test_box(length):
                assert_matches_baseline(box(length), "box")
            """))
        self.assertIn("1 xfailed", self.update("""
            def test_box(request):
                request.applymarker(pytest.mark.xfail)
                assert_matches_baseline(box(2), "box")
            """))

    def test_the_strict_ini_option_is_respected(self):
        self.write("pytest.ini", "[pytest]\nxfail_strict = true\n")
        self.assertIn("1 xfailed", self.update(self.TEST % "@pytest.mark.xfail"))

    def test_expected_failure_of_unittest(self):
        self.assertIn("1 xfailed", self.update("""
            import unittest
            class Box(unittest.TestCase):
                @unittest.expectedFailure
                def test_box(self):
                    assert_matches_baseline(box(2), "box")
            """))

    def test_calls_of_xfail_and_skip_accept_nothing(self):
        for call in ("pytest.xfail('so')", "pytest.skip('so')"):
            text = self.update("""
                def test_box():
                    assert_matches_baseline(box(2), "box")
                    assert_matches_baseline(box(3), "new")
                    %s
                """ % call)
            self.assertIn("1 xfailed" if "xfail" in call else "1 skipped", text)

    def test_tests_that_fail_later_accept_nothing(self):
        for rest in ("assert False", "raise ValueError", "pytest.fail('so')"):
            text = self.update("""
                def test_box():
                    assert_matches_baseline(box(2), "box")
                    assert_matches_baseline(box(3), "new")
                    %s
                """ % rest, status=1)
            self.assertIn("; not accepted, since the test has not passed", text)

    def test_pictures_expected_to_differ_are_not_accepted(self):
        self.update("""
            def test_box():
                with pytest.raises(AssertionError):
                    assert_matches_baseline(box(2), "box")
            """, status=1)

    def test_pictures_of_fixtures_follow_the_test(self):
        fixture = """
            @pytest.fixture
            def checked():
                assert_matches_baseline(box(2), "box")
            """
        self.update(fixture, "def test_box(checked): pytest.xfail('so')")
        self.update(fixture, "def test_box(checked): assert False", status=1)
        self.update(fixture + "    raise ValueError\n", "def test_box(checked): pass", status=1)
        self.update(fixture, "def test_box(checked): pass", accepts=True)

    def test_later_changes_to_an_image_are_not_accepted(self):
        text = self.update("""
            def test_box():
                tracer = box(2)
                tracer.Update()
                image = tracer.GetOutput()
                assert_matches_baseline(image, "box")
                assert_matches_baseline(image, "box")
                image.GetPointData().GetScalars().Fill(9)
                assert_matches_baseline(image, "box")
            """, status=1)
        self.assertIn("has accepted another picture under this name", text)

    def test_other_tests_are_still_accepted(self):
        text = self.update("""
            def test_first():
                assert_matches_baseline(box(3), "box")
                pytest.xfail("so")

            def test_second():
                assert_matches_baseline(box(2), "box")
            """, accepts=True)
        self.assertIn("1 passed, 1 xfailed", text)
        self.write_tests(BOX.replace("(box()", "(box(2)"), name="test_other.py")
        self.run_pytest()

    def test_inactive_marks_are_ignored(self):
        for mark, arguments in (("@pytest.mark.xfail(False, reason='never')", ()),
                                ("@pytest.mark.xfail", ("--runxfail",))):
            self.update("""
                %s
                def test_box():
                    assert_matches_baseline(box(2), "box")
                """ % mark, arguments=arguments, accepts=True)
            with open(self.baseline, "wb") as file:
                file.write(self.content)
            os.utime(self.baseline, (1, 1))

    def test_no_baseline_is_created_for_expected_failures(self):
        os.remove(self.baseline)
        self.write_tests(self.TEST % "@pytest.mark.xfail", """
            def test_called():
                assert_matches_baseline(box(2), "called")
                pytest.xfail("so")
            """, name="test_other.py")
        self.assertIn("2 xfailed", self.run_pytest("--lambent-update").text)
        self.assertEqual(self.baselines(), [])

    def test_workers_behave_the_same(self):
        try:
            import xdist  # noqa: F401
        except ImportError:
            self.skipTest("there is no pytest-xdist")
        self.update("""
            @pytest.mark.parametrize("length", [2, 3, 4])
            def test_box(length):
                assert_matches_baseline(box(length), "box")
                pytest.xfail("so")

            @pytest.mark.xfail
            def test_marked():
                assert_matches_baseline(box(2), "box")
            """, arguments=("-n", "2"))

    def test_folders_and_unwritable_paths_are_not_accepted(self):
        os.makedirs(os.path.join(self.suite, "baselines", "folder.png"))
        os.symlink("/proc/x/a.png", os.path.join(self.suite, "baselines", "nowhere.png"))
        self.write_tests("""
            @pytest.mark.parametrize("name", ["folder", "nowhere"])
            def test_box(name):
                assert_matches_baseline(box(2), name)
            """, name="test_other.py")
        run = self.run_pytest("--lambent-update", status=1)
        self.assertIn("2 failed", run.text)
        self.assertNotIn("baselines written", run.text)

    def test_a_symbolic_link_to_a_baseline_is_kept(self):
        os.rename(self.baseline, os.path.join(self.suite, "kept.png"))
        os.symlink("../kept.png", self.baseline)
        self.update(BOX.replace("(box()", "(box(2)"), accepts=True)
        self.assertTrue(os.path.islink(self.baseline))


class Reports(PytestSuiteTest):
    def test_files_that_are_not_reports_are_not_overwritten(self):
        self.write_tests(BOX)
        self.run_pytest("--lambent-update")
        for name in ("baselines/box.png", "drawing.py", "page.html"):
            path = self.write(name, "<html>") if name == "page.html" else os.path.join(self.suite, name)
            with open(path, "rb") as file:
                before = file.read()
            run = self.run_pytest("--lambent-report", name, status=1)
            self.assertIn("could not write the report: '%s' exists and is not a report" % path, run.text)
            with open(path, "rb") as file:
                self.assertEqual(file.read(), before)
        for _ in range(2):
            self.run_pytest("--lambent-report", "new.html")


class WithoutPytest(SuiteTest):
    def test_expected_failure_of_unittest(self):
        self.write_tests("""
            import unittest
            class Method(unittest.TestCase):
                @unittest.expectedFailure
                def test_box(self):
                    assert_matches_baseline(box(2), "method")

            @unittest.expectedFailure
            class Whole(unittest.TestCase):
                def test_box(self):
                    assert_matches_baseline(box(2), "whole")

            class Other(unittest.TestCase):
                def test_box(self):
                    assert_matches_baseline(box(2), "other")
            """)
        run = self.run_python("-m", "unittest", LAMBENT_UPDATE_BASELINES="1")
        self.assertEqual(run.status, 0, run.text)
        self.assertIn("OK (expected failures=2)", run.text)
        self.assertEqual(self.baselines(), ["other.png"])


if __name__ == "__main__":
    unittest.main()
