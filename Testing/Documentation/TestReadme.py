# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""The README says what is so: it quotes the examples word by word, its links lead to files, and its tables
name every setting and every option. That the quoted files run, and draw the picture, is tested with the
gallery.

    TestReadme.py             needs the standard library only; LAMBENT_COMMAND may name the command
    TestReadme.py --update    copies the examples into the README
"""

import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
README = os.path.join(ROOT, "README.md")
QUOTE = re.compile(r"(<!-- file: (\S+) -->\n```\w+\n)(.*?)(```\n)", re.DOTALL)
LICENCE = re.compile(r"\A(?:(?://|#) SPDX-.*\n)+\n?")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def example(path):
    """The text of an example without the lines about its licence."""
    return LICENCE.sub("", read(path))


def section(text, title):
    """What follows a heading, up to the next of its level or above."""
    level = re.search(r"^(#+) %s$" % re.escape(title), text, re.MULTILINE)
    rest = text[level.end():]
    following = re.search(r"^#{1,%d} " % len(level.group(1)), rest, re.MULTILINE)
    return rest[:following.start()] if following else rest


def setters(header):
    """The names of the public methods of a class that change what it makes."""
    public = read(header).split("\npublic:\n")[1].split("\nprotected:\n")[0]
    macros = re.findall(r"vtkSet(?:Vector\d|Clamp|)Macro\((\w+),", public)
    methods = re.findall(r"^  (?:virtual )?void ((?:Set|Add|Remove|Reset)\w+)\((?!.*override)", public,
                         re.MULTILINE)
    return {"Set" + name for name in macros} | set(methods)


class Readme(unittest.TestCase):
    def setUp(self):
        self.text = read("README.md")

    def test_quotes_equal_the_files(self):
        quotes = QUOTE.findall(self.text)
        self.assertEqual({path for _, path, _, _ in quotes},
                         {"Examples/CommandLine/quickstart.sh", "Examples/Python/quickstart.py",
                          "Examples/Cxx/QuickStart.cxx", "Examples/Cxx/CMakeLists.txt",
                          "Examples/Python/test_pictures.py"})
        for _, path, body, _ in quotes:
            self.assertEqual(body, example(path), path)

    def test_the_first_command_builds_what_the_quick_starts_take(self):
        built = re.search("^compile --target (.*)$", read("Examples/run.sh"), re.MULTILINE).group(1)
        self.assertEqual(set(built.split()), {"lambent", "vtkLambentPython"})

    def test_every_block_of_code_is_quoted(self):
        self.assertEqual(len(re.findall(r"^```\w", self.text, re.MULTILINE)),
                         len(QUOTE.findall(self.text)))

    def test_links_lead_to_files(self):
        links = re.findall(r"\]\(([^)#]+)\)", self.text)
        self.assertGreater(len(links), 20)
        for link in links:
            if "://" not in link:
                self.assertTrue(os.path.isfile(os.path.join(ROOT, link)), link)

    def test_gallery_shows_every_baseline(self):
        for name in os.listdir(os.path.join(ROOT, "Testing/Baselines")):
            self.assertIn("](Testing/Baselines/%s)" % name, self.text)

    def test_settings_are_those_of_the_classes(self):
        for header in ("Rendering/vtkLambentRayTracer.h", "Filters/vtkLambentNormals.h",
                       "Rendering/Comparison/vtkLambentImageComparison.h"):
            name = os.path.basename(header)[:-2]
            table = section(self.text, name)
            # "`SetFooToBar()`, `…ToBaz()`" names SetFooToBaz, too.
            known = set(re.findall(r"`(\w+)", table))
            stems = {method.split("To")[0] for method in known if "To" in method}
            known |= {stem + tail for tail in re.findall(r"`…(\w+)", table) for stem in stems}
            wanted = setters(header)
            self.assertGreater(len(wanted), 5)
            self.assertEqual(wanted - known, set(), name + ": not in the README")
            named = {method for method in known if re.match("(Set|Add|Remove|Reset)[A-Z]", method)
                     and "…" + method[method.find("To"):] not in table}
            self.assertEqual(named - wanted, set(), name + ": only in the README")

    def test_assertions_and_options_are_those_of_pytest(self):
        text = section(self.text, "From pytest")
        assertions = re.findall(r"^def (assert_\w+\(.*\)):$",
                                read("Rendering/Python/testing/assertions.py"), re.MULTILINE)
        self.assertEqual(len(assertions), 2)
        for assertion in assertions:
            self.assertIn("`%s`" % assertion, text)
        options = re.findall(r'addoption\("(--[\w-]+)"', read("Rendering/Python/pytest_lambent.py"))
        self.assertEqual(set(re.findall(r"--lambent-\w+", text)), set(options))

    def test_contract_version_is_the_current_one(self):
        version = re.search(r"constexpr int ImageContractVersion = (\d+);",
                            read("Rendering/Core/ImageContract.h")).group(1)
        self.assertIn("This is version %s of it" % version, self.text)

    @unittest.skipUnless("LAMBENT_COMMAND" in os.environ, "needs the command")
    def test_options_are_those_of_the_command(self):
        help_text = subprocess.run([os.environ["LAMBENT_COMMAND"], "--help"], check=True,
                                   stdout=subprocess.PIPE).stdout.decode()
        offered = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", help_text, re.MULTILINE))
        rows = re.findall(r"^\| (`-.*?) \|", section(self.text, "The command"), re.MULTILINE)
        named = set(re.findall(r"--[a-z-]+", " ".join(rows)))
        self.assertGreater(len(offered), 15)
        self.assertEqual(named, offered)


def update():
    with open(README, encoding="utf-8") as file:
        text = file.read()
    text = QUOTE.sub(lambda match: match[1] + example(match[2]) + match[4], text)
    with open(README, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update()
    else:
        unittest.main()
