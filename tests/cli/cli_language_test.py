"""What the program says with --language ja: Japanese alone, whatever goes well or wrong; PDFs with any letters.

Usage: cli_language_test.py SNUG [unittest arguments]
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
JAPANESE = re.compile("[\u3040-\u30ff\u4e00-\u9fff]")
# Two words of English beside each other: no name of a file, an option or a unit is that.
ENGLISH = re.compile(r"(?<![-\w./`\"])[A-Za-z]?[a-z]{2,} [a-z]{2,}(?![\w./-])")
DEJAVU = next(iter(Path("/usr/share/fonts").rglob("DejaVuSans.ttf")), None)


def snug(*arguments, config=None):
    environment = os.environ | ({"XDG_CONFIG_HOME": str(config)} if config else {})
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=240, env=environment)


def text_of(pdf):
    return subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout


class LanguageTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.vase = self.work / "vase.stl"
        self.assertEqual(snug("sample", "vase", "-o", self.vase).returncode, 0)

    def japanese(self, *arguments, status=0, config=None):
        """What is said, which is Japanese; the same status as in English, where other words are said."""
        done = snug(*arguments, "--language", "ja", config=config)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, status, said)
        self.assertRegex(said, JAPANESE, arguments)
        plain = said.replace(str(self.work), "")
        self.assertEqual(ENGLISH.findall(re.sub(r"`[^`]*`|\"[^\"]*\"|--\S+ \w+", "", plain)), [], said)
        english = snug(*arguments, config=config)
        self.assertEqual(english.returncode, status, english.stderr)
        self.assertNotRegex(english.stdout + english.stderr, JAPANESE, arguments)
        return said

    def test_every_command_speaks_japanese(self):
        self.assertIn("閉じている", self.japanese("inspect", self.vase))
        self.assertIn("切り取り", self.japanese("make", self.vase, "-o", self.work / "a"))
        self.japanese("sample", "torus", "-o", self.work / "torus.stl")
        self.japanese("make", self.vase, "--for", "sponge", "--preset", "slit-15", "--price", "12EUR", "--dry-run",
                      "--blocks", "auto", "-o", self.work / "b")
        self.japanese("cases", "--for", self.vase, "--wall", "25")
        self.assertIn("段ボール箱", snug("cases", "--language", "ja").stdout)
        presets = snug("presets", "--language=ja").stdout
        self.assertEqual(sum(1 for line in presets.splitlines()[1:13] if JAPANESE.search(line)), 12, presets)

    def test_every_help_is_japanese(self):
        for command in ((), ("make",), ("plan",), ("inspect",), ("sample",), ("shape",), ("presets",), ("cases",), ("studio",), ("generate",)):
            said = snug(*command, "--help", "--language", "ja").stdout
            lines = said.split("例：")[0].splitlines()
            for line in lines:
                if re.match(r" {10,}|  -|[^ ]", line) and not re.match(r"  -[^ ]* ?[^ ]*( .{0,30})?$", line):
                    self.assertRegex(line, JAPANESE, command)
            self.assertEqual(ENGLISH.findall(re.sub(r"`[^`]*`|: snug \w+", "", "\n".join(lines))), [], said)
            self.assertIn("snug ", said.split("例：")[1])

    def test_what_is_wrong_is_said_in_japanese(self):
        config = self.work / "config" / "snug"
        config.mkdir(parents=True)
        torn, newer, odd = self.work / "torn.stl", self.work / "newer.snug.json", self.work / "odd.snug.json"
        torn.write_bytes(b"nothing")
        project = {"snug": 2, "object": {"name": "vase.stl"}, "design": {}}
        newer.write_text(json.dumps(project))
        odd.write_text(json.dumps(project | {"snug": 1, "design": {"fit": {"least_rib_mm": "x", }}}))
        out = ("-o", self.work / "out")
        for status, arguments in (
                (1, ()), (1, ("make",)), (1, ("make", self.vase)), (1, ("make", self.vase, *out, "--nonsense", "x")),
                (1, ("make", self.vase, *out, "--threads", "many")), (1, ("make", self.vase, *out, "--wall")),
                (1, ("make", self.vase, *out, "--stream", "--no-stream")), (1, ("cases", "--mass", "2")),
                (1, ("make", self.vase, *out, "--blocks", "three")), (1, ("make", self.vase, *out, "--wall", "-1")),
                (1, ("make", self.vase, *out, "--units", "miles")), (1, ("make", self.vase, *out, "--preset", "x")),
                (1, ("make", self.vase, *out, "--case", "x")), (1, ("make", self.vase, *out, "--clearance", "-9")),
                (1, ("make", self.vase, *out, "--paper", "b5")), (1, ("make", self.vase, *out, "--set", "a.b=1")),
                (1, ("make", self.vase, *out, "--notch-at", "3")), (1, ("make", self.vase, *out, "--objective", "x")),
                (1, ("make", self.vase, *out, "--brick-sizes", "9x9")), (1, ("sample", "teapot", *out)),
                (1, ("make", self.vase, *out, "--case", "300x200x100:400")), (1, ("inspect",)),
                (2, ("make", self.work / "none.stl", *out)), (2, ("make", torn, *out)), (2, ("inspect", torn)),
                (2, ("make", newer, *out)), (2, ("make", odd, *out)), (2, ("studio", "--files", self.work)),
                (3, ("make", self.vase, *out, "--blocks", "2x2x2")), (4, ("make", self.vase, "-o", self.vase)),
                (3, ("cases", "--for", self.vase, "--wall", "3000"))):
            with self.subTest(arguments):
                self.japanese(*arguments, status=status)
        (config / "cases.csv").write_text("name,length_mm,width_mm,height_mm\nours,300,x,100\n")
        self.assertIn("width_mm", self.japanese("cases", "--for", self.vase, config=config.parent))
        (config / "presets.json").write_text('[{"name": "ours", "block_mm": 3}]')
        self.assertIn("block_mm", self.japanese("presets", config=config.parent, status=1))

    def test_the_language_is_english_unless_asked_for_and_one_of_two(self):
        wrong = snug("inspect", self.vase, "--language", "fr")
        self.assertEqual((wrong.returncode, wrong.stderr), (1, 'snug: --language takes en or ja, not "fr"\n'))
        for language in ("ja_JP.UTF-8", "C"):
            done = subprocess.run([SNUG, "inspect", self.vase], capture_output=True, text=True,
                                  env=os.environ | {"LANG": language, "LC_ALL": language, "LANGUAGE": "ja"})
            self.assertEqual(done.stdout, snug("inspect", self.vase, "--language=en").stdout)

    def test_machines_read_the_same_names_in_both(self):
        torn = self.work / "open.off"
        torn.write_text("OFF\n4 4 0\n0 0 0\n90 0 0\n0 90 0\n0 0 90\n3 0 1 2\n3 0 1 3\n3 0 2 3\n2 0 1\n")
        english, japanese = (json.loads(snug("inspect", torn, "--json", "--language", each).stdout)
                             for each in ("en", "ja"))
        self.assertGreater(len(english["findings"]), 0)
        for a, b in zip(english.pop("findings"), japanese.pop("findings"), strict=True):
            self.assertEqual((a["code"], a["severity"]), (b["code"], b["severity"]))
            self.assertRegex(b["message"], JAPANESE)
        self.assertEqual(english, japanese)
        for command in (("presets",), ("cases", "--csv"), ("cases", "--json")):
            if command != ("presets",):
                self.assertEqual(snug(*command).stdout, snug(*command, "--language", "ja").stdout)

    def make_sponge(self, name, *arguments):
        """The text of a pack's PDFs, and what was said."""
        path, out = self.work / name, self.work / "out"
        if path != self.vase:
            shutil.copy(self.vase, path)
        done = snug("make", path, "--for", "sponge", "--blocks", "auto", "-o", out, *arguments)
        return done, [text_of(pdf) for pdf in sorted(out.rglob("*.pdf"))] if done.returncode == 0 else []

    def test_pages_show_names_in_any_script(self):
        for name in ("銅鐸.stl", "Ваза.stl", "Αγγείο.stl", "vase.stl"):
            with self.subTest(name):
                done, pages = self.make_sponge(name)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertGreater(len(pages), 2)
                for page in pages:
                    self.assertIn(name.split(".")[0], page)
                self.assertNotIn("question marks", done.stdout)

    def test_a_letter_that_no_font_has_is_told(self):
        done, pages = self.make_sponge("𐎀𐎁.stl")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("??", pages[0])
        self.assertIn("no font was found that has 𐎀𐎁", re.sub(r"\s+", " ", done.stdout))
        findings = json.loads((self.work / "out" / "report.json").read_text())["findings"]
        self.assertIn("letters_missing", [finding["code"] for finding in findings])

    @unittest.skipUnless(DEJAVU, "a TrueType font without Japanese is not there")
    def test_japanese_pages_need_a_font_that_has_japanese(self):
        done, _ = self.make_sponge("壺.stl", "--language", "ja", "--font", DEJAVU)
        self.assertEqual(done.returncode, 4, done.stdout)
        self.assertIn("apt install fonts-ipafont-gothic", done.stderr)
        self.assertRegex(done.stderr, JAPANESE)
        self.assertFalse((self.work / "out").exists(), "nothing is written")

    def test_a_chosen_font_must_be_one(self):
        done, _ = self.make_sponge("壺.stl", "--font", self.vase)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("vase.stl: this is no TrueType font", done.stderr)


if __name__ == "__main__":
    unittest.main()
