"""Several layers in one case: what every pack tells of its pieces, put together again by readers of their own.

Usage: cli_layers_test.py SNUG [unittest arguments]
"""

import csv
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_maps import Map, layers_named
from read_solids import edge_balance, read_ply, read_stl, signed_volume
from some_of import some_of

SNUG = Path(sys.argv.pop(1)).resolve()
SEED = int(os.environ.get("SEED", 1))
KITS = int(os.environ.get("KITS", 2))


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def pieces_of(path, blocks):
    """For each piece, the lowest first, the blocks [first, end) that it keeps in each column (j, k)."""
    rows = rows_of(path)
    middles = sum(name.endswith("_blocks") and name.startswith("middle") for name in rows[0])
    pieces = {"lower": {}, **{f"middle-{i + 1}": {} for i in range(middles)}, "upper": {}}
    for row in rows:
        column = int(row["j"]), int(row["k"])
        lower, upper = int(row["lower_blocks"]), int(row["upper_blocks"])
        first = int(row.get("lower_first", 0))
        pieces["lower"][column] = (first, first + lower)
        first = int(row.get("upper_first", blocks - upper))
        pieces["upper"][column] = (first, first + upper)
        for i in range(1, middles + 1):
            first = int(row[f"middle_{i}_first"])
            pieces[f"middle-{i}"][column] = (first, first + int(row[f"middle_{i}_blocks"]))
    return pieces


def kept_at(piece, level):
    return {column for column, (first, end) in piece.items() if first <= level < end}


def levels_of(piece):
    """The lowest level that it keeps and the one above its highest."""
    runs = [run for run in piece.values() if run[0] < run[1]]
    return min(first for first, _ in runs), max(end for _, end in runs)


class LayersTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        for name in ("torus", "vase", "camera"):
            self.assertEqual(self.snug("sample", name, "-o", self.work / f"{name}.stl").returncode, 0)

    def snug(self, *arguments):
        return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=300, cwd=self.work)

    def make(self, *arguments, out="kit"):
        # In rows, where items have no places: cli_arrange_test.py arranges them.
        done = self.snug("make", *arguments, "--no-arrange", "-o", self.work / out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.work / out

    def refused(self, status, *arguments):
        done = self.snug("make", *arguments, "-o", self.work / "none")
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertFalse((self.work / "none").exists())
        return done.stderr

    def kit(self, numbers):
        """Items of two or three layers, or a tray of one to three, half the time in a case whose walls lean and whose
        corners are round."""
        tray = numbers.random() < 0.4
        layers = numbers.randint(1 if tray else 2, 3)
        items = []
        for layer in range(1, layers + 1):
            for _ in range(numbers.randint(1, 2)):
                own = numbers.choice(["", f",clearance={numbers.uniform(0, 3):.2f}", ",group=a", ",rotate=0x90x30"])
                items.append(f"{numbers.choice(['torus', 'vase', 'camera'])}.stl:longest={numbers.randint(40, 70)},layer={layer}{own}")
        options = ["--units=mm", numbers.choice(["--block-size=15x15x22", "--block-size=10x12x14"]),
                   "--clearance=" + ",".join(f"{numbers.uniform(0, 3):.2f}" for _ in range(6))]
        if numbers.random() < 0.5:
            options += ["--blocks=auto", "--wall=30"]
        else:
            options += ["--case=340x300x400:80", "--case-radius=30", "--case-base=320x290", "--case-top=330x300"]
        if tray:
            options.append(f"--open={numbers.choice([numbers.uniform(0.2, 1), numbers.uniform(5, 30)]):.2f}")
        if numbers.random() < 0.4:
            options.append("--notches=40x20")
        if numbers.random() < 0.4:
            options.append("--least-rib=25")
        if numbers.random() < 0.5:
            options.append("--lift=60x20")
        return items + options

    def packs(self, way, *own):
        for seed in some_of(range(SEED, SEED + KITS)):
            words = self.kit(random.Random(f"{way} {seed}"))
            with self.subTest(f"SEED={seed}: {' '.join(words)}"):
                out = self.make(*words, f"--for={way}", *own)
                report = json.loads((out / "report.json").read_text())
                pieces = pieces_of(out / "depths.csv", report["design_space"]["blocks"][0])
                self.assertEqual(len(pieces), max(item["layer"] for item in report["items"]) + 1)
                if any(word.startswith("--open") for word in words):
                    self.assertFalse(any(first < end for first, end in pieces.pop("upper").values()))
                    self.assertEqual(report["foam"]["upper_blocks"], 0)
                    self.assertFalse((out / "upper.stl").exists() or (out / "upper.ply").exists())
                yield out, report, pieces
                shutil.rmtree(out)

    def test_solids_are_the_depths(self):
        for out, report, pieces in self.packs("sponge"):
            block = report["design_space"]["block_mm"]
            counts = report["design_space"]["blocks"]
            for name, piece in pieces.items():
                vertices, triangles = read_ply(out / f"{name}.ply")[:2]
                self.assertTrue(all(each == [1, 1] for each in edge_balance(triangles)), "closed and outward")
                faces = [[vertices[i] for i in t] for t in triangles]
                blocks = sum(end - first for first, end in piece.values())
                self.assertAlmostEqual(signed_volume(faces) / (blocks * block[0] * block[1] * block[2]), 1, 6)
                level = [face for face in faces if face[0][0] == face[1][0] == face[2][0]]
                for (j, k), (first, end) in piece.items():
                    y = (j + 0.3716843 - counts[1] / 2) * block[1]
                    z = (k + 0.4139271 - counts[2] / 2) * block[2]
                    ends = sorted(face[0][0] / block[0] + counts[0] / 2 for face in level if holds(face, y, z))
                    expected = [first, end] if first < end else []
                    self.assertEqual([round(x) for x in ends], expected, (name, j, k))

    def test_sponge_maps(self):
        for out, report, pieces in self.packs("sponge"):
            _, row_mm, column_mm = report["design_space"]["block_mm"]
            ny = report["design_space"]["blocks"][1]
            for name, piece in pieces.items():
                low, high = levels_of(piece)
                stem = "lid" if name == "upper" else name
                if stem == "lower":
                    low = 0
                if stem == "lid":
                    high = report["design_space"]["blocks"][0]
                gone = {}
                for path in (out / "sponge").glob(f"{stem}-[0-9]*.svg"):
                    first, last = layers_named(Path(path.name.removeprefix(stem + "-")).with_stem("x-" + path.stem.removeprefix(stem + "-")))
                    cells = set()
                    for layer in ("pluck", "cut-off"):
                        cells |= Map(path, layer).cells(row_mm, column_mm)
                    for number in range(first, last + 1):
                        gone[number] = cells
                for number in range(1, high - low + 1):
                    level = low + number - 1 if stem == "lid" else high - number
                    kept = {(ny - 1 - j if stem == "lid" else j, k) for j, k in kept_at(piece, level)}
                    self.assertFalse(kept & gone.get(number, set()), (name, number))
                    self.assertEqual(len(kept) + len(gone.get(number, set())), len(piece), (name, number))

    def test_sheets(self):
        for out, report, pieces in self.packs("sheets"):
            index = rows_of(out / "sheets" / "index.csv")
            for name, piece in pieces.items():
                stem = "lid" if name == "upper" else name
                own = [row for row in index if row["half"] == stem]
                low, high = levels_of(piece)
                if stem != "lid":
                    levels = range(0 if stem == "lower" else low, high)
                else:
                    levels = range(report["design_space"]["blocks"][0] - 1, low - 1, -1)
                for number, level in enumerate(levels, 1):
                    cells = sum(int(row["cells"]) for row in own if int(row["sheet"]) == number)
                    self.assertEqual(cells, len(kept_at(piece, level)), (name, number))

    def test_print(self):
        for out, report, pieces in self.packs("print", "--dowel=0"):
            x, y, z = report["design_space"]["block_mm"]
            parts = rows_of(out / "print" / "parts.csv")
            for name, piece in pieces.items():
                stem = "lid" if name == "upper" else name
                names = [row["part"] for row in parts if row["part"].rsplit("-", 1)[0] == stem]
                printed = sum(signed_volume(read_stl(out / "print" / f"{part}.stl")) for part in names)
                blocks = sum(end - first for first, end in piece.values())
                self.assertAlmostEqual(printed / (blocks * x * y * z), 1, 4)

    def test_a_middle_piece_is_milled_from_both_sides(self):
        out = self.make("vase.stl:longest=60,layer=1", "torus.stl:longest=60,layer=2", "--units=mm", "--blocks=auto", "--wall=30",
                        "--preset=mill", "--for=mill", "--flute=200")
        names = sorted(path.name for path in (out / "mill").iterdir())
        self.assertEqual(names, ["lid.nc", "lower.nc", "middle-1-board.nc", "middle-1-outside.nc", "middle-1.nc"])

    def test_what_cannot_be_made_of_layers_is_said(self):
        two = ["vase.stl:longest=60,layer=1", "torus.stl:longest=60,layer=2", "--units=mm", "--blocks=auto"]
        for way in ("bricks", "mould"):
            self.assertIn("several layers", self.refused(1, *two, f"--for={way}"))
        self.assertIn("layer 2 of 3", self.refused(1, "vase.stl:layer=1", "torus.stl:layer=3", "--units=mm"))
        self.assertIn("layer", self.refused(1, "vase.stl:layer=0", "--units=mm"))
        self.assertIn("layer", self.refused(1, "vase.stl:layer=21", "--units=mm"))
        self.assertIn("2 layers", self.refused(1, *two, "--parting=3"))
        self.assertIn("rise", self.refused(1, *two, "--parting=5,5"))
        self.assertIn("--parting", self.refused(1, *two, "--parting=a,b"))

    def test_layers_stand_where_they_are_told_to_and_again(self):
        words = ["vase.stl:longest=60,count=2,layer=1", "torus.stl:longest=60,layer=2", "--units=mm", "--blocks=auto",
                 "--parting=8,14", "--for=sponge"]
        out = self.make(*words)
        report = json.loads((out / "report.json").read_text())
        self.assertEqual(report["foam"]["parting_level"], [8, 14])
        self.assertEqual([item["layer"] for item in report["items"]], [1, 1, 2])
        self.assertEqual(len(report["foam"]["middle"]), 1)
        self.assertLess(report["items"][0]["box_mm"][1][0], report["items"][2]["box_mm"][0][0], "one above the other")
        shutil.copy(out / "project.snug.json", self.work)
        again = self.make("project.snug.json", out="again")
        for path in sorted(out.rglob("*")):
            if path.is_file() and path.name not in ("report.json", ".snug-files") and path.suffix != ".pdf":
                self.assertEqual(path.read_bytes(), (again / path.relative_to(out)).read_bytes(), path)
        # Fewer layers into the same folder leave no middle piece of before.
        self.make("vase.stl:longest=60", "--units=mm", "--blocks=auto", "--for=sponge")
        self.assertEqual(list(out.rglob("middle*")), [])

    def test_items_of_one_layer_above_another_need_foam_between(self):
        def near(gap):
            out = self.make("vase.stl:longest=60,name=A,layer=1,move=-40x0x0", f"vase.stl:longest=60,name=B,layer=2,move={gap - 40}x0x0",
                            "--units=mm", "--blocks=auto", "--wall=30")
            return [each for each in json.loads((out / "report.json").read_text())["findings"] if each["code"] == "items_near"]
        found = near(40)
        self.assertEqual([each["severity"] for each in found], ["danger"])
        self.assertIn("between A and B in a layer above it", found[0]["message"])
        up = float(found[0]["message"].split("move B ")[1].split()[0])
        self.assertEqual(near(40 + up), [])

    def test_an_item_that_gets_no_notches_is_named(self):
        # With more room for the fingers than the case has.
        out = self.make("vase.stl:longest=60,name=deep,layer=1", "torus.stl:longest=60,name=A,count=2,layer=2", "--units=mm",
                        "--case=400x300x400", "--notches=40x25x300")
        told = [each["message"] for each in json.loads((out / "report.json").read_text())["findings"]
                if each["code"] == "no_notches"]
        self.assertEqual([each.split(":")[0] for each in told], ["deep", "A (2)", "A (3)"])

    def test_clouds_lie_in_layers(self):
        numbers = random.Random(SEED)
        points = [(numbers.uniform(-1, 1), numbers.uniform(-1, 1), numbers.uniform(-1, 1)) for _ in range(9000)]
        ball = [[30 * c / max(sum(x * x for x in point) ** 0.5, 1e-9) for c in point] for point in points]
        text = "\n".join("{:.4f} {:.4f} {:.4f}".format(*point) for point in ball)
        (self.work / "ball.ply").write_text("ply\nformat ascii 1.0\nelement vertex 9000\nproperty float x\nproperty float y\n"
                                            f"property float z\nend_header\n{text}\n")
        out = self.make("ball.ply:layer=1", "vase.stl:longest=60,layer=2", "--units=mm", "--blocks=auto", "--for=sponge")
        pieces = pieces_of(out / "depths.csv", json.loads((out / "report.json").read_text())["design_space"]["blocks"][0])
        self.assertTrue(all(any(first < end for first, end in piece.values()) for piece in pieces.values()))

    def test_layers_in_japanese(self):
        out = self.make("vase.stl:longest=60,layer=1", "torus.stl:longest=60,layer=2", "--units=mm", "--blocks=auto",
                        "--for=sponge", "--language=ja")
        svg = (out / "preview.svg").read_text()
        self.assertIn("中間", svg)
        self.assertNotIn("MIDDLE foam", svg)


def holds(face, y, z):
    """Whether a triangle that lies level holds a point that is on none of its edges."""
    sides = []
    for a, b in zip(face, face[1:] + face[:1]):
        sides.append((b[1] - a[1]) * (z - a[2]) - (b[2] - a[2]) * (y - a[1]) > 0)
    return all(sides) or not any(sides)


if __name__ == "__main__":
    unittest.main()
