"""Foams from a scan of 100,000,000 triangles that is read in pieces, beside plain reads of the same file.

Usage: large_scan_times.py BUILD FOLDER [TRIANGLES]   (prints JSON; FOLDER needs 7 GB for a while)

Cold: the file is not in memory, where this program may empty the system's cache; warm: it is.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

BUILD, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
TRIANGLES = int(sys.argv[3]) if len(sys.argv) > 3 else 100_000_000
TURNS = 3


def emptied():
    """Whether the system's cache of files could be emptied."""
    os.sync()
    try:
        Path("/proc/sys/vm/drop_caches").write_text("3")
        return True
    except OSError:
        return False


def timed(command):
    """Seconds, and the most memory that was resident, in MB."""
    begun = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{command}: status {status}")
    return time.monotonic() - begun, usage.ru_maxrss * 1024 / 1e6


def measured(path, out):
    plain = ["cat", path]
    make = [BUILD / "snug", "make", path, "--stream", "--quiet", "--blocks", "auto", "-o", out]
    result = {"bytes": path.stat().st_size, "triangles": TRIANGLES}
    for state in ("cold", "warm"):
        reads, runs = [], []
        for _ in range(TURNS):
            if state == "cold" and not emptied():
                break
            reads.append(timed(plain)[0])
            if state == "cold":
                emptied()
            runs.append(timed(make))
        if runs:
            result[state] = {"plain_s": median(reads), "snug_s": median(run[0] for run in runs)}
            result["resident_mb"] = max(run[1] for run in runs)
    return result


def main():
    with tempfile.TemporaryDirectory(dir=FOLDER) as work:
        results = {}
        for ending in ("stl", "ply"):
            path = Path(work) / f"scan.{ending}"
            subprocess.run([BUILD / "bench" / "snug_large_scan", path, str(TRIANGLES)], check=True)
            results[ending] = measured(path, Path(work) / "out")
            path.unlink()
    print(json.dumps(results, indent=1))


main()
