# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's report, and parallel runs: together, the workers of pytest-xdist accept, fail and report like
a single process. Needs pytest; without pytest-xdist its tests are skipped."""

import importlib.util
import os
import re
import unittest

from picture_suites import BOX, PytestSuiteTest, require_pytest

require_pytest()


class Report(PytestSuiteTest):
    def report(self, name="report.html"):
        with open(os.path.join(self.suite, name), encoding="utf-8") as file:
            return file.read()

    def test_the_report_embeds_all_pictures(self):
        self.write_tests(BOX, """
            @pytest.mark.parametrize("sign", ["<b>&amp;"])
            def test_good(sign, lambent_baseline):
                lambent_baseline(box(1))
            """)
        self.run_pytest("--lambent-update", "--lambent-report", "out/report.html")
        page = self.report("out/report.html")
        self.assertEqual(page.count("accepted as the baseline: " + self.suite), 2)
        run = self.run_pytest("--lambent-report", "out/report.html", LENGTH="1.5", status=1)
        self.assertIn("lambent: the report is %s/out/report.html\n" % self.suite, run.text)
        page = self.report("out/report.html")
        self.assertIn("<h1>1 of 2 pictures differ</h1>", page)
        self.assertIn("test_good[&lt;b&gt;&amp;amp;]", page)
        self.assertNotIn("<b>&amp;]", page)
        sources = re.findall(r'(?:src|href)="([^"]*)"', page)
        self.assertEqual(len(sources), 3)
        self.assertEqual(page.count('<div class="slide"><img alt="picture" src='), 1)
        for source in sources:
            self.assertTrue(source.startswith("data:image/png;base64,"), source[:40])
        self.assertNotIn("http", page)

    def test_the_report_is_also_written_on_success(self):
        self.write_tests("""
            def test_box():
                assert_images_equal(box(1), box(1))
            """)
        self.run_pytest("--lambent-report=report.html")
        self.assertIn("<h1>0 of 1 pictures differ</h1>", self.report())

    def test_an_unwritable_report_fails_the_run(self):
        self.write_tests("def test_nothing(): pass")
        self.write("file", "")
        run = self.run_pytest("--lambent-report", "file/report.html", status=1)
        self.assertIn("lambent: could not write the report: ", run.text)


@unittest.skipUnless(importlib.util.find_spec("xdist"), "there is no pytest-xdist")
class Parallel(PytestSuiteTest):
    TESTS = """
        @pytest.mark.parametrize("width", range(40, 48))
        def test_box(lambent_baseline, width):
            lambent_baseline(box(width=width))
        """

    def test_workers_write_one_report(self):
        self.write_tests(self.TESTS)
        run = self.run_pytest("-n", "2", "--lambent-update")
        written = ["test_box/test_box[%d].png" % width for width in range(40, 48)]
        self.assertEqual(self.baselines(), written)
        for name in written:
            self.assertEqual(run.text.count("%s/baselines/%s (new)\n" % (self.suite, name)), 1)
        self.run_pytest("-n", "2")

        run = self.run_pytest("-n", "2", "--lambent-report", "report.html", LENGTH="1.5", status=1)
        summary = run.text[run.text.index("= pictures that differ ="):]
        with open(os.path.join(self.suite, "report.html"), encoding="utf-8") as file:
            page = file.read()
        for width in range(40, 48):
            self.assertEqual(summary.count("test_box.py::test_box[%d]\n" % width), 1)
            self.assertEqual(page.count("<h2>test_box.py::test_box[%d]</h2>" % width), 1)
        self.assertNotIn("def assert_matches", run.text)  # the tests are shown, not the fixture
        pictures = set(run.paths("picture"))
        self.assertEqual(len(pictures), 8)
        self.assertTrue(all(map(os.path.isfile, pictures)))

    def test_paths_in_options_are_relative_to_the_main_process(self):
        self.write_tests(self.TESTS)
        self.run_pytest("-n", "2", "--lambent-update", "--lambent-baselines", "../all")
        self.assertEqual(len(self.baselines("../all")), 8)

    def test_two_pictures_with_the_same_name_fail_the_run(self):
        # Each waits until the other's worker also runs.
        self.write_tests("""
            import os, time
            @pytest.mark.parametrize("length", [1, 2])
            def test_box(length):
                for name, wanted in (("here%d" % length, 1), ("here%d" % (3 - length), 0)):
                    if wanted:
                        open(name, "w").close()
                    deadline = time.time() + 60
                    while not os.path.exists(name) and time.time() < deadline:
                        time.sleep(0.01)
                assert_matches_baseline(box(length), "box")
            """)
        run = self.run_pytest("-n", "2", "--lambent-update", status=1)
        self.assertIn("2 passed", run.text)
        self.assertIn("draw different pictures for %s/baselines/box.png; give each its own name"
                      % self.suite, run.text)
        self.assertEqual(self.baselines(), ["box.png"])  # a complete one, and no temporary file

    def test_a_crashed_worker_is_reported(self):
        self.write_tests(BOX, """
            def test_death():
                import os
                os._exit(3)
            """)
        run = self.run_pytest("-n", "1", status=1)
        self.assertIn("test_box.py::test_box\n", run.text)
        self.assertIn("crashed", run.text)


if __name__ == "__main__":
    unittest.main()
