"""What `snug make --for mould` hands to a maker, read back by nothing of the program's own.

Usage: cli_mould_test.py SNUG [unittest arguments]
"""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_solids import is_closed, read_stl
from some_of import some_of

SNUG = Path(sys.argv.pop(1)).resolve()
SAMPLES = ["torus", "vase", "figurine", "camera"]


def snug(*arguments):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=240)


def normal_up(t):
    (ax, ay, _), (bx, by, _), (cx, cy, _) = t
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


class Mould:
    """The parts of one mould, put together as parts.csv says."""

    def __init__(self, folder, half):
        self.parts = {}
        with open(folder / "parts.csv") as file:
            for row in csv.DictReader(file):
                if not row["part"].startswith(half):
                    continue
                left, front, up, depth = (float(row[name]) for name in ("left_mm", "front_mm", "up_mm", "depth_mm"))
                turn = (lambda p: (p[1], depth - p[0], p[2])) if row["turned_deg"] == "90" else lambda p: p
                place = lambda p: (p[0] + left, p[1] + front, p[2] + up)
                triangles = read_stl(folder / f"{row['part']}.stl")
                self.parts[row["part"]] = [tuple(place(turn(p)) for p in t) for t in triangles]
        self.triangles = [t for part in self.parts.values() for t in part]

    def crossings(self, lines):
        """For each upright line (x, y) the heights at which it enters (+1) or leaves (-1) plastic, from below."""
        found = {line: [] for line in lines}
        by_x = {}
        for line in lines:
            by_x.setdefault(line[0], []).append(line)
        for t in self.triangles:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = t
            for x, column in by_x.items():
                if not min(ax, bx, cx) < x < max(ax, bx, cx):
                    continue
                for line in column:
                    y = line[1]
                    ab = (ax - x) * (by - y) - (ay - y) * (bx - x)
                    bc = (bx - x) * (cy - y) - (by - y) * (cx - x)
                    ca = (cx - x) * (ay - y) - (cy - y) * (ax - x)
                    if (ab > 0 and bc > 0 and ca > 0) or (ab < 0 and bc < 0 and ca < 0):
                        area = ab + bc + ca
                        found[line].append(((az * bc + bz * ca + cz * ab) / area, -1 if area > 0 else 1))
        return found


class MouldTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.out = self.work / "out"

    def make(self, name, *arguments):
        path = self.work / f"{name}.stl"
        self.assertEqual(snug("sample", name, "-o", path).returncode, 0)
        shutil.rmtree(self.out, ignore_errors=True)
        done = snug("make", path, "--for", "mould", *arguments, "-o", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.out / "report.json").read_text())

    def test_what_can_be_poured_is_the_foam_of_the_depths(self):
        for name, bed in [("torus", "250x210x210"), ("camera", "150x120x60")]:
            with self.subTest(name):
                report = self.make(name, "--block-size", "12x11x10", "--draft", "0", "--dowel", "0", "--bed", bed,
                                   "--rotate", "10,20,30")
                _, ny, nz = report["design_space"]["blocks"]
                sx, sy, sz = report["design_space"]["block_mm"]
                with open(self.out / "depths.csv") as file:
                    kept = {(int(row["j"]), int(row["k"])): {"lower": int(row["lower_blocks"]), "lid": int(row["upper_blocks"])}
                            for row in csv.DictReader(file)}
                for half in ("lower", "lid"):
                    mould = Mould(self.out / "mould", half)
                    # BACK, where j is least, lies in front in the lower mould and behind in the lid's.
                    lines = {(j, k): (3 + (k + 0.479) * sz, 3 + ((j if half == "lower" else ny - 1 - j) + 0.513) * sy)
                             for j, k in kept}
                    crossings = mould.crossings(lines.values())
                    top = 3 + sx * max(each[half] for each in kept.values())
                    for column, line in lines.items():
                        filled = [0.0] + [z for z, _ in sorted(crossings[line])]
                        self.assertEqual(sum(way for _, way in crossings[line]), 0)
                        self.assertAlmostEqual(top - max(filled), kept[column][half] * sx, 2)

    def test_parts_are_closed_drained_and_read_by_another_program(self):
        for name in some_of(SAMPLES):
            with self.subTest(name):
                self.make(name, "--dowel", "0", "--block-size", "10x10x10")
                for half in ("lower", "lid"):
                    for part, triangles in Mould(self.out / "mould", half).parts.items():
                        self.assertTrue(is_closed(read_stl(self.out / "mould" / f"{part}.stl")), part)
                        floor = min(p[2] for t in triangles for p in t)
                        for t in triangles:
                            if normal_up(t) < 0:
                                self.assertEqual({p[2] for p in t}, {floor}, f"{part} overhangs")
                for path in sorted((self.out / "mould").glob("*.3mf")) + sorted((self.out / "mould").glob("*-01.stl")):
                    info = subprocess.run(["assimp", "info", path], capture_output=True, text=True)
                    self.assertEqual(info.returncode, 0, info.stdout)

    def test_the_guide_says_what_to_pour_and_where_back_is(self):
        report = self.make("figurine")
        text = subprocess.run(["pdftotext", "-layout", self.out / "mould-guide.pdf", "-"], capture_output=True, text=True, check=True).stdout
        for words in ["LOWER", "LID", "BACK", "release agent", "expand", "ledge", "lower-01", "lid-01"]:
            self.assertIn(words, text)
        pour = [float(line.split()[-2]) for line in self.dry_run("figurine") if line.strip().startswith("To pour")]
        self.assertAlmostEqual(sum(pour), report["workshop"]["litres"], delta=0.011)
        self.assertLess(report["workshop"]["litres"], report["foam"]["volume_mm3"] * 1e-6)
        for litres in pour:
            self.assertIn(f"{litres:g} litres", text)

    def dry_run(self, name):
        done = snug("make", self.work / f"{name}.stl", "--for", "mould", "--dry-run", "-o", self.work / "none")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.work / "none").exists())
        return done.stdout.splitlines()

    def test_the_draft_makes_the_foam_smaller_never_larger(self):
        litres = [self.make("vase", "--draft", draft)["workshop"]["litres"] for draft in (0, 1, 3)]
        self.assertGreater(litres[0], litres[1])
        self.assertGreater(litres[1], litres[2])

    def test_what_cannot_be_made_is_refused_with_what_can(self):
        path = self.work / "vase.stl"
        snug("sample", "vase", "-o", path)
        for options, words in [(["--draft", "40"], ["draft is 40 degrees", "0 to 15"]),
                               (["--mould-wall", "0.1"], ["wall is 0.1 mm", "0.4 to 100"]),
                               (["--mould-rim", "-1"], ["rim"]),
                               (["--bed", "12x12x12", "--block-size", "10x10x10"], ["smaller than a block", "13 x 13 x 15"])]:
            with self.subTest(options):
                done = snug("make", path, "--for", "mould", *options, "-o", self.out)
                self.assertEqual(done.returncode, 1, done.stderr)
                for word in words:
                    self.assertIn(word, done.stderr)
                self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
