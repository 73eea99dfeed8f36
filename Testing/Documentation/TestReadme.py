# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The READMEs are correct: they quote the examples word for word, their links and images resolve, and their
tables list every setting, every option, every file format, and the measured times. The tests of the gallery
check that the quoted files run and render the picture.

    TestReadme.py             needs the standard library only; LAMBENT_COMMAND may name the command
    TestReadme.py --update    copies the examples into the READMEs
"""

import importlib.machinery
import importlib.util
import os
import re
import subprocess
import sys
import unittest

import documents
from documents import ROOT, read, section

MOST_LINES = 200  # of the first page
COMMAND = os.environ.get("LAMBENT_COMMAND")


def setters(header):
    """The names of the public methods of a class that change its output, with those of its superclass in the
    same folder."""
    text = read(header)
    public = text.split("\npublic:\n")[1].split("\nprotected:\n")[0]
    superclass = re.search(r"^class \w+ \w+ : public (\w+)$", text, re.MULTILINE).group(1)
    above = "%s/%s.h" % (os.path.dirname(header), superclass)
    inherited = setters(above) if os.path.exists(os.path.join(ROOT, above)) else set()
    macros = re.findall(r"vtkSet(?:Vector\d|Clamp|FilePath|)Macro\((\w+)", public)
    methods = re.findall(r"^  (?:virtual )?void ((?:Set|Add|Remove|Reset)\w+)\((?!.*override)", public,
                         re.MULTILINE)
    return {"Set" + name for name in macros} | set(methods) | inherited


def settings(text):
    """The names of the methods that a text shows as code, and those of them that may belong to any class."""
    known = set(re.findall(r"`(\w+)", text))
    # "`SetFooToBar()`, `…ToBaz()`" includes SetFooToBaz, too.
    stems = {method.split("To")[0] for method in known if "To" in method}
    tails = re.findall(r"`…(\w+)", text)
    named = {method for method in known if re.match("(Set|Add|Remove|Reset)[A-Z]", method)
             and method[method.find("To"):] not in tails}
    return known | {stem + tail for tail in tails for stem in stems}, named


def output_of_command(option):
    return subprocess.run([COMMAND, option], check=True, stdout=subprocess.PIPE).stdout.decode()


def has_rounded(text, value):
    """Whether a figure such as "1.1" is this value, rounded to as many digits."""
    decimals = len(text.partition(".")[2])
    return abs(float(text) - value) <= 0.5 * 10.0 ** -decimals + 1e-9


class EveryPage(unittest.TestCase):
    def test_the_first_page_is_short_and_links_to_all_others(self):
        self.assertLessEqual(len(read("README.md").splitlines()), MOST_LINES)
        readmes = documents.readmes()
        self.assertGreaterEqual(len(readmes), 8)
        others = {documents.target("README.md", link)[0] for link in documents.links("README.md")}
        self.assertEqual(set(readmes) - others - {"README.md"}, set(), "not linked from README.md")

    def test_links_and_images_resolve(self):
        for page in documents.pages():
            for link in documents.links(page):
                if "://" in link:
                    continue
                path, anchor = documents.target(page, link)
                self.assertFalse(path.startswith(("/", "..", "build")), (page, link))
                self.assertTrue(os.path.exists(os.path.join(ROOT, path)), (page, link))
                if anchor:
                    self.assertIn(anchor, documents.anchors(path), (page, link))

    def test_quoted_code_equals_the_files(self):
        quoted = {}
        for page in documents.pages():
            for _, path, first, last, body, _ in documents.QUOTE.findall(read(page)):
                self.assertEqual(body, documents.example(path, first, last), (page, path))
                quoted.setdefault(page, set()).add((path, bool(first)))
        whole = {page: {path for path, excerpt in quotes if not excerpt} for page, quotes in quoted.items()}
        self.assertEqual(whole["README.md"],
                         {"Examples/CommandLine/quickstart.sh", "Examples/Python/quickstart.py"})
        self.assertEqual(whole["Examples/README.md"],
                         {"Examples/Cxx/QuickStart.cxx", "Examples/Cxx/CMakeLists.txt"})
        self.assertEqual(whole["Rendering/Python/README.md"], {"Examples/Python/test_pictures.py"})
        self.assertEqual(whole["Rendering/CommandLine/README.md"],
                         {"Examples/CommandLine/colours.sh", "Examples/CommandLine/passes.sh"})

    def test_every_code_block_is_a_quote(self):
        for page in documents.pages():
            text = read(page)
            self.assertEqual(len(re.findall(r"^ *(?:```|~~~)", text, re.MULTILINE)),
                             2 * len(documents.QUOTE.findall(text)), page)

    def test_scripts_and_paths_exist(self):
        for page in documents.pages():
            text = read(page)
            paths = re.findall(r"\b(?:sh|python3) ([\w./-]+\.(?:sh|py))", text)
            paths += re.findall(r"`((?:\.ci|Data|Examples|Filters|Rendering|Testing)/[\w./-]*)`", text)
            for path in paths:
                self.assertTrue(os.path.exists(os.path.join(ROOT, path)), (page, path))


class Claims(unittest.TestCase):
    def test_the_first_command_builds_what_the_quick_starts_need(self):
        built = re.search("^compile --target (.*)$", read("Examples/run.sh"), re.MULTILINE).group(1)
        self.assertEqual(set(built.split()), {"lambent", "vtkLambentPython"})

    def test_gallery_shows_every_baseline(self):
        names = os.listdir(os.path.join(ROOT, "Testing/Baselines"))
        self.assertGreater(len(names), 5)
        gallery = section(read("Examples/README.md"), "Gallery")
        for name in names:
            self.assertIn("](Testing/Baselines/%s)" % name, read("README.md"))
            if name != "Seashell.png":  # the picture of the quick starts
                self.assertIn("](../Testing/Baselines/%s)" % name, gallery)
        for source in re.findall(r"^    (\w+)\)?$", read("Examples/Gallery/Pictures.cmake"), re.MULTILINE):
            self.assertIn("](Gallery/%s.cxx)" % source, gallery)

    def test_settings_match_the_classes(self):
        for header, page, least in (
                ("Rendering/vtkLambentRayTracer.h", "Rendering/README.md", 20),
                ("Filters/vtkLambentNormals.h", "Filters/README.md", 9),
                ("Rendering/Comparison/vtkLambentImageComparison.h", "Rendering/Comparison/README.md", 7),
                ("Rendering/Comparison/vtkLambentPNGReader.h", "Rendering/Comparison/README.md", 1)):
            name = os.path.basename(header)[:-2]
            known, named = settings(section(read(page), name))
            wanted = setters(header)
            self.assertGreaterEqual(len(wanted), least)
            self.assertEqual(wanted - known, set(), "%s: not in %s" % (name, page))
            self.assertEqual(named - wanted, set(), "%s: only in %s" % (name, page))

    def test_assertions_and_options_match_the_pytest_plugin(self):
        text = section(read("Rendering/Python/README.md"), "Image tests with pytest")
        assertions = re.findall(r"^def (assert_\w+\(.*\)):$",
                                read("Rendering/Python/testing/assertions.py"), re.MULTILINE)
        self.assertEqual(len(assertions), 2)
        for assertion in assertions:
            self.assertIn("`%s`" % assertion, text)
        options = re.findall(r'addoption\("(--[\w-]+)"', read("Rendering/Python/pytest_lambent.py"))
        self.assertEqual(set(re.findall(r"--lambent-\w+", text)), set(options))

    def test_contract_version_is_current(self):
        version = re.search(r"constexpr int ImageContractVersion = (\d+);",
                            read("Rendering/Core/Contract/ImageContract.h")).group(1)
        self.assertIn("This is version %s of it" % version, read("Testing/Reproducibility/README.md"))

    def test_matrix_can_write_its_readme(self):
        folder = os.path.join(ROOT, "Testing", "Reproducibility")
        sys.path.insert(0, folder)
        loader = importlib.machinery.SourceFileLoader("matrix", os.path.join(folder, "matrix"))
        matrix = importlib.util.module_from_spec(importlib.util.spec_from_loader("matrix", loader))
        loader.exec_module(matrix)
        page = os.path.join(folder, "README.md")
        self.assertEqual(str(matrix.README), page)
        text = read("Testing/Reproducibility/README.md")
        tables = [match.group(0) for match in matrix.MARKED.finditer(text)]
        self.assertEqual(len(tables), 1)
        for paragraph in (matrix.INSTRUCTION_SETS, matrix.OTHER_WAYS):
            self.assertIn("\n\n%s\n\n| " % paragraph, tables[0])

    def test_times_match_the_report(self):
        report = read("Testing/Benchmarks/report.md")
        lambent = {row[0]: row for row in documents.table(report, "scene                  |  triangles")}
        opengl = {row[0]: row for row in documents.table(report, "scene           | OpenGL")}
        first = documents.table(section(read("README.md"), "How fast it is"), "mesh")
        second = documents.table(section(read("Testing/Benchmarks/README.md"), "Results"), "mesh")
        scenes = ("bunny", "dragon", "dragon-zoom", "wave-300", "wave-600")
        self.assertEqual((len(first), len(second)), (len(scenes), len(scenes)))
        for scene, ratios, times in zip(scenes, first, second):
            one, other = lambent[scene], opengl[scene]
            triangles = float(one[1].replace(",", ""))
            for row, cells in ((ratios, [one[2], one[4], one[10], other[2], other[8]]),
                               (times, [one[2], one[3], one[6], one[9], other[1] + " " + other[7]])):
                count, unit = row[1].split()
                self.assertTrue(has_rounded(count, triangles / {"k": 1e3, "M": 1e6}[unit]), row)
                for shown, cell in zip(row[2:], cells):
                    figures = re.findall(r"[\d.]+", shown)
                    measured = re.findall(r"[\d.]+", cell)
                    self.assertTrue(figures and len(figures) <= len(measured), (row, shown))
                    for figure, value in zip(figures, measured):
                        self.assertTrue(has_rounded(figure, float(value)), (row, shown, cell))

    @unittest.skipUnless(COMMAND, "needs the command")
    def test_options_match_the_command(self):
        offered = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", output_of_command("--help"), re.MULTILINE))
        text = section(read("Rendering/CommandLine/README.md"), "Options")
        rows = re.findall(r"^\| (`-.*?) \|", text, re.MULTILINE)
        named = set(re.findall(r"--[a-z-]+", " ".join(rows)))
        self.assertGreater(len(offered), 15)
        self.assertEqual(named, offered)

    def test_file_formats_match_the_command(self):
        page = read("Rendering/CommandLine/README.md")
        rows = re.findall(r"^\| (.*?) \|", section(page, "Input files"), re.MULTILINE)
        named = re.findall(r"(?<=[ `])\.\w+", " ".join(rows))
        formats = re.findall(r'^  \{ (?:MeshKind::\w+|Other), "([^"]+)"',
                             read("Rendering/CommandLine/Reading/Formats.cxx"), re.MULTILINE)
        self.assertGreater(len(formats), 15)
        self.assertEqual(sorted(named), sorted(" ".join([*formats, ".gz"]).split()))
        kinds = dict(re.findall(r'\{ "(\.\w+)", PictureKind::(\w+) \}',
                                read("Rendering/CommandLine/FileKinds.cxx")))
        written = re.findall(r"(?<=[ `])\.\w+", page[:page.index("## ")])
        self.assertEqual(sorted(kinds[extension] for extension in written), sorted(set(kinds.values())))


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        documents.update()
    else:
        unittest.main()
