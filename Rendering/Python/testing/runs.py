# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a run of tests decides for all of its pictures: where baselines are, whether new ones are
accepted, and where the pictures of a failure go. This is the run without pytest; the plugin
pytest_lambent has one with the same methods."""

import os
import sys
import tempfile

from .pictures import write_file


class EnvironmentRun:
    """A run that the environment steers: LAMBENT_UPDATE_BASELINES=1 accepts what is drawn."""

    how_to_accept = "run the test with LAMBENT_UPDATE_BASELINES=1"

    def __init__(self):
        self.accepted = set()  # the baselines that this run has written
        self.pending = {}  # pictures and bytes of those that it is still to write: none

    @property
    def updates(self):
        """Whether a picture of the running test may be accepted."""
        return (os.environ.get("LAMBENT_UPDATE_BASELINES") == "1"
                and not unittest_expects_failure())

    def baselines(self, test_file):
        """The folder of the baselines of a test in this file."""
        return os.path.join(os.path.dirname(os.path.abspath(test_file)), "baselines")

    def failures(self):
        """A new folder for the pictures of a failure."""
        return tempfile.mkdtemp(prefix="lambent-failures-")

    def accept(self, baseline, _picture, content):
        """Make a picture, and these bytes of it, the baseline."""
        write_file(baseline, content)
        self.accepted.add(baseline)

    def record(self, result):
        """Take note of a comparison's result, a dictionary of strings."""
        if result["outcome"] == "accepted":
            print("lambent: wrote %s (%s)" % (result["baseline"], result["change"]),
                  file=sys.stderr)


_environment_run = EnvironmentRun()


def current_run():
    """That of pytest if one of its tests is running, else the environment's."""
    plugin = sys.modules.get("pytest_lambent")
    return (plugin and plugin.running) or _environment_run


def unittest_expects_failure():
    """Whether the test of unittest that is running, if one is, is expected to fail."""
    unittest = sys.modules.get("unittest")
    frame = sys._getframe(1)
    while unittest and frame:
        test = frame.f_locals.get("self")
        if isinstance(test, unittest.TestCase):
            method = getattr(test, test._testMethodName, None)
            return any(getattr(each, "__unittest_expecting_failure__", False)
                       for each in (test, method))
        frame = frame.f_back
    return False


def calling_file():
    """The file of the code that called lambent.testing."""
    package = __name__.rpartition(".")[0]
    frame = sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(package):
        frame = frame.f_back
    return frame.f_code.co_filename
