"""Every folder of the library includes only what lies above it, and a way of fabrication no other way.

Usage: includes_test.py [unittest arguments]
"""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# From what every part speaks to what uses most; files that stand directly in snug/ use all of it.
FOLDERS = ["base", "words", "polygon", "drawing", "mesh", "formats", "samples", "design", "object", "space", "depth",
           "foam", "check", "search", "solid", "picture", "fabricate/kit", "fabricate/printing"]

def folder_of(path):
    return str(Path(path).relative_to("snug").parent)


def includes():
    """Each file of the library with each of its includes, both from the root."""
    for path in sorted((ROOT / "snug").rglob("*")):
        if path.suffix in (".h", ".cpp"):
            for included in re.findall(r'#include "([^"]+)"', path.read_text()):
                yield str(path.relative_to(ROOT)), included


def rank(folder):
    if folder in ("fabricate", "."):
        return len(FOLDERS) + (1 if folder == "fabricate" else 2)
    return FOLDERS.index(folder) if folder in FOLDERS else len(FOLDERS)


class Includes(unittest.TestCase):
    def test_every_folder_has_its_place(self):
        # Each way of fabrication is one that the list of ways takes in.
        ways = [folder_of(included) for file, included in includes() if file == "snug/fabricate/processes.cpp"]
        for path in (ROOT / "snug").rglob("*.h"):
            self.assertIn(folder_of(path.relative_to(ROOT)), [".", "fabricate", *FOLDERS, *ways], path)

    def test_the_top_alone_stands_directly_in_the_library(self):
        self.assertEqual(sorted(path.name for path in (ROOT / "snug").glob("*.*")), ["make.cpp", "make.h", "plan.cpp", "plan.h"])

    def test_includes_are_written_from_the_root_and_stay_in_the_library(self):
        for file, included in includes():
            self.assertTrue((ROOT / included).is_file() and included.startswith("snug/"), f"{file}: {included}")

    def test_no_include_runs_back_and_no_way_includes_another(self):
        for file, included in includes():
            own, other = folder_of(file), folder_of(included)
            self.assertTrue(own == other or rank(other) < rank(own), f"{file} includes {included}")

    def test_no_headers_include_each_other_in_a_circle(self):
        below = {}
        for file, included in includes():
            if file.endswith(".h"):
                below.setdefault(file, []).append(included)
        done = set()

        def walk(file, way):
            self.assertNotIn(file, way, " -> ".join([*way, file]))
            if file in done:
                return
            for included in below.get(file, []):
                walk(included, [*way, file])
            done.add(file)

        for file in list(below):
            walk(file, [])


if __name__ == "__main__":
    unittest.main()
