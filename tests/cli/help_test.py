"""Runs every example of every --help as it is printed, in the order in which it is printed.

Usage: help_test.py SNUG
"""

import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

SNUG = Path(sys.argv[1]).resolve()
# What the examples begin with, as a person would have it: (file, sample, unit in mm).
OBJECTS = {"vase.stl": ("vase", 1), "camera.stl": ("camera", 1), "scan.ply": ("figurine", 1000)}


def run(command, work):
    environment = os.environ | {"PATH": f"{SNUG.parent}:{os.environ['PATH']}"}
    return subprocess.run(command, shell=True, cwd=work, capture_output=True, text=True, env=environment, timeout=300)


def help_of(*command):
    return subprocess.run([SNUG, *command, "--help"], capture_output=True, text=True).stdout


def examples_of(text):
    """The lines behind "Example:" or "Examples:"; one that goes on in the next line is joined."""
    found = re.search(r"^Examples?:(.*)", text, re.S | re.M)
    return [line.strip() for line in found[1].splitlines() if line.strip().startswith("snug ")] if found else []


def write_object(name, work):
    """A sample as a file; a scan in metres is written by a reader and a writer of our own."""
    sample, unit = OBJECTS[name]
    if unit == 1:
        return run(f"snug sample {sample} -o {name}", work)
    done = run(f"snug sample {sample} -o metres.obj", work)
    vertices, faces = [], []
    for line in (work / "metres.obj").read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append(" ".join(str(float(word) / unit) for word in words[1:4]))
        if words[:1] == ["f"]:
            faces.append("3 " + " ".join(str(int(word.split("/")[0]) - 1) for word in words[1:4]))
    (work / name).write_text(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\nproperty float x\n"
                             f"property float y\nproperty float z\nelement face {len(faces)}\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             + "\n".join(vertices + faces) + "\n")
    return done


def serves(command, work):
    """`snug studio` says where it is and goes on until Ctrl-C."""
    with subprocess.Popen([SNUG, *shlex.split(command)[1:]], cwd=work, stdout=subprocess.PIPE, text=True) as process:
        said = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        process.wait(30)
    return "http://127.0.0.1" in said


def main():
    commands = re.findall(r"^  ([a-z]+) {2,}", help_of().split("Subcommands:")[1], re.M)
    if len(commands) < 6:
        sys.exit("the help has lost its commands")
    count = 0
    for command in [(), *((each,) for each in commands)]:
        examples = examples_of(help_of(*command))
        if not examples:
            sys.exit(f"snug {' '.join(command)} --help has no example")
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            for name in OBJECTS:
                if any(re.search(rf"(?<![/\w]){re.escape(name)}", each) and f"-o {name}" not in each for each in examples):
                    if (done := write_object(name, work)).returncode != 0:
                        sys.exit(done.stderr)
            for example in examples:
                if example.startswith("snug studio"):
                    if not (Path(__file__).resolve().parents[2] / "studio" / "dist").exists():
                        print(f"{example}: passed over, the studio is not built")
                    elif not serves(example, work):
                        sys.exit(f"{example}: says no address")
                    continue
                done = run(example, work)
                if done.returncode != 0:
                    sys.exit(f"{example}: status {done.returncode}\n{done.stderr}")
                count += 1
    print(f"{count} passed, 0 failed")


main()
