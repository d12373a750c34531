"""Guards against slower code: instructions of fixed work under callgrind, beside stored counts. Times on shared machines
say little; instructions say the same everywhere, as long as the compiler is the same.

Usage: instruction_counts.py SNUG_INSTRUCTIONS [--store]
"""

import json
import re
import subprocess
import sys
from pathlib import Path

PROGRAM = sys.argv[1]
STORED = Path(__file__).resolve().parent / "instruction_counts.json"
CASES = ["prepare", "plain", "columns-10", "columns-30", "columns-300", "read-stl", "read-obj"]
TOLERANCE = 0.05


def compiler():
    return subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True, check=True).stdout.strip()


def count(case):
    done = subprocess.run(["valgrind", "--tool=callgrind", "--toggle-collect=*measured*",
                           "--callgrind-out-file=/dev/null", PROGRAM, case], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not found:
        sys.exit(f"{case}: status {done.returncode}\n{done.stderr}")
    return int(found[1])


def main():
    counts = {case: count(case) for case in CASES}
    if "--store" in sys.argv:
        STORED.write_text(json.dumps({"compiler": compiler(), "instructions": counts}, indent=1) + "\n")
        return
    stored = json.loads(STORED.read_text())
    if stored["compiler"] != compiler():
        print(f"skipped: the counts are of g++ {stored['compiler']}, this is {compiler()}")
        return
    failed = 0
    for case in CASES:
        before, now = stored["instructions"][case], counts[case]
        change = now / before - 1
        wrong = abs(change) > TOLERANCE
        failed += wrong
        print(f"{case}: {now:,} instructions, {change:+.1%}{' FAILED' if wrong else ''}")
    if failed:
        print("More than 5 % more is a regression; where it is less or meant, store the counts: "
              "python3 tests/instruction_counts.py build/bench/snug_instructions --store")
    print(f"{len(CASES) - failed} passed, {failed} failed")
    sys.exit(failed > 0)


main()
