"""Several items arranged from the command line: all of them lie there, far enough apart, in less than a row takes.

Usage: cli_arrange_test.py SNUG [unittest arguments]
"""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()


class ArrangeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = Path(tempfile.mkdtemp())
        for name in ("torus", "vase", "camera"):
            subprocess.run([SNUG, "sample", name, "-o", cls.work / f"{name}.stl"], check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.work)

    def snug(self, *arguments):
        return subprocess.run([SNUG, "make", *map(str, arguments), "--quiet"], capture_output=True, text=True,
                              timeout=300, cwd=self.work)

    def report(self, *arguments, out="kit"):
        done = self.snug(*arguments, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.work / out / "report.json").read_text())

    def refused(self, status, *arguments):
        done = self.snug(*arguments, "-o", "none")
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertFalse((self.work / "none").exists())
        return done.stderr

    def volume(self, report):
        x, y, z = report["design_space"]["blocks"]
        a, b, c = report["design_space"]["block_mm"]
        return x * y * z * a * b * c

    def expect_sound(self, report):
        self.assertNotIn("items_near", [finding["code"] for finding in report["findings"]])
        self.assertAlmostEqual(report["arrangement"]["volume_mm3"], self.volume(report), delta=1)
        self.assertIn("arrangement", report["timing_ms"])

    def test_in_a_case_with_room_foam_stands_on_all_sides_of_each_layer(self):
        kit = ("vase.stl:longest=90,count=6", "--case", "600x400x400", "--preset", "slit-12.7")
        for layers in (1, 2):
            report = self.report(*kit, "--layers", layers, out=f"room-{layers}")
            self.expect_sound(report)
            walls = report["wall_mm"]
            self.assertGreaterEqual(min(walls), 50)
            for low, high, block in zip(walls[::2], walls[1::2], report["design_space"]["block_mm"]):
                self.assertLessEqual(abs(low - high), 2 * block)
            self.assertFalse(any(finding["severity"] == "danger" for finding in report["findings"]))

    def test_without_places_they_are_arranged_and_the_project_keeps_it(self):
        kit = ("vase.stl:longest=150", "torus.stl:longest=90,count=3", "--blocks", "auto")
        one = self.report(*kit, "--threads", 1, out="one")
        self.report(*kit, "--threads", 2, out="two")
        self.expect_sound(one)
        self.assertGreaterEqual(min(one["wall_mm"]), 50)
        self.assertLessEqual(one["arrangement"]["lower_bound_mm3"], one["arrangement"]["volume_mm3"])
        for file in ("project.snug.json", "lower.stl", "depths.csv"):
            self.assertEqual((self.work / "one" / file).read_bytes(), (self.work / "two" / file).read_bytes(), file)
        shutil.copy(self.work / "one" / "project.snug.json", self.work)
        again = self.report("project.snug.json", out="again")
        self.assertNotIn("arrangement", again)
        self.assertEqual(again["foam"], one["foam"])
        row = self.report(*kit, "--no-arrange", out="row")
        self.assertNotIn("arrangement", row)
        self.assertLess(self.volume(one), self.volume(row))
        shutil.copy(self.work / "row" / "project.snug.json", self.work)
        self.assertEqual(self.report("project.snug.json", out="again")["foam"], row["foam"])

    def test_locked_items_stay_and_layers_are_spread(self):
        locked = self.report("vase.stl:move=0x40x0,lock=yes", "camera.stl", "--blocks", "auto", "--search-seconds", 0.2)
        self.expect_sound(locked)
        self.assertEqual(locked["items"][0]["placement"]["offset_mm"], [0, 40, 0])
        layers = self.report("torus.stl:count=4", "--blocks", "auto", "--layers", 2, "--search-seconds", 0.2)
        self.expect_sound(layers)
        self.assertEqual({item["layer"] for item in layers["items"]}, {1, 2})

    def test_a_locked_item_lets_the_others_keep_their_walls(self):
        report = self.report("camera.stl:lock=yes,move=0x0x0", "vase.stl:longest=90,count=2", "--blocks", "30x30x30",
                             "--search-seconds", 1)
        self.assertGreaterEqual(min(report["wall_mm"]), 12.7)
        report = self.report("camera.stl:lock=yes,move=0x0x0", "vase.stl:longest=90", "--blocks", "auto", out="open")
        self.assertGreaterEqual(min(report["wall_mm"]), 50)

    def test_a_tray_goes_into_a_known_case_that_is_high_enough(self):
        report = self.report("camera.stl", "vase.stl:longest=90", "--known-case", "--open", 0.6, "--search-seconds", 0.2)
        self.assertEqual([f for f in report["findings"] if f["severity"] == "danger"], [])

    def test_room_for_hands_is_left_between_items(self):
        alone = self.report("camera.stl:count=2", "--blocks", "auto", "--search-seconds", 0.5)
        hands = self.report("camera.stl:count=2", "--blocks", "auto", "--notches", "60x30", "--search-seconds", 0.5, out="hands")
        self.assertGreater(hands["arrangement"]["volume_mm3"], alone["arrangement"]["volume_mm3"])
        # Rather without it than against the case.
        tight = self.report("camera.stl:count=2", "--blocks", "14x10x17", "--notches", "60x30", out="tight")
        self.assertGreaterEqual(min(tight["wall_mm"]), 12.7)

    def test_what_contradicts_itself_is_refused(self):
        for words, sentence in [(["camera.stl", "--known-case"], "snug cases"),
                                (["camera.stl:count=2", "--known-case", "--no-arrange"], "--no-arrange"),
                                (["camera.stl:count=2", "--known-case", "--case", "500x400x300:80"], "--case"),
                                (["camera.stl:count=2,lock=maybe"], "lock")]:
            self.assertIn(sentence, self.refused(1, *words))

    def test_the_smallest_known_case_that_holds_them_is_found(self):
        report = self.report("camera.stl:count=2", "--known-case", "--wall", 20, "--search-seconds", 0.2)
        self.expect_sound(report)
        self.assertTrue(report["case"]["name"])
        usual = self.report("camera.stl:count=2", "--known-case", "--search-seconds", 0.2, out="usual")
        self.expect_sound(usual)
        self.assertGreaterEqual(min(usual["wall_mm"]), 50)

    def test_a_space_too_small_for_walls_is_not_searched_for_them_all_the_time(self):
        report = self.report("camera.stl:longest=60,count=4", "--case", "150x130x90", "--search-seconds", 3, "--block-size", "5x5x5")
        self.expect_sound(report)

    def test_what_cannot_be_is_said(self):
        self.assertIn("of them do, without", self.refused(3, "torus.stl:count=9", "--blocks", "20x12x10", "--search-seconds", 0.2))
        self.assertIn("both locked", self.refused(1, "vase.stl:move=0x0x0,lock", "camera.stl:move=0x5x0,lock",
                                                  "torus.stl", "--blocks", "auto"))
        self.assertIn("no place to stay", self.refused(1, "vase.stl:lock=yes", "camera.stl", "--blocks", "auto"))
        self.assertIn("no layer may be empty", self.refused(1, "vase.stl", "camera.stl", "--layers", 3))


if __name__ == "__main__":
    unittest.main()
