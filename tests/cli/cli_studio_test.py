"""`snug studio` as a browser, and as somebody who means ill, meets it.

Usage: cli_studio_test.py SNUG [unittest arguments]
"""

import hashlib
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SNUG = Path(sys.argv.pop(1)).resolve()


class Server:
    """The program, serving; ended by Ctrl-C."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([SNUG, "studio", *map(str, arguments)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.said = []
        self.port = None
        for line in self.process.stdout:
            self.said.append(line)
            if found := re.search(r"http://127\.0\.0\.1:(\d+)/(\S*)", line):
                self.port, self.rest = int(found[1]), found[2]
                break

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.end()
        self.process.stdout.close()
        self.process.stderr.close()

    def end(self):
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(20)

    def ask(self, path, method="GET", host=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host=host is not None)
        if host is not None:
            connection.putheader("Host", host)
        connection.endheaders()
        response = connection.getresponse()
        body = response.read()
        connection.close()
        return response, body


def policy_of_page():
    """What the page says of itself, which the server repeats for all that it serves."""
    page = Path(__file__).resolve().parents[2] / "studio" / "index.html"
    return re.search(r'Content-Security-Policy"\s*content="([^"]*)"', page.read_text())[1]


class StudioTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.site = self.folder / "site"
        (self.site / "assets").mkdir(parents=True)
        (self.site / "index.html").write_text("<title>page</title>")
        (self.site / "assets" / "snug.wasm").write_bytes(b"\0asm")
        (self.site / "assets" / "app.js").write_text("1")
        (self.site / "assets" / "core.mjs").write_text("2")
        (self.site / "assets" / "app.css").write_text("a {}")
        (self.site / "icon.svg").write_text("<svg/>")
        (self.site / "icon.png").write_bytes(b"\x89PNG")
        (self.site / "list.json").write_text("[]")
        (self.site / "manifest.webmanifest").write_text("{}")
        (self.site / ".secret").write_text("no")
        (self.folder / "outside.txt").write_text("no")
        os.symlink(self.folder / "outside.txt", self.site / "link.txt")

    def serve(self, *arguments):
        return Server("--files", self.site, *arguments)

    def sample(self, name):
        path = self.folder / name
        subprocess.run([SNUG, "sample", "vase", "-o", path], check=True, stdout=subprocess.DEVNULL)
        return path

    def test_serves_the_page_with_its_types_and_a_strict_policy(self):
        with self.serve() as server:
            for path, kind, body in (("/", "text/html", b"<title>page</title>"), ("/index.html", "text/html", None),
                                     ("/assets/snug.wasm", "application/wasm", b"\0asm"),
                                     ("/assets/app.js", "text/javascript", b"1"),
                                     ("/assets/core.mjs", "text/javascript", b"2"),
                                     ("/assets/app.css", "text/css", None), ("/icon.svg", "image/svg+xml", None),
                                     ("/icon.png", "image/png", None), ("/list.json", "application/json", None),
                                     ("/manifest.webmanifest", "application/manifest+json", None)):
                response, content = server.ask(path)
                self.assertEqual(response.status, 200, path)
                self.assertTrue(response.getheader("Content-Type").startswith(kind), path)
                for name, value in (("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer"),
                                    ("Cache-Control", "no-cache"), ("Cross-Origin-Resource-Policy", "same-origin")):
                    self.assertEqual(response.getheader(name), value, path)
                policy = response.getheader("Content-Security-Policy")
                self.assertEqual(policy, policy_of_page() + "; frame-ancestors 'none'", path)
                if body is not None:
                    self.assertEqual(content, body)
            self.assertEqual(server.ask("/", "HEAD")[0].status, 200)
            self.assertEqual(server.end(), 0)

    def test_nothing_outside_of_the_folder_can_be_had(self):
        with self.serve() as server:
            for path in ("/../outside.txt", "/%2e%2e/outside.txt", "/assets/../../outside.txt", "/link.txt", "/.secret",
                         "/assets", "/assets/", "//etc/passwd", "/etc/passwd", "/object/info", "/%00"):
                response, body = server.ask(path)
                self.assertIn(response.status, (400, 404), path)
                self.assertNotEqual(body, b"no", path)

    def test_refuses_other_methods_and_other_names_for_this_machine(self):
        with self.serve() as server:
            for method in ("POST", "PUT", "DELETE", "OPTIONS", "PATCH"):
                self.assertEqual(server.ask("/", method)[0].status, 405, method)
            for host in ("evil.example", "evil.example:80", "127.0.0.1.evil.example", ""):
                self.assertEqual(server.ask("/", host=host)[0].status, 403, host)
            for host in ("localhost", f"127.0.0.1:{server.port}"):
                self.assertEqual(server.ask("/", host=host)[0].status, 200, host)

    def test_listens_on_the_loopback_address_alone(self):
        with self.serve() as server:
            with self.assertRaises(OSError):
                socket.create_connection(("127.0.0.2", server.port), timeout=5)
            own = subprocess.run(["hostname", "-I"], capture_output=True, text=True).stdout.split()
            for address in own:
                with self.assertRaises(OSError, msg=address):
                    socket.create_connection((address, server.port), timeout=5)

    def test_a_taken_port_is_refused_and_a_free_one_found(self):
        with self.serve() as first:
            done = subprocess.run([SNUG, "studio", "--files", self.site, "--port", str(first.port)],
                                  capture_output=True, text=True, timeout=30)
            self.assertEqual(done.returncode, 4)
            self.assertIn("taken", done.stderr)
            with self.serve() as second:
                self.assertNotEqual(first.port, second.port)

    def test_offers_the_object_as_it_is(self):
        vase = self.sample("vase.stl")
        with self.serve(vase) as server:
            self.assertEqual(server.rest, "?object")
            info = json.loads(server.ask("/object/info")[1])
            self.assertEqual((info["name"], info["thinned"], info["project"]), ("vase.stl", False, False))
            self.assertEqual(info["sha256"], hashlib.sha256(vase.read_bytes()).hexdigest())
            self.assertEqual(info["triangles"], info["shown_triangles"])
            self.assertEqual(server.ask("/object/file")[1], vase.read_bytes())
            response, nothing = server.ask("/object/file", "HEAD")
            self.assertEqual((response.status, nothing), (200, b""))
            self.assertEqual(response.getheader("Content-Length"), str(vase.stat().st_size))

    def test_offers_a_project_with_its_object(self):
        vase = self.sample("vase.stl")
        subprocess.run([SNUG, "make", vase, "-o", self.folder / "out", "--quiet", "--rotate", "0,90,0"], check=True)
        project = self.folder / "work.snug.json"
        project.write_bytes((self.folder / "out" / "project.snug.json").read_bytes())
        with self.serve(project) as server:
            self.assertTrue(json.loads(server.ask("/object/info")[1])["project"])
            design = json.loads(server.ask("/object/project")[1])["design"]
            self.assertEqual(design["placement"]["rotation_deg"], [0, 90, 0])
            self.assertEqual(server.ask("/object/file")[1], vase.read_bytes())
        moved = vase.rename(self.folder / "out" / "moved.stl")
        with self.serve(project, "--object", moved) as server:
            self.assertEqual(server.ask("/object/file")[1], moved.read_bytes())

    def test_connections_that_stay_idle_hold_up_neither_a_page_nor_the_end(self):
        with self.serve() as server:
            idle = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(12)]
            start = time.monotonic()
            self.assertEqual(server.ask("/")[0].status, 200)
            self.assertEqual(server.end(), 0)
            self.assertLess(time.monotonic() - start, 3)
            for connection in idle:
                connection.close()

    def test_a_file_that_is_too_large_is_shown_as_a_thin_copy(self):
        vase = self.sample("vase.stl")
        with self.serve(vase, "--most-bytes", "1000") as server:
            self.assertIn("too large for a page", "".join(server.said))
            info = json.loads(server.ask("/object/info")[1])
            self.assertTrue(info["thinned"])
            self.assertEqual(info["original"], "vase.stl")
            self.assertLessEqual(info["shown_triangles"], info["triangles"])
            thin = self.folder / info["name"]
            thin.write_bytes(server.ask("/object/file")[1])
            seen = subprocess.run([SNUG, "inspect", thin], capture_output=True, text=True)
            self.assertEqual(seen.returncode, 0)

    def test_says_what_is_wrong_before_it_serves(self):
        (self.folder / "broken.stl").write_text("solid of nothing")
        for arguments, sentence in ((("--files", self.folder / "nowhere"), "make build"),
                                    (("--files", self.site, self.folder / "absent.stl"), "absent.stl"),
                                    (("--files", self.site, self.folder / "broken.stl"), "broken.stl")):
            done = subprocess.run([SNUG, "studio", *map(str, arguments)], capture_output=True, text=True, timeout=30)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(sentence, done.stderr)


if __name__ == "__main__":
    unittest.main()
