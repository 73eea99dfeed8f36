# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""find_package(Lambent) and lambent_add_image_test() in a separate project.

    TestPackage.py FOLDER CMAKE CTEST OPTION...
"""

import os
import re
import shutil
import subprocess
import sys
import unittest

FOLDER, CMAKE, CTEST, *OPTIONS = sys.argv[1:]
SOURCE = os.path.join(FOLDER, "source")
BUILD = os.path.join(FOLDER, "build")

HEAD = "cmake_minimum_required(VERSION 3.22)\n"
PROJECT = HEAD + "project(Pictures C)\nenable_testing()\nfind_package(Lambent REQUIRED)\n"
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"


def run(*command, **variables):
    environment = {name: value for name, value in os.environ.items()
                   if name != "LAMBENT_UPDATE_BASELINES"}
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**environment, **variables})
    return done.returncode, done.stdout.decode()


class PackageTest(unittest.TestCase):

    def setUp(self):
        os.environ.pop("LAMBENT_UPDATE_BASELINES", None)
        shutil.rmtree(FOLDER, ignore_errors=True)
        os.makedirs(SOURCE)
        self.write("square.obj", SQUARE)

    def write(self, name, text):
        with open(os.path.join(SOURCE, name), "w", encoding="utf-8") as file:
            file.write(text)

    def configure(self, text):
        """The exit status, and CMake's output as words without line ends."""
        self.write("CMakeLists.txt", text)
        status, said = run(CMAKE, "-S", SOURCE, "-B", BUILD, *OPTIONS)
        return status, re.sub(r"\s+", " ", said)

    def succeed(self, text):
        status, said = self.configure(text)
        self.assertEqual(status, 0, said)
        return said

    def fail_with(self, text, *words):
        status, said = self.configure(text)
        self.assertNotEqual(status, 0, said)
        for word in words:
            self.assertIn(word, said)

    def run_tests(self, status, *arguments, **variables):
        code, said = run(CTEST, "--test-dir", BUILD, "--output-on-failure", *arguments, **variables)
        self.assertEqual(code == 0, status == 0, said)
        return said


class TestFinding(PackageTest):

    def test_unknown_components_are_refused(self):
        self.fail_with(HEAD + "project(P CXX)\nfind_package(Lambent REQUIRED COMPONENTS NoSuch)\n",
                       "NoSuch was requested")
        said = self.succeed(HEAD + """project(P CXX)
            find_package(Lambent COMPONENTS NoSuch)
            message("found '${Lambent_FOUND}' '${Lambent_NoSuch_FOUND}'")
            if (TARGET Lambent::Lambent)
              message(FATAL_ERROR "there is a target")
            endif ()
            find_package(Lambent OPTIONAL_COMPONENTS NoSuch)
            message("found '${Lambent_FOUND}' '${Lambent_NoSuch_FOUND}'")
            if (NOT TARGET Lambent::Lambent)
              message(FATAL_ERROR "there is no target")
            endif ()
            find_package(Lambent REQUIRED) # once more
            """)
        self.assertIn("found '0' 'FALSE'", said.replace("'FALSE' 'FALSE'", "'0' 'FALSE'"))
        self.assertIn("found '1' 'FALSE'", said)

    def test_projects_without_a_language_are_refused(self):
        self.fail_with(HEAD + "project(P NONE)\nfind_package(Lambent REQUIRED)\n",
                       "project(<name> CXX)")
        said = self.succeed(HEAD + "project(P NONE)\nfind_package(Lambent)\n")
        self.assertNotIn("VTK", said)
        self.succeed(HEAD + "project(P NONE)\nenable_language(CXX)\nfind_package(Lambent REQUIRED)\n")


class TestImageTests(PackageTest):

    def test_similar_names_have_separate_files(self):
        names = ["Box-1", "Box_1", "Box 1", "Box.1", "box_1", "Box-1-", "BOX_1"]
        self.succeed(PROJECT + "".join(
            'lambent_add_image_test(NAME "%s" INPUT square.obj BASELINE "%s.png" ARGS --size 8x8'
            " --color 0.%d,0,0)\n" % (name, name.replace(" ", ""), k + 1)
            for k, name in enumerate(names)))
        self.run_tests(0, LAMBENT_UPDATE_BASELINES="1")
        pictures = [name for name in os.listdir(os.path.join(BUILD, "lambent-images"))]
        self.assertEqual(len({name.lower() for name in pictures}), len(names), pictures)
        self.assertIn("Box_1.png", pictures)
        self.run_tests(0, "--parallel", "7")

    def test_a_relative_working_directory_is_in_the_build_folder(self):
        self.succeed(PROJECT + """
            lambent_add_image_test(NAME Drawn BASELINE drawn.png
              COMMAND Lambent::Command "${CMAKE_CURRENT_SOURCE_DIR}/square.obj" -o x.png --size 8x8
              PICTURE x.png WORKING_DIRECTORY some/folder)
            """)
        self.run_tests(1)
        self.assertTrue(os.path.exists(os.path.join(BUILD, "some", "folder", "x.png")))
        self.run_tests(0, LAMBENT_UPDATE_BASELINES="1")
        self.run_tests(0)

    def test_lights_can_be_elements_of_a_list(self):
        self.succeed(PROJECT + """
            set(view --size 8x8 --light direction=0,0,-1:color=0,1,0)
            list(APPEND view --ambient 0)
            lambent_add_image_test(NAME Colon INPUT square.obj BASELINE green.png ARGS ${view})
            lambent_add_image_test(NAME Quoted INPUT square.obj BASELINE green.png
              ARGS --size 8x8 --light "direction=0,0,-1;color=0,1,0")
            """)
        self.run_tests(0, "-R", "Colon", LAMBENT_UPDATE_BASELINES="1")
        self.run_tests(0)

    def test_a_picture_that_is_its_baseline_is_refused(self):
        os.symlink(SOURCE, os.path.join(FOLDER, "link"))
        for picture, baseline in (("${CMAKE_CURRENT_SOURCE_DIR}/x.png", "x.png"),
                                  ("x.png", "${CMAKE_CURRENT_BINARY_DIR}/./x.png"),
                                  (FOLDER + "/link/x.png", "../source/x.png")):
            self.fail_with(PROJECT + 'lambent_add_image_test(NAME Self PICTURE "%s" BASELINE "%s")\n'
                           % (picture, baseline), "PICTURE and BASELINE are the same file")

    def test_a_picture_that_becomes_its_baseline_fails(self):
        """Detected when the test runs: a link created later, and the picture of INPUT."""
        self.succeed(PROJECT + """
            lambent_add_image_test(NAME Link PICTURE x.png BASELINE y.png)
            lambent_add_image_test(NAME Own INPUT square.obj ARGS --size 8x8
              BASELINE "${CMAKE_CURRENT_BINARY_DIR}/lambent-images/Own.png")
            """)
        os.symlink(os.path.join(SOURCE, "y.png"), os.path.join(BUILD, "x.png"))
        shutil.copy(os.path.join(SOURCE, "square.obj"), os.path.join(SOURCE, "y.png"))
        for _ in range(2):
            said = self.run_tests(1)
            self.assertIn("they are the same file", said)
            self.assertIn("it is the baseline", said)
            self.assertIn("0% tests passed", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
