"""Makes docs/benchmarks.md from what the measuring programs left in a folder.

Usage: report.py FOLDER docs/benchmarks.md
"""

import json
import os
import platform
import re
import sys
from pathlib import Path

import arrange_table
import search_table

FOLDER, OUT = Path(sys.argv[1]), Path(sys.argv[2])


def load(name):
    path = FOLDER / name
    return json.loads(path.read_text()) if path.exists() else None


def ms(value):
    return f"{value:.2f}" if value < 10 else f"{value:.1f}" if value < 100 else f"{value:.0f}"


def spread(summary):
    return f"{ms(summary['median'])} ({ms(summary['low'])}–{ms(summary['high'])})"


def ratio(a, b):
    times = a["median"] / b["median"]
    return f"{times:.0f} ×" if times >= 10 else f"{times:.1f} ×"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def cube(blocks):
    return " × ".join(map(str, blocks))


def machine(method):
    cpu = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    memory = re.search(r"MemTotal:\s*(\d+)", Path("/proc/meminfo").read_text())
    system = re.search(r'PRETTY_NAME="(.*)"', Path("/etc/os-release").read_text())
    return (f"{cpu[1] if cpu else platform.processor()}, {os.cpu_count()} cores, {int(memory[1]) // 2**20} GiB, "
            f"{system[1] if system else platform.system()}, g++ {method['compiler']}; the paper's method: "
            f"{method['objects'][0]['renderer']}.")


def method_tables(method):
    header = ["object", "vertices", "blocks", "paper's method", "plain exact loop", "Snug, 1 thread",
              f"Snug, {method['threads']} threads", "paper / Snug", "loop / Snug", "threads"]
    rows = []
    for thing in method["objects"]:
        for run in thing["runs"]:
            rows.append([thing["name"], f"{thing['vertices']:,}".replace(",", " "), cube(run["blocks"]),
                         spread(run["paper"]), spread(run["loop"]), spread(run["snug"]), spread(run["threads"]),
                         ratio(run["paper"], run["snug"]), ratio(run["loop"], run["snug"]),
                         ratio(run["snug"], run["threads"])])
    return table(header, rows)


def layers_table(method):
    runs = method["objects"][-1]["layers"]
    return table(["blocks", "Snug, 1 thread"], [[cube(run["blocks"]), spread(run["snug"])] for run in runs])


def prepare_table(method):
    return table(["object", "triangles", "1 thread", f"{method['threads']} threads"],
                 [[thing["name"], f"{thing['triangles']:,}".replace(",", " "), spread(thing["prepare_one_thread"]),
                   spread(thing["prepare"])] for thing in method["objects"]])


def wasm_table(method, wasm):
    rows = []
    for native, browser in zip(method["pack"], wasm["pack"]):
        rows.append([f"{native['columns']} × {native['columns']}", spread(native["time"]), spread(browser["time"]),
                     ratio(browser["time"], native["time"])])
    return table(["columns", "native, 1 thread", f"WebAssembly, node {wasm['node']}", "ratio"], rows)


READERS = {"stl_binary": "STL, welded", "stl_binary_shuffled": "STL in no order, welded",
           "stl_binary_loose": "STL without a common vertex", "ply_binary": "PLY",
           "ply_binary_coloured": "PLY with colours", "obj": "OBJ"}


def reader_table(readers):
    rows = []
    for run in readers["benchmarks"]:
        if run["aggregate_name"] == "median":
            name = run["run_name"].split("/")[0]
            rows.append([READERS.get(name, name), f"{run['real_time']:.0f}", f"{run['assimp_ms']:.0f}",
                         f"{run['times_faster']:.1f} ×", f"{run['memory_of_mesh']:.1f}",
                         f"{run['assimp_memory']:.1f}"])
    return table(["file", "Snug, ms", "assimp, ms", "assimp / Snug", "Snug's memory, meshes",
                  "assimp's memory, meshes"], rows)


def packs_table(packs):
    return table(["pack", "blocks", "ms", "files", "pages"],
                 [[run["pack"], cube(run["blocks"]), spread(run["time"]), run["files"], run["pages"]] for run in packs if "pack" in run])


def moved_text(packs):
    return [f"One of five items of {run['triangles']:,} triangles moved at 30 × 18 × 18, all packed again: {spread(run['time'])} ms."
            for run in packs if "moved" in run]


def median(values):
    return sorted(values)[len(values) // 2]


def share(value):
    return f"{100 * value:.2g} %"


def strength(runs, load):
    """The median over the layouts of what a load case takes of the weakest joint."""
    each = [run["loads"][load] for run in runs]
    loose = [one for one in each if "loose" in one]
    if loose:
        return f"loose in {len(loose)} of {len(each)}" if len(each) > 1 else "loose"
    return share(median([one["used"] for one in each])) if all("used" in one for one in each) else "—"


def brick_rows(runs):
    return [median([run["bricks"] for run in runs]), max(run["pieces"] for run in runs),
            median([run["articulations"] for run in runs]), strength(runs, 0), strength(runs, 1),
            ms(median([run["ms"] for run in runs]))]


def bricks_table(layouts):
    header = ["object", "blocks", "half", "layout", "bricks", "pieces", "articulation bricks", "lifted",
              "turned over", "ms"]
    rows = []
    for thing in layouts:
        for half in thing["halves"]:
            place = [thing["object"], cube(thing["blocks"]), half["half"]]
            mark = "" if half["exact"] else " †"
            for name, runs in (("random merge", half["random"]), ("Snug", [half["snug"]])):
                row = brick_rows(runs)
                rows.append(place + [name] + row[:3] + [cell + mark for cell in row[3:5]] + row[5:])
    return table(header, rows)


def checks_table(checks):
    rows = []
    for check in checks:
        for one in check["loads"]:
            program = "program_ms" in one
            rows.append([f"{check['bricks']:,}".replace(",", " "), one["load"], f"{one['springs_ms']:.0f}",
                         share(one["springs_used"]), f"{one['rows']} × {one['columns']}" if program else "—",
                         f"{one['program_ms']:.0f}" if program else "—", share(one["program_used"]) if program else "—"])
    return table(["bricks", "load case", "springs, ms", "at most", "rows × columns", "linear programme, ms", "exactly"], rows)


def large_table(large):
    rows = []
    for ending, run in large.items():
        for state in ("cold", "warm"):
            if state not in run:
                continue
            plain, snug = run[state]["plain_s"], run[state]["snug_s"]
            rows.append([ending.upper(), f"{run['triangles']:,}".replace(",", " "), f"{run['bytes'] / 1e9:.1f} GB", state,
                         f"{plain:.2f} s", f"{snug:.2f} s", f"{snug / plain:.1f}", f"{run['resident_mb']:.0f} MB"])
    return table(["file", "triangles", "size", "file was", "plain read", "`snug make --stream`", "plain reads", "resident"],
                 rows)


def main():
    method, wasm, readers = load("method.json"), load("wasm.json"), load("readers.json")
    search, packs = load("search.json"), load("packs.json")
    largest = method["objects"][-1]
    equal = min(run["paper_columns_equal"] for thing in method["objects"] for run in thing["runs"])
    parts = [
        "# Benchmarks", "Written by `make bench`; every time in milliseconds, the median with its quartiles, all of a row "
        "measured by turns in one run.", machine(method),
        "## From a placement to two foams",
        "The paper's method draws two depth textures of 1024 × 1024 with Mesa's software rasteriser on one thread, reads "
        "them back and pools them; the plain loop is exact and looks at every triangle; Snug gives the loop's result to "
        "the bit. The mesh is read and prepared. The paper publishes 110 to 143 ms at 30 × 30 × 30 on its own machine, "
        "and a growth to the ninefold from 10 to 30 cubed. The two largest objects: 20 random rotations at 10, 30 and 300 "
        "cubed, 5 elsewhere.",
        method_tables(method),
        f"The paper's method agrees with the exact one in at least {100 * equal:.1f} % of the columns of a row.",
        "## Growth with the layers", f"{largest['name']}, 30 × 30 columns.", layers_table(method),
        "## Preparation", "Once for each object, before the first of many placements.", prepare_table(method),
    ]
    if wasm:
        parts += ["## WebAssembly", f"The whole of `snug::pack` on {largest['name']}, one thread, SIMD of 128 bits.",
                  wasm_table(method, wasm)]
    if readers:
        parts += ["## Readers", "A million triangles from memory, medians of five by turns with assimp; memory at its peak, "
                  "in meshes of 12 bytes a vertex and 12 a triangle.", reader_table(readers)]
    if search:
        parts += ["## Searching the placement",
                  "Blocks cut at 30 × 18 × 18, objects of a 240 mm diagonal and about 100,000 triangles at most, one thread: the "
                  "start, the paper's greedy climb, Snug after so much of the processor's time (medians of "
                  "the seeds, and how far above the least), and the least that any search ever found "
                  "(`bench/least_placements.json`).", search_table.table(search)]
    arranged = load("arrange.json")
    if arranged:
        parts += arrange_table.parts(arranged)
    if packs:
        parts += ["## Packs for the workshop", "The camera, in the library: drawings, solids and their files, without PDF "
                  "and zip. Bricks in blocks of one brick, without the linear programme; the mill with a cutter of 6 mm, in "
                  "blocks of 15 × 15 × 22 mm and with columns of 1 mm in a block of 450 × 400 mm.", packs_table(packs), *moved_text(packs)]
    bricks = load("bricks.json")
    if bricks:
        parts += ["## Bricks", "Luo et al.'s random merge (the median of five seeds, of pieces the most) beside our layout, "
                  "both of Luo's bricks, blocks of one brick; what the weakest joint needs of what its studs hold (0.7 N a "
                  "contact point) when a half is lifted by its rim and when it lies on it: exactly, by the linear programme, "
                  "or, where marked †, at most, by the springs.", bricks_table(bricks["layouts"]),
                  "How long it takes to know that a block with a bowl in it holds: by springs, which stop at a tenth of the "
                  "capacity, and by the linear programme, which gives the least.", checks_table(bricks["checks"])]
    large = load("large.json")
    if large:
        parts += ["## Scans that do not fit in memory", "Read in pieces, two passes on two threads, from the start of the "
                  "program to the written foams; the plain read is `cat` of the same file into nothing, by turns, medians "
                  "of three. Cold: from the disk, with the system's cache emptied before; warm: from that cache. A PLY's "
                  "vertices are kept, 12 bytes each.", large_table(large)]
    studio = FOLDER / "studio.txt"
    if studio.exists():
        parts += ["## The studio: from a slider's input to the picture, and a scan of 150 MB",
                  "In Chromium's software renderer. Memory is that of the whole browser.",
                  "```\n" + studio.read_text().rstrip() + "\n```"]
    parts += ["## Memory", f"Peak of the measuring program, with its six objects and Mesa: {method['peak_mb']:.0f} MB."]
    OUT.write_text("\n\n".join(parts) + "\n")
    print("\n\n".join(parts))


main()
