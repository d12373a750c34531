"""Trays: foam without a lid, as the command line makes it of every way of working.

Usage: cli_trays_test.py SNUG [unittest arguments]
"""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_solids import read_stl

SNUG = Path(sys.argv.pop(1)).resolve()


class TraysTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        for name in ("torus", "vase", "camera"):
            subprocess.run([SNUG, "sample", name, "-o", self.work / f"{name}.stl"], check=True, capture_output=True)

    def snug(self, *arguments):
        return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=300, cwd=self.work)

    def make(self, *arguments, out="tray"):
        # In rows, where items have no places: cli_arrange_test.py arranges them.
        done = self.snug("make", *arguments, "--no-arrange", "-o", self.work / out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.work / out, json.loads((self.work / out / "report.json").read_text()), done.stdout

    def surface(self, report):
        space = report["design_space"]
        return (report["foam"]["parting_level"] - space["blocks"][0] / 2) * space["block_mm"][0]

    def test_items_are_sunk_by_their_share(self):
        out, report, said = self.make("vase.stl:longest=80,upright=z", "torus.stl:longest=60", "camera.stl:longest=70", "--units=mm",
                                      "--blocks=auto", "--block-size=1x10x10", "--open=0.5")
        surface = self.surface(report)
        sunk = []
        for item in report["items"]:
            (low, _, _), (high, _, _) = item["box_mm"]
            sunk.append((surface - low) / (high - low))
        for share, item in zip(sunk, report["items"]):
            low, high = item["box_mm"][0][0], item["box_mm"][1][0]
            self.assertGreaterEqual(share, 0.5 - 1e-6)
            self.assertLess(share, 0.5 + 1 / (high - low))
        rows = list(csv.DictReader((out / "depths.csv").read_text().splitlines()))
        self.assertTrue(all(int(row["upper_blocks"]) == 0 for row in rows))
        self.assertEqual(max(int(row["lower_blocks"]) for row in rows), report["foam"]["parting_level"])
        self.assertFalse((out / "upper.stl").exists())
        # As a word: the folder in it has a name of chance letters.
        self.assertNotRegex(said, r"\blid\b")
        self.assertEqual([each for each in report["findings"] if each["severity"] == "danger"], [])
        # 25.4 mm below and beside, as makers of trays do.
        self.assertGreaterEqual(min(report["wall_mm"][:1] + report["wall_mm"][2:]), 25.4)

    def test_a_depth_in_mm_is_the_same_for_all(self):
        _, report, _ = self.make("vase.stl:longest=80,upright=z", "torus.stl:longest=60", "--units=mm", "--blocks=auto",
                                 "--block-size=0.5x10x10", "--open=12")
        for item in report["items"]:
            self.assertAlmostEqual(self.surface(report) - item["box_mm"][0][0], 12.25, delta=0.2501)

    def test_items_stand_on_the_floor_of_a_drawer(self):
        _, report, _ = self.make("vase.stl:longest=60", "torus.stl:longest=60", "--units=mm", "--case=400x300x120", "--block-size=5x5x5",
                                 "--open=0.6", "--wall=20")
        self.assertAlmostEqual(report["wall_mm"][0], 20, delta=5)
        self.assertLess(self.surface(report), 60)

    def test_each_item_has_notches_of_its_own(self):
        _, report, _ = self.make("camera.stl", "vase.stl:longest=90,count=2,upright=z", "--units=mm", "--blocks=auto", "--open=0.6",
                                 "--block-size=5x5x5", "--notches=40x25x25")
        self.assertEqual([each["item"] for each in report["notches"]], [1, 1, 2, 2, 3, 3])
        for item in report["items"]:
            low, high = item["box_mm"]
            for notch in report["notches"]:
                if notch["item"] != item["number"]:
                    continue
                along, axis = (2, 1) if notch["side"] in ("back", "front") else (1, 2)
                self.assertTrue(low[along] - 25 < notch["at_mm"] < high[along] + 25, (item, notch))
                self.assertGreaterEqual(notch["size_mm"][axis], 25)

    def test_a_place_of_its_own_leaves_an_item_as_deep_as_the_others(self):
        words = ["vase.stl:longest=60,move=0x-60x0", "torus.stl:longest=60,move=0x60x0", "--units=mm", "--case=400x300x120",
                 "--block-size=1x5x5", "--open=0.5", "--wall=20"]
        _, report, _ = self.make(*words)
        for item in report["items"]:
            low, high = item["box_mm"][0][0], item["box_mm"][1][0]
            self.assertAlmostEqual((self.surface(report) - low) / (high - low), 0.5, delta=1.01 / (high - low))
        words[0] = "vase.stl:longest=60,move=7x-60x0"
        _, raised, _ = self.make(*words)
        self.assertEqual(raised["foam"]["parting_level"], report["foam"]["parting_level"])
        self.assertAlmostEqual(raised["items"][0]["box_mm"][0][0] - report["items"][0]["box_mm"][0][0], 7)
        self.assertEqual(raised["items"][1]["box_mm"], report["items"][1]["box_mm"])

    def test_every_way_makes_it(self):
        presets = {"bricks": ["--preset=lego-brick"], "mill": ["--preset=mill", "--flute=200"], "mould": ["--preset=cast"]}
        for way in ("sponge", "sheets", "print", "mill", "mould", "bricks"):
            with self.subTest(way):
                out, report, _ = self.make("torus.stl:longest=60", "--units=mm", "--blocks=auto", "--wall=16", "--open=0.5",
                                           f"--for={way}", *presets.get(way, []), out=way)
                names = [str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()]
                self.assertEqual([name for name in names if "lid" in name], [])
                self.assertTrue(any(name.startswith(way) for name in names), names)
                self.assertEqual(report["foam"]["upper_blocks"], 0)

    def test_it_is_made_again_from_its_project_and_closed_again(self):
        words = ["vase.stl:longest=60", "torus.stl:longest=50", "--units=mm", "--blocks=auto", "--open=0.6", "--for=sponge"]
        out, _, _ = self.make(*words)
        shutil.copy(out / "project.snug.json", self.work)
        again, _, _ = self.make("project.snug.json", out="again")
        for path in sorted(out.rglob("*")):
            if path.is_file() and path.name not in ("report.json", ".snug-files") and path.suffix != ".pdf":
                self.assertEqual(path.read_bytes(), (again / path.relative_to(out)).read_bytes(), path)
        closed, report, _ = self.make(*(word for word in words if not word.startswith("--open")))
        self.assertTrue((closed / "upper.stl").exists())
        self.assertGreater(report["foam"]["upper_blocks"], 0)
        self.make(*words)
        self.assertFalse((out / "upper.stl").exists(), "nothing of the lid is left")

    def test_a_tray_too_shallow_for_a_pocket_is_a_danger(self):
        _, report, _ = self.make("torus.stl:longest=60", "--units=mm", "--case=300x300x100", "--block-size=10x10x10", "--wall=10",
                                 "--open=0.001", "--parting=1")
        self.assertIn(("danger", "no_pocket"), [(each["severity"], each["code"]) for each in report["findings"]])

    def test_what_is_sunk_less_than_asked_is_said(self):
        def told(*words):
            _, report, _ = self.make("vase.stl:longest=120,upright=z", "--units=mm", "--block-size=15x10x10", "--open=0.9", *words)
            return report["items"][0]["sunk_mm"], [each["code"] for each in report["findings"] if each["severity"] == "warning"]
        self.assertGreaterEqual(told("--blocks=auto")[0], 108)
        self.assertNotIn("sunk_less", told("--blocks=auto")[1])
        self.assertIn("sunk_less", told("--blocks=4x16x16")[1])
        self.assertIn("sunk_less", told("--blocks=auto", "--parting=4")[1])

    def test_it_is_made_of_a_cloud_and_of_a_stream(self):
        whole, _, _ = self.make("vase.stl:longest=90", "--units=mm", "--blocks=auto", "--open=0.6", "--notches=40x25", "--lift=60x20", out="whole")
        streamed, _, _ = self.make("vase.stl:longest=90", "--units=mm", "--blocks=auto", "--open=0.6", "--notches=40x25", "--lift=60x20", "--stream",
                                   out="streamed")
        self.assertEqual((whole / "depths.csv").read_bytes(), (streamed / "depths.csv").read_bytes())
        points = {tuple(map(str, vertex)) for face in read_stl(self.work / "vase.stl") for vertex in face}
        (self.work / "points.xyz").write_text("\n".join(" ".join(point) for point in sorted(points)))
        cloud, report, _ = self.make("points.xyz", "--units=mm", "--longest=90", "--blocks=auto", "--open=0.6", "--notches=40x25", out="cloud")
        self.assertEqual(report["foam"]["upper_blocks"], 0)
        self.assertGreater(report["items"][0]["sunk_mm"], 0)

    def test_items_may_stand_out_of_the_foam_up_to_the_top_of_the_case(self):
        words = ["camera.stl", "--units=mm", "--preset=slit-15", "--blocks=auto", "--open=25", "--wall=15"]
        _, report, _ = self.make(*words, "--case=300x200x110")
        self.assertGreaterEqual(report["wall_mm"][0], 15)
        done = self.snug("make", *words, "--case=300x200x90", "-o", self.work / "none")
        self.assertEqual(done.returncode, 3)
        self.assertIn("--wall", done.stderr)

    def test_what_makes_no_sense_is_said(self):
        for wrong in ("0", "-1", "nan", "deep"):
            done = self.snug("make", "torus.stl", "--units=mm", f"--open={wrong}", "-o", self.work / "none")
            self.assertEqual(done.returncode, 1, wrong)
            self.assertTrue("--open" in done.stderr or "how deep items are sunk" in done.stderr, done.stderr)
        done = self.snug("make", "torus.stl", "--units=mm", "--open=0.5", "--optimize", "-o", self.work / "none")
        self.assertEqual(done.returncode, 1)
        self.assertIn("this is a tray", done.stderr)
        self.assertFalse((self.work / "none").exists())


if __name__ == "__main__":
    unittest.main()
