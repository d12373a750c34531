"""Guards against slower code: instructions of fixed work under callgrind, beside stored counts. Times on shared machines
say little; instructions say the same everywhere, as long as the compiler is the same.

Usage: instruction_counts.py SNUG_INSTRUCTIONS [--store]
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM = sys.argv[1]
STORED = Path(__file__).resolve().parent / "instruction_counts.json"
TOLERANCE = 0.05


def compiler():
    return subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True, check=True).stdout.strip()


def counts():
    """By case, in the program's order: one dump each, named by what triggered it."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["valgrind", "--tool=callgrind", "--instr-atstart=no",
                               f"--callgrind-out-file={folder}/counts", PROGRAM], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"status {done.returncode}\n{done.stderr}")
        found = {}
        for number in range(1, len(done.stdout.splitlines()) + 1):
            dump = (Path(folder) / f"counts.{number}").read_text()
            name = re.search(r"^desc: Trigger: Client Request: (.*)$", dump, re.MULTILINE)[1]
            found[name] = int(re.search(r"^totals: (\d+)$", dump, re.MULTILINE)[1])
    return found


def verdict(name, now, before):
    """A line, and whether the case passed."""
    if before is None:
        return f"{name}: {now:,} instructions, not stored FAILED", False
    change = now / before - 1
    wrong = "FAILED: slower" if change > TOLERANCE else "FAILED: faster, store it" if change < -TOLERANCE else ""
    return f"{name}: {now:,} instructions, {change:+.1%} {wrong}".rstrip(), not wrong


def main():
    stored = json.loads(STORED.read_text())
    if "--store" in sys.argv:
        STORED.write_text(json.dumps({"compiler": compiler(), "instructions": counts()}, indent=1) + "\n")
        return
    if stored["compiler"] != compiler():
        print(f"skipped: the counts are of g++ {stored['compiler']}, this is {compiler()}")
        return
    now, before = counts(), stored["instructions"]
    failed = 0
    for name in now | before:
        line, passed = verdict(name, now[name], before.get(name)) if name in now else (f"{name}: gone FAILED", False)
        failed += not passed
        print(line)
    if failed:
        print("More than 5 % more is a regression; where it is less, or meant, store the new counts: "
              "python3 tests/instruction_counts.py build/bench/snug_instructions --store")
    print(f"{len(now | before) - failed} passed, {failed} failed")
    sys.exit(failed > 0)


main()
