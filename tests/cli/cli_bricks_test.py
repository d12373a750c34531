"""What `snug make --for bricks` hands to a builder, and what it refuses.

Usage: cli_bricks_test.py SNUG [unittest arguments]
"""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
SMALL = ["--longest", 60]


class BricksTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.out = self.work / "out"
        self.vase = self.work / "vase.stl"
        self.assertEqual(self.snug("sample", "vase", "-o", self.vase).returncode, 0)

    def snug(self, *arguments):
        return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=240)

    def make(self, *arguments):
        blocks = [] if "--blocks" in arguments else ["--blocks", "14x14x14"]
        return self.snug("make", self.vase, "--for", "bricks", *SMALL, *blocks, *arguments, "-o", self.out)

    def parts(self):
        return list(csv.DictReader((self.out / "bricks/parts.csv").read_text().splitlines()))

    def codes(self):
        report = json.loads((self.out / "report.json").read_text())
        return {finding["code"] for finding in report["findings"]}

    def test_files_for_builders_are_whole(self):
        done = self.make()
        self.assertEqual(done.returncode, 0, done.stderr)
        names = {str(path.relative_to(self.out)) for path in self.out.rglob("*") if path.is_file()}
        self.assertLessEqual({"bricks/foams.mpd", "bricks/parts.csv", "bricks/wanted.xml", "bricks-plan.pdf",
                              "packing-sheet.pdf", "lower.stl", "depths.csv"}, names)
        parts = self.parts()
        listed = sum(int(part["pieces"]) for part in parts)
        wanted = ElementTree.parse(self.out / "bricks/wanted.xml").getroot()
        self.assertEqual(sum(int(item.findtext("MINQTY")) for item in wanted), listed)
        placed = [line for line in (self.out / "bricks/foams.mpd").read_text().splitlines()
                  if line.startswith("1 ") and line.endswith(".dat")]
        self.assertEqual(len(placed), listed)
        self.assertEqual({part["color"] for part in parts}, {"blue", "orange"})
        self.assertLessEqual({"rigid", "lid_gap"}, self.codes())

    def test_tiles_close_the_lid_and_colors_are_chosen(self):
        done = self.make("--brick-rim", "tiles", "--brick-colors", "tan,dark red", "--brick-unit", "plate")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("lid_gap", self.codes())
        parts = self.parts()
        self.assertEqual({part["color"] for part in parts}, {"tan", "dark red"})
        self.assertEqual({part["name"].split()[0] for part in parts}, {"Plate", "Tile"})

    def test_a_project_keeps_every_option_and_gives_the_same_bytes(self):
        options = ["--brick-sizes", "1x1,1x2,2x4", "--brick-stock", "2x4=30", "--brick-capacity", 0.5]
        self.assertEqual(self.make(*options).returncode, 0)
        first = (self.out / "bricks/foams.mpd").read_bytes()
        again = self.work / "again"
        done = self.snug("make", self.out / "project.snug.json", "--object", self.vase, "-o", again)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "bricks/foams.mpd").read_bytes(), first)

    def test_strength_is_checked(self):
        done = self.make()
        self.assertRegex(done.stdout, "Lower half, lifted by its rim +holds")
        self.assertRegex(done.stdout, "Lid, cavity down on its rim +holds")

    def test_dry_run_counts_and_writes_nothing(self):
        done = self.make("--dry-run")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Bricks, lower", done.stdout)
        self.assertFalse(self.out.exists())

    def test_what_cannot_be_built_is_said(self):
        cases = [(["--block-size", "15x15x22"], ["16 x 16 x 24", "--block-size"]),
                 (["--brick-sizes", "1x1"], ["1x2"]),
                 (["--brick-sizes", "5x5"], ["5x5", "2x4"]),
                 (["--brick-sizes", "2x2,2x4", "--blocks", "15x15x15"], ["1x1"]),
                 (["--brick-stock", "2x4"], ["2x4=100"]),
                 (["--brick-stock", "2x4=-3"], ["stock"]),
                 (["--brick-sizes", "2x4,1x1", "--brick-stock", "1x1=3,2x4=2"], ["stock", "1x1"]),
                 (["--brick-colors", "mauve"], ["mauve", "tan"]),
                 (["--brick-rim", "glue"], ["studs or tiles"]),
                 (["--brick-unit", "slab"], ["plate"]),
                 (["--brick-unit", "brick", "--block-size", "6.4x8x8", "--blocks", "20x14x14"], ["9.6"]),
                 (["--brick-capacity", 0], ["newtons"])]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                done = self.make(*arguments)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                for word in words:
                    self.assertIn(word, done.stderr)
                self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
