"""Places on an item that foam keeps away from, from the command line.

Usage: cli_zones_test.py SNUG [unittest arguments]
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_solids import read_stl

SNUG = Path(sys.argv.pop(1)).resolve()
FOAM = ["--preset", "sheet-10", "--blocks", "auto"]


def snug(*arguments, **options):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


def overlap(triangle, low, high):
    """Whether a triangle across an axis, as blocks have them, meets the inside of a box: by separating axes."""
    if not all(min(c[a] for c in triangle) < high[a] and max(c[a] for c in triangle) > low[a] for a in range(3)):
        return False
    axis = next(a for a in range(3) if triangle[0][a] == triangle[1][a] == triangle[2][a])
    u, v = (axis + 1) % 3, (axis + 2) % 3
    box = [(p, q) for p in (low[u], high[u]) for q in (low[v], high[v])]
    flat = [(c[u], c[v]) for c in triangle]
    for i in range(3):
        n = (flat[i - 1][1] - flat[i][1], flat[i][0] - flat[i - 1][0])
        along = [[n[0] * p + n[1] * q for p, q in shape] for shape in (flat, box)]
        if max(along[0]) <= min(along[1]) or max(along[1]) <= min(along[0]):
            return False
    return True


class Zones(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.work = Path(cls.folder.name)
        for sample in ("camera", "vase"):
            assert snug("sample", sample, "-o", cls.work / f"{sample}.ply").returncode == 0
            assert snug("sample", sample, "-o", cls.work / f"{sample}.stl").returncode == 0
        cls.vase = cls.work / "vase.ply"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def report(self, *arguments, status=0, folder="out"):
        done = snug("make", *arguments, "-o", self.work / folder, "--json")
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout) if status == 0 else done.stderr

    def test_no_foam_of_either_file_lies_within_the_distance_of_the_zone(self):
        ball, radius, off = (60.0, 0.0, 20.0), 15.0, 22.0
        zone = f"{ball[0]},{ball[1]},{ball[2]},{radius}:{off}"
        report = self.report(self.vase, *FOAM, "--move", "0,3,-4", "--keep-off", zone)
        told = report["protection"]["zones"][0]
        self.assertGreater(told["cut_blocks"], 0)
        self.assertIsNone(told["reached"])
        placed = report["placement"]
        self.assertEqual(placed["rotation_deg"], [0, 0, 0])
        # The vase is centred in its file, so that file and design coordinates differ by the shift alone.
        corners = {corner for t in read_stl(self.work / "vase.stl") for corner in t}
        met = [c for c in corners if sum((c[a] - ball[a]) ** 2 for a in range(3)) < radius**2]
        self.assertGreater(len(met), 3)
        middle = [(min(c[a] for c in corners) + max(c[a] for c in corners)) / 2 for a in range(3)]
        at = [[c[a] - middle[a] + placed["offset_mm"][a] for a in range(3)] for c in met]
        for foam in ("lower.stl", "upper.stl"):
            triangles = read_stl(self.work / "out" / foam)
            self.assertGreater(len(triangles), 100)
            for p in at:  # each stands in its pocket, so foam that is near has a face that is near
                low, high = [x - off + 0.02 for x in p], [x + off - 0.02 for x in p]
                self.assertFalse(any(overlap(t, low, high) for t in triangles))

    def test_a_zone_is_told_everywhere_and_comes_back_from_the_project(self):
        ask = ["--mass", "2.4", "--foam", "ld33", "--drop-height", "760", "--wall", "90"]
        zones = ["--keep-off", "60,0,20,15:22:loose", "--keep-off", "0,0,-140,20:press=0.5kPa"]
        report = self.report(self.vase, *FOAM, *ask, *zones)
        first, second = report["protection"]["zones"]
        self.assertEqual((first["zone"], first["keep_off_mm"], first["loose"]), (1, 22, True))
        sink = {face["face"]: face["sink_mm"] for face in report["protection"]["faces"]}
        for side, left in first["left_mm"].items():
            if left is not None:
                self.assertLessEqual(left, first["room_mm"][side] - sink[side] + 1e-3)
        self.assertEqual(first["reached"], min(v for v in first["left_mm"].values() if v is not None) < 3)
        self.assertEqual(second["press_kpa"], 0.5)
        self.assertGreater(max(v for v in second["peak_kpa"].values() if v is not None), 0.5)
        codes = {finding["code"] for finding in report["findings"]}
        self.assertTrue({"zone_reached", "zone_pressed", "zone_free"} <= codes, codes)
        again = self.report(self.work / "out" / "project.snug.json", "--object", self.vase, folder="again")
        self.assertEqual(again["protection"], report["protection"])
        said = snug("make", self.vase, *FOAM, *ask, *zones, "-o", self.work / "said", "--for", "sheets")
        self.assertIn("Zone 1", said.stdout)
        self.assertIn("loose", said.stdout)

    def test_what_the_sentence_advises_does(self):
        ask = [*FOAM, "--mass", "1.2", "--foam", "ld33", "--drop-height", "400", "--wall", "120"]
        place = "60,0,20,15"
        off = 10
        for _ in range(3):  # with less foam to carry it the item travels a little farther
            report = self.report(self.vase, *ask, "--keep-off", f"{place}:{off}")
            reached = [f for f in report["findings"] if f["code"] == "zone_reached"]
            if off == 10:
                self.assertEqual(len(reached), 1)
            if not reached:
                return
            off = int(reached[0]["message"].split("Keep ")[1].split(" mm")[0])
        self.fail(f"{off} mm are not enough")

    def test_each_item_has_its_own(self):
        items = [f"{self.vase}:keep-off=60x0x20x15:22,mass=2", f"{self.work / 'camera.ply'}:count=2,mass=0.9"]
        report = self.report(*items, *FOAM)
        self.assertEqual([(zone["item"], zone["zone"]) for zone in report["protection"]["zones"]], [(1, 1)])
        both = self.report(f"{self.vase}:keep-off=60,0,20,15:22:loose,part=1:press=2,move=0x0x0", *FOAM)
        self.assertEqual(len(both["protection"]["zones"]), 2)

    def test_a_zone_that_cannot_be_is_said_to_be_wrong(self):
        for zone, said in {"0,0,9000,5:15": "no surface", "0,0,0,9000:15": "whole object", "part=7:15": "no part 7",
                           "part=1": "--keep-off takes", "1,2,3:15": "--keep-off takes", "0,0,1,-2:15": "radius",
                           "0,0,1,2:2000": "0 to 1000 mm", "0,0,1,2:press=2kPa:loose": "loose", "0,0,1,2:0": "neither",
                           "part=1:press=0": "above 0 kPa"}.items():
            with self.subTest(zone):
                self.assertIn(said, self.report(self.vase, *FOAM, "--keep-off", zone, status=1))
        many = ",".join(["1,2,3,4"] * 2001) + ":15"
        self.assertIn("2000", self.report(self.vase, *FOAM, "--keep-off", many, status=1))

    def test_a_search_knows_them(self):
        for ask in [["--optimize", "--search-seconds", "2"], ["--fit-case"]]:
            with self.subTest(ask):
                report = self.report(self.vase, *FOAM, "--keep-off", "60,0,20,15:40", *ask)
                self.assertEqual(report["search"]["cut_blocks"], report["foam"]["cut_blocks"])
                self.assertGreater(report["protection"]["zones"][0]["cut_blocks"], 0)
                self.assertGreaterEqual(min(report["wall_mm"]), 50)


if __name__ == "__main__":
    unittest.main()
