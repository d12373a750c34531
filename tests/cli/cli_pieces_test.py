"""Objects that are read in pieces, and what becomes of them where memory is short or the disk fails.

Usage: cli_pieces_test.py SNUG FAILING_DISK [unittest arguments]
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from written_objects import l_shape, write_sparse_stl, write_stl

SNUG = Path(sys.argv.pop(1)).resolve()
FAILING_DISK = Path(sys.argv.pop(1)).resolve()  # tests/support/failing_disk.cpp


def snug(*arguments):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def snug_within(megabytes, *arguments):
    """With so much memory only."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
    # Threads reserve memory that they do not use.
    return subprocess.run([SNUG, *map(str, arguments), *(["--threads", "1"] if arguments[0] == "make" else [])],
                          capture_output=True, text=True, timeout=120, preexec_fn=limit)


class Pieces(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def depths(self, path, *options):
        out = self.folder / ("out-" + path.name)
        done = snug("make", path, "-o", out, "--quiet", "--blocks", "60x50x40", "--block-size", "5x7x9", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (out / "depths.csv").read_text()

    def refused(self, path, *options):
        done = snug("make", path, "-o", self.folder / "none", *options)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertFalse((self.folder / "none").exists())
        self.assertIn(path.name, done.stderr)
        return done.stderr

    def test_reading_in_pieces_gives_the_same_foams(self):
        for name in ("torus", "vase"):
            whole = self.folder / f"{name}.stl"
            self.assertEqual(snug("sample", name, "-o", whole).returncode, 0)
            ply = self.folder / f"{name}.ply"
            self.assertEqual(snug("sample", name, "-o", ply).returncode, 0)
            for path in (whole, ply):
                memory, pieces = self.depths(path, "--rotate", "10,20,30"), self.depths(path, "--rotate", "10,20,30", "--stream")
                self.assertEqual(memory, pieces)
            report = json.loads((self.folder / f"out-{name}.stl" / "report.json").read_text())
            self.assertTrue(report["object"]["streamed"])
            for unknown in ("vertices", "watertight", "volume_mm3"):
                self.assertIsNone(report["object"][unknown])
            self.assertIsNone(report["gap"])
            self.assertIn("streamed", [finding["code"] for finding in report["findings"]])

    def test_a_search_in_pieces_ends_with_the_object_itself(self):
        path = self.folder / "vase.stl"
        self.assertEqual(snug("sample", "vase", "-o", path).returncode, 0)
        out = self.folder / "out"
        done = snug("make", path, "-o", out, "--stream", "--blocks", "auto", "--fit-case", "--optimize", "--quiet",
                    "--search-seconds", "0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = (out / "depths.csv").read_text()
        # The project has the placement that was found; read whole, it gives the same foams.
        done = snug("make", out / "project.snug.json", "--object", path, "-o", self.folder / "again", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(found, (self.folder / "again" / "depths.csv").read_text())

    def limited(self):
        """Under sanitizers a program cannot start at all in little memory."""
        if snug_within(400, "presets").returncode != 0:
            self.skipTest("this program needs more memory than the test leaves it")

    def test_a_file_of_more_than_a_share_of_memory_is_read_in_pieces_by_itself(self):
        self.limited()
        path = self.folder / "large.stl"
        write_sparse_stl(path, 120)
        report = self.folder / "out" / "report.json"
        for options, streamed in (((), True), (("--no-stream",), False)):
            done = snug_within(400, "make", path, "-o", self.folder / "out", "--quiet", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(report.read_text())["object"].get("streamed", False), streamed)
        # Nothing else is read in pieces, so it is read whole as long as there is memory for it.
        path = self.folder / "large.xyz"
        path.write_text("".join(f"{60 * x} {y} {z}" + " " * 30000 + "\n" for x in (0, 1) for y in range(0, 101, 2)
                                for z in range(0, 81, 2)))
        done = snug_within(400, "make", path, "-o", self.folder / "out", "--quiet")
        self.assertNotIn("pieces", done.stderr)

    def test_an_object_that_memory_does_not_hold_is_a_sentence(self):
        self.limited()
        path = self.folder / "large.stl"
        write_sparse_stl(path, 600)
        for command in (("make", path, "-o", self.folder / "none", "--no-stream"), ("inspect", path)):
            done = snug_within(400, *command)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"large\.stl: there is not enough memory.*--stream")
        self.assertFalse((self.folder / "none").exists())

    def test_a_disk_that_fails_and_a_file_that_shrinks_are_sentences(self):
        path = self.folder / "a.stl"
        self.assertEqual(snug("sample", "vase", "-o", path).returncode, 0)
        cloud = self.folder / "a.xyz"
        cloud.write_text("".join(f"{60 * x} {y} {z}\n" for x in (0, 1) for y in range(0, 101, 2) for z in range(0, 81, 2)))
        for file, options in ((path, ["--stream"]), (path, []), (cloud, [])):
            for shrinks, word in ((False, "cannot be read (Input/output error)"), (True, "shorter while it was read")):
                environment = {**os.environ, "LD_PRELOAD": str(FAILING_DISK), "FAILING_FILE": str(file),
                               "FAILS_AT": str(file.stat().st_size // 2), **({"SHRINKS": "1"} if shrinks else {})}
                whole = file.read_bytes()
                done = subprocess.run([SNUG, "make", file, "-o", self.folder / "none", *options], capture_output=True,
                                      text=True, timeout=120, env=environment)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(word, done.stderr)
                self.assertEqual(done.stderr.count(file.name), 1, done.stderr)
                self.assertFalse((self.folder / "none").exists())
                self.assertEqual(file.stat().st_size < len(whole), shrinks)
                file.write_bytes(whole)

    def test_what_is_wrong_with_a_design_is_said_alike_however_the_file_is_read(self):
        path = self.folder / "a.stl"
        write_stl(path, *l_shape())
        for options in (["--for", "bricks", "--block-size", "20x10x10"], ["--parting", "31"]):
            whole, pieces = (snug("make", path, "-o", self.folder / "none", *options, *way) for way in ([], ["--stream"]))
            self.assertEqual((whole.returncode, whole.stderr), (1, pieces.stderr))

    def test_what_cannot_be_read_in_pieces_says_so(self):
        path = self.folder / "a.off"
        path.write_text("OFF\n4 4 6\n0 0 0\n60 0 0\n0 60 0\n0 0 60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        self.assertIn("--no-stream", self.refused(path, "--stream"))
        step = self.folder / "a.step"
        step.write_bytes(b"ISO-10303-21;\nHEADER;" + bytes(100))
        self.assertIn("STEP", self.refused(step, "--stream"))
        path = self.folder / "a.stl"
        write_stl(path, *l_shape())
        path.write_bytes(path.read_bytes()[:-20])
        self.assertIn("cut off", self.refused(path, "--stream"))
        self.assertEqual(snug("make", self.folder, "-o", self.folder / "none", "--stream").returncode, 2)


if __name__ == "__main__":
    unittest.main()
