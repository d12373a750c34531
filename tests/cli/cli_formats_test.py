"""Objects that are no mesh files of the library's own: scenes (glTF, 3MF) and point clouds, as a
person hands them to the program.

Usage: cli_formats_test.py SNUG [unittest arguments]
"""

import base64
import csv
import json
import random
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

from some_of import some_of
from written_objects import l_shape, write_stl

SNUG = Path(sys.argv.pop(1)).resolve()


def snug(*arguments):
    return subprocess.run([SNUG, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def gltf(vertices, triangles, nodes, uri=None):
    """The scene and its buffer; metres."""
    positions = b"".join(struct.pack("<3f", *(x / 1000 for x in v)) for v in vertices)
    indices = b"".join(struct.pack("<3I", *t) for t in triangles)
    low = [min(v[i] for v in vertices) / 1000 for i in range(3)]
    high = [max(v[i] for v in vertices) / 1000 for i in range(3)]
    buffer = {"byteLength": len(positions) + len(indices)}
    if uri:
        buffer["uri"] = uri
    scene = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": [{"mesh": 0, **node} for node in nodes],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3", "min": low, "max": high},
            {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "buffers": [buffer]}
    return scene, positions + indices


def glb(scene, buffer):
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(buffer), 0x004E4942) + buffer
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def write_3mf(path, vertices, triangles, unit="millimeter", transform="1 0 0 0 1 0 0 0 1 0 0 0"):
    mesh = ("<mesh><vertices>" + "".join('<vertex x="%r" y="%r" z="%r"/>' % v for v in vertices) +
            "</vertices><triangles>" + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in triangles) +
            "</triangles></mesh>")
    model = (f'<?xml version="1.0" encoding="UTF-8"?><model unit="{unit}" xml:lang="en-US" '
             'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
             f'<object id="1" type="model">{mesh}</object><object id="2" type="model"><components>'
             f'<component objectid="1" transform="{transform}"/></components></object></resources>'
             '<build><item objectid="2"/></build></model>')
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("[Content_Types].xml",
                         '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
                         '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
                         '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
        archive.writestr("_rels/.rels",
                         '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
                         '<Relationship Target="/3D/3dmodel.model" Id="r" '
                         'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
        archive.writestr("3D/3dmodel.model", model)


class Formats(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def depths(self, path, *options):
        out = self.folder / ("out-" + path.name)
        done = snug("make", path, "-o", out, "--quiet", "--blocks", "60x50x40", "--block-size", "5x7x9", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (out / "depths.csv").read_text()

    def refused(self, path, *options):
        done = snug("make", path, "-o", self.folder / "none", *options)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertFalse((self.folder / "none").exists())
        self.assertIn(path.name, done.stderr)
        return done.stderr

    def plain(self, change=lambda v: v, twice=False, flip=False):
        vertices, triangles = l_shape()
        moved = [change(v) for v in vertices]
        if flip:
            triangles = [t[::-1] for t in triangles]
        if twice:
            triangles += [tuple(i + len(moved) for i in t) for t in triangles]
            moved = moved + [(x + 130, y, z) for x, y, z in moved]
        path = self.folder / "plain.stl"
        write_stl(path, moved, triangles)
        return self.depths(path)

    def test_a_scene_is_what_its_nodes_place(self):
        vertices, triangles = l_shape()
        path = self.folder / "scene.glb"
        path.write_bytes(glb(*gltf(vertices, triangles, [{}])))
        self.assertEqual(self.depths(path), self.plain())
        path.write_bytes(glb(*gltf(vertices, triangles, [{}, {"translation": [0.13, 0, 0]}])))
        self.assertEqual(self.depths(path), self.plain(twice=True))
        # A quarter turn about z, and a mirror.
        half = 0.5 ** 0.5
        path.write_bytes(glb(*gltf(vertices, triangles, [{"rotation": [0, 0, half, half], "scale": [1, 1, -1]}])))
        self.assertEqual(self.depths(path), self.plain(lambda v: (-v[1], v[0], -v[2]), flip=True))
        report = json.loads((self.folder / "out-scene.glb" / "report.json").read_text())
        self.assertEqual(report["object"]["triangles"], 24)

    def test_a_buffer_of_its_own_is_read_from_the_same_folder_only(self):
        vertices, triangles = l_shape()
        scene, buffer = gltf(vertices, triangles, [{}], "the buffer.bin".replace(" ", "%20"))
        path = self.folder / "scene.gltf"
        path.write_text(json.dumps(scene))
        self.refused(path)
        (self.folder / "the buffer.bin").write_bytes(buffer)
        self.assertEqual(self.depths(path), self.plain())
        scene, _ = gltf(vertices, triangles, [{}], "data.bin")
        path.write_text(json.dumps(scene))
        (self.folder / "data.bin").write_bytes(buffer)
        self.assertEqual(self.depths(path), self.plain())
        inner = self.folder / "inner"
        inner.mkdir()
        scene, _ = gltf(vertices, triangles, [{}], "../data.bin")
        (inner / "scene.gltf").write_text(json.dumps(scene))
        self.refused(inner / "scene.gltf")
        scene, _ = gltf(vertices, triangles, [{}],
                        "data:application/octet-stream;base64," + base64.b64encode(buffer).decode())
        path.write_text(json.dumps(scene))
        self.assertEqual(self.depths(path), self.plain())

    def test_public_gltf_files_are_what_viewers_show(self):
        cases = Path(__file__).resolve().parents[3] / "shared" / "cases"
        if not cases.exists():
            self.skipTest(f"{cases} is not there")
        with open(cases / "expected.csv", newline="") as table:
            rows = [row for row in csv.DictReader(table) if row["file"].endswith((".gltf", ".glb"))]
        self.assertGreater(len(rows), 10)
        for row in rows:
            done = snug("inspect", "--json", cases / row["file"])
            self.assertEqual(done.returncode, int(row["exit status"]), (row["file"], done.stderr))
            told = json.loads(done.stdout)
            self.assertEqual(told["triangles"], int(row["triangles"]), row["file"])
            size = [float(side) for side in row["size_mm"].split("x")]
            for found, side in zip(told["size"], size):
                self.assertAlmostEqual(found, side, delta=2e-5 * max(size), msg=row["file"])

    def test_3mf_has_units_and_components(self):
        vertices, triangles = l_shape()
        path = self.folder / "object.3mf"
        write_3mf(path, vertices, triangles)
        self.assertEqual(self.depths(path), self.plain())
        write_3mf(path, [tuple(x / 25.4 for x in v) for v in vertices], triangles, "inch")
        report = self.folder / "out-object.3mf" / "report.json"
        self.depths(path)
        for found, size in zip(json.loads(report.read_text())["object"]["size_mm"], (120, 100, 30)):
            self.assertAlmostEqual(found, size, 3)
        # Row vectors: x goes to y, y to -x.
        write_3mf(path, vertices, triangles, transform="0 1 0 -1 0 0 0 0 1 7 0 0")
        self.assertEqual(self.depths(path), self.plain(lambda v: (-v[1], v[0], v[2])))
        write_3mf(path, vertices, triangles, "cubit")
        self.assertIn("cubit", self.refused(path))

    def inspected(self, path):
        done = snug("inspect", "--json", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_a_file_that_states_its_unit_takes_no_other(self):
        vertices, triangles = l_shape()
        inch, scene = self.folder / "inch.3mf", self.folder / "scene.glb"
        write_3mf(inch, [tuple(x / 25.4 for x in v) for v in vertices], triangles, "inch")
        scene.write_bytes(glb(*gltf(vertices, triangles, [{}])))
        for path in (inch, scene):
            for unit in ("in", "mm"):
                for command in (("make", path, "-o", self.folder / "none", "--blocks", "auto", "--units", unit),
                                ("cases", "--for", path, "--units", unit)):
                    done = snug(*command)
                    self.assertEqual(done.returncode, 1, done.stderr)
                    self.assertIn("states its unit", done.stderr)
            told = self.inspected(path)
            self.assertIsNone(told["likely_unit"])
            self.assertEqual(told["stated_unit"], "mm")
            self.assertIn("the file states its unit", snug("inspect", path).stdout)
            self.depths(path)
            out = self.folder / ("out-" + path.name)
            project = out / "project.snug.json"
            size = json.loads((out / "report.json").read_text())["object"]["size_mm"]
            # A project of before.
            design = json.loads(project.read_text())
            design["design"]["object"]["units"] = "in"
            project.write_text(json.dumps(design))
            done = snug("make", project, "--object", path, "-o", self.folder / "again", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads((self.folder / "again" / "report.json").read_text())
            self.assertEqual(report["object"]["size_mm"], size)
            self.assertIn("unit_stated", [finding["code"] for finding in report["findings"]])
            self.depths(path, "--scale", "0.5")
            half = json.loads((out / "report.json").read_text())["object"]["size_mm"]
            for found, whole in zip(half, size):
                self.assertAlmostEqual(found, whole / 2, 3)

    def test_what_is_left_out_is_told(self):
        square = "v 0 0 0\nv 60 0 0\nv 60 60 0\nv 0 60 9\n"
        for name, text, word, severity in (
                ("a.obj", square + "f 1 2 3\nf 1 3 4\nf 1 2\n", "1 of 3 faces", "danger"),
                ("b.obj", square + "f 1 2 3\n" * 200 + "f 1\n", "1 of 201 faces", "warning"),
                ("a.xyz", "nan nan nan\n" + "".join(f"{i % 10} {i // 10} 7\n" for i in range(60)), "1 of 61 points", "danger"),
                ("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 60 0 0\nvertex 0 60 9\n"
                          "endloop\nendfacet\n", "endsolid", "warning")):
            path = self.folder / name
            path.write_text(text)
            [finding] = self.inspected(path)["findings"]
            self.assertEqual(finding["severity"], severity)
            self.assertIn(word, finding["message"])
            self.assertIn(word, snug("inspect", path).stdout)
            out = self.folder / ("out-" + name)
            done = snug("make", path, "-o", out, "--units", "mm", "--blocks", "auto", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads((out / "report.json").read_text())
            self.assertIn(finding, [{key: each[key] for key in finding} for each in report["findings"]])

    def test_what_is_not_read_says_what_to_export(self):
        for name, start, word in (("a.step", b"ISO-10303-21;\nHEADER;", "STEP"), ("a.e57", b"ASTM-E57", "E57"), ("a.las", b"LASF", "LAS"), ("a.fbx", b"Kaydara FBX Binary  ", "FBX"),
                                  ("a.blend", b"BLENDER-v300", "Blender")):
            path = self.folder / name
            path.write_bytes(start + bytes(100))
            sentence = self.refused(path)
            self.assertIn(word, sentence)
            self.assertIn("export it as STL", sentence)

    def test_a_zip_gives_the_one_object_in_it(self):
        vertices, triangles = l_shape()
        mesh = self.folder / "l.stl"
        write_stl(mesh, vertices, triangles)
        path = self.folder / "bust.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("bust/bust.mtl", "newmtl a")
            archive.writestr("bust/bust.jpg", bytes(1000))
            archive.write(mesh, "bust/bust.stl")
        self.assertEqual(self.depths(path), self.plain())
        # The project speaks of the zip, so that it can be made again.
        done = snug("make", self.folder / "out-bust.zip" / "project.snug.json", "--object", path, "-o",
                    self.folder / "again", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("readme.txt", "x")
        self.assertIn("no object in it", self.refused(path))

    def test_an_archive_that_claims_too_much_is_refused_at_once(self):
        path = self.folder / "bomb.3mf"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("3D/3dmodel.model", bytes(100_000_000))
        begun = time.monotonic()
        self.assertIn("64 MiB", self.refused(path))
        self.assertLess(time.monotonic() - begun, 10)

    def test_pictures_and_comments_in_a_3mf_change_nothing(self):
        vertices, triangles = l_shape()
        path = self.folder / "object.3mf"
        write_3mf(path, vertices, triangles)
        with zipfile.ZipFile(path, "a") as archive:
            archive.writestr("Metadata/thumbnail.png", b"\x89PNG\r\n\x1a\n" + bytes(500))
        self.assertEqual(self.depths(path), self.plain())

    def test_damaged_scenes_are_sentences(self):
        vertices, triangles = l_shape()
        scene = glb(*gltf(vertices, triangles, [{}]))
        path = self.folder / "whole.3mf"
        write_3mf(path, vertices, triangles)
        chosen = random.Random(11)
        for name, whole in (("a.glb", scene), ("a.3mf", path.read_bytes())):
            for turn in some_of(range(60)):
                data = bytearray(whole)
                for _ in range(chosen.randint(1, 8)):
                    data[chosen.randrange(len(data))] = chosen.randrange(256)
                if turn % 3 == 0:
                    data = data[:chosen.randrange(4, len(data))]
                hurt = self.folder / name
                hurt.write_bytes(data)
                done = snug("make", hurt, "-o", self.folder / "hurt", "--quiet", "--dry-run")
                self.assertIn(done.returncode, (0, 1, 2, 3), (turn, done.returncode, done.stderr))

    def test_a_cloud_is_packed_and_told(self):
        path = self.folder / "cloud.xyz"
        path.write_text("".join(f"{60 * x} {y} {z} 10 20 30\n" for x in (0, 1) for y in range(0, 101, 4)
                                for z in range(0, 81, 4)))
        done = snug("make", path, "-o", self.folder / "out", "--clearance", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1,092 points", done.stdout)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(report["object"]["points"], 1092)
        for unknown in ("watertight", "volume_mm3"):
            self.assertIsNone(report["object"][unknown])
        self.assertIsNone(report["gap"])
        few = report["foam"]["cut_blocks"]
        done = snug("make", self.folder / "out" / "project.snug.json", "--object", path, "-o", self.folder / "out",
                    "--point-radius", "20", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertGreater(report["foam"]["cut_blocks"], few)
        done = snug("inspect", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1,092 points", done.stdout)
        for text, word in (("1 2 3\n", "all its points are one"), ("1 2 3\n" * 1000, "all its points are one"),
                           ("1 2 3\n4 inf 6\n5 1e39 6\n", "2 of 3 points"), ("1,5 2,5 3,5\n", "decimal"),
                           ("1 2\n", "three numbers")):
            path.write_text(text)
            self.assertIn(word, self.refused(path))

    def test_equal_points_beside_others_take_no_time(self):
        path = self.folder / "a.xyz"
        path.write_text("1 2 3\n" * len(some_of(range(1000000))) + "61 2 3\n")
        done = snug("make", path, "-o", self.folder / "out", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
