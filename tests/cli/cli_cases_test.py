"""Cases and walls as a person or a script meets them.

Usage: cli_cases_test.py SNUG [unittest arguments]
"""

import csv
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from some_of import some_of

SNUG = Path(sys.argv.pop(1)).resolve()


class CasesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        cls.camera = cls.shared / "camera.stl"
        subprocess.run([SNUG, "sample", "camera", "-o", cls.camera], check=True, capture_output=True)

    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        (self.work / "snug").mkdir()
        self.own = self.work / "snug" / "cases.csv"
        self.out = self.work / "out"

    def snug(self, *arguments):
        return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                              env={**os.environ, "XDG_CONFIG_HOME": str(self.work)})

    def make(self, *arguments):
        return self.snug("make", self.camera, *arguments, "-o", self.out)

    def report(self):
        return json.loads((self.out / "report.json").read_text())

    def assertRefused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists(), "nothing may be written")

    def test_a_hard_case_and_a_carton_are_filled_exactly(self):
        for case, inside in (("425x284x155:45", (425, 284, 155)), ("cube-10in", (254, 254, 254))):
            for preset in some_of(("slit-10", "cube-25", "sheet-10", "print"), 2):
                with self.subTest(case=case, preset=preset):
                    done = self.make("--case", case, "--preset", preset, "--formats", "stl", "--wall", "20")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    report = self.report()
                    fitted, space = report["case"], report["design_space"]
                    volume = 1
                    for blocks, size in zip(space["blocks"], space["block_mm"]):
                        volume *= blocks * size
                    for filler in fitted["fillers"]:
                        length, width, height = filler["size_mm"]
                        volume += length * width * height
                    free = 1
                    for side in inside:
                        free *= side - 6
                    self.assertAlmostEqual(volume / free, 1, 4)
                    for blocks, size, rest, whole in zip(space["blocks"][::-1], space["block_mm"][::-1],
                                                         fitted["rest_mm"], inside):
                        self.assertAlmostEqual(blocks * size + rest + 6, whole, 3)
                    if fitted["lid_mm"]:
                        self.assertAlmostEqual(fitted["parting_mm"], 155 - 45 + fitted["lid_off_mm"], 4)
                        self.assertLessEqual(abs(fitted["lid_off_mm"]), space["block_mm"][0] / 2)
                    shutil.rmtree(self.out)

    def test_the_project_makes_the_same_case_again(self):
        self.assertEqual(self.make("--case", "425x284x155:45", "--case-radius", "40", "--case-base", "400x260",
                                   "--wall", "10,20,15,15,10,5", "--formats", "stl").returncode, 0)
        shutil.copy(self.camera, self.out)
        again = self.work / "again"
        self.assertEqual(self.snug("make", self.out / "project.snug.json", "-o", again).returncode, 0)
        for name in ("lower.stl", "upper.stl", "depths.csv", "project.snug.json", "preview.svg"):
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)
        self.assertGreater(self.report()["case"]["shortened_blocks"], 0)
        design = json.loads((self.out / "project.snug.json").read_text())["design"]
        self.assertEqual(design["space"]["wall_mm"], [10, 20, 15, 15, 10, 5])

    def test_each_side_keeps_its_own_wall(self):
        self.assertEqual(self.make("--blocks", "auto", "--wall", "30,60,20,40,50,10").returncode, 0)
        for wall, wanted, block in zip(self.report()["wall_mm"], (30, 60, 20, 40, 50, 10), (15, 15, 15, 15, 22, 22)):
            self.assertGreaterEqual(wall, wanted)
            self.assertLess(wall, wanted + block)

    def test_bad_cases_are_refused_with_a_sentence(self):
        self.assertRefused(self.make("--case", "425x284"), 1, "425x284x155:45")
        self.assertRefused(self.make("--case", "no-such-case"), 1, "no-such-case", "snug cases")
        self.assertRefused(self.make("--case", "425x284x155:200"), 1, "lid")
        self.assertRefused(self.make("--case", "5x5x5"), 1, "play")
        self.assertRefused(self.make("--case", "425x284x155", "--case-radius", "150"), 1, "radius")
        self.assertRefused(self.make("--case", "425x284x155", "--case-base", "500x284"), 1, "widest")
        self.assertRefused(self.make("--case", "425x284x155", "--blocks", "10x10x10"), 1, "exclude")
        self.assertRefused(self.make("--case-play", "3"), 1, "--case")
        self.assertRefused(self.make("--wall", "1,2"), 1, "--wall")
        self.assertRefused(self.make("--wall", "-5"), 1, "wall")
        self.assertRefused(self.make("--case", "60x60x60"), 3, "Lacking", "A case would do from")

    def test_walls_that_the_case_does_not_leave_are_a_warning(self):
        self.assertEqual(self.make("--case", "425x284x155:45", "--wall", "400").returncode, 0)
        codes = [finding["code"] for finding in self.report()["findings"]]
        self.assertIn("wall_below_wanted", codes)

    def test_the_list_is_a_table_json_or_csv(self):
        self.assertIn("1500", self.snug("cases").stdout)
        listed = json.loads(self.snug("cases", "--json").stdout)
        known = {case["name"]: case for case in listed}
        self.assertEqual(known["1500"]["inside_mm"], [425, 284, 155])
        rows = list(csv.DictReader(io.StringIO(self.snug("cases", "--csv").stdout)))
        self.assertEqual([row["name"] for row in rows], [case["name"] for case in listed])

    def test_own_cases_are_used_and_a_bad_line_is_named(self):
        self.own.write_text("name,length_mm,width_mm,height_mm,lid_mm,price\n"
                            "ours,425,284,155,45,80\n"
                            "broken,425,x,155,,\n"
                            "\"also, ours\",300,200,150,,5\n")
        done = self.snug("cases")
        self.assertEqual(done.returncode, 0)
        self.assertIn("ours", done.stdout)
        self.assertIn("also, ours", done.stdout)
        self.assertIn("line 3: width_mm", done.stderr)
        self.assertEqual(self.make("--case", "ours").returncode, 0)
        self.assertEqual(self.report()["case"]["lid_mm"], 45)

    def test_those_that_fit_do_fit(self):
        done = self.snug("cases", "--for", self.camera, "--wall", "25", "--mass", "1.2", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        fitting = json.loads(done.stdout)["fitting"]
        self.assertGreater(len(fitting), 3)
        fills = [case["fill"] for case in fitting]
        self.assertEqual(fills, sorted(fills, reverse=True))
        for case in fitting[:3] + [case for case in fitting if any(case["rotation_deg"])][:4]:
            rotation = ",".join(map(str, case["rotation_deg"]))
            done = self.make("--case", case["name"], "--rotate=" + rotation, "--wall", "25")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreaterEqual(min(self.report()["wall_mm"]), 25, case["name"])

    def test_where_nothing_fits_it_says_what_would(self):
        done = self.snug("cases", "--for", self.camera, "--wall", "300")
        self.assertEqual(done.returncode, 3)
        for word in ("A case would do from", "Nearest is", "lacks"):
            self.assertIn(word, done.stderr)
        self.assertEqual(self.snug("cases", "--mass", "3").returncode, 1)


if __name__ == "__main__":
    unittest.main()
