"""A folder holds one run: what the next run takes away, what it never touches, and what kills leave.

Usage: cli_folder_test.py SNUG KILLED_AT_LIBRARY [unittest arguments]
"""

import fcntl
import functools
import hashlib
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from some_of import some_of
from ways import WAYS

SNUG, KILLED_AT = (Path(sys.argv.pop(1)).resolve() for _ in range(2))
LIST, UNFINISHED = ".snug-files", "UNFINISHED.txt"
PLAIN = {"lower.stl", "upper.stl", "lower.ply", "upper.ply", "depths.csv", "preview.svg", "report.json",
         "project.snug.json"}
TETRAHEDRON = "OFF\n4 4 6\n0 0 0\n60 0 0\n0 60 0\n0 0 60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
SEED = int(os.environ.get("SEED", 1))
# What differs from run to run: times, and the dates in PDF and in containers.
VARYING = (".pdf", ".3mf", "report.json")


def contents(folder):
    """Every file below a folder by its name, without the list of what was made."""
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in Path(folder).rglob("*") if path.is_file() and path.name != LIST}


def listed(folder):
    return {line.split(" ", 2)[2]: line.split(" ", 2)[:2] for line in (folder / LIST).read_text().splitlines()[1:]
            if not line.startswith("#")}


def line(name, content):
    return f"{hashlib.sha256(content).hexdigest()} {len(content)} {name}\n"


class FolderTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.object = self.work / "tetrahedron.off"
        self.object.write_text(TETRAHEDRON)
        self.out = self.work / "out"

    def run_make(self, *arguments, out=None, **options):
        return subprocess.run([SNUG, "make", self.object, *arguments, "-o", out or self.out], capture_output=True,
                              text=True, timeout=120, **options)

    def make(self, *arguments, **options):
        done = self.run_make(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    @functools.cache
    def fresh(self, *arguments):
        folder = Path(tempfile.mkdtemp(dir=self.work))
        self.make(*arguments, out=folder)
        return contents(folder)

    def assertSame(self, found, wanted, message=None):
        """As assertEqual(), which takes minutes to show how two foams differ."""
        self.assertEqual(set(found), set(wanted), message)
        self.assertEqual([name for name in wanted if found[name] != wanted[name]], [], message)

    def assertHolds(self, folder, fresh, *others):
        found = contents(folder)
        self.assertEqual(set(found), set(fresh) | set(others))
        for name in fresh:
            if not name.endswith(VARYING):
                self.assertTrue(found[name] == fresh[name], name)
        self.assertEqual({path for path in folder.rglob("*") if path.is_dir() and not any(path.iterdir())}, set())

    # ---- what goes

    def test_what_a_run_made_and_the_next_does_not_make_goes(self):
        for work in WAYS:
            self.make("--for", work)
            self.assertHolds(self.out, self.fresh("--for", work))
        self.make("--formats", "stl")
        self.assertHolds(self.out, self.fresh("--formats", "stl"))

    def test_the_list_names_every_file_with_its_bytes_and_hash(self):
        self.make("--for", "sponge")
        found = contents(self.out)
        self.assertEqual({name: [hashlib.sha256(content).hexdigest(), str(len(content))]
                          for name, content in found.items()}, listed(self.out))

    def test_it_says_what_went_and_nothing_where_nothing_did(self):
        self.assertNotIn("earlier", self.make("--for", "mill").stdout)
        self.assertNotIn("earlier", self.make("--for", "mill").stdout)
        report = json.loads(self.make("--json").stdout)
        self.assertEqual([f["code"] for f in report["findings"] if f["code"].startswith("earlier")], ["earlier_files"])

    def test_what_others_wrote_under_a_name_that_is_made_stays_beside_it(self):
        self.out.mkdir()
        (self.out / "depths.csv").write_text("my notes")
        report = json.loads(self.make("--json").stdout)
        self.assertIn("earlier_files_kept", [f["code"] for f in report["findings"]])
        self.assertHolds(self.out, self.fresh(), "depths.csv.old")
        with open(self.out / "depths.csv", "a") as file:
            file.write("a line of mine")
        self.make()
        self.assertHolds(self.out, self.fresh(), "depths.csv.old", "depths.csv.old2")
        self.assertEqual((self.out / "depths.csv.old").read_text(), "my notes")
        self.assertTrue((self.out / "depths.csv.old2").read_text().endswith("a line of mine"))
        self.assertNotIn("earlier", self.make().stdout)

    def test_the_object_is_never_written_over(self):
        self.out.mkdir()
        stl = self.out / "upper.stl"
        subprocess.run([SNUG, "sample", "torus", "-o", stl], check=True, capture_output=True)
        before = contents(self.out)
        done = subprocess.run([SNUG, "make", stl, "-o", self.out], capture_output=True, text=True)
        self.assertEqual((done.returncode, contents(self.out)), (4, before), done.stderr)
        self.assertIn("would write over it", done.stderr)

    def test_leftovers_of_killed_runs_go_and_those_of_living_ones_stay(self):
        ended = subprocess.Popen(["true"])
        ended.wait()
        self.make("--for", "print")
        (self.out / "sponge").mkdir()
        dead = [self.out / f"{place}.lower.stl.{ended.pid}.part" for place in ["", "print/", "sponge/"]]
        alive = self.out / f".lower.stl.{os.getpid()}.part"
        others = [self.out / name for name in [".part", ".lower.part", f"lower.stl.{ended.pid}.part", ".lower.stl.x.part",
                                               f"..{ended.pid}x.part", ".lower.stl.-1.part", ".lower.stl.0.part"]]
        for path in [*dead, alive, *others]:
            path.write_text("begun")
        self.make()
        self.assertHolds(self.out, self.fresh(), alive.name, *(path.name for path in others))

    # ---- what stays

    def test_what_a_person_changed_or_added_stays_and_is_said(self):
        self.make("--for", "mill")
        program = self.out / "mill" / "lid-outside.nc"
        program = program if program.exists() else sorted((self.out / "mill").glob("*.nc"))[0]
        as_written = program.read_bytes()
        program.write_bytes(as_written + b"(mine)\n")
        (self.out / "mill" / "notes.txt").write_text("mine")
        (self.out / "lower.off").write_text("mine")
        name = program.relative_to(self.out).as_posix()
        for _ in range(2):
            done = self.make()
            self.assertIn("not as they were written: 1 file", done.stdout)
            self.assertIn(name, done.stdout)
            self.assertHolds(self.out, self.fresh(), name, "mill/notes.txt", "lower.off")
        program.write_bytes(as_written)
        self.make()
        self.assertHolds(self.out, self.fresh(), "mill/notes.txt", "lower.off")

    def test_files_of_before_there_was_a_list_stay(self):
        self.make("--for", "print")
        (self.out / LIST).unlink()
        before = set(contents(self.out))
        self.make()
        # Who wrote them cannot be known: nothing goes, and what is made anew keeps its predecessor.
        self.assertEqual(set(contents(self.out)), before | {f"{name}.old" for name in PLAIN})

    def test_what_the_run_reads_stays(self):
        self.make("--for", "mill")
        done = subprocess.run([SNUG, "make", self.out / "lower.stl", "--formats", "ply", "-o", self.out],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("because this run read them: 1 file", done.stdout)
        self.assertTrue((self.out / "lower.stl").exists())
        self.assertFalse((self.out / "upper.stl").exists())

    def test_a_run_that_fails_takes_nothing_away(self):
        self.make("--for", "print")
        left = self.out / ".x.stl.999999999.part"
        left.write_text("begun")
        before = contents(self.out)

        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

        for arguments, status, options in [(["--blocks", "2x2x2"], 3, {}), (["--blocks", "2"], 1, {}),
                                           (["--rotate", "0,45,0"], 4, {"preexec_fn": little_room})]:
            self.assertEqual(self.run_make(*arguments, **options).returncode, status)
            self.assertSame(contents(self.out), before)
        (self.out / "depths.csv").unlink()
        (self.out / "depths.csv").mkdir()
        self.assertEqual(self.run_make().returncode, 4)
        self.assertEqual(set(contents(self.out)), set(before) - {"depths.csv"})
        self.assertEqual(self.run_make("--dry-run").returncode, 0)
        self.assertEqual(set(contents(self.out)), set(before) - {"depths.csv"})

    def test_a_run_that_is_interrupted_takes_nothing_away(self):
        self.make("--for", "print")
        before = contents(self.out)
        random.seed(SEED)
        for _ in some_of(range(8), 2):
            process = subprocess.Popen([SNUG, "make", self.object, "--formats", "stl", "-o", self.out],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(random.uniform(0.005, 0.08))
            process.send_signal(signal.SIGINT)
            if process.wait(timeout=60) != 0:
                self.assertSame(contents(self.out), before, f"SEED={SEED}")
            else:  # it was done before it was asked to stop
                self.make("--for", "print")
                before = contents(self.out)

    def test_a_folder_that_may_not_be_written_to(self):
        self.make("--for", "print")
        before = contents(self.out)
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        (self.out / "print").chmod(0o555)
        self.assertIn("may not be written to", self.make().stdout)
        self.out.chmod(0o555)
        self.assertEqual(self.run_make().returncode, 4)
        self.out.chmod(0o755)
        (self.out / "print").chmod(0o755)
        self.assertLessEqual({name for name in before if name.startswith("print/")}, set(contents(self.out)))

    # ---- lists and links that want to reach out

    def test_no_list_reaches_out_of_the_folder(self):
        outside = self.work / "outside"
        outside.mkdir()
        mine = outside / "mine.txt"
        mine.write_text("mine")
        inside = self.out / "kept.txt"
        self.make()
        head = (self.out / LIST).read_text()
        for name in ["../outside/mine.txt", str(mine), f"/{mine}", "print/../../outside/mine.txt", "./kept.txt", "..",
                     "kept.txt/", "", ".hidden", "kept\x01.txt"]:
            with self.subTest(name=name[:40]):
                inside.write_text("mine")
                (self.out / LIST).write_text(head + line("kept.txt", b"mine") + line(name, b"mine"))
                self.assertIn("is damaged or of", self.make().stdout)
                self.assertEqual((mine.read_text(), inside.read_text()), ("mine", "mine"))
                self.assertEqual(set(listed(self.out)), PLAIN)

    def test_lists_that_are_none_take_nothing_away(self):
        self.make()
        whole = (self.out / LIST).read_bytes() + line("kept.txt", b"mine").encode()
        (self.out / "kept.txt").write_text("mine")
        hostile = [b"", b"\n", b"snug files 2\n" + whole, whole[:-1], bytes(5000), whole.replace(b"snug", b"snag"),
                   whole.replace(b" 4 kept", b" 99999999999999999999 kept"), whole.replace(b" 4 kept", b" -4 kept"),
                   whole + b"#" * (17 << 20) + b"\n"]
        for content in hostile:
            (self.out / LIST).write_bytes(content)
            self.assertIn("damaged", self.make().stdout)
            self.assertEqual((self.out / "kept.txt").read_text(), "mine")
        (self.out / LIST).unlink()
        (self.out / LIST).symlink_to(self.object)
        self.make()
        self.assertEqual(self.object.read_text(), TETRAHEDRON)
        (self.out / LIST).unlink()
        os.mkfifo(self.out / LIST)
        self.make()
        (self.out / LIST).write_bytes(whole)
        self.make()
        self.assertFalse((self.out / "kept.txt").exists(), "the list itself was good")

    def test_no_link_is_followed_out_of_the_folder(self):
        outside = self.work / "outside"
        self.make("--for", "mill")
        (self.out / "mill").rename(outside)
        (self.out / "mill").symlink_to(outside)
        (outside / f".x.{999999999}.part").write_text("begun")
        mine = self.work / "mine.pdf"
        (self.out / "packing-sheet.pdf").rename(mine)
        (self.out / "packing-sheet.pdf").symlink_to(mine)
        before = contents(outside)
        self.assertIn("not as they were written", self.make().stdout)
        self.assertSame(contents(outside), before)
        self.assertTrue(mine.exists())

    def test_a_link_in_the_place_of_a_temporary_file_is_not_written_through(self):
        mine = self.work / "mine"
        mine.write_text("mine")
        self.out.mkdir()
        # The next process that is started has one of the next numbers.
        for pid in range(os.getpid(), os.getpid() + 300):
            (self.out / f".lower.stl.{pid}.part").symlink_to(mine)
        self.make()
        self.assertEqual(mine.read_text(), "mine")

    def test_a_file_with_the_name_of_the_warning_is_not_lost(self):
        self.make("--for", "mill")
        before = set(contents(self.out))
        (self.out / UNFINISHED).write_text("mine")
        done = self.run_make()
        self.assertEqual(done.returncode, 4)
        self.assertIn(UNFINISHED, done.stderr)
        self.assertEqual((self.out / UNFINISHED).read_text(), "mine")
        self.assertEqual(set(contents(self.out)), before | {UNFINISHED})

    # ---- kills, and two at once

    def killed(self, at, folder, arguments):
        done = self.run_make(*arguments, out=folder, env=os.environ | {"LD_PRELOAD": str(KILLED_AT), "KILLED_AT": str(at)})
        self.assertEqual(done.returncode, -signal.SIGKILL, done.stderr)

    def look_at_kill(self, at, first, second, arguments):
        """Kills the second run into a folder before its at-th change, looks, and lets a run end there."""
        folder = self.work / f"killed-{at}"
        shutil.copytree(self.work / "first", folder)
        self.killed(at, folder, arguments)
        found = contents(folder)
        names = {name for name in found if not name.endswith(".part")} - {UNFINISHED}
        for name in names - {"mine.txt", "mill/board.nc"}:
            if not name.endswith(VARYING):
                self.assertTrue(any(found[name] == run.get(name) for run in (first, second)), name)
        new = any(found[name] != first.get(name) for name in names - {"mine.txt", "mill/board.nc"})
        old = any(name in first and name not in second for name in names - {"mill/board.nc"})
        if new and old:
            self.assertIn(UNFINISHED, found, "a mix without a warning")
        if not new:
            self.assertEqual(names, set(first) | {"mine.txt"}, "nothing goes before the new files are there")
        if UNFINISHED in found:
            self.assertIn("stopped before it had finished", self.make(*arguments, out=folder).stdout)
        else:
            self.make(*arguments, out=folder)
        self.assertHolds(folder, second, "mine.txt", "mill/board.nc")
        self.assertEqual((folder / "mine.txt").read_text(), "mine")
        self.assertEqual((folder / "mill/board.nc").read_text(), "changed")
        shutil.rmtree(folder)

    def test_a_kill_before_any_change_leaves_what_the_next_run_puts_right(self):
        first_folder, counted = self.work / "first", self.work / "counted"
        self.make("--for", "mill", out=first_folder)
        (first_folder / "mine.txt").write_text("mine")
        (first_folder / "mill/board.nc").write_text("changed")
        first = contents(first_folder)
        del first["mine.txt"]
        arguments = ["--for", "sponge", "--formats", "stl", "--rotate", "0,0,30"]
        second = self.fresh(*arguments)
        shutil.copytree(first_folder, self.work / "whole")
        self.make(*arguments, out=self.work / "whole",
                  env=os.environ | {"LD_PRELOAD": str(KILLED_AT), "COUNTED": str(counted)})
        changes = int(counted.read_text())
        self.assertGreater(changes, 2 * len(second), "every file is made and renamed")
        with ThreadPoolExecutor(2) as pool:
            # While files are written beside their places each moment is like the others.
            moments = [*range(1, changes // 2, 4), *range(changes // 2, changes + 1)]
            for done in [pool.submit(self.look_at_kill, at, first, second, arguments) for at in some_of(moments, 8)]:
                done.result()

    def test_kills_one_after_another_lose_nothing_of_what_is_known(self):
        random.seed(SEED)
        works = [["--for", work] for work in ["mill", "sponge", "print"]] + [["--formats", "ply"]]
        self.make("--for", "mill")
        for _ in some_of(range(8), 3):
            arguments = random.choice(works)
            self.run_make(*arguments, env=os.environ | {"LD_PRELOAD": str(KILLED_AT),
                                                        "KILLED_AT": str(random.randint(20, 60))})
        self.make("--for", "sheets")
        self.assertHolds(self.out, self.fresh("--for", "sheets"))

    def test_two_at_once_leave_one_run(self):
        wanted = {work: self.fresh("--for", work) for work in ["mill", "sponge"]}
        for _ in range(3):
            both = [subprocess.Popen([SNUG, "make", self.object, "--for", work, "-o", self.out, "--quiet"])
                    for work in wanted]
            self.assertEqual([process.wait(timeout=60) for process in both], [0, 0])
            last = "mill" if (self.out / "mill").exists() else "sponge"
            self.assertHolds(self.out, wanted[last])

    def test_a_run_waits_while_another_finishes(self):
        self.make("--for", "mill")
        before = contents(self.out)
        folder = os.open(self.out, os.O_RDONLY)
        fcntl.flock(folder, fcntl.LOCK_EX)
        process = subprocess.Popen([SNUG, "make", self.object, "-o", self.out, "--quiet"])
        time.sleep(1)
        self.assertIsNone(process.poll())
        self.assertSame({name: content for name, content in contents(self.out).items() if not name.endswith(".part")},
                        before)
        os.close(folder)
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertHolds(self.out, self.fresh())


if __name__ == "__main__":
    unittest.main()
