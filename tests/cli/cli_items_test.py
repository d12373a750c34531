"""Several objects in one case, as a person or a script types them.

Usage: cli_items_test.py SNUG [unittest arguments]
"""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from read_solids import edge_balance, read_ply, signed_volume
from some_of import some_of

SNUG = Path(sys.argv.pop(1)).resolve()
TETRAHEDRON = "OFF\n4 4 6\n0 0 0\n60 0 0\n0 60 0\n0 0 60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"


def snug(*arguments, **options):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=120, **options)


class ItemsTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.out = self.work / "kit"
        for name in ("torus", "vase"):
            self.assertEqual(snug("sample", name, "-o", self.work / f"{name}.stl").returncode, 0)
        (self.work / "tetra.off").write_text(TETRAHEDRON)

    def make(self, *arguments, out=None):
        """In a row, where items have no places: cli_arrange_test.py arranges them."""
        return snug("make", *arguments, "--no-arrange", "-o", out or self.out, cwd=self.work)

    def report(self, out=None):
        return json.loads(((out or self.out) / "report.json").read_text())

    def assertMade(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)

    def assertRefused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists(), "nothing may be written")

    def depths(self, out=None):
        with open((out or self.out) / "depths.csv", newline="") as file:
            return {(int(row["j"]), int(row["k"])): row for row in csv.DictReader(file)}

    def test_the_report_tells_of_each_item(self):
        self.assertMade(self.make("torus.stl:upright=z,mass=0.4,name=ring", "vase.stl:count=2,longest=120,clearance=1x2x3",
                                  "--units", "mm", "--blocks", "auto", "--mass", "2"))
        report = self.report()
        items = report["items"]
        self.assertIsNone(report["object"])
        self.assertIsNone(report["placement"])
        self.assertEqual([(item["name"], item["file"], item["number"], item["layer"]) for item in items],
                         [("ring", "torus.stl", 1, 1), ("vase.stl", "vase.stl", 2, 1), ("vase.stl", "vase.stl", 3, 1)])
        self.assertEqual([item["mass_kg"] for item in items], [0.4, 2, 2])
        self.assertEqual([item["clearance_mm"] for item in items], [0, [1, 2, 3, 1, 2, 3], [1, 2, 3, 1, 2, 3]])
        self.assertEqual(items[0]["placement"]["rotation_deg"], [0, 90, 0])
        for item in items:
            low, high = item["box_mm"]
            for axis in range(3):
                self.assertAlmostEqual((low[axis] + high[axis]) / 2, item["placement"]["offset_mm"][axis], 3)
        size = [items[1]["box_mm"][1][axis] - items[1]["box_mm"][0][axis] for axis in range(3)]
        self.assertAlmostEqual(max(size), 120, 3)

    def test_the_solids_hold_what_the_depths_say(self):
        self.assertMade(self.make("torus.stl", "vase.stl:longest=150", "tetra.off:count=3", "--units", "mm", "--blocks", "auto"))
        report, rows = self.report(), self.depths()
        block = report["design_space"]["block_mm"]
        for half, column in (("lower", "lower_blocks"), ("upper", "upper_blocks")):
            vertices, triangles = read_ply(self.out / f"{half}.ply")[:2]
            self.assertTrue(all(each == [1, 1] for each in edge_balance(triangles)), "closed and outward")
            blocks = sum(int(row[column]) for row in rows.values())
            self.assertAlmostEqual(signed_volume([[vertices[i] for i in t] for t in triangles]) / (blocks * block[0] * block[1] * block[2]), 1, 6)

    def test_the_project_makes_the_same_again(self):
        self.assertMade(self.make("torus.stl:units=mm", "vase.stl:count=2,units=cm,scale=0.05", "--blocks", "auto", "--for", "sponge"))
        project = json.loads((self.out / "project.snug.json").read_text())
        self.assertEqual(project["snug"], 2)
        self.assertEqual([each["name"] for each in project["objects"]], ["torus.stl", "vase.stl"])
        self.assertEqual([each["object"] for each in project["design"]["items"]], [0, 1, 1])
        shutil.copy(self.out / "project.snug.json", self.work)
        again = self.work / "again"
        self.assertMade(self.make("project.snug.json", out=again))
        names = [path.relative_to(self.out) for path in sorted(self.out.rglob("*")) if path.is_file()]
        self.assertGreater(len(names), 10)
        for name in names:
            if name.name not in ("report.json", ".snug-files") and name.suffix != ".pdf":
                self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)

    def test_one_object_is_as_it_was(self):
        plain, item, old = self.out, self.work / "item", self.work / "old"
        self.assertMade(self.make("vase.stl", "--units", "mm", "--rotate=10,20,30", "--move=1,2,3", "--clearance=1,2,2"))
        self.assertMade(self.make("vase.stl:rotate=10x20x30,move=1x2x3,clearance=1x2x2", "--units", "mm", out=item))
        project = json.loads((plain / "project.snug.json").read_text())
        project["snug"] = 1
        project["object"] = project.pop("objects")[0]
        del project["design"]["items"]
        (self.work / "old.snug.json").write_text(json.dumps(project))
        self.assertMade(self.make("old.snug.json", out=old))
        for name in ("depths.csv", "lower.stl", "upper.ply", "preview.svg"):
            for other in (item, old):
                self.assertEqual((plain / name).read_bytes(), (other / name).read_bytes(), name)
        self.assertEqual(self.report(plain)["placement"], self.report(item)["placement"])
        self.assertEqual(len(self.report(plain)["items"]), 1)

    def test_items_that_meet_are_a_danger_that_names_both(self):
        self.assertMade(self.make("torus.stl:move=0x0x-40", "vase.stl:longest=100,move=0x0x40", "--units", "mm"))
        near = [each for each in self.report()["findings"] if each["code"] == "items_near"]
        self.assertEqual(len(near), 1)
        self.assertEqual(near[0]["severity"], "danger")
        for word in ("torus.stl", "vase.stl", "shift one of them by"):
            self.assertIn(word, near[0]["message"])
        self.assertMade(self.make("torus.stl:move=0x0x-40,group=a", "vase.stl:longest=100,move=0x0x40,group=a", "--units", "mm"))
        self.assertEqual([each for each in self.report()["findings"] if each["code"] == "items_near"], [])

    def test_items_in_each_other_are_told_what_parts_them(self):
        self.assertMade(self.make("vase.stl:longest=100,name=A,move=0x0x0", "torus.stl:name=B,move=0x0x40", "--units", "mm", "--blocks", "auto"))
        near = [each["message"] for each in self.report()["findings"] if each["code"] == "items_near"]
        self.assertEqual(len(near), 1)
        self.assertIn("lie in the same columns", near[0])
        shift = float(near[0].split("shift one of them by ")[1].split()[0])
        self.assertMade(self.make("vase.stl:longest=100,name=A,move=0x0x0", f"torus.stl:name=B,move=0x0x{40 + shift}", "--units", "mm", "--blocks", "auto"))
        self.assertEqual([each for each in self.report()["findings"] if each["code"] == "items_near"], [])

    def test_different_files_of_one_name_are_told(self):
        (self.work / "a").mkdir()
        shutil.copy(self.work / "vase.stl", self.work / "a" / "torus.stl")
        self.assertMade(self.make("torus.stl:longest=90", "a/torus.stl:longest=80", "--units", "mm", "--blocks", "auto"))
        self.assertIn("object_same_name", [each["code"] for each in self.report()["findings"] if each["severity"] == "warning"])

    def test_items_of_one_name_are_told_apart_and_an_object_is_told_of_once(self):
        (self.work / "open.off").write_text(TETRAHEDRON.replace("4 4 6", "4 3 6").replace("3 1 2 3\n", ""))
        done = self.make("open.off:count=2,move=0x0x10", "torus.stl:move=0x0x110,cap", "--units", "mm")
        self.assertMade(done)
        found = [(each["code"], each["message"].split(":")[0]) for each in self.report()["findings"]]
        self.assertIn(("open", "open.off (1)"), found)
        self.assertIn(("open", "open.off (2)"), found)
        self.assertEqual([name for code, name in found if code == "nothing_to_cap"], ["torus.stl"])
        near = [each["message"] for each in self.report()["findings"] if each["code"] == "items_near"]
        self.assertTrue(any("open.off (1) and open.off (2) lie in" in message for message in near), near)
        self.assertIn("open.off x2", done.stdout)

    def test_an_item_that_does_not_fit_is_named(self):
        done = self.make("torus.stl:move=0x0x0", "vase.stl:longest=100,move=0x0x900,name=spare vase", "--units", "mm")
        self.assertRefused(done, 3, "spare vase", "leaves the design space", "all items together take")
        done = self.make("torus.stl:name=ring", "vase.stl:longest=270", "--units", "mm", "--case", "425x284x200:45")
        self.assertRefused(done, 3, "all items together take", "place the items yourself")
        length = done.stderr.split("A case would do from ")[1].split(" ")[0]
        self.assertMade(self.make("torus.stl:name=ring", "vase.stl:longest=270", "--units", "mm", "--case", f"{length}x400x400"))

    def test_items_that_share_a_place_are_told(self):
        for more in (["--between", "0"], []):
            group = "" if more else ",group=a"
            self.assertMade(self.make(f"torus.stl:name=A,move=0x0x0{group}", f"torus.stl:name=B,move=0x0x0{group}", "--units", "mm", *more))
            found = [each for each in self.report()["findings"] if each["code"] == "items_overlap"]
            self.assertEqual([each["severity"] for each in found], ["warning"])
            self.assertIn("A and B share a pocket", found[0]["message"])
        self.assertMade(self.make("tetra.off:name=A,move=0x0x-32,group=a", "tetra.off:name=B,move=0x0x32,group=a", "--units", "mm"))
        self.assertEqual([each["code"] for each in self.report()["findings"] if each["code"].startswith("items_")], [])

    def test_pictures_number_several_items_and_never_one(self):
        self.assertMade(self.make("torus.stl", "vase.stl:longest=90,count=2", "--units", "mm", "--blocks", "auto"))
        preview = (self.out / "preview.svg").read_text()
        for number in ("1", "2", "3"):
            self.assertIn(f">{number}</text>", preview)
        self.assertMade(self.make("torus.stl", "--units", "mm"))
        self.assertNotIn(">1</text>", (self.out / "preview.svg").read_text())

    def test_each_combination_is_made_twice_and_again_from_its_project(self):
        """Faults sit where two parts meet."""
        two = ["torus.stl:longest=80,move=0x0x-60", "vase.stl:longest=90,move=0x0x60", "--units", "mm"]
        leaning = [*two, "--case", "300x250x200:60", "--case-base", "290x240", "--case-top", "290x240"]
        self.assertEqual(snug("sample", "figurine", "-o", self.work / "figurine.obj").returncode, 0)
        points = [line[2:] for line in (self.work / "figurine.obj").read_text().splitlines() if line.startswith("v ")]
        (self.work / "cloud.xyz").write_text("\n".join(points))
        for arguments, project_too in (
                (["torus.stl:clearance=0x1x2x3x2x1", "vase.stl:longest=90,clearance=2", "--units", "mm", "--blocks", "auto"], []),
                ([*two, "--notches", "60x30", "--least-rib", "25", "--liner", "1", "--mass", "2"], []),
                ([*two, "--case", "425x284x155:45", "--case-radius", "40", "--for", "sponge"], []),
                ([*leaning, "--for", "sheets"], []),
                ([*leaning, "--for", "print"], []),
                ([*leaning, "--for", "mould"], []),
                ([*leaning, "--for", "mill", "--block-size", "5x5x5", "--flute", "200"], []),
                ([*two, "--for", "bricks"], []),
                (["cloud.xyz:units=mm", "vase.stl:longest=90,units=mm", "--blocks", "auto", "--for", "sponge"], []),
                (["torus.stl:count=2", "vase.stl", "--units", "mm", "--blocks", "auto"], ["--stream"]),
                (["torus.stl:name=輪", "vase.stl:name=花瓶,count=2", "--units", "mm", "--blocks", "auto"], ["--language", "ja"])):
            with self.subTest(" ".join(arguments)):
                again = self.work / "again"
                for _ in some_of(range(2)):
                    self.assertMade(self.make(*arguments, *project_too))
                shutil.copy(self.out / "project.snug.json", self.work)
                self.assertMade(self.make("project.snug.json", *project_too, out=again))
                names = [path.relative_to(self.out) for path in self.out.rglob("*") if path.is_file()]
                self.assertEqual(sorted(names), sorted(path.relative_to(again) for path in again.rglob("*") if path.is_file()))
                for name in names:
                    if name.name not in ("report.json", ".snug-files") and name.suffix not in (".pdf", ".3mf"):
                        self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)
                shutil.rmtree(self.out)
                shutil.rmtree(again)

    def test_streamed_objects_give_the_same_foams(self):
        kit = ["torus.stl:count=2,rotate=0x90x0", "vase.stl", "--units", "mm", "--blocks", "auto"]
        self.assertMade(self.make(*kit))
        self.assertMade(self.make(*kit, "--stream", out=self.work / "streamed"))
        for name in ("depths.csv", "lower.stl", "upper.ply"):
            self.assertEqual((self.out / name).read_bytes(), (self.work / "streamed" / name).read_bytes(), name)

    def test_a_path_that_exists_is_taken_whole(self):
        odd = "a:count=3"
        shutil.copy(self.work / "tetra.off", self.work / odd)
        self.assertMade(self.make(odd, "--units", "mm"))
        self.assertEqual([item["file"] for item in self.report()["items"]], [odd])

    def test_what_is_typed_wrongly_is_named_with_its_file(self):
        self.assertRefused(self.make("torus.stl:count=0"), 1, "torus.stl", "count takes a whole number from 1 to 1000")
        self.assertRefused(self.make("torus.stl:count=10000"), 1, "torus.stl", "count")
        self.assertRefused(self.make("torus.stl:count=600", "vase.stl:count=600"), 1, "vase.stl", "1000")
        self.assertRefused(self.make("torus.stl:turn=3"), 1, "torus.stl", "\"turn\"", "rotate", "longest")
        self.assertRefused(self.make("torus.stl:move=0x40"), 1, "torus.stl", "move")
        self.assertRefused(self.make("torus.stl:upright=up"), 1, "torus.stl", "x, y, z")
        self.assertRefused(self.make("torus.stl:mass=0,5"), 1, "torus.stl", "mass takes")
        self.assertRefused(self.make("torus.stl:COUNT=2"), 1, "torus.stl", "\"COUNT\"")
        self.assertRefused(self.make("torus.stl:rotate=nanx0x0"), 1, "torus.stl")
        self.assertRefused(self.make("torus.stl:move=1e9x0x0", "vase.stl"), 1, "torus.stl")
        self.assertRefused(self.make("torus.stl:mass=1,mass=2"), 1, "torus.stl", "twice")
        self.assertRefused(self.make("torus.stl:rotate=0x90x0,upright=z"), 1, "torus.stl", "rotate and upright")
        self.assertRefused(self.make("torus.stl:clearance=-9"), 1, "clearance")
        self.assertRefused(self.make("torus.stl:mass=-1"), 1, "mass")
        self.assertRefused(self.make("torus.stl:scale=0"), 1, "torus.stl", "scale")

    def test_a_file_that_is_missing_or_broken_among_others_is_named(self):
        self.assertRefused(self.make("torus.stl", "gone.stl", "vase.stl"), 2, "gone.stl")
        (self.work / "broken.stl").write_bytes(b"solid nothing")
        self.assertRefused(self.make("torus.stl", "broken.stl"), 2, "broken.stl")
        self.assertRefused(self.make("torus.stl", "vase.stl", "--optimize"), 1, "one object")
        self.assertMade(self.make("torus.stl", "vase.stl", "--units", "mm", "--blocks", "auto", out=self.work / "two"))
        self.assertRefused(self.make("two/project.snug.json", "torus.stl"), 1, "project.snug.json")
        self.assertRefused(self.make("two/project.snug.json", "--object", "torus.stl"), 1, "2 objects")
        self.assertRefused(self.make("two/project.snug.json"), 2, "torus.stl", "--object FOLDER")
        self.assertMade(self.make("two/project.snug.json", "--object", ".", out=self.work / "again"))
        self.assertEqual((self.work / "two" / "depths.csv").read_bytes(), (self.work / "again" / "depths.csv").read_bytes())


if __name__ == "__main__":
    unittest.main()
