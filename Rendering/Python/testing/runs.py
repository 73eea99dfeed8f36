# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a run of tests decides for all of its pictures: where baselines are, whether new ones are
accepted, and where the pictures of a failure go. This is the run without pytest; the plugin
pytest_lambent has one with the same methods."""

import os
import sys
import tempfile


class EnvironmentRun:
    """A run that the environment steers: LAMBENT_UPDATE_BASELINES=1 accepts what is drawn."""

    how_to_accept = "run the test with LAMBENT_UPDATE_BASELINES=1"

    def __init__(self):
        self.accepted = set()  # the baselines that this run has written

    @property
    def updates(self):
        return os.environ.get("LAMBENT_UPDATE_BASELINES") == "1"

    def baselines(self, test_file):
        """The folder of the baselines of a test in this file."""
        return os.path.join(os.path.dirname(os.path.abspath(test_file)), "baselines")

    def failures(self):
        """A new folder for the pictures of a failure."""
        return tempfile.mkdtemp(prefix="lambent-failures-")

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


def calling_file():
    """The file of the code that called lambent.testing."""
    package = __name__.rpartition(".")[0]
    frame = sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").startswith(package):
        frame = frame.f_back
    return frame.f_code.co_filename
