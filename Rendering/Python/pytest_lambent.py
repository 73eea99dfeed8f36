# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Image tests in pytest: the location of baselines, accepting new ones, and a report.

pytest finds this plugin by its entry point wherever the package lambent is installed;
`-p no:lambent` disables it. It imports neither lambent nor VTK, so suites without pictures do not
wait for them. lambent.testing uses the run in `running`; without pytest it uses that of
lambent/testing/runs.py.
"""

import os
import re
import tempfile
import zlib

import pytest

running = None  # the PictureRun whose test is running


def pytest_addoption(parser):
    group = parser.getgroup("lambent", "image tests (lambent.testing)")
    group.addoption("--lambent-update", action="store_true",
                    help="accept the pictures that differ from their baselines or have none yet")
    group.addoption("--lambent-baselines", metavar="DIR",
                    help="the folder of all baselines (default: 'baselines' beside each test's file)")
    group.addoption("--lambent-report", metavar="FILE",
                    help="write a report of the pictures as a single HTML file")
    parser.addini("lambent_baselines", "like --lambent-baselines, relative to the ini-file")


def pytest_configure(config):
    # Make paths absolute, since xdist passes the options to its workers unchanged.
    for option in ("lambent_baselines", "lambent_report"):
        path = config.getoption(option)
        if path:
            setattr(config.option, option, str(config.invocation_params.dir / path))
    config.pluginmanager.register(PictureRun(config), "lambent-run")


@pytest.fixture
def lambent_baseline(request):
    """assert_matches_baseline(image_or_filter, name, tolerance, metric) with an optional name. The
    default is the name of the test, such as "test_box/test_side[front]"."""
    from lambent.testing import assert_matches_baseline

    def assert_matches(image_or_filter, name=None, tolerance=0, metric="max"):
        __tracebackhide__ = True
        if name is None:
            name = running.name_of(request.node)
        assert_matches_baseline(image_or_filter, name, tolerance, metric)

    return assert_matches


class PictureRun:
    """The settings of this run for its pictures, and their results. Each worker of xdist has its
    own, and sends the results with its reports to that of the main process."""

    how_to_accept = "run pytest --lambent-update"

    def __init__(self, config):
        self.config = config
        self.is_updating = (config.getoption("lambent_update")
                            or os.environ.get("LAMBENT_UPDATE_BASELINES") == "1")
        self.accepted = set()  # the baselines that this process has accepted
        self.item = None  # the test that is running
        self.pending = {}  # pictures and bytes of baselines to write if it passes
        self.fresh = []  # its results not reported yet
        self.results = []  # all reported results
        self.report = None  # the path of the report once it is written
        self.problems = []  # reasons to fail the run although its tests have passed

    # The interface to lambent.testing.

    @property
    def updates(self):
        """Whether a picture of the running test may be accepted. It may not if the test is expected
        to fail."""
        return self.is_updating and not _expects_failure(self.item)

    def baselines(self, _calling_file):
        """The folder of the baselines of the running test, wherever its helpers are."""
        return self._common_baselines() or str(self.item.path.parent / "baselines")

    def failures(self):
        """Create a folder, named after the running test, for the pictures of a failure."""
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
        kept.DeepCopy(picture)  # the test may still change its picture
        self.pending[baseline] = kept, content
        self.accepted.add(baseline)

    def record(self, result):
        self.fresh.append(dict(result, test=self.item.nodeid))

    def name_of(self, item):
        """The baseline name of a test: "file/Class.test[parameters]". If all tests share a folder,
        the folders of the file are part of the name."""
        file, _, test = item.nodeid.partition("::")
        folders = [part.strip(".") for part in os.path.splitext(file)[0].split("/")]
        folders = [_plain(part) for part in folders if part]
        if not self._common_baselines():
            folders = folders[-1:]
        test, bracket, parameters = test.partition("[")
        return "/".join(folders + [_plain(test.replace("::", ".") + bracket + parameters)])

    def _common_baselines(self):
        """The folder from the option, or else from the ini-file, if any."""
        config = self.config
        folder = config.getoption("lambent_baselines") or config.getini("lambent_baselines")
        # The setting can come from -o without an ini-file.
        home = config.inipath.parent if config.inipath else config.invocation_params.dir
        return folder and str(home / folder)

    # The hooks of pytest.

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
            # Keep these until the test has run, and accept them only if it passes.
            self.fresh = [result for result in self.fresh if result["outcome"] != "failed"]
            return
        if not report.passed or hasattr(report, "wasxfail"):
            self._drop_pending("not accepted, since the test has not passed")
        else:
            self._write_pending(report)
        report.lambent, self.fresh = self.fresh, []

    def pytest_runtest_logreport(self, report):
        # If a test passes although a comparison failed, it expected the failure.
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
            write("If these pictures are right, %s to accept them." % self.how_to_accept)
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
        """Write the baselines that a test has accepted; if that fails, the test fails."""
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
        """Find baselines for which two workers have accepted different pictures."""
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
    """Whether a test is marked as expected to fail."""
    from lambent.testing.runs import unittest_expects_failure
    if unittest_expects_failure():
        return True
    if item.config.getoption("runxfail", False):
        return False
    try:
        from _pytest.skipping import evaluate_xfail_marks  # there is no public API
    except ImportError:
        return item.get_closest_marker("xfail") is not None
    return evaluate_xfail_marks(item) is not None


def _plain(text):
    """Make a text usable as a file name. If that changes it, its checksum is appended to keep it
    unique."""
    plain = re.sub(r"[^\w.,=+@()\[\] -]", "_", text)[:100]
    if plain == text:
        return text
    return "%s-%08x" % (plain, zlib.crc32(text.encode("utf-8", "replace")))
