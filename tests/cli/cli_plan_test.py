"""Whole proposals from a few answers, from the command line; what each promises is what `snug make` then makes of it.

Usage: cli_plan_test.py SNUG [unittest arguments]
"""

import json
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
KINDS = ["smallest", "most-margin", "cheapest"]


def snug(*arguments):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=300)


class Plans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.work = Path(cls.folder.name)
        for sample in ("camera", "vase", "torus"):
            assert snug("sample", sample, "-o", cls.work / f"{sample}.ply").returncode == 0
        text = "box 143x87x40 r5 + cylinder 63x60 at 0,0,50"
        assert snug("shape", text, "-o", cls.work / "measured.shape").returncode == 0
        for name, text in (("small", "box 30x20x40 r5 + cylinder 20x30 at 0,0,30"), ("ball", "ball 40")):
            assert snug("shape", text, "-o", cls.work / f"{name}.shape").returncode == 0

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def plan(self, *arguments, folder="plan", status=0):
        done = snug("plan", *arguments, "-o", self.work / folder, "--json")
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout) if status == 0 else done.stderr

    def made(self, kind, objects, folder="plan"):
        done = snug("make", self.work / folder / f"{kind}.snug.json", "--object", objects, "-o", self.work / "made", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def assertAsMade(self, proposals, objects, folder="plan"):
        self.assertEqual([each["kind"] for each in proposals], KINDS)
        for each in proposals:
            report = self.made(each["kind"], objects, folder)
            if each["case"] is None:
                size = [n * mm for n, mm in zip(report["design_space"]["blocks"], report["design_space"]["block_mm"])]
                for a, b in zip(size, each["size_mm"]):
                    self.assertAlmostEqual(a, b, 3)
            self.assertAlmostEqual(each["litres"], each["size_mm"][0] * each["size_mm"][1] * each["size_mm"][2] * 1e-6, 3)
            self.assertEqual(report["workshop"]["pieces"], each["pieces"])
            self.assertAlmostEqual(each["work_hours"], each["pieces"] * each["seconds_each"] / 3600, 4)
            self.assertEqual([f["message"] for f in report["findings"] if f["severity"] != "note"],
                             [f["message"] for f in each["findings"] if f["severity"] != "note"])
            self.assertShocksAreThoseOf(report.get("protection"), each)
            self.assertIn("<svg", (self.work / folder / f"{each['kind']}.svg").read_text())
        by = dict(zip(KINDS, proposals))
        if by["smallest"]["meets"] == "yes":
            for each in proposals:
                if each["meets"] == "yes":
                    self.assertLessEqual(by["smallest"]["litres"], each["litres"] + 1e-9)
                    self.assertLessEqual(by["cheapest"]["billed_kg"], each["billed_kg"])

    def assertShocksAreThoseOf(self, protection, proposal):
        if protection is None or proposal["why_none"] in ("no_foam_data", "no_mass", "no_height"):
            self.assertIsNone(proposal["worst_g"])
            return
        items = protection.get("items") or [protection]
        faces = [face for item in items for face in item["faces"]]
        untold = [face for face in faces if face["g"] is None or face["g"][1] is None]
        self.assertEqual(proposal["worst_g"] is None, bool(untold), (proposal, untold))
        asked = proposal["asked_g"]
        if untold:
            self.assertIn(proposal["why_none"], ("bottoms", "thin", "unsettled"))
            self.assertEqual(proposal["meets"], "no" if asked or proposal["why_none"] == "bottoms" else "unknown")
            return
        worst = max(face["g"][1] for face in faces)  # all of them bear the same here
        self.assertAlmostEqual(worst, proposal["worst_g"], 0)
        self.assertEqual(proposal["meets"], "unknown" if asked is None else "yes" if worst <= asked else "no")

    def test_each_proposal_is_what_make_makes_of_it(self):
        vase = self.work / "vase.ply"
        proposals = self.plan(vase, "--mass", "2.4", "--fragility", "115", "--carrier", "hand", "--for", "sheets", "--foam", "ld33")
        self.assertAsMade(proposals, vase)
        self.assertEqual({each["meets"] for each in proposals}, {"yes"})
        self.assertLess(proposals[1]["worst_g"], proposals[0]["worst_g"])

    def test_a_store_claims_nothing_of_drops_and_prices_decide(self):
        torus = self.work / "torus.ply"
        proposals = self.plan(torus, "--carrier", "store", "--price", "2EUR", "--seconds-each", "6")
        self.assertAsMade(proposals, torus)
        for each in proposals:
            self.assertIsNone(each["worst_g"])
            self.assertEqual(each["seconds_each"], 6)
            self.assertGreaterEqual(each["cost"], proposals[2]["cost"])
            self.assertEqual(each["currency"], "EUR")

    def test_measurements_and_several_objects(self):
        measured = self.work / "measured.shape"
        self.assertAsMade(self.plan(measured, "--clearance", "2", "--ways", "print,bricks"), measured)
        kit = self.plan(f"{self.work / 'small.shape'}:count=2", self.work / "ball.shape", "--carrier", "store", folder="kit")
        self.assertAsMade(kit, self.work, folder="kit")
        for each in kit:
            self.assertEqual([f for f in each["findings"] if f["severity"] == "danger"], [], each)

    def test_what_is_there_is_used(self):
        camera = self.work / "camera.ply"
        for each in self.plan(camera, "--case", "1450", "--for", "sheets", "--preset", "sheet-5", "--carrier", "store"):
            self.assertEqual((each["case"], each["for"], each["preset"]), ("1450", "sheets", "sheet-5"))
        hard = re.findall(r"^(\S+) +hard case", snug("cases").stdout, re.M)
        for objects in ([camera], [camera, self.work / "torus.ply"]):
            for each in self.plan(*objects, "--choose-case", "hard-cases", "--for", "sponge"):
                self.assertIn(each["case"], hard)
                self.assertEqual(each["meets"], "unknown")

    def test_a_side_without_a_figure_is_the_worst(self):
        small = self.work / "small.shape"
        two = f"{small}:count=2"
        proposals = self.plan(two, "--mass", "0.2", "--carrier", "hand", "--for", "sheets", "--foam", "ethafoam-200lc",
                              "--notches", "60x30", "--upright", "x", "--choose-case", "none", folder="two")
        self.assertEqual({(each["why_none"], each["meets"]) for each in proposals}, {("thin", "unknown")})
        self.assertAsMade(proposals, small, folder="two")

    def test_what_stands_upright_does_so_in_every_case(self):
        vase = self.work / "vase.ply"
        for choice in ("cartons", "hard-cases"):
            for each in self.plan(vase, "--upright", "z", "--rotate", "0,90,0", "--for", "sponge", "--choose-case", choice, folder="up"):
                report = self.made(each["kind"], vase, folder="up")
                psi, theta, phi = (math.radians(angle) for angle in report["placement"]["rotation_deg"])
                # x of the object's own z: the third of the first row of Rz(phi) Ry(theta) Rx(psi).
                up = math.cos(phi) * math.sin(theta) * math.cos(psi) + math.sin(phi) * math.sin(psi)
                self.assertAlmostEqual(up, 1, 6, each)

    def test_a_tray_is_planned_and_not_dropped(self):
        torus = self.work / "torus.ply"
        for each in self.plan(torus, "--open", "0.6", "--mass", "1", "--fragility", "115"):
            self.assertIsNone(each["worst_g"])
            self.assertIsNone(each["case"])

    def test_what_is_not_needed_is_not_proposed(self):
        vase, torus = self.work / "vase.ply", self.work / "torus.ply"
        for each in (*self.plan(vase, "--for", "sponge", "--mass", "2.4"), *self.plan(torus, "--for", "sheets")):
            self.assertNotIn("settled_none", [f["code"] for f in each["findings"]])
            self.assertFalse(str(each["case"]).startswith(("royal-mail", "usps", "fedex")), each["case"])

    def test_it_is_told_in_both_languages(self):
        small = self.work / "small.shape"
        done = snug("plan", small, "--carrier", "store")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("Smallest", "Most margin", "Cheapest", "made to measure", "nothing is claimed"):
            self.assertIn(word, done.stdout)
        done = snug("plan", small, "--carrier", "store", "--language", "ja")
        for word in ("最も小さい", "最も余裕がある", "最も安い", "評価なし"):
            self.assertIn(word, done.stdout)

    def test_a_second_run_takes_the_place_of_the_first(self):
        small, folder = self.work / "small.shape", self.work / "again"
        self.assertEqual(snug("plan", small, "--carrier", "store", "-o", folder, "--quiet").stdout, "")
        (folder / "note.txt").write_text("mine")
        first = {path.name: path.read_bytes() for path in folder.iterdir()}
        self.assertEqual(snug("plan", small, "--carrier", "store", "-o", folder, "--threads", "1").returncode, 0)
        self.assertEqual({path.name: path.read_bytes() for path in folder.iterdir()}, first)

    def test_what_is_wrong_is_said(self):
        torus = self.work / "torus.ply"
        for status, said, arguments in ((1, "store, hand, courier or parcel", ["--carrier", "pigeon"]),
                                        (1, "not \"clay\"", ["--ways", "sponge,clay"]),
                                        (1, "cartons, hard-cases or none", ["--choose-case", "all"]),
                                        (1, "--for", ["--for", "clay"]),
                                        (3, "choose smaller blocks or a larger case", ["--case", "20x20x20"]),
                                        (3, "torus.ply", ["--case", "60x60x60"])):
            error = self.plan(torus, *arguments, status=status)
            self.assertIn(said, error)
        self.assertEqual(snug("plan", self.work / "none.ply").returncode, 2)


if __name__ == "__main__":
    unittest.main()
