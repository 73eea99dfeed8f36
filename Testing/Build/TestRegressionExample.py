# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Examples/RegressionTest as a user's project: its pictures pass; a bug in its filter makes the right test
fail, with a page that shows it; a missing baseline is reported, and created on request.

    TestRegressionExample.py SOURCE FOLDER CMAKE CTEST OPTION...

Builds a copy of SOURCE in FOLDER with the options of CMake.
"""

import os
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree

SOURCE, FOLDER, CMAKE, CTEST, *OPTIONS = sys.argv[1:]
COPY = os.path.join(FOLDER, "source")
BUILD = os.path.join(FOLDER, "build")
REPORT = os.path.join(BUILD, "lambent-report.html")

PICTURES = {"Cube", "Spikes", "Hollows", "Twice"}
MESHES = {"Spikes.Mesh", "Hollows.Mesh", "Twice.Draw"}


def run(*command, **keywords):
    """The output of a command that must succeed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **keywords)
    text = done.stdout.decode()
    if done.returncode != 0:
        raise AssertionError(" ".join(command) + "\n" + text)
    return text


def build(*options):
    run(CMAKE, "-S", COPY, "-B", BUILD, *OPTIONS, *options)
    run(CMAKE, "--build", BUILD)


def test():
    """The outputs of the passed tests and of the failed tests, by name."""
    results = os.path.join(BUILD, "results.xml")
    subprocess.run([CTEST, "--test-dir", BUILD, "--output-junit", results, "--parallel", "2"],
                   stdout=subprocess.DEVNULL, check=False)
    passed, failed = {}, {}
    for case in xml.etree.ElementTree.parse(results).iter("testcase"):
        chosen = passed if case.get("status") == "run" else failed
        chosen[case.get("name")] = case.findtext("system-out")
    return passed, failed


def sections():
    """The page's section of each test: passed or failed, and the HTML."""
    with open(REPORT, encoding="utf-8") as file:
        page = file.read()
    return {name: (state, body) for state, name, body in re.findall(
        r'<section class="(\w+)">\n<h2>(.*?)</h2>\n(.*?)</section>', page, re.DOTALL)}


class RegressionExample(unittest.TestCase):

    def setUp(self):
        os.environ.pop("LAMBENT_UPDATE_BASELINES", None)
        shutil.rmtree(COPY, ignore_errors=True)
        shutil.copytree(SOURCE, COPY)
        if os.path.exists(REPORT):
            os.remove(REPORT)

    def test_the_example_passes(self):
        build("-DSTELLATE_WITH_A_BUG=OFF")
        passed, failed = test()
        self.assertEqual(failed, {})
        self.assertEqual(set(passed), PICTURES | MESHES)
        self.assertEqual({name: state for name, (state, _) in sections().items()},
                         {name: "passed" for name in PICTURES})

    def test_a_bug_makes_the_right_test_fail(self):
        build("-DSTELLATE_WITH_A_BUG=ON")
        passed, failed = test()
        self.assertEqual(set(failed), {"Hollows"})
        self.assertEqual(set(passed), (PICTURES | MESHES) - {"Hollows"})
        self.assertRegex(failed["Hollows"], r"\A\d+ of 16384 pixels differ, by at most \d+ of 255;")
        self.assertRegex(failed["Hollows"], r"the changed pixels show cells .* of '.*Hollows\.vtp'")
        self.assertNotIn("DartMeasurementFile", failed["Hollows"])  # CTest collects them for CDash
        state, body = sections()["Hollows"]
        self.assertEqual(state, "failed")
        self.assertEqual(body.count('src="data:image/png;base64,'), 3)
        self.assertIn('type="range"', body)
        self.assertRegex(body, r"<tr><td>.*Hollows\.vtp</td><td>\d+</td><td>\d+</td>")
        self.assertEqual(sections()["Spikes"][0], "passed")

    def test_missing_baselines_are_reported_and_can_be_created(self):
        build("-DSTELLATE_WITH_A_BUG=OFF")
        lost = {name: os.path.join(COPY, "Baselines", name + ".png") for name in ("Cube", "Twice")}
        for path in lost.values():
            os.remove(path)
        failed = test()[1]
        self.assertEqual(set(failed), set(lost))
        for name, output in failed.items():
            self.assertIn("there is no baseline 'Baselines/%s.png'" % name, output)
            self.assertIn("lambent-update-baselines", output)
        run(CMAKE, "--build", BUILD, "--target", "lambent-update-baselines")
        self.assertEqual(test()[1], {})
        for path in lost.values():
            self.assertTrue(os.path.exists(path), path)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
