"""What an item meets in a drop, from the command line: foams, rules, fragility, walls that protect.

Usage: cli_drops_test.py SNUG [unittest arguments]
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
DROP = ["--preset", "sheet-10", "--blocks", "auto", "--foam", "ld33"]


def snug(*arguments, **options):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


class Drops(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.work = Path(cls.folder.name)
        for sample in ("camera", "vase", "figurine"):
            assert snug("sample", sample, "-o", cls.work / f"{sample}.ply").returncode == 0

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def report(self, *arguments, status=0):
        done = snug("make", *arguments, "-o", self.work / "out", "--json")
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout) if status == 0 else done.stderr

    def test_the_report_names_every_input_and_a_range(self):
        report = self.report(self.work / "camera.ply", *DROP, "--mass", "0.9", "--drop-height", "ista-2a", "--wall", "90",
                             "--fragility", "delicate")
        told = report["protection"]
        self.assertEqual((told["drop_mm"], told["rule"], told["mass_kg"]), (970, "ista-2a", 0.9))
        self.assertGreater(told["gross_kg"], 0.9)
        self.assertEqual((told["foam"]["name"], told["foam"]["status"]), ("ld33", "maker's sheet"))
        self.assertEqual([face["face"] for face in told["faces"]], ["floor", "roof", "back", "front", "left", "right"])
        for face in told["faces"]:
            if face["g"] is None:
                self.assertIn(face["why_none"], ("bottoms", "thin"))
                continue
            low, high = face["g"]
            self.assertLess(0, low)
            self.assertTrue(high is None or high >= 1.2 * face["g_model"] - 1e-3)
            self.assertGreater(face["sink_mm"], 0)
        self.assertEqual(told["fragility_g"], 40)
        self.assertEqual(told["centre"], "assumed uniform")
        self.assertIn("the object's own resonance", told["not_computed"])
        self.assertEqual(report["bearing"]["drops"], "see protection")

    def test_a_search_that_weighs_shocks(self):
        ask = ["--block-size", "10x15x15", "--blocks", "24x16x20", "--foam", "ld33", "--mass", "1.2", "--fragility", "60",
               "--move", "30,-50,40"]
        shock = ["--objective", "shock"]
        drop = ["--drop-height", "200"]
        before, after = (self.report(self.work / "camera.ply", *ask, *drop, *search)
                         for search in ([], [*shock, "--optimize", "--turns", "none", "--search-seconds", "2"]))

        def worst(report):
            return max(face["g"][1] if face["g"] else 1e6 for face in report["protection"]["faces"])

        self.assertLess(worst(after), worst(before))
        self.assertEqual(after["placement"]["rotation_deg"], before["placement"]["rotation_deg"])
        said = self.report(self.work / "camera.ply", *ask, *shock, "--optimize", status=1)
        self.assertIn("searches that weigh shocks need the drop (--drop-height)", said)
        self.assertIn("--optimize", self.report(self.work / "camera.ply", *ask, *drop, *shock, status=1))
        items = [f"{self.work / 'camera.ply'}:count=2,mass=0.9", f"{self.work / 'figurine.ply'}:mass=0.4"]
        kit = ["--block-size", "10x15x15", "--blocks", "auto", "--foam", "ld33", *drop, "--objective", "shock"]
        arranged = self.report(*items, *kit, "--fragility", "60", "--arrange", "--search-seconds", "2")
        self.assertEqual(len(arranged["items"]), 3)
        self.assertIn("--fragility", self.report(*items, *kit, "--arrange", status=1))

    def test_walls_that_protect_do(self):
        report = self.report(self.work / "camera.ply", *DROP, "--mass", "0.9", "--drop-height", "300", "--fragility", "110",
                             "--wall", "protect")
        for face in report["protection"]["faces"]:
            self.assertLessEqual(face["g"][1], 110)
        codes = {finding["code"] for finding in report["findings"]}
        self.assertFalse(codes & {"shock", "bottoms", "thin_pads"})
        # The walls stand in the project, which makes the same again.
        again = self.report(self.work / "out" / "project.snug.json", "--object", self.work / "camera.ply")
        self.assertEqual(again["protection"], report["protection"])
        # A little less of any of them would not do for all.
        walls = json.loads((self.work / "out" / "project.snug.json").read_text())["design"]["space"]["wall_mm"]
        self.assertEqual(len(walls), 6)
        self.assertTrue(all(wall % 5 == 0 and wall >= 25 for wall in walls))

    def test_walls_of_several_items_are_chosen_and_the_foam_between_them(self):
        items = [self.work / "vase.ply", f"{self.work / 'camera.ply'}:mass=0.9"]
        ask = ["--mass", "1.5", *DROP, "--drop-height", "200", "--fragility", "300"]
        near = self.report(*items, *ask)
        self.assertIn("items_meet", {finding["code"] for finding in near["findings"]})
        for arrange in ([], ["--arrange", "--search-seconds", "2"]):
            report = self.report(*items, *ask, *arrange, "--wall", "protect")
            codes = [finding["code"] for finding in report["findings"]]
            self.assertIn("moved_apart", codes)
            self.assertFalse({"items_meet", "near_items", "shock", "bottoms", "thin_pads"} & set(codes))
            for item in report["protection"]["items"]:
                for face in item["faces"]:
                    self.assertLessEqual(face["g"][1], 300)
        # Items that are locked stay where they are.
        locked = [f"{self.work / 'vase.ply'}:move=0x0x-60,lock=yes", f"{self.work / 'camera.ply'}:mass=0.9,move=0x0x60"]
        self.assertIn("--between", self.report(*locked, *ask, "--wall", "protect", status=3))

    def test_what_is_printed_or_built_does_not_bear_the_figures_of_a_foam_in_silence(self):
        for work, rigid in (("print", True), ("bricks", True), ("sheets", False)):
            report = self.report(self.work / "vase.ply", "--for", work, "--blocks", "auto", "--foam", "ld33", "--mass", "1.2",
                                 "--drop-height", "400", "--longest", "90")
            self.assertEqual("foam_of_rigid" in {finding["code"] for finding in report["findings"]}, rigid, work)

    def test_a_stand_in_and_an_unverified_rule_are_said_and_a_foam_alone_asks_for_no_drop(self):
        vase = self.work / "vase.ply"
        told = self.report(vase, *DROP, "--mass", "1.2", "--drop-height", "d4169-2", "--wall", "80", "--stream")
        self.assertIn("shock_of_stand_in", {finding["code"] for finding in told["findings"]})
        self.assertFalse(told["protection"]["rule_verified"])
        whole = self.report(vase, *DROP, "--mass", "1.2", "--drop-height", "d4169-2", "--wall", "80")
        self.assertNotIn("shock_of_stand_in", {finding["code"] for finding in whole["findings"]})
        quiet = self.report(vase, "--blocks", "auto", "--foam", "ethafoam-220", "--mass", "1.2")
        self.assertNotIn("no_shock", {finding["code"] for finding in quiet["findings"]})
        self.assertEqual(quiet["bearing"]["creep_kpa"], 17.2)

    def test_two_layers_of_items_meet_each_other(self):
        items = [f"{self.work / 'figurine.ply'}:layer={layer},name={name}" for layer, name in ((1, "low"), (2, "high"))]
        report = self.report(*items, *DROP, "--mass", "0.2", "--drop-height", "300", "--between", "30", "--wall", "60")
        told = report["protection"]
        self.assertEqual(len(told["items"]), 2)
        self.assertEqual([face["face"] for face in told["faces"]], ["floor", "roof", "back", "front", "left", "right"])
        self.assertTrue(all(face["item"] in (1, 2) for face in told["faces"]))

    def test_a_foam_of_ones_own_and_its_points(self):
        config = self.work / "config" / "snug"
        config.mkdir(parents=True, exist_ok=True)
        environment = {"XDG_CONFIG_HOME": str(config.parent), "PATH": "/usr/bin:/bin"}
        points = [[2.8, 47, 50, 610], [4.1, 41, 50, 610], [5.5, 39, 50, 610], [6.9, 39, 50, 610], [8.3, 41, 50, 610]]
        (config / "foams.json").write_text(json.dumps([{"name": "tested", "points": points}]))
        self.assertIn("tested", snug("foams", env=environment).stdout)
        listed = {foam["name"]: foam for foam in json.loads(snug("foams", "--json", env=environment).stdout)}
        self.assertEqual((listed["tested"]["impacts"], listed["tested"]["thickness_mm"]), (1, [50, 50]))
        done = snug("make", self.work / "vase.ply", "--foam", "tested", "--mass", "1", "--drop-height", "400", "--wall", "80",
                    "--blocks", "auto", "-o", self.work / "own", "--json", env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        # The project carries the foam where no list has it.
        again = snug("make", self.work / "own" / "project.snug.json", "--object", self.work / "vase.ply", "-o", self.work / "own2",
                     "--json")
        self.assertEqual(json.loads(again.stdout)["protection"], json.loads(done.stdout)["protection"])
        for wrong in ('[{"name": "x", "curve": [[0.5, 10]]}]', '[{"name": "x", "curve": [[0.5, 10], [0.6, 5]]}]', '{}', "[{]",
                      '[{"name": "x", "points": [[1, 50, 50, 600]]}]'):
            (config / "foams.json").write_text(wrong)
            done = snug("foams", env=environment)
            self.assertEqual(done.returncode, 1, wrong)
            self.assertIn("foams.json", done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_bad_input_is_a_sentence(self):
        camera = self.work / "camera.ply"
        for arguments in (["--mass", "0"], ["--drop-height", "0"], ["--drop-height", "50000"], ["--drop-height", "tall"],
                          ["--foam", "cheese"], ["--fragility", "glassy"], ["--open", "0.5", "--drop-height", "500"],
                          ["--wall", "protect"], ["--foam", "ld33", "--mass", "1", "--drop-height", "500", "--fragility", "40",
                                                  "--wall", "protect", "--blocks", "20x20x20"]):
            message = self.report(camera, *arguments, status=1)
            self.assertEqual(len(message.strip().splitlines()), 1, message)
        thick = self.report(camera, *DROP, "--mass", "90", "--drop-height", "900", "--fragility", "5", "--wall", "protect", status=3)
        self.assertIn("a stiffer foam", thick)

    def test_what_is_missing_is_said(self):
        def codes(*arguments):
            found = self.report(self.work / "camera.ply", "--blocks", "auto", *arguments)
            return [finding["message"] for finding in found["findings"] if finding["code"] == "no_shock"]
        self.assertIn("snug foams", codes("--mass", "1", "--drop-height", "500")[0])
        self.assertIn("--mass", codes("--foam", "ld33", "--drop-height", "500")[0])
        self.assertIn("--foam", codes("--foam", "ethafoam-220", "--mass", "1", "--drop-height", "500")[0])


if __name__ == "__main__":
    unittest.main()
