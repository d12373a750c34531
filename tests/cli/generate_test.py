"""`snug generate`: the manual page and what shells complete by have all that --help has, and the shells take them.

Usage: generate_test.py SNUG [unittest arguments]
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()
SHELLS = ("bash", "zsh", "fish")
# Says what bash would offer for the last of some words.
ASK_BASH = "COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _snug; printf '%s\\n' \"${{COMPREPLY[@]}}\""


def run(*command, **how):
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, **how)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def snug(*arguments):
    return run(SNUG, *arguments)


def flags_of_help(*command):
    return re.findall(r"^  (?:-\w,)?(--[a-z-]+)", snug(*command, "--help"), re.M)


def section(page, command):
    """What the manual page says of a command."""
    return page.split(f".SS snug {command}\n")[1].split("\n.S")[0].replace("\\-", "-")


class GenerateTest(unittest.TestCase):
    commands = re.findall(r"^  ([a-z]+) {2,}", snug("--help").split("Subcommands:")[1], re.M)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work, self.home = Path(folder.name) / "work", Path(folder.name) / "home"
        self.work.mkdir()
        self.home.mkdir()
        for kind in ("man", *SHELLS):
            (self.work / kind).write_text(snug("generate", kind))

    def offered_by_bash(self, *words):
        ask = ASK_BASH.format(words=" ".join(map(shlex.quote, words)))
        return run("bash", "-c", f"source ./bash; {ask}", cwd=self.work).split()

    def offered_by_fish(self, line):
        environment = os.environ | {"PATH": f"{SNUG.parent}:{os.environ['PATH']}", "HOME": str(self.home)}
        offered = run("fish", "-c", f"source ./fish; complete -C {shlex.quote(line)}", cwd=self.work, env=environment)
        return [each.split("\t")[0] for each in offered.splitlines()]

    def test_every_flag_of_every_command_is_there(self):
        page, zsh = ((self.work / kind).read_text() for kind in ("man", "zsh"))
        self.assertIn("generate", self.commands)
        self.assertGreater(len(flags_of_help("make")), 80)
        for command in self.commands:
            told = section(page, command)
            in_zsh = zsh.split(f"\n            {command})\n")[1].split(";;")[0]
            by_bash, by_fish = self.offered_by_bash("snug", command, "--"), self.offered_by_fish(f"snug {command} --")
            for flag in flags_of_help(command):
                self.assertIn(f"\\fB{flag}\\fR", told)
                self.assertIn(f"){flag}[", in_zsh.replace("*--", ")--"))
                self.assertIn(flag, by_bash)
                self.assertIn(flag, by_fish)

    def test_values_are_offered(self):
        (self.work / "vase.stl").touch()
        (self.work / "folder").mkdir()
        units = ["auto", "cm", "in", "m", "mm"]
        self.assertEqual(sorted(self.offered_by_bash("snug", "make", "--units", "")), units)
        self.assertEqual(sorted(self.offered_by_fish("snug make --units ")), units)
        self.assertEqual(self.offered_by_bash("snug", "ma"), ["make"])
        self.assertEqual(self.offered_by_bash("snug", "make", "-o", ""), ["folder"])
        self.assertEqual(self.offered_by_bash("snug", "make", "va"), ["vase.stl"])
        self.assertEqual(self.offered_by_bash("snug", "cases", "--for", "va"), ["vase.stl"])
        self.assertEqual(self.offered_by_fish("snug make va"), ["vase.stl"])
        # Nobody can list numbers.
        self.assertEqual(self.offered_by_bash("snug", "make", "--scale", ""), [])

    def test_the_shells_and_man_read_them(self):
        for shell in SHELLS:
            run(shell, "-n", shell, cwd=self.work)
        loaded = "autoload -U compinit; compinit -u -D; source ./zsh; print ${_comps[snug]}"
        self.assertIn("_snug", run("zsh", "-f", "-c", loaded, cwd=self.work))
        for language in ("en", "ja"):
            (self.work / "page").write_text(snug("generate", "man", "--language", language))
            run("mandoc", "-Tlint", "-Werror", "page", cwd=self.work)

    def test_the_page_says_each_exit_status(self):
        status = (self.work / "man").read_text().split(".SH EXIT STATUS\n")[1]
        self.assertEqual(re.findall(r"\\fB(\d)\\fR", status), list("012345"))

    def test_another_kind_is_refused(self):
        done = subprocess.run([SNUG, "generate", "csh"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("man, bash, zsh or fish", done.stderr)


if __name__ == "__main__":
    unittest.main()
