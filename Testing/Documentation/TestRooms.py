# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
"""Includes go in one direction only, as the map of the folders in Rendering/README.md shows."""

import re
import unittest

import rooms


class TestRooms(unittest.TestCase):

    def test_includes_go_one_way(self):
        self.assertEqual(rooms.wrong_includes(), [], "The order is:\n" + rooms.table())

    def test_rooms_are_in_order(self):
        seen = set()
        for room in rooms.ROOMS:
            self.assertLessEqual(set(room.includes), seen, room.folder)
            seen.add(room.folder)

    def test_all_sources_are_in_a_room(self):
        known = {path for room in rooms.ROOMS for path in rooms.sources(room)}
        self.assertGreater(len(known), 200)
        for top in ("Filters", "Rendering"):
            for path in (rooms.ROOT / top).rglob("*"):
                if path.suffix in (".h", ".cxx"):
                    self.assertIn(path, known)

    def test_headers_of_the_core_have_unique_names(self):
        for header, folders in rooms.rooms_of_headers().items():
            core = [folder for folder in folders if folder != rooms.COMMAND]
            self.assertLessEqual(len(core), 1, header)

    def test_the_table_in_the_readme_is_current(self):
        text = (rooms.ROOT / "Rendering/README.md").read_text()
        shown = re.search(r"<!-- rooms -->\n(.*?)\n<!-- end of the rooms -->", text, re.DOTALL)
        self.assertEqual(shown and shown.group(1), rooms.table(),
                         "copy the output of python3 Testing/Documentation/rooms.py")


if __name__ == "__main__":
    unittest.main()
