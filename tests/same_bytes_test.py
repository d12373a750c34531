"""The same input gives the same bytes: g++ build, clang build and WebAssembly under node.

Usage: same_bytes_test.py SNUG_GCC SNUG_CLANG WASM_FOLDER
"""

import filecmp
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MODELS = Path(os.environ.get("SNUG_MODELS", HERE.parent.parent / "shared" / "models"))

SAMPLE_CASES = [
    ("torus", []),
    ("vase", ["--rotate", "12.3,45.6,-78.9", "--clearance", "1.5"]),
    ("camera", ["--rotate", "30,0,60", "--blocks", "auto", "--preset", "slit-12.7"]),
    ("figurine", ["--blocks", "90x54x54", "--block-size", "5x5x7.3", "--cut-on-touch", "--parting", "40"]),
]
MODEL_CASES = [
    ("stanford-bunny.obj", ["--units", "m", "--rotate", "33,-71,158", "--cap"]),
    ("armadillo.obj", ["--longest", "170", "--rotate", "1,2,3", "--blocks", "300x180x180", "--block-size", "1.5x1.5x2.2"]),
    ("beetle-alt.obj", ["--longest", "240", "--rotate", "0,90,0", "--clearance", "-2"]),
]


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout}{done.stderr}")


def comparable(folder):
    """Report and all, with the one thing that may differ taken out."""
    report = folder / "report.json"
    content = json.loads(report.read_text())
    del content["timing_ms"]
    report.write_text(json.dumps(content))
    return sorted(path.name for path in folder.iterdir())


def check(programs, wasm, path, options, work):
    folders = []
    for number, program in enumerate(programs):
        folders.append(work / f"native{number}")
        run([program, "make", path, *options, "-o", folders[-1], "--quiet"])
    folders.append(work / "wasm")
    run(["node", HERE / "make_with_wasm.mjs", wasm, path, folders[0] / "project.snug.json", folders[-1]])
    names = [comparable(folder) for folder in folders]
    for folder, found in zip(folders[1:], names[1:]):
        if found != names[0]:
            sys.exit(f"{path.name} {options}: {found} instead of {names[0]}")
        _, different, errors = filecmp.cmpfiles(folders[0], folder, names[0], shallow=False)
        if different or errors:
            sys.exit(f"{path.name} {options}: {different + errors} differ in {folder}")
    print(f"{path.name} {' '.join(options)}: {len(names[0])} files equal", flush=True)


def main():
    programs, wasm = [Path(p).resolve() for p in sys.argv[1:3]], Path(sys.argv[3]).resolve()
    cases = []
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        for name, options in SAMPLE_CASES:
            path = work / f"{name}.ply"
            run([programs[0], "sample", name, "-o", path])
            cases.append((path, options))
        if MODELS.is_dir():
            cases += [(MODELS / name, options) for name, options in MODEL_CASES]
        else:
            print(f"skipped: the models are not at {MODELS}")
        for number, (path, options) in enumerate(cases):
            folder = work / str(number)
            folder.mkdir()
            check(programs, wasm, path, options, folder)
    print(f"{len(cases)} passed, 0 failed")


main()
