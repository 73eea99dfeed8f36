# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of image tests passes with its baselines, and a change of its pictures makes the right tests
fail. Needs pytest."""

import os
import shutil
import unittest

from picture_suites import PytestSuiteTest, require_pytest

require_pytest()

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLES = os.path.join(ROOT, "Examples", "Python")


class Example(PytestSuiteTest):
    def setUp(self):
        super().setUp()
        shutil.copy(os.path.join(EXAMPLES, "test_pictures.py"), self.suite)
        shutil.copytree(os.path.join(EXAMPLES, "baselines"), os.path.join(self.suite, "baselines"))

    def test_the_example_passes_and_needs_all_its_baselines(self):
        self.assertIn("3 passed", self.run_pytest().text)
        self.assertEqual(self.baselines(), ["box.png"] + [
            "test_pictures/test_shrunk[%s].png" % factor for factor in ("0.5", "0.75")])

    def test_a_change_makes_the_right_tests_fail(self):
        path = os.path.join(self.suite, "test_pictures.py")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        changed = text.replace("SetShrinkFactor(factor)", "SetShrinkFactor(factor - 2 ** -4)")
        self.assertNotEqual(changed, text)
        self.write("test_pictures.py", changed)
        text = self.run_pytest("-rA", status=1).text
        self.assertIn("PASSED test_pictures.py::test_box\n", text)
        for factor in ("0.5", "0.75"):
            self.assertIn("FAILED test_pictures.py::test_shrunk[%s] - AssertionError" % factor, text)


if __name__ == "__main__":
    unittest.main()
