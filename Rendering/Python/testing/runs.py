# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of a test run for its pictures: where baselines are, whether new ones are accepted,
and where the pictures of a failure go. This is the run without pytest; the plugin pytest_lambent
has one with the same methods."""

import os
import sys
import tempfile

from .pictures import write_file


class EnvironmentRun:
    """A run that the environment controls: LAMBENT_UPDATE_BASELINES=1 accepts new pictures."""

    how_to_accept = "run the test with LAMBENT_UPDATE_BASELINES=1"

    def __init__(self):
        self.accepted = set()  # the baselines that this run has written
        self.pending = {}  # pictures and bytes still to write; always empty

    @property
    def updates(self):
        """Whether a picture of the running test may be accepted."""
        return (os.environ.get("LAMBENT_UPDATE_BASELINES") == "1"
                and not unittest_expects_failure())

    def baselines(self, test_file):
        """The folder of the baselines for tests in this file."""
        return os.path.join(os.path.dirname(os.path.abspath(test_file)), "baselines")

    def failures(self):
        """Create a folder for the pictures of a failure."""
        return tempfile.mkdtemp(prefix="lambent-failures-")

    def accept(self, baseline, _picture, content):
        """Make a picture the baseline. `content` is its PNG."""
        write_file(baseline, content)
        self.accepted.add(baseline)

    def record(self, result):
        """Record the result of a comparison, a dictionary of strings."""
        if result["outcome"] == "accepted":
            print("lambent: wrote %s (%s)" % (result["baseline"], result["change"]),
                  file=sys.stderr)


_environment_run = EnvironmentRun()


def current_run():
    """The run of pytest if one of its tests is running, otherwise the environment's."""
    plugin = sys.modules.get("pytest_lambent")
    return (plugin and plugin.running) or _environment_run


def unittest_expects_failure():
    """Whether a unittest test is running that is expected to fail."""
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
    """The file that called lambent.testing."""
    package = __name__.rpartition(".")[0]
    frame = sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(package):
        frame = frame.f_back
    return frame.f_code.co_filename
