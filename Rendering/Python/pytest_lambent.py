# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as tests in pytest: where their baselines are, how new ones are accepted, and a report.

pytest finds this plugin by its entry point wherever the package lambent is installed, and with
`-p no:lambent` does without. It loads neither lambent nor VTK, so that a suite that draws nothing
does not wait for them. lambent.testing finds in `running` what lambent/testing/runs.py tells
without pytest.
"""

import os
import re
import tempfile
import zlib

import pytest

running = None  # the PictureRun whose test is running


def pytest_addoption(parser):
    group = parser.getgroup("lambent", "pictures as tests (lambent.testing)")
    group.addoption("--lambent-update", action="store_true",
                    help="accept the pictures that differ from their baselines or have none yet")
    group.addoption("--lambent-baselines", metavar="DIR",
                    help="the folder of all baselines; without it they are in 'baselines' beside"
                    " each test's file")
    group.addoption("--lambent-report", metavar="FILE",
                    help="write a report of the pictures, HTML, complete in one file")
    parser.addini("lambent_baselines", "as --lambent-baselines, relative to the ini-file")


def pytest_configure(config):
    # Absolute from here on: xdist hands the options to its workers as they are.
    for option in ("lambent_baselines", "lambent_report"):
        path = config.getoption(option)
        if path:
            setattr(config.option, option, str(config.invocation_params.dir / path))
    config.pluginmanager.register(PictureRun(config), "lambent-run")


@pytest.fixture
def lambent_baseline(request):
    """assert_matches_baseline(image_or_filter, name, tolerance, metric) with a name that can be
    left out; it is the test's own then, such as "test_box/test_side[front]"."""
    from lambent.testing import assert_matches_baseline

    def assert_matches(image_or_filter, name=None, tolerance=0, metric="max"):
        __tracebackhide__ = True
        if name is None:
            name = running.name_of(request.node)
        assert_matches_baseline(image_or_filter, name, tolerance, metric)

    return assert_matches


class PictureRun:
    """What this run decides for its pictures, and what became of them. A worker of xdist has one of
    its own, and hands the results with its reports to that of the main process."""

    how_to_accept = "run pytest --lambent-update"

    def __init__(self, config):
        self.config = config
        self.is_updating = (config.getoption("lambent_update")
                            or os.environ.get("LAMBENT_UPDATE_BASELINES") == "1")
        self.accepted = set()  # the baselines that this process has accepted
        self.item = None  # the test that is running
        self.pending = {}  # pictures and bytes of baselines, to be written if it passes
        self.fresh = []  # its results that have not been reported
        self.results = []  # those of all phases that have been reported
        self.report = None  # the file, when it is written
        self.problems = []  # what makes the run fail although its tests have passed

    # What lambent.testing asks.

    @property
    def updates(self):
        """Whether a picture of the running test may be accepted: a wrong one that is expected to
        fail its test may not."""
        return self.is_updating and not _expects_failure(self.item)

    def baselines(self, _calling_file):
        """The folder of the baselines of the running test, whichever file its helpers are in."""
        return self._common_baselines() or str(self.item.path.parent / "baselines")

    def failures(self):
        """A new folder, named after the running test, for the pictures of a failure."""
        factory = getattr(self.config, "_tmp_path_factory", None)  # none after -p no:tmpdir
        base = str(factory.getbasetemp()) if factory else tempfile.mkdtemp(prefix="pytest-")
        test = re.sub("::|/", ".", self.item.nodeid)
        stem = os.path.join(base, "lambent-failures", _plain(test))
        folder, count = stem, 1
        while os.path.exists(folder):
            count += 1
            folder = "%s-%d" % (stem, count)
        os.makedirs(folder)
        return folder

    def accept(self, baseline, picture, content):
        kept = type(picture)()
        kept.DeepCopy(picture)  # the test may go on working on its own
        self.pending[baseline] = kept, content
        self.accepted.add(baseline)

    def record(self, result):
        self.fresh.append(dict(result, test=self.item.nodeid))

    def name_of(self, item):
        """The name of a test as that of its baseline: "file/Class.test[parameters]". In a folder
        that is common to all tests the file has its folders, too."""
        file, _, test = item.nodeid.partition("::")
        folders = [part.strip(".") for part in os.path.splitext(file)[0].split("/")]
        folders = [_plain(part) for part in folders if part]
        if not self._common_baselines():
            folders = folders[-1:]
        test, bracket, parameters = test.partition("[")
        return "/".join(folders + [_plain(test.replace("::", ".") + bracket + parameters)])

    def _common_baselines(self):
        """The folder that an option or else the ini-file names, if one of them does."""
        config = self.config
        folder = config.getoption("lambent_baselines") or config.getini("lambent_baselines")
        # There may be no ini-file: -o stands for one.
        home = config.inipath.parent if config.inipath else config.invocation_params.dir
        return folder and str(home / folder)

    # What pytest tells.

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item):
        global running
        outer, running, self.item = running, self, item  # a test may run pytest itself
        self.pending, self.fresh = {}, []
        yield
        running, self.item = outer, None

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self):
        outcome = yield
        report = outcome.get_result()
        if report.when == "setup" and report.passed:
            # Whether these are accepted is known after the test itself.
            self.fresh = [result for result in self.fresh if result["outcome"] != "failed"]
            return
        if not report.passed or hasattr(report, "wasxfail"):
            self._drop_pending("not accepted, since the test has not passed")
        else:
            self._write_pending(report)
        report.lambent, self.fresh = self.fresh, []

    def pytest_runtest_logreport(self, report):
        # A test that expects a failure passes: then nothing is wrong with the picture.
        self.results += [result for result in getattr(report, "lambent", ())
                         if result["outcome"] != "failed" or report.failed]

    @pytest.hookimpl(tryfirst=True)
    def pytest_sessionfinish(self, session):
        if hasattr(self.config, "workerinput"):
            return
        self._find_conflicts()
        self._write_report()
        if self.problems and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter):
        write = terminalreporter.write_line
        failed = self._of("failed")
        if failed:
            terminalreporter.write_sep("=", "pictures that differ")
        for result in failed:
            write(result["test"])
            write("  " + result["message"])
            for role in ("picture", "baseline", "difference"):
                if role in result:
                    write("  %-11s %s" % (role + ":", result[role]))
        if any("accept" in result for result in failed):
            write("Those that are right: %s to accept them." % self.how_to_accept)
        accepted = self._of("accepted")
        if accepted:
            terminalreporter.write_sep("=", "baselines written")
        for result in accepted:
            write("%s (%s)" % (result["baseline"], result["change"]))
        for problem in self.problems:
            write("lambent: " + problem, red=True)
        if self.report:
            write("lambent: the report is " + self.report)

    def _write_pending(self, report):
        """Write what a test has accepted; if that cannot be, the test has failed."""
        from lambent.testing.pictures import write_file
        while self.pending:
            baseline, (_picture, content) = self.pending.popitem()
            try:
                write_file(baseline, content)
            except OSError as error:
                self.pending[baseline] = None
                problem = "the baseline cannot be written: %s" % error
                report.outcome, report.longrepr = "failed", problem
                self._drop_pending(problem)

    def _drop_pending(self, reason):
        for result in self.fresh:
            if result["outcome"] == "accepted" and result["baseline"] in self.pending:
                result["outcome"] = "failed"
                result["message"] += "; " + reason
        self.accepted.difference_update(self.pending)
        self.pending = {}

    def _of(self, outcome):
        return [result for result in self.results if result["outcome"] == outcome]

    def _find_conflicts(self):
        """Two workers may have accepted different pictures under one name."""
        digests = {}
        for result in self._of("accepted"):
            first = digests.setdefault(result["baseline"], result)
            if result["digest"] != first["digest"]:
                self.problems.append(
                    "%s and %s draw different pictures for %s; give each its own name"
                    % (first["test"], result["test"], result["baseline"]))

    def _write_report(self):
        path = self.config.getoption("lambent_report")
        if not path:
            return
        from lambent.testing.report import write_report
        try:
            write_report(path, self.results)
            self.report = path
        except OSError as error:
            self.problems.append("could not write the report: %s" % error)


def _expects_failure(item):
    """Whether a test is marked as one that fails."""
    from lambent.testing.runs import unittest_expects_failure
    if unittest_expects_failure():
        return True
    if item.config.getoption("runxfail", False):
        return False
    try:
        from _pytest.skipping import evaluate_xfail_marks  # there is no public way to ask
    except ImportError:
        return item.get_closest_marker("xfail") is not None
    return evaluate_xfail_marks(item) is not None


def _plain(text):
    """Text that a file can be named after. Where that changes it, its checksum keeps it unique."""
    plain = re.sub(r"[^\w.,=+@()\[\] -]", "_", text)[:100]
    if plain == text:
        return text
    return "%s-%08x" % (plain, zlib.crc32(text.encode("utf-8", "replace")))
