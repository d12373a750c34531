"""Runs the program on files that people have, which lie beside the repository, and compares with what is known of
each: expected.csv has a file, a command, its exit status, triangles and size."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop())
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "shared", "cases")
KNOWN = os.path.join(FOLDER, "expected.csv")
DIGITS = 5e-5  # of a size: 5 significant digits are known


def lines():
    with open(KNOWN, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def run(line, output):
    """Exit status, and the JSON that the program prints."""
    command, *options = line["command options"].split(" ")
    arguments = [PROGRAM, command, os.path.join(FOLDER, line["file"]), *options]
    if command == "make":
        arguments += ["--json", "-o", output]
    done = subprocess.run(arguments, capture_output=True, text=True, timeout=120, check=False)
    try:
        return done, json.loads(done.stdout)
    except ValueError:
        return done, None


def triangles_and_size(told):
    """Of `inspect`, or of the report of `make`."""
    entry = told if "triangles" in told else told["object"]
    return entry["triangles"], entry["size"] if "size" in entry else entry["size_mm"]


@unittest.skipUnless(os.path.isfile(KNOWN), "the files that people have are not here (../shared/cases)")
class PeopleFiles(unittest.TestCase):
    def expect(self, line, output):
        done, told = run(line, output)
        self.assertEqual(done.returncode, int(line["exit status"]), done.stderr)
        if line["triangles"] == "-":
            return
        triangles, size = triangles_and_size(told)
        self.assertEqual(triangles, int(line["triangles"]))
        if line["size_mm"] == "-":
            return
        for found, known in zip(size, map(float, line["size_mm"].split("x")), strict=True):
            self.assertLessEqual(abs(found - known), DIGITS * max(abs(known), 1e-12), line["size_mm"])

    def test_every_file_gives_what_is_known_of_it(self):
        for line in lines():
            with self.subTest(line["file"] + " " + line["command options"]), \
                    tempfile.TemporaryDirectory() as folder:
                self.expect(line, os.path.join(folder, "out"))


if __name__ == "__main__":
    unittest.main()
