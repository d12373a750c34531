"""Objects that ask for far more work than their size tells end in bounded time and memory.

Usage: cli_hostile_test.py SNUG [unittest arguments]
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import hostile_objects

SNUG = Path(sys.argv.pop(1)).resolve()
# Twice what the slowest takes on a machine of 2024, for machines that are slower or busy.
MOST_CPU_SECONDS = 12
MOST_MB = 400
MANY_COLUMNS = ["--blocks=30x1024x1024", "--block-size=15x0.3123x0.4057"]
FLUSH_COLUMNS = ["--blocks=30x1024x1024", "--block-size=15x0.3x0.4"]  # whose faces hold the tetrahedron's corners


class Hostile(unittest.TestCase):
    def made(self, name, contents, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.write_bytes(contents)
            self.assertLessEqual(len(contents), hostile_objects.BYTES)
            process = subprocess.Popen(
                [SNUG, "make", path, "-o", Path(folder) / "out", "--units=mm", "--quiet", *arguments],
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertIn(process.returncode, (0, 1, 3))
            self.assertTrue((Path(folder) / "out" / "report.json").exists())
        seconds, mb = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
        print(f"{name} {' '.join(arguments)}: {seconds:.1f} s of CPU, {mb:.0f} MB")
        self.assertLess(seconds, MOST_CPU_SECONDS)
        self.assertLess(mb, MOST_MB)

    def test_one_tetrahedron_80000_times(self):
        self.made("coincident.ply", hostile_objects.coincident_tetrahedra())

    def test_one_tetrahedron_flush_with_a_million_columns(self):
        self.made("coincident.ply", hostile_objects.coincident_tetrahedra(), *FLUSH_COLUMNS)

    def test_boxes_flush_with_blocks(self):
        self.made("flush.stl", hostile_objects.flush_boxes(1))

    def test_large_triangles(self):
        self.made("large.ply", hostile_objects.large_triangles(1))

    def test_layers_over_a_million_columns(self):
        self.made("layers.stl", hostile_objects.layers(), *MANY_COLUMNS)


if __name__ == "__main__":
    unittest.main()
