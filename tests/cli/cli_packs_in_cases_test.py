"""Packs of random designs in cases whose walls lean and whose corners are round hold what depths.csv keeps.

Usage: cli_packs_in_cases_test.py SNUG [unittest arguments]
"""

import csv
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_solids import read_stl, signed_volume

SNUG = Path(sys.argv.pop(1)).resolve()
SEED = int(os.environ.get("SEED", 1))
# Studs of the parts that LDraw knows by these numbers.
STUDS = {"3005": 1, "3004": 2, "3622": 3, "3010": 4, "3009": 6, "3008": 8, "3003": 4, "3002": 6, "3001": 8,
         "2456": 12, "3007": 16, "3006": 20}


def rows_of(path):
    with open(path) as file:
        return list(csv.DictReader(file))


class PacksInCases(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.object = self.work / "object.stl"

    def design(self, numbers, most_lean):
        length, width, height = (numbers.randint(*ends) for ends in ((230, 300), (180, 240), (150, 180)))
        lean = numbers.randint(0, most_lean)
        return [
            f"--longest={numbers.randint(60, 100)}",
            f"--case={length}x{width}x{height}:{numbers.randint(40, 80)}",
            f"--case-base={length - lean}x{width - lean}",
            f"--case-top={length - numbers.randint(0, most_lean)}x{width - numbers.randint(0, most_lean)}",
            f"--case-radius={numbers.choice([0, 15, 40])}",
            "--clearance=" + ",".join(f"{numbers.uniform(0, 4):.3f}" for _ in range(6)),
            f"--rotate={numbers.uniform(0, 360):.2f},{numbers.choice([0, 90, 37.5])},0",
            *numbers.choice([[], ["--notches=40x30"]]),
            *numbers.choice([[], ["--least-rib=25"]]),
            "--edit=" + ",".join(self.edit(numbers) for _ in range(numbers.randint(1, 30))),
        ]

    @staticmethod
    def edit(numbers):
        """Of a column that there may not be, and of blocks that may be the object's."""
        piece = numbers.choice(["lower", "upper"])
        return f"{piece}:{numbers.randint(0, 20)}:{numbers.randint(0, 25)}:{numbers.choice([-2, -1, 1, 2, 3])}"

    def packs(self, way, *own, lean=40):
        """Reports and folders of a few random designs, each with the blocks that both halves keep."""
        edited = 0
        for seed in range(SEED, SEED + 3):
            numbers = random.Random(f"{way} {seed}")
            name = numbers.choice(["torus", "vase", "camera", "figurine"])
            subprocess.run([SNUG, "sample", name, "-o", self.object], check=True, capture_output=True)
            words = self.design(numbers, lean)
            out = self.work / f"{seed}"
            command = [SNUG, "make", self.object, f"--for={way}", *words, *own, "-o", out]
            with self.subTest(f"SEED={seed}: {name} {' '.join(words)}"):
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                report = json.loads((out / "report.json").read_text())
                kept = {"lower": 0, "lid": 0}
                for row in rows_of(out / "depths.csv"):
                    kept["lower"] += int(row["lower_blocks"])
                    kept["lid"] += int(row["upper_blocks"])
                self.assertGreater(min(kept.values()), 0)
                x, y, z = report["design_space"]["block_mm"]
                for half, file in (("lower", "lower.stl"), ("lid", "upper.stl")):
                    self.assertAlmostEqual(signed_volume(read_stl(out / file)) / (kept[half] * x * y * z), 1, 4)
                edited += report["edits"]["taken_blocks"] + report["edits"]["put_back_blocks"]
                yield out, kept, x * y * z
        self.assertGreater(edited, 0)

    def test_sheets(self):
        for out, kept, _ in self.packs("sheets"):
            pieces = rows_of(out / "sheets" / "index.csv")
            for half in kept:
                self.assertEqual(sum(int(row["cells"]) for row in pieces if row["half"] == half), kept[half])

    def test_print(self):
        for out, kept, block in self.packs("print", "--dowel=0", "--block-size=10x10x10"):
            parts = rows_of(out / "print" / "parts.csv")
            for half in kept:
                names = [row["part"] for row in parts if row["part"].startswith(half)]
                printed = sum(signed_volume(read_stl(out / "print" / f"{name}.stl")) for name in names)
                self.assertAlmostEqual(printed / (kept[half] * block), 1, 4)

    def test_bricks(self):
        # A brick cannot hang in the air, so walls stand upright.
        for out, kept, _ in self.packs("bricks", lean=0):
            models = (out / "bricks" / "foams.mpd").read_text().split("0 FILE ")
            for half in kept:
                built = next(model for model in models if model.startswith(f"{half}.ldr"))
                studs = sum(STUDS[part] for part in re.findall(r" (\d+)\.dat", built))
                self.assertEqual(studs, kept[half])


if __name__ == "__main__":
    unittest.main()
