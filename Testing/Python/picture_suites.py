# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the tests of lambent.testing: a folder with a small suite that renders boxes, and the outcome of
running it."""

import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import textwrap
import unittest

DRAWING = '''
import os
from lambent import vtkLambentRayTracer
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkCamera

def box(length=None, width=60):
    """A box as long as LENGTH says; drawn without the platform's sine."""
    source = vtkCubeSource()
    source.SetXLength(length or float(os.environ.get("LENGTH", "1")))
    camera = vtkCamera()
    camera.SetPosition(2, 3, 4)
    tracer = vtkLambentRayTracer()
    tracer.SetInputConnection(source.GetOutputPort())
    tracer.SetCamera(camera)
    tracer.SetImageSize(width, 40)
    return tracer
'''

HEAD = '''
from drawing import box
from lambent.testing import assert_images_equal, assert_matches_baseline
'''

BOX = """
    def test_box():
        assert_matches_baseline(box(), "box")
    """


# Variables of build servers and terminals that make pytest write more, or format it differently.
TALKATIVE = ("CI", "BUILD_NUMBER", "COLUMNS", "LINES", "PY_COLORS", "FORCE_COLOR", "NO_COLOR")


class Outcome:
    """The output of a run, without colours, and its exit status."""

    def __init__(self, process):
        text = process.stdout.decode() + process.stderr.decode()
        self.text = re.sub(r"\x1b\[[0-9;]*m", "", text)
        self.status = process.returncode

    def paths(self, role):
        """The files that the output names as pictures, baselines or differences, in order."""
        return re.findall(r"^(?:E  )? +%s: +(.*)$" % role, self.text, re.MULTILINE)


class SuiteTest(unittest.TestCase):
    """A test with a separate folder, in which it writes and runs suites."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.suite = os.path.join(self.folder, "suite")
        self.write("drawing.py", DRAWING)

    def write(self, name, text):
        path = os.path.join(self.suite, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(textwrap.dedent(text))
        return path

    def write_tests(self, *texts, name="test_box.py"):
        return self.write(name, HEAD + "\n".join(map(textwrap.dedent, texts)))

    def run_python(self, *arguments, **variables):
        """Run Python in the folder of the suite."""
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("PYTEST", "LAMBENT", "DISPLAY"))
                       and name not in TALKATIVE}
        environment.update(variables, PYTHONDONTWRITEBYTECODE="1", TMPDIR=self.folder)
        environment["PYTHONPATH"] = os.pathsep.join(
            [self.suite] + os.environ.get("PYTHONPATH", "").split(os.pathsep))
        return Outcome(subprocess.run([sys.executable] + list(arguments), cwd=self.suite,
                                      env=environment, stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, timeout=200))

    def baselines(self, folder="baselines"):
        """The files below a folder of the suite."""
        top = os.path.join(self.suite, folder)
        return sorted(os.path.relpath(os.path.join(where, name), top).replace(os.sep, "/")
                      for where, _, names in os.walk(top) for name in names)


class PytestSuiteTest(SuiteTest):
    """A test whose suites are for pytest."""

    def write_tests(self, *texts, **options):
        return super().write_tests("import pytest", *texts, **options)

    def run_pytest(self, *arguments, status=0, **variables):
        outcome = self.run_python(
            "-m", "pytest", "-p", "no:cacheprovider",
            "--basetemp", os.path.join(self.folder, "temporary"), *arguments, **variables)
        self.assertEqual(outcome.status, status, outcome.text)
        return outcome


def require_pytest():
    """Without pytest, exit with the status that CTest shows as a skipped test."""
    if importlib.util.find_spec("pytest") is None:
        print("skipped: there is no pytest for %s" % sys.executable)
        sys.exit(77)
