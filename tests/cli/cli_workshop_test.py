"""What `snug make --for` hands to a maker, read back by nothing of the program's own.

Usage: cli_workshop_test.py SNUG [unittest arguments]
"""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from read_maps import Map, area_of, layers_named, loops_of
from some_of import some_of
from ways import WAYS
from written_objects import LETTER_L, prism

SNUG = Path(sys.argv.pop(1)).resolve()
SAMPLES = ["torus", "vase", "figurine", "camera"]
PAPER = {"a4": (210, 297), "letter": (215.9, 279.4), "a3": (297, 420)}
POINTS = 72 / 25.4  # a mm

MEASURE_DXF = """
import json, sys
import ezdxf
from ezdxf import bbox
for path in sys.argv[1:]:
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    errors = len(audit.errors) + len(audit.fixes)
    assert (drawing.dxfversion, drawing.units) == ('AC1015', ezdxf.units.MM), (drawing.dxfversion, drawing.units)
    space = drawing.modelspace()
    loops = [e for e in space if e.dxftype() == 'LWPOLYLINE' and e.closed and e.dxf.layer.startswith('cut')]
    area = 0
    for loop in loops:
        corners = list(loop.vertices_in_wcs())
        area += abs(sum(a.x * b.y - b.x * a.y for a, b in zip(corners, corners[1:] + corners[:1]))) / 2
    box = bbox.extents(space)
    print(json.dumps([errors, len(loops), area, box.extmin.x, box.extmin.y, box.extmax.x, box.extmax.y]))
"""


def snug(*arguments):
    words = [each if isinstance(each, bytes) else str(each) for each in arguments]
    return subprocess.run([SNUG, *words], capture_output=True, text=True, errors="replace", timeout=240)


class WorkshopTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.out = self.work / "out"

    def sample(self, name):
        path = self.work / f"{name}.stl"
        self.assertEqual(snug("sample", name, "-o", path).returncode, 0)
        return path

    def letter(self, x0=-30, x1=30):
        path = self.work / "letter.off"
        path.write_text(prism(LETTER_L, x0, x1))
        return path

    def make(self, path, *arguments):
        done = snug("make", path, *arguments, "-o", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.out / "report.json").read_text())

    def assertMapsMakeTheFoams(self, report):
        """Who plucks what the maps show has the blocks that depths.csv says are kept."""
        nx, ny, nz = report["design_space"]["blocks"]
        _, row_mm, column_mm = report["design_space"]["block_mm"]
        kept = {}
        with open(self.out / "depths.csv") as file:
            for row in csv.DictReader(file):
                kept[int(row["j"]), int(row["k"])] = {"lower": int(row["lower_blocks"]), "lid": int(row["upper_blocks"])}
        plucked = 0
        for half in ("lower", "lid"):
            whole = max(each[half] for each in kept.values())
            left = {column: whole for column in kept}
            for path in sorted((self.out / "sponge").glob(f"{half}-*.svg")):
                first, last = layers_named(path)
                drawn = Map(path, "pluck")
                self.assertAlmostEqual(drawn.right - drawn.left, nz * column_mm, 2)
                self.assertAlmostEqual(drawn.bottom - drawn.top, ny * row_mm, 2)
                self.assertEqual(drawn.view, [0, 0, drawn.width, drawn.height], "one unit is one mm")
                for row, column in drawn.cells(row_mm, column_mm):
                    j = row if half == "lower" else ny - 1 - row
                    left[j, column] -= last - first + 1
                    plucked += last - first + 1
            self.assertEqual(left, {column: each[half] for column, each in kept.items()}, half)
        self.assertEqual(report["workshop"]["pieces"], plucked)

    # ---- the sponge's maps

    def test_maps_of_every_sample_make_its_foams(self):
        for name in some_of(SAMPLES):
            with self.subTest(name):
                report = self.make(self.sample(name), "--for", "sponge", "--rotate", "10,20,30")
                self.assertMapsMakeTheFoams(report)
                shutil.rmtree(self.out)

    def test_maps_of_long_blocks_and_parting_anywhere(self):
        for options in (["--parting", "0"], ["--parting", "30"], ["--parting", "12", "--cut-on-touch"]):
            with self.subTest(options):
                self.assertMapsMakeTheFoams(
                    self.make(self.letter(), "--for", "sponge", "--preset", "paper", "--blocks", "30x18x18", *options))
                shutil.rmtree(self.out)

    def test_an_l_is_not_mirrored_and_folds_onto_its_lid(self):
        report = self.make(self.letter(-30, 30), "--for", "sponge", "--blocks", "8x8x8", "--block-size", "15x15x15")
        self.assertMapsMakeTheFoams(report)
        lower = Map(next((self.out / "sponge").glob("lower-01*.svg")), "pluck")
        lid = Map(next((self.out / "sponge").glob("lid-01*.svg")), "pluck")
        # From BACK: the leg at k = 1 and 2 (z from -40 to -10), the foot at j = 5 and 6 (y from 10 to 40).
        below = {(row, column) for row, column in lower.cells(15, 15)}
        self.assertIn((1, 1), below)
        self.assertIn((6, 6), below)
        self.assertNotIn((1, 6), below, "a mirrored L has its leg on the right")
        # Folded along BACK, which is the upper edge of the lower map and the lower edge of the lid's.
        folded = {(7 - row, column) for row, column in lid.cells(15, 15)}
        self.assertEqual(folded, below)
        self.assertLess(lower.texts["BACK"][1], lower.top)
        self.assertGreater(lid.texts["BACK"][1], lid.bottom)
        self.assertEqual(min(lower.odd_corner), (lower.left, lower.top))
        self.assertIn((lid.left, lid.bottom), lid.odd_corner)
        self.assertIn("LOWER", lower.texts)
        self.assertIn("LID", lid.texts)

    def test_an_object_that_is_taller_above_the_parting_is_deeper_in_the_lid(self):
        report = self.make(self.letter(-30, 30), "--for", "sponge", "--blocks", "12x8x8", "--block-size", "15x15x15",
                           "--move", "15,0,0", "--parting", "6")
        self.assertMapsMakeTheFoams(report)
        deepest = {half: max(layers_named(path)[1] for path in (self.out / "sponge").glob(f"{half}-*.svg"))
                   for half in ("lower", "lid")}
        self.assertEqual(deepest, {"lower": 1, "lid": 3})

    def test_the_fit_test_is_a_ring_around_the_first_layer(self):
        self.make(self.letter(), "--for", "sponge", "--blocks", "8x8x8", "--block-size", "15x15x15")
        ring = Map(self.out / "sponge" / "fit-test.svg", "ring").cells(15, 15)
        hole = Map(next((self.out / "sponge").glob("lower-01*.svg")), "pluck").cells(15, 15)
        around = {(row + dr, column + dc) for row, column in hole for dr in (-1, 0, 1) for dc in (-1, 0, 1)}
        self.assertEqual(ring, around - hole)

    # ---- what is printed

    def words_of(self, pdf):
        """For each page its size in mm and its words with the middles of their boxes in mm."""
        text = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, check=True).stdout
        root = ElementTree.fromstring(re.sub(rb"&(?!amp;|lt;|gt;|quot;|#)", b"&amp;", text))
        pages = []
        for page in root.iter("{http://www.w3.org/1999/xhtml}page"):
            words = [(word.text, *((float(word.get(a + "Min")) + float(word.get(a + "Max"))) / 2 / POINTS for a in "xy"))
                     for word in page]
            pages.append(((float(page.get("width")) / POINTS, float(page.get("height")) / POINTS), words))
        return pages

    def test_the_overview_on_paper_says_how_many_blocks_to_remove(self):
        report = self.make(self.sample("vase"), "--for", "sponge", "--rotate", "10,20,30")
        _, ny, nz = report["design_space"]["blocks"]
        with open(self.out / "depths.csv") as file:
            kept = {(int(row["j"]), int(row["k"])): (int(row["lower_blocks"]), int(row["upper_blocks"]))
                    for row in csv.DictReader(file)}
        found = set()
        for _, words in self.words_of(self.out / "sponge-plan.pdf"):
            texts = [word[0] for word in words]
            if "Cavity" not in texts or not {"LOWER", "LID"} & set(texts[:2]):
                continue
            half = 0 if "LOWER" in texts else 1
            # Rows by their letters at the left, columns by the numbers above the grid.
            rows = {w[0]: w[2] for w in words if re.fullmatch("[A-Z]", w[0]) and w[1] < 100}
            self.assertEqual(len(rows), ny)
            top = min(rows.values())
            above = max(w[2] for w in words if w[0] == "1" and w[2] < top)
            columns = {int(w[0]): w[1] for w in words if w[0].isdigit() and abs(w[2] - above) < 1}
            self.assertEqual(len(columns), nz)
            bottom = max(rows.values())
            read = dict.fromkeys(kept, 0)
            for text, x, y in words:
                if text.isdigit() and top - 1.5 < y < bottom + 1.5:
                    row = min(rows, key=lambda name: abs(rows[name] - y))
                    column = min(columns, key=lambda number: abs(columns[number] - x))
                    read[ord(row) - ord("A"), column - 1] = int(text)
            whole = max(each[half] for each in kept.values())
            self.assertEqual(read, {column: whole - each[half] for column, each in kept.items()})
            self.assertEqual(rows["A"] < rows["B"], half == 0, "A lies at BACK")
            found.add(half)
        self.assertEqual(found, {0, 1})

    def assertPagesAre(self, pdf, size):
        told = subprocess.run(["pdfinfo", "-l", "10000", pdf], capture_output=True, text=True, check=True).stdout
        pages = re.findall(r"size: +([0-9.]+) x ([0-9.]+) pts", told)
        self.assertEqual(len(pages), int(re.search(r"Pages: +(\d+)", told)[1]), pdf)
        for page in pages:
            for side, wanted in zip(sorted(float(each) / POINTS for each in page), sorted(size)):
                self.assertAlmostEqual(side, wanted, 1, pdf)

    def test_every_page_of_every_pack_is_of_the_paper_that_was_asked_for(self):
        vase = self.sample("vase")
        plans = {"sponge": {"sponge-maps", "sponge-plan"}, "sheets": {"sheets-assembly"}, "print": set(),
                 "bricks": {"bricks-plan"}, "mill": {"mill-setup"}, "mould": {"mould-guide"}}
        for work in WAYS:
            for paper, size in some_of(PAPER.items()):
                with self.subTest(f"{work} {paper}"):
                    self.make(vase, "--for", work, "--longest", 60, "--paper", paper)
                    found = {path.stem: path for path in self.out.glob("**/*.pdf")}
                    self.assertIn("packing-sheet", found)
                    if work in plans:
                        self.assertEqual(set(found), plans[work] | {"packing-sheet"})
                    for path in found.values():
                        self.assertPagesAre(path, size)
                    shutil.rmtree(self.out)

    def test_what_must_not_be_scaled_says_so_to_the_printer(self):
        self.make(self.sample("vase"), "--for", "sponge", "--longest", 60)
        self.assertIn(b"/PrintScaling /None", (self.out / "sponge-maps.pdf").read_bytes())

    def test_no_name_of_an_object_breaks_a_file_of_any_pack(self):
        vase = self.sample("vase").read_bytes()
        names = [b"=1+1,\"<&>'\n\r\t0 FILE x.ldr ]]> \x01\x1b[31m \xe5\xa3\xba \xe2\x80\xa8.stl", b"bad\xff\xfe(!~?%;).stl",
                 b"FILE a.stl", b"\xe2\x80\xae.stl"]
        for name in some_of(names):
            path = os.path.join(os.fsencode(self.work), name)
            with open(path, "wb") as file:
                file.write(vase)
            for work in WAYS:
                with self.subTest(f"{name} {work}"):
                    self.make(path, "--for", work, "--longest", "60")
                    for written in self.out.glob("**/*"):
                        self.assertRegex(str(written.relative_to(self.out)), r"^[a-z0-9/.-]+$")
                        self.assertWhole(written)
                    shutil.rmtree(self.out)

    def assertWhole(self, path):
        if path.suffix == ".svg":
            ElementTree.parse(path)
        elif path.suffix == ".3mf":
            with zipfile.ZipFile(path) as package:
                for member in package.namelist():
                    ElementTree.fromstring(package.read(member))
        elif path.suffix == ".json":
            json.loads(path.read_text("utf-8"))
        elif path.suffix == ".csv":
            for row in csv.reader(path.read_text("ascii").splitlines()):
                for cell in row:
                    self.assertNotRegex(cell, r"^[=+@\t\r]|^-[^0-9.]", path)
        elif path.suffix == ".nc":
            for line in path.read_bytes().split(b"\n"):
                self.assertLess(len(line), 80)
                self.assertRegex(line, rb"^(\([A-Za-z0-9 .,:+/=&'_-]*\)|[GMXYZFSPIJ0-9 .-]*)$")
        elif path.suffix == ".dxf":
            path.read_text("ascii")
        elif path.suffix == ".mpd":
            for line in path.read_bytes().decode("utf-8").split("\r\n"):
                self.assertEqual(line.splitlines(), [line] if line else [])
                self.assertRegex(line, r"^(0 (FILE (foams|lower|lid)\.ldr|NOFILE|STEP|Name: |Author: |"
                                       r"!LDRAW_ORG Unofficial_Model$|(Foams of bricks|Lower half, cavity up|Lid, cavity up): )"
                                       r"|1 |$)")
        elif path.suffix == ".pdf":
            subprocess.run(["pdfinfo", path], capture_output=True, check=True)

    def test_the_square_to_measure_is_100_mm(self):
        self.make(self.sample("vase"), "--for", "sponge")
        picture = subprocess.run(["pdftoppm", "-r", "254", "-gray", "-l", "1", self.out / "sponge-maps.pdf"],
                                 capture_output=True, check=True).stdout
        _, size, _, pixels = picture.split(b"\n", 3)
        width, height = map(int, size.split())
        # Rows with one dark stretch of 100 mm: no words, whatever font stands in, are that long.
        lines = [y for y in range(height) if any(len(run) <= 1010 for run in re.findall(
            b"[\x00-\x9f]{990,}", pixels[y * width:(y + 1) * width]))]
        self.assertAlmostEqual(lines[-1] - lines[0], 1000, delta=4)
        middle = pixels[(lines[0] + lines[-1]) // 2 * width + 0:][:width]
        sides = [x for x in range(width) if middle[x] < 160]
        self.assertAlmostEqual(sides[-1] - sides[0], 1000, delta=4)

    def test_tiles_on_paper_show_every_cell_to_pluck_once(self):
        self.make(self.sample("vase"), "--for", "sponge")
        cells = {}
        for _, words in self.words_of(self.out / "sponge-maps.pdf")[1:]:
            texts = [word[0] for word in words]
            if "FIT" in texts:
                continue
            half = "lower" if any(text.startswith("LOWER") for text in texts) else "lid"
            layer = int(texts[texts.index("layer") + 1])
            cells.setdefault((half, layer), []).extend(t for t in texts if re.fullmatch("[A-Z][0-9]+", t))
        for path in (self.out / "sponge").glob("l*.svg"):
            first, _ = layers_named(path)
            half = path.stem.split("-")[0]
            rows = 18
            names = [f"{chr(ord('A') + (row if half == 'lower' else rows - 1 - row))}{column + 1}"
                     for row, column in Map(path, "pluck").cells(15, 15)]
            self.assertEqual(sorted(cells[half, first]), sorted(names), path)

    # ---- figures, before anything is written

    def test_another_program_reads_the_dxf_and_measures_the_same_as_in_the_svg(self):
        camera = self.work / "camera.ply"
        self.assertEqual(snug("sample", "camera", "-o", camera).returncode, 0)
        self.assertEqual(snug("make", camera, "--for", "sheets", "-o", self.out, "--quiet").returncode, 0)
        files = sorted((self.out / "sheets").glob("*.dxf"))
        self.assertGreater(len(files), 0)
        # Debian's own interpreter, which has its packages.
        python = shutil.which("python3", path="/usr/bin") or sys.executable
        measured = subprocess.run([python, "-c", MEASURE_DXF, *map(str, files)], capture_output=True, text=True)
        if "No module named 'ezdxf'" in measured.stderr:
            self.skipTest("python3-ezdxf is not installed")
        self.assertEqual(measured.returncode, 0, measured.stderr)
        for path, line in zip(files, measured.stdout.splitlines()):
            errors, loops, area, *extents = json.loads(line)
            self.assertEqual(errors, 0, "ezdxf finds nothing to mend")
            svg = path.with_suffix(".svg").read_text()
            cut = "".join(re.findall(r'<g id="cut[^"]*".*?</g>', svg, re.S))
            data = re.findall(r' d="([^"]+)"', cut)
            outlines = [loop for path in data for part in re.findall("M[^M]*Z", path) for loop in loops_of(part)]
            self.assertEqual(loops, len(outlines))
            self.assertAlmostEqual(area / sum(map(area_of, outlines)), 1, 4)
            self.assertGreaterEqual(min(extents), -1e-6)
            self.assertLessEqual(extents[2], 1000)
            self.assertLessEqual(extents[3], 600)

    def test_a_dry_run_tells_all_and_writes_nothing(self):
        done = snug("make", self.sample("vase"), "--for", "sponge", "--price", "0.5 EUR", "--dry-run", "-o", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(self.out.exists())
        for words in ["Blocks to pluck, lower", "litres", "kg", "EUR at 0.5 EUR a litre"]:
            self.assertIn(words, done.stdout)
        self.assertLess(done.stdout.index("For the workshop"), done.stdout.index("Object"))

    def test_litres_kilograms_and_cost_agree(self):
        report = self.make(self.sample("vase"), "--for", "sponge", "--price", "0.5EUR")
        workshop, foam = report["workshop"], report["foam"]
        nx, ny, nz = report["design_space"]["blocks"]
        self.assertAlmostEqual(workshop["foam_kg"], foam["volume_mm3"] * 1e-9 * 25, 5)
        self.assertGreaterEqual(workshop["litres"], nx * ny * nz * 15 ** 3 * 1e-6 - 1e-6)
        self.assertAlmostEqual(workshop["cost"], workshop["litres"] * 0.5, 3)
        for name in workshop["files"]:
            self.assertTrue((self.out / name).is_file(), name)

    def test_for_takes_its_usual_foam_unless_one_is_named(self):
        report = self.make(self.sample("vase"), "--for", "sponge")
        self.assertEqual(report["design_space"]["block_mm"], [15, 15, 15])
        self.assertTrue(all(wall >= 50 for wall in report["wall_mm"]))
        project = self.work / "again.snug.json"
        project.write_bytes((self.out / "project.snug.json").read_bytes())
        report = self.make(self.work / "vase.stl", "--for", "sponge", "--preset", "slit-10", "--blocks", "30x40x40")
        self.assertEqual(report["design_space"], {"blocks": [30, 40, 40], "block_mm": [20, 10, 10]})
        report = self.make(project)
        self.assertEqual(report["design_space"]["block_mm"], [15, 15, 15])
        self.assertIn("workshop", report)

    def test_the_same_files_from_any_number_of_threads(self):
        vase = self.sample("vase")
        self.make(vase, "--for", "sponge", "--threads", 1)
        again = self.work / "again"
        self.assertEqual(snug("make", vase, "--for", "sponge", "--threads", 2, "-o", again).returncode, 0)
        maps = sorted(path.relative_to(self.out) for path in self.out.glob("sponge/*.svg"))
        self.assertGreater(len(maps), 4)
        for name in maps:
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)

    # ---- bad input

    def test_what_has_no_meaning_is_refused_with_what_has(self):
        vase = self.sample("vase")
        for options, words in [(["--for", "unicorn"], ["unicorn", "sponge", "sheets", "print"]),
                               (["--for", "felt"], ["felt", "sponge", "mould"]),
                               (["--price", "cheap"], ["--price", "12.50EUR"]),
                               (["--price", "nan"], ["price"]),
                               (["--price", "-3"], ["price"]),
                               (["--price", "1,5"], ["--price", "12.50"]),
                               (["--paper", "b0"], ["a4", "letter", "a3"]),
                               (["--mass", "-1"], ["mass", "above 0"])]:
            with self.subTest(options):
                done = snug("make", vase, "--for", "sponge", *options, "-o", self.out) if options[0] != "--for" \
                    else snug("make", vase, *options, "-o", self.out)
                self.assertEqual(done.returncode, 1, done.stderr)
                for word in words:
                    self.assertIn(word, done.stderr)
                self.assertFalse(self.out.exists())

    def test_a_folder_of_the_pack_that_cannot_be_made_leaves_nothing(self):
        self.out.mkdir()
        (self.out / "sponge").write_text("in the way")
        done = snug("make", self.sample("vase"), "--for", "sponge", "-o", self.out)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual([path.name for path in self.out.iterdir()], ["sponge"])


if __name__ == "__main__":
    unittest.main()
