"""Searching from the command line: what is found is written, the same every time, and Ctrl-C keeps it.
Usage: cli_search_test.py PROGRAM"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=300, check=False)


class Search(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.object = os.path.join(cls.folder.name, "figurine.stl")
        run("sample", "figurine", "-o", cls.object)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def out(self, name):
        return os.path.join(self.folder.name, name)

    def report(self, name):
        with open(os.path.join(self.out(name), "report.json"), encoding="utf-8") as file:
            return json.load(file)

    def make(self, name, *arguments):
        return run("make", self.object, "--quiet", "-o", self.out(name), *arguments)

    def test_what_was_found_is_written_and_found_again(self):
        self.assertEqual(self.make("a", "--optimize", "--threads", "1").returncode, 0)
        self.assertEqual(self.make("b", "--optimize", "--threads", "2").returncode, 0)
        report = self.report("a")
        search = report["search"]
        self.assertLess(search["cut_blocks"], search["start_cut_blocks"])
        self.assertEqual(search["cut_blocks"], report["foam"]["cut_blocks"])
        self.assertEqual(search["seed"], 1)
        self.assertFalse(search["cancelled"])
        for file in ("project.snug.json", "lower.stl", "depths.csv"):
            with open(os.path.join(self.out("a"), file), "rb") as one, \
                    open(os.path.join(self.out("b"), file), "rb") as other:
                self.assertEqual(one.read(), other.read(), file)
        # The project makes the same foams without another search.
        again = run("make", os.path.join(self.out("a"), "project.snug.json"), "--object", self.object,
                    "--quiet", "-o", self.out("c"))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(self.report("c")["foam"], report["foam"])
        self.assertNotIn("search", self.report("c"))

    def test_the_smallest_case_keeps_its_walls(self):
        self.assertEqual(self.make("auto", "--blocks", "auto").returncode, 0)
        self.assertEqual(self.make("case", "--fit-case", "--wall", "50").returncode, 0)
        case, auto = self.report("case"), self.report("auto")

        def blocks(report):
            x, y, z = report["design_space"]["blocks"]
            return x * y * z
        self.assertLessEqual(blocks(case), blocks(auto))
        self.assertGreaterEqual(min(case["wall_mm"]), 50)
        self.assertEqual(case["search"]["method"], "fit-case")

    def test_ctrl_c_keeps_the_best_so_far(self):
        with subprocess.Popen([PROGRAM, "make", self.object, "--quiet", "--optimize", "--search-seconds", "60",
                               "-o", self.out("cancelled")], stderr=subprocess.PIPE, text=True) as process:
            time.sleep(2)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 0, process.stderr.read())
        report = self.report("cancelled")
        self.assertTrue(report["search"]["cancelled"])
        self.assertLessEqual(report["search"]["cut_blocks"], report["search"]["start_cut_blocks"])

    def test_what_fits_in_no_orientation_is_said(self):
        done = self.make("none", "--optimize", "--blocks", "3x3x3")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("too long by", done.stderr)
        self.assertFalse(os.path.exists(self.out("none")))

    def test_wrong_words_are_answered(self):
        for arguments, words in ((("--objective", "speed"), "cut, gap, depth"),
                                 (("--objective", "cut=x"), "cut, gap, depth"),
                                 (("--objective", "cut=0"), "weight above 0"),
                                 (("--upright", "up"), "x, y, z"),
                                 (("--seed", "-3"), "--seed")):
            done = self.make("wrong", "--optimize", *arguments)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
