"""What `snug make --for mill` hands to a miller, and what it refuses.

Usage: cli_mill_test.py SNUG [unittest arguments]
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
WORD = re.compile(r"[GMXYZFSPIJ]-?\d+(\.\d{1,3})?")


class MillTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.out = self.work / "out"
        self.vase = self.work / "vase.stl"
        self.assertEqual(self.snug("sample", "vase", "-o", self.vase).returncode, 0)

    def snug(self, *arguments):
        return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=240)

    def make(self, *arguments):
        return self.snug("make", self.vase, "--for", "mill", "--longest", 70, "--wall", 15, *arguments, "-o", self.out)

    def report(self):
        return json.loads((self.out / "report.json").read_text())

    def places(self, name):
        """X, Y and Z of every move, and the words of the program."""
        at, found, words = {}, [], set()
        for line in (self.out / "mill" / name).read_text(encoding="ascii").splitlines():
            self.assertLessEqual(len(line), 80)
            if line.startswith("("):
                continue
            for word in line.split():
                self.assertRegex(word, f"^{WORD.pattern}$")
                words.add(word)
                if word[0] in "XYZ":
                    at[word[0]] = float(word[1:])
            if len(at) == 3:
                found.append((at["X"], at["Y"], at["Z"]))
        return found, words

    def test_both_halves_get_a_program_within_their_stock(self):
        done = self.make()
        self.assertEqual(done.returncode, 0, done.stderr)
        names = {path.name for path in (self.out / "mill").iterdir()}
        self.assertEqual(names, {"lower.nc", "lid.nc"})
        self.assertTrue((self.out / "mill-setup.pdf").read_bytes().startswith(b"%PDF"))
        space = self.report()["design_space"]
        width, depth = (space["blocks"][axis] * space["block_mm"][axis] for axis in (2, 1))
        for name in names:
            places, words = self.places(name)
            self.assertLessEqual({"G21", "G90", "G94", "G17", "G54", "M3", "M5", "M30", "S16000"}, words)
            for x, y, z in places:
                self.assertTrue(0 <= x <= width and 0 <= y <= depth and z <= 5)
            self.assertEqual(max(z for _, _, z in places), 5)

    def test_the_origin_may_be_the_middle_and_feeds_are_chosen(self):
        self.assertEqual(self.make().returncode, 0)
        corner, _ = self.places("lower.nc")
        done = self.make("--origin", "centre", "--feed", 900, "--plunge", 150, "--spindle", 9000, "--safe-height", 8)
        self.assertEqual(done.returncode, 0, done.stderr)
        middle, words = self.places("lower.nc")
        self.assertLessEqual({"F900", "F150", "S9000"}, words)
        self.assertEqual(max(z for _, _, z in middle), 8)
        space = self.report()["design_space"]
        for axis, name in ((0, 2), (1, 1)):
            half = space["blocks"][name] * space["block_mm"][name] / 2
            for place, shifted in zip(corner, middle):
                self.assertAlmostEqual(place[axis] - half, shifted[axis], delta=0.0011)

    def test_a_project_keeps_every_option_and_gives_the_same_bytes(self):
        self.assertEqual(self.make("--cutter", 4, "--step-down", 2, "--stepover", 0.3, "--pin", 5).returncode, 0)
        first = (self.out / "mill/lower.nc").read_bytes()
        again = self.work / "again"
        done = self.snug("make", self.out / "project.snug.json", "--object", self.vase, "-o", again, "--threads", 1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "mill/lower.nc").read_bytes(), first)

    def test_a_half_that_leaves_out_foam_outside_is_turned_over_on_pins_of_its_own(self):
        for case in (["--case-radius", 20], ["--case-base", "140x100"], ["--case-base", "150x110", "--case-top", "140x96"]):
            with self.subTest(case=case):
                done = self.snug("make", self.vase, "--for", "mill", "--longest", 70, "--case", "160x120x90:45",
                                 *case, "--flute", 100, "-o", self.out)
                self.assertEqual(done.returncode, 0, done.stderr)
                names = {path.name for path in (self.out / "mill").iterdir()}
                halves = {name.split("-")[0] for name in names if name.endswith("-outside.nc")}
                self.assertEqual(bool(halves), "--case-base" in case)
                self.assertEqual(names, {"lower.nc", "lid.nc"} | {f"{half}-{what}.nc" for half in halves
                                                                  for what in ("outside", "board")})
                for name in names:
                    text = (self.out / "mill" / name).read_text("ascii")
                    self.assertEqual("cavity up" in text, "-" not in name, name)
                    self.assertEqual("outer side up" in text, "outside" in name, name)
                    self.places(name)
                shutil.rmtree(self.out)

    def test_a_name_that_would_stop_the_machine_is_made_harmless(self):
        path = self.vase.rename(self.work / "fragile! ~ keep.stl")
        done = self.snug("make", path, "--for", "mill", "--longest", 70, "--wall", 15, "-o", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, half in (("lower.nc", b"LOWER"), ("lid.nc", b"LID")):
            program = (self.out / "mill" / name).read_bytes()
            self.assertTrue(program.startswith(b"(" + half + b", cavity up. Object: fragile keep)\n"))
            self.assertFalse(set(program) & set(b"!~?%;$") or [byte for byte in program if byte > 126])

    def test_what_cannot_be_milled_is_said(self):
        cases = [(["--cutter", 100], ["wider than every pocket", "--cutter"]),
                 (["--flute", 5], ["flute", "at least"]),
                 (["--cutter", 0], ["0.5 to 100"]),
                 (["--stepover", 1], ["0.05 to 0.9"]),
                 (["--step-down", 0], ["depth of a pass"]),
                 (["--feed", -3], ["feed"]),
                 (["--safe-height", 0], ["safe height"]),
                 (["--pin", 0.2], ["pins"]),
                 (["--origin", "left"], ["corner or centre"])]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                done = self.make(*arguments)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                for word in words:
                    self.assertIn(word, done.stderr)
                self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
