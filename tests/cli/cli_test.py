"""The program as a person or a script meets it: files, exit statuses, sentences.

Usage: cli_test.py SNUG [unittest arguments]
"""

import json
import os
import pty
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.dom.minidom
from pathlib import Path

from read_solids import edge_balance, read_ply, read_stl, signed_volume

SNUG = Path(sys.argv.pop(1)).resolve()
FILES = {"lower.stl", "upper.stl", "lower.ply", "upper.ply", "depths.csv", "preview.svg", "report.json",
         "project.snug.json"}
LIST = ".snug-files"  # of what was made, for the next run into the folder
TETRAHEDRON = "OFF\n4 4 6\n0 0 0\n60 0 0\n0 60 0\n0 0 60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"


def snug(*arguments, **options):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=120, **options)


def files_in(folder):
    return {path.name for path in folder.iterdir()} if folder.exists() else set()


class CliTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.object = self.work / "tetrahedron.off"
        self.object.write_text(TETRAHEDRON)
        self.out = self.work / "out"

    def file(self, name, content):
        path = self.work / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def make(self, path, *arguments):
        return snug("make", path, *arguments, "-o", self.out)

    def assertRefused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(files_in(self.out), set(), "nothing may be written")
        self.assertNotIn("terminate", done.stderr)

    # ---- what it makes

    def test_make_writes_every_file_and_tells_a_packer(self):
        done = self.make(self.object)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(files_in(self.out), FILES | {LIST})
        for word in ["Object", "Space", "Foam", "Walls", "Gaps", "litres"]:
            self.assertIn(word, done.stdout)
        self.assertEqual(done.stderr, "", "no progress where standard error is no terminal")
        xml.dom.minidom.parse(str(self.out / "preview.svg"))

    def test_the_report_agrees_with_the_depths(self):
        self.assertEqual(self.make(self.object).returncode, 0)
        report = json.loads((self.out / "report.json").read_text())
        lines = (self.out / "depths.csv").read_text().splitlines()
        self.assertEqual(lines[0], "j,k,lower_blocks,upper_blocks")
        rows = [tuple(map(int, line.split(","))) for line in lines[1:]]
        self.assertEqual([row[:2] for row in rows], [(j, k) for j in range(18) for k in range(18)])
        foam = report["foam"]
        self.assertEqual(sum(row[2] for row in rows), foam["lower_blocks"])
        self.assertEqual(sum(row[3] for row in rows), foam["upper_blocks"])
        self.assertEqual(foam["lower_blocks"] + foam["upper_blocks"] + foam["cut_blocks"], 30 * 18 * 18)
        self.assertAlmostEqual(foam["fill_ratio"], 1 - foam["cut_blocks"] / (30 * 18 * 18))
        self.assertEqual(list(report), ["object", "placement", "items", "design_space", "foam", "gap", "bearing", "wall_mm",
                                        "findings", "timing_ms"])
        self.assertEqual(list(report["timing_ms"]),
                         ["read", "depth_map", "block_map", "foam_pair", "solids", "write"])
        self.assertEqual(report["design_space"], {"blocks": [30, 18, 18], "block_mm": [15, 15, 22]})
        self.assertTrue(report["object"]["watertight"])
        self.assertAlmostEqual(report["object"]["volume_mm3"], 60 ** 3 / 6, 1)
        self.assertEqual(len(report["wall_mm"]), 6)

    def test_json_prints_the_report_that_is_written(self):
        done = self.make(self.object, "--json")
        self.assertEqual(done.stdout, (self.out / "report.json").read_text())

    def test_quiet_prints_nothing(self):
        done = self.make(self.object, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_formats_choose_the_foams(self):
        self.assertEqual(self.make(self.object, "--formats", "stl").returncode, 0)
        self.assertEqual(files_in(self.out), FILES - {"lower.ply", "upper.ply"} | {LIST})

    def test_a_project_gives_the_same_bytes_again(self):
        options = ["--rotate", "10,20,30", "--move", "1,2,3", "--clearance", "0.7", "--blocks", "auto", "--wall",
                   "30", "--preset", "slit-10", "--parting", "6", "--longest", "99.9"]
        self.assertEqual(self.make(self.object, *options).returncode, 0)
        project = self.file("again.snug.json", (self.out / "project.snug.json").read_bytes())
        again = self.work / "again"
        done = snug("make", project, "-o", again)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in FILES - {"report.json"}:
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)

    def test_a_project_of_measurements_needs_no_object_beside_it(self):
        shape = self.file("part.shape", "box 60x40x20 + cylinder 25x30 at 0,0,25\n")
        self.assertEqual(self.make(shape, "--blocks", "auto").returncode, 0)
        again = self.work / "again"
        done = snug("make", self.out / "project.snug.json", "-o", again)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("is not the one", done.stdout)
        for name in FILES - {"report.json"}:
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)
        done = snug("make", self.out / "project.snug.json", "--object", self.work / "gone.shape", "-o", again)
        self.assertEqual(done.returncode, 2)

    def test_a_project_whose_object_changed_or_is_gone(self):
        self.assertEqual(self.make(self.object).returncode, 0)
        project = self.out / "project.snug.json"
        done = snug("make", project, "-o", self.work / "b")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--object", done.stderr)
        other = self.file("other.off", TETRAHEDRON.replace("60", "50"))
        done = snug("make", project, "--object", other, "-o", self.work / "b")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("is not the one", done.stdout)

    def test_blocks_auto_gives_the_object_and_its_walls(self):
        done = self.make(self.object, "--blocks", "auto", "--block-size", "20x20x20", "--json")
        self.assertEqual(json.loads(done.stdout)["design_space"]["blocks"], [3 + 2 * 3] * 3)

    def test_stl_and_ply_are_what_another_program_reads(self):
        self.assertEqual(self.make(self.object).returncode, 0)
        for name in ["lower.stl", "upper.ply"]:
            info = subprocess.run(["assimp", "info", self.out / name], capture_output=True, text=True)
            self.assertEqual(info.returncode, 0, info.stdout)
        data = (self.out / "lower.stl").read_bytes()
        self.assertEqual(len(data), 84 + 50 * struct.unpack("<I", data[80:84])[0])

    def test_foams_on_disk_are_closed_and_hold_the_blocks_of_the_depths(self):
        figurine = self.work / "figurine.stl"
        snug("sample", "figurine", "-o", figurine)
        for options in [[], ["--blocks", "60x40x50", "--block-size", "6x6x6", "--rotate", "20,30,40"],
                        ["--parting", "0"], ["--parting", "30", "--cut-on-touch"]]:
            self.assertEqual(self.make(figurine, *options).returncode, 0)
            report = json.loads((self.out / "report.json").read_text())
            sx, sy, sz = report["design_space"]["block_mm"]
            for half in ("lower", "upper"):
                volume = report["foam"][f"{half}_blocks"] * sx * sy * sz
                vertices, faces = read_ply(self.out / f"{half}.ply")
                self.assertTrue(all(way == [1, 1] for way in edge_balance(faces)))
                self.assertAlmostEqual(signed_volume([[vertices[v] for v in f] for f in faces]) / volume, 1, 5)
                triangles = read_stl(self.out / f"{half}.stl")
                self.assertTrue(all(up == down for up, down in edge_balance(triangles)))
                self.assertAlmostEqual(signed_volume(triangles) / volume, 1, 5)

    def test_the_fit_of_each_half_notches_and_bearing(self):
        camera = self.work / "camera.ply"
        self.assertEqual(snug("sample", "camera", "-o", camera).returncode, 0)
        done = self.make(camera, "--preset", "sheet-10", "--blocks", "auto", "--clearance", "0,1,1,1,4,4",
                         "--liner", "0.5", "--notches", "60x30", "--least-rib", "12", "--mass", "1.2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Notch     back at z", done.stdout)
        self.assertIn("Drops were not checked", done.stdout)
        report = json.loads((self.out / "report.json").read_text())
        bearing = report["bearing"]
        self.assertEqual(bearing["sinking_mm"], [1, 3, 5])
        self.assertEqual(bearing["lower_mm2"], sorted(bearing["lower_mm2"]))
        self.assertAlmostEqual(bearing["static_kpa"][2], 1.2 * 9.80665e3 / bearing["lower_mm2"][2], 3)
        self.assertEqual((bearing["creep_kpa"], bearing["drops"]), (None, "not checked"))
        self.assertEqual([notch["side"] for notch in report["notches"]], ["back", "front"])
        for notch in report["notches"]:
            depth, outwards, width = notch["size_mm"]
            self.assertEqual((depth, width), (30, 60))
            self.assertGreaterEqual(outwards, 25, "the room and what the object leaves of the blocks")
        cut = json.loads((self.out / "project.snug.json").read_text())["design"]["cut"]
        self.assertEqual((cut["clearance_mm"], cut["liner_mm"]), ([0, 1, 1, 1, 4, 4], 0.5))
        again = self.make(self.out / "project.snug.json", "--object", camera, "--notches", "none")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("notches", json.loads((self.out / "report.json").read_text()))

    def test_a_wrong_fit_is_a_sentence(self):
        for arguments, word in [(["--clearance", "1,2"], "six"), (["--clearance", "x"], "number"),
                                (["--clearance", "0,-9,0"], "-6"), (["--liner", "-1"], "liner"),
                                (["--least-rib", "-3"], "rib"), (["--notches", "80"], "80x40"),
                                (["--notches", "80x-4"], "depth"), (["--notch-at", "5"], "--notches"),
                                (["--notches", "80x40", "--notch-axis", "x"], "y, z or auto"),
                                (["--notches", "80x40", "--notch-at", "1,2,3"], "one or two")]:
            done = self.make(self.object, *arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(word, done.stderr, arguments)
            self.assertFalse(self.out.exists())

    def test_no_name_of_a_file_steers_the_terminal(self):
        path = self.work / "\x1b[31mred\x07\u202e.off"
        path.write_bytes((self.work / "missing").name.encode())
        done = snug("inspect", path)
        self.assertEqual(done.returncode, 2)
        for character in "\x1b\x07\u202e":
            self.assertNotIn(character, done.stdout + done.stderr)

    def test_a_search_takes_a_number_of_seconds(self):
        for seconds in ["nan", "inf", "-1", "0"]:
            done = snug("make", self.work / "nothing.stl", "--optimize", "--search-seconds", seconds, "-o", self.out)
            self.assertEqual(done.returncode, 1, seconds)

    def test_findings_name_a_thin_wall(self):
        done = self.make(self.object, "--blocks", "6x6x6", "--block-size", "20x20x20", "--json")
        codes = {finding["code"] for finding in json.loads(done.stdout)["findings"]}
        self.assertIn("thin_floor", codes)

    def test_inspect_guesses_the_unit(self):
        small = self.file("small.off", TETRAHEDRON.replace("60", "0.2"))
        done = snug("inspect", small)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"m +200 x 200 x 200 mm +<- likely")

    def test_samples_in_every_format_are_packed(self):
        for name, ending in [("torus", "stl"), ("vase", "ply"), ("camera", "obj"), ("figurine", "off")]:
            path = self.work / f"{name}.{ending}"
            self.assertEqual(snug("sample", name, "-o", path).returncode, 0)
            done = snug("make", path, "--json", "-o", self.work / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertTrue(report["object"]["watertight"], name)
            self.assertEqual([f for f in report["findings"] if f["severity"] == "danger"], [])
        self.assertEqual(json.loads(snug("inspect", "--json", self.work / "torus.stl").stdout)["vertices"], 7200)

    def test_an_object_from_measurements_is_packed(self):
        text = "box 143x87x40 r5 + cylinder 63x60 at 0,0,50"
        for ending in ("stl", "ply", "obj", "off", "shape"):
            path = self.work / f"measured.{ending}"
            done = snug("shape", text, "-o", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = snug("make", path, "--blocks", "auto", "--json", "-o", self.work / ending)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertTrue(report["object"]["watertight"], ending)
            self.assertEqual((self.work / ending / "depths.csv").read_text(), (self.work / "stl" / "depths.csv").read_text())
        self.assertEqual(path.read_text(), text + "\n")
        self.assertEqual(snug("shape", *text.split(), "-o", path).returncode, 0)
        self.assertEqual(path.read_text(), text + "\n")
        for wrong, status, said in (("box 143x87", 1, "part 1"), ("egg 7", 1, "cylinder"), ("", 1, "such as")):
            done = snug("shape", wrong, "-o", self.work / "none.stl")
            self.assertEqual(done.returncode, status, wrong)
            self.assertIn(said, done.stderr)
        self.assertEqual(snug("shape", text, "-o", self.work / "none.txt").returncode, 1)
        (self.work / "torn.shape").write_text("ball 7 + box 1x2")
        done = snug("make", self.work / "torn.shape", "-o", self.work / "torn")
        self.assertEqual(done.returncode, 2)
        self.assertIn("part 2", done.stderr)

    def test_version_help_and_presets(self):
        self.assertRegex(snug("--version").stdout, r"^snug \d+\.\d+\.\d+\n$")
        for command in [[], ["make"], ["plan"], ["inspect"], ["sample"], ["shape"], ["presets"]]:
            done = snug(*command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("Example", done.stdout)
        done = snug("presets", env={"HOME": str(self.work)})
        self.assertIn("paper", done.stdout)
        self.assertIn(str(self.work / ".config/snug/presets.json"), done.stdout)

    def test_every_option_can_be_typed_by_its_name(self):
        done = self.make(self.object, "--for", "sheets", "--liner", "1", "--set", "cut.liner_mm=0.5", "--set",
                         "workshop.sheets.dxf=false", "--set", "workshop.sheets.stock_mm=[900,500]")
        self.assertEqual(done.returncode, 0, done.stderr)
        design = json.loads((self.out / "project.snug.json").read_text())["design"]
        self.assertEqual(design["cut"]["liner_mm"], 0.5)
        self.assertEqual((design["workshop"]["sheets"]["dxf"], design["workshop"]["sheets"]["stock_mm"]), (False, [900, 500]))
        for text, word in [("cut.linner=1", "cut.linner is not an option"), ("cut", "path"),
                           ("cut.liner_mm=thick", "must be a number"), ("cut.liner_mm=-1", "from 0 to")]:
            refused = snug("make", self.object, "--set", text, "-o", self.work / "none")
            self.assertEqual(refused.returncode, 1, text)
            self.assertIn(word, refused.stderr)

    def test_own_presets_are_used(self):
        config = self.work / "snug"
        config.mkdir()
        (config / "presets.json").write_text('[{"name": "ours", "block_mm": [20, 10, 10], "clearance_mm": 2}]')
        environment = {"XDG_CONFIG_HOME": str(self.work)}
        done = snug("make", self.object, "--preset", "ours", "--json", "-o", self.out, env=environment)
        self.assertEqual(json.loads(done.stdout)["design_space"]["block_mm"], [20, 10, 10])
        (config / "presets.json").write_text("[{]")
        self.assertEqual(snug("presets", env=environment).returncode, 1)

    # ---- bad input

    def test_wrong_usage(self):
        for options in [["--blocks", "0x8x8"], ["--blocks", "8x8"], ["--blocks", "5000x8x8"], ["--blocks", "-3x8x8"],
                        ["--block-size", "0x1x1"], ["--block-size", "nanx1x1"], ["--block-size", "20000x1x1"],
                        ["--clearance", "-7"], ["--clearance", "x"], ["--parting", "31"], ["--parting", "low"],
                        ["--rotate", "1,2"], ["--rotate", "inf,0,0"], ["--units", "miles"], ["--scale", "0"],
                        ["--longest", "-5"], ["--preset", "marble"], ["--formats", "dwg"], ["--wall", "-1"],
                        ["--threads", "0"], ["--nonsense"]]:
            with self.subTest(options=options):
                done = self.make(self.object, *options)
                self.assertRefused(done, 1)
                self.assertGreater(len(done.stderr), 20)
        self.assertEqual(snug().returncode, 1)
        self.assertEqual(snug("make", self.object).returncode, 1)
        self.assertEqual(snug("frobnicate").returncode, 1)
        self.assertEqual(snug("sample", "unicorn", "-o", self.work / "a.stl").returncode, 1)
        self.assertEqual(snug("sample", "torus", "-o", self.work / "a.dwg").returncode, 1)

    def test_unreadable_objects(self):
        cases = {"missing.stl": (None, "no such file"), "empty.stl": (b"", "empty"),
                 "cloud.ply": (b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                               b"property float z\nend_header\n0 0 0\n", "all its points are one"),
                 "cut.stl": (bytes(80) + struct.pack("<I", 1000) + bytes(500), "cut off"),
                 "lying.ply": (b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
                               b"property float y\nproperty float z\nelement face 1\n"
                               b"property list uchar int vertex_indices\nend_header\n", ""),
                 "nan.off": (TETRAHEDRON.replace("60 0 0", "nan 0 0").encode(), "3 of 4 faces"),
                 "index.obj": (b"v 0 0 0\nv 50 0 0\nv 0 50 0\nf 1 2 9\n", "9"),
                 "none.obj": (b"# nothing\n", ""), "text.txt": (b"Dear diary,\n", ""),
                 "project.snug.json": (b"{}", "snug is missing")}
        for name, (content, word) in cases.items():
            with self.subTest(name=name):
                path = self.file(name, content) if content is not None else self.work / name
                self.assertRefused(self.make(path), 2, word, name)
        self.assertRefused(self.make(self.work), 2, "folder")

    def test_implausible_size_asks_for_the_unit(self):
        small = self.file("small.off", TETRAHEDRON.replace("60", "0.2"))
        self.assertRefused(self.make(small), 2, "--units", "200 x 200 x 200 mm", "5.1 x 5.1 x 5.1")
        self.assertEqual(self.make(small, "--units", "m").returncode, 0)
        huge = self.file("huge.off", TETRAHEDRON.replace("60", "6000"))
        shutil.rmtree(self.out)
        self.assertRefused(self.make(huge), 2, "5 m")

    def test_an_object_too_large_names_the_smallest_space(self):
        done = self.make(self.object, "--blocks", "3x8x8", "--block-size", "15x15x15")
        self.assertRefused(done, 3, "4 x 4 x 4 blocks", "--blocks auto")
        self.assertEqual(self.make(self.object, "--blocks", "4x4x4", "--block-size", "15x15x15").returncode, 0)
        shutil.rmtree(self.out)
        done = self.make(self.object, "--blocks", "3x8x8", "--block-size", "15x15x15", "--json")
        report = json.loads(done.stdout)
        self.assertEqual((done.returncode, report["foam"], report["findings"][0]["code"]), (3, None, "outside"))

    def test_an_output_folder_that_cannot_be_written(self):
        blocker = self.file("blocker", "I am a file")
        done = snug("make", self.object, "-o", blocker / "out")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(snug("make", self.object, "-o", blocker).returncode, 4)
        self.assertEqual(snug("make", self.object, "-o", "/proc/snug").returncode, 4)
        self.assertEqual(blocker.read_text(), "I am a file")
        self.assertEqual(snug("sample", "torus", "-o", blocker / "a.stl").returncode, 4)

    def test_a_full_disk_leaves_old_files_alone(self):
        self.assertEqual(self.make(self.object).returncode, 0)
        before = {name: (self.out / name).read_bytes() for name in FILES}

        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

        done = snug("make", self.object, "--rotate", "0,45,0", "-o", self.out, preexec_fn=little_room)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(files_in(self.out), FILES | {LIST})
        self.assertEqual(before, {name: (self.out / name).read_bytes() for name in FILES})
        done = snug("make", self.object, "-o", self.work / "new" / "deep", preexec_fn=little_room)
        self.assertEqual(done.returncode, 4)
        self.assertFalse((self.work / "new").exists())

    def test_ctrl_c_ends_with_its_status_and_no_files(self):
        torus = self.work / "torus.stl"
        snug("sample", "torus", "-o", torus)
        slow = ["make", torus, "--blocks", "400x400x400", "--block-size", "1x1x1", "-o", self.out]
        # Before its first line the program cannot answer; under sanitizers that takes longer.
        begun = time.monotonic()
        snug("--version")
        start = 2 * (time.monotonic() - begun)
        for delay in [0.05, 0.2, 0.4]:
            with self.subTest(delay=delay):
                process = subprocess.Popen([SNUG, *slow], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                time.sleep(start + delay)
                process.send_signal(signal.SIGINT)
                _, errors = process.communicate(timeout=60)
                if process.returncode == 0:
                    continue  # it was faster than the signal
                self.assertEqual(process.returncode, 5)
                self.assertIn("cancelled", errors)
                self.assertEqual(files_in(self.out), set())

    def test_progress_is_shown_on_a_terminal_only(self):
        main, side = pty.openpty()
        process = subprocess.Popen([SNUG, "make", self.object, "-o", self.out], stdout=subprocess.PIPE, stderr=side)
        process.communicate(timeout=60)
        os.close(side)
        shown = os.read(main, 65536).decode()
        os.close(main)
        self.assertIn("Reading", shown)

    def test_standard_output_that_nobody_reads(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([SNUG, "presets"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 4)


if __name__ == "__main__":
    unittest.main()
