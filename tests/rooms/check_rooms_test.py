#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each kind of arrow that runs back up, in a house of three rooms, is found by check_rooms.py."""

import tempfile
import unittest
from pathlib import Path

from check_rooms import errors_of

HOUSE = {
    "CMakeLists.txt": "foreach(room core oit app)\n",
    "core/CMakeLists.txt": "pellucid_room(core ORDER error options)",
    "core/error.h": "",
    "core/options/names.cpp": '#include "core/error.h"',
    "oit/CMakeLists.txt": "pellucid_room(oit\n  ORDER gl lists methods\n  ROOMS core\n  LIBRARIES x)",
    "oit/gl/program.h": '#include "core/error.h"',
    "oit/gl/screen.vert.glsl": "",
    "oit/lists/sort.glsl": "",
    "oit/lists/lists.cpp": "oit_glsl::screen_vert_glsl()",
    "oit/methods/tree/tree.cpp": "oit_glsl::sort_glsl()",
    "oit/methods/fourier/fourier.cpp": "",
    "app/CMakeLists.txt": "target_link_libraries(pellucid PRIVATE pellucid_oit CLI11::CLI11)",
    "app/main.cpp": '#include "oit/gl/program.h"',
}


def errors(changes):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**HOUSE, **changes}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return errors_of(folder)[1]


class WrongArrows(unittest.TestCase):
    def finds(self, changes, *words):
        found = errors(changes)
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_a_house_in_order_has_none(self):
        self.assertEqual(errors({}), [])

    def test_cpp_between_rooms(self):
        found = errors({"core/error.h": '#include "oit/gl/program.h"'})
        self.assertIn("core/error.h: oit/gl/program.h: core may not include oit", found)

    def test_cpp_between_sub_rooms(self):
        self.finds({"oit/gl/program.h": '#include "core/error.h"\n#include "oit/lists/lists.cpp"'},
                   "gl comes before lists")

    def test_cpp_from_a_file_at_the_top(self):
        self.finds({"core/error.h": '#include "core/options/names.cpp"'}, "error comes before options")

    def test_glsl(self):
        self.finds({"oit/gl/screen.vert.glsl": '#include "oit/lists/sort.glsl"'},
                   "gl comes before lists")

    def test_names_of_embedded_shaders(self):
        self.finds({"oit/gl/program.h": '#include "core/error.h"\noit_glsl::sort_glsl()'},
                   "gl comes before lists")

    def test_circles_of_methods(self):
        self.finds({"oit/methods/tree/tree.cpp": '#include "oit/methods/fourier/fourier.cpp"',
                    "oit/methods/fourier/fourier.cpp": '#include "oit/methods/tree/tree.cpp"'},
                   "a circle among the folders")

    def test_cmake_names_a_room_to_the_right(self):
        self.finds({"core/CMakeLists.txt": "pellucid_room(core ORDER error options ROOMS oit)"},
                   "core may not include it")

    def test_cmake_names_a_room_in_vain(self):
        self.finds({"oit/gl/program.h": ""}, "ROOMS core", "nothing of it is included")

    def test_cmake_forgets_a_room(self):
        self.finds({"app/main.cpp": '#include "oit/gl/program.h"\n#include "core/error.h"'},
                   "ROOMS lacks core")

    def test_an_entry_without_a_place(self):
        self.finds({"oit/colours/map.h": ""}, "ORDER lacks colours")

    def test_a_missing_file(self):
        self.finds({"oit/lists/lists.cpp": "oit_glsl::nothing_glsl()"}, "not there")

    def test_full_folders(self):
        self.finds({f"oit/gl/file_{i}.h": "" for i in range(39)}, "at most 40")


if __name__ == "__main__":
    unittest.main()
