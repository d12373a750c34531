"""The same input gives the same bytes: g++ build, clang build and WebAssembly under node.

Usage: same_bytes_test.py SNUG_GCC SNUG_CLANG WASM_FOLDER
"""

import io
import json
import os
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
MODELS = Path(os.environ.get("SNUG_MODELS", HERE.parent.parent / "shared" / "models"))

SAMPLE_CASES = [
    ("torus", []),
    ("vase", ["--rotate", "12.3,45.6,-78.9", "--clearance", "1.5"]),
    ("camera", ["--rotate", "30,0,60", "--blocks", "auto", "--preset", "slit-12.7"]),
    ("vase", ["--for", "sponge", "--paper", "letter", "--mass", "2"]),
    ("camera", ["--for", "sheets", "--kerf", "0.2", "--price", "0.8EUR"]),
    ("torus", ["--for", "print", "--block-size", "5x5x5", "--bed", "180x180x180"]),
    ("vase", ["--for", "bricks", "--longest", "120"]),
    ("camera", ["--for", "mill", "--longest", "90", "--rotate", "10,20,30", "--flute", "100"]),
    ("vase", ["--for", "mould", "--bed", "180x180x90", "--draft", "3"]),
    ("camera", ["--for", "sponge", "--case", "425x284x155:45", "--preset", "slit-10", "--language", "ja"]),
    ("vase", ["--for", "sheets", "--blocks", "auto", "--clearance", "1,2,2,0,1,3", "--notches", "60x30", "--language", "ja",
              "--edit", "lower:3:3:2,upper:4:4:1,lower:30:40:-1,upper:31:41:-1,lower:9:900:1"]),
    ("vase", ["--for", "bricks", "--longest", "120", "--language", "ja"]),
    ("camera", ["--for", "mill", "--longest", "90", "--flute", "100", "--open", "0.7", "--language", "ja"]),
    ("figurine", ["--for", "print", "--blocks", "auto", "--open", "0.5"]),
    ("torus", ["--for", "mould", "--language", "ja"]),
    ("camera", ["--for", "sheets", "--blocks", "auto", "--wall", "70", "--foam", "ld33", "--mass", "0.9", "--drop-height", "ista-2a",
                "--fragility", "museum"]),
    ("vase", ["--for", "sheets", "--blocks", "auto", "--wall", "70", "--foam", "ld33", "--mass", "1.2", "--drop-height", "400",
              "--keep-off", "60,0,20,15:22:loose", "--keep-off", "0,0,-140,20:press=2kPa", "--language", "ja"]),
    ("vase", ["--for", "sheets", "--preset", "sheet-10", "--blocks", "auto", "--settle", "--pads", "2,1", "--foam", "ld33", "--mass",
              "1.2", "--drop-height", "400", "--keep-off", "60,0,20,15:22"]),
    ("camera", ["--for", "sheets", "--blocks", "auto", "--open", "0.6", "--notches", "60x30", "--lift", "60x20",
                "--liner-slit", "12", "--second-color"]),
    ("vase", ["--for", "sponge", "--case", "400x300x200", "--open", "40", "--clearance", "1,2,2,0,1,3", "--language", "ja"]),
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


def contents(folder):
    """Every file by its name, the report without the one thing that may differ, and no list of their hashes."""
    found = {path.relative_to(folder).as_posix(): path.read_bytes()
             for path in folder.rglob("*") if path.is_file() and path.name != ".snug-files"}
    report = json.loads(found["report.json"])
    del report["timing_ms"]
    found["report.json"] = json.dumps(report)
    return found


def unpacked(found):
    """Without PDF, and with the members of 3MF instead of how they were compressed."""
    plain = {name: content for name, content in found.items() if not name.endswith((".pdf", ".3mf"))}
    for name in found:
        if name.endswith(".3mf"):
            with zipfile.ZipFile(io.BytesIO(found[name])) as container:
                plain |= {f"{name}/{member}": container.read(member) for member in container.namelist()}
    return plain


def check(programs, wasm, path, options, work):
    work.mkdir()
    language = options[options.index("--language") + 1] if "--language" in options else "en"
    made = []
    for number, program in enumerate(programs):
        folder = work / f"native{number}"
        run([program, "make", path, *options, "-o", folder, "--quiet"])
        made.append(contents(folder))
    folder = work / "wasm"
    run(["node", HERE / "make_with_wasm.mjs", wasm, path, work / "native0" / "project.snug.json", folder,
         language])
    pairs = [("clang", made[0], made[1]), ("wasm", unpacked(made[0]), contents(folder))]
    for name, expected, found in pairs:
        if sorted(found) != sorted(expected):
            sys.exit(f"{path.name} {options}: {sorted(found)} instead of {sorted(expected)} by {name}")
        different = [file for file in expected if found[file] != expected[file]]
        if different:
            sys.exit(f"{path.name} {options}: {different} differ by {name}")
    print(f"{path.name} {' '.join(options)}: {len(made[0])} files equal", flush=True)


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
        # Node takes one processor.
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            folders = [work / str(number) for number in range(len(cases))]
            list(pool.map(lambda case, folder: check(programs, wasm, *case, folder), cases, folders))
    print(f"{len(cases)} passed, 0 failed")


main()
