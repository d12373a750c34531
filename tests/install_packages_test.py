"""scripts/install-packages beside another program that holds a lock of the packages.

Works on a repository, a system and a package of its own in a temporary folder; the system's are left alone.
"""

import os
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent.parent / "scripts" / "install-packages"
NAME = "snug-test-package"
LOCKS = {"lists": "var/lib/apt/lists/lock", "frontend": "var/lib/dpkg/lock-frontend", "dpkg": "var/lib/dpkg/lock",
         "archives": "var/cache/apt/archives/lock"}


@unittest.skipUnless(shutil.which("apt-get") and shutil.which("dpkg-deb"), "needs apt")
class InstallPackagesTest(unittest.TestCase):
    def setUp(self):
        self.work = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.work)
        self.root = self.work / "root"
        for folder in ["etc/apt/preferences.d", "etc/apt/none", "var/lib/apt/lists/partial", "var/lib/dpkg/updates", "var/lib/dpkg/info",
                       "var/cache/apt/archives/partial", "var/log/apt"]:
            (self.root / folder).mkdir(parents=True)
        (self.root / "var/lib/dpkg/status").touch()
        self.make_repository()
        (self.work / "scripts").mkdir()
        shutil.copy(SCRIPT, self.work / "scripts")
        (self.work / "packages.txt").write_text(f"[test]\n{NAME}\n")
        (self.work / "sudo").write_text('#!/bin/sh\nexec "$@"\n')
        (self.work / "sudo").chmod(0o755)
        config = self.work / "apt.conf"
        config.write_text(f'Dir "{self.root}";\nDir::State::status "{self.root}/var/lib/dpkg/status";\n'
                          'APT::Sandbox::User "";\nDir::Etc::Parts "none";\n#clear DPkg::Pre-Install-Pkgs;\n'
                          f'DPkg::Options {{"--root={self.root}"; "--force-not-root"; "--log=/dev/null";}};\n')
        self.environment = os.environ | {"APT_CONFIG": str(config), "PATH": f"{self.work}:{os.environ['PATH']}"}

    def make_repository(self):
        package, repository = self.work / "package", self.work / "repository"
        (package / "DEBIAN").mkdir(parents=True)
        package.chmod(0o755)
        (package / "DEBIAN").chmod(0o755)
        architecture = subprocess.run(["dpkg", "--print-architecture"], capture_output=True, text=True).stdout.strip()
        control = (f"Package: {NAME}\nVersion: 1\nArchitecture: {architecture}\nMaintainer: nobody <nobody@localhost>\n"
                   "Description: nothing\n")
        (package / "DEBIAN" / "control").write_text(control)
        repository.mkdir()
        file = repository / f"{NAME}.deb"
        subprocess.run(["dpkg-deb", "--root-owner-group", "-b", package, file], check=True, capture_output=True)
        digest = subprocess.run(["sha256sum", file], capture_output=True, text=True).stdout.split()[0]
        (repository / "Packages").write_text(control.rstrip() + f"\nFilename: ./{file.name}\nSize: {file.stat().st_size}\n"
                                             f"SHA256: {digest}\n\n")
        (self.root / "etc/apt/sources.list").write_text(f"deb [trusted=yes] file:{repository} ./\n")

    def install(self, seconds=60):
        return subprocess.run([self.work / "scripts" / "install-packages", "test"], capture_output=True, text=True,
                              timeout=120, env=self.environment | {"PACKAGE_LOCK_SECONDS": str(seconds)})

    def installed(self):
        return f"Package: {NAME}\nStatus: install ok installed" in (self.root / "var/lib/dpkg/status").read_text()

    def hold(self, lock):
        """As apt and dpkg hold it: by a process of its own, since a process does not stand in its own way."""
        path = self.root / LOCKS[lock]
        code = ("import fcntl, sys, time\nf = open(sys.argv[1], 'w')\nfcntl.lockf(f, fcntl.LOCK_EX)\n"
                "print('held', flush=True)\nsys.stdin.read()\n")
        holder = subprocess.Popen(["python3", "-c", code, path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.assertEqual(holder.stdout.readline(), "held\n")
        self.addCleanup(holder.stdout.close)
        self.addCleanup(holder.wait)
        return holder

    def test_it_waits_for_each_lock_and_says_so_once(self):
        for lock in LOCKS:
            with self.subTest(lock=lock):
                (self.root / "var/lib/dpkg/status").write_text("")
                holder = self.hold(lock)
                timer = threading.Timer(1.5, holder.stdin.close)
                timer.start()
                begun = time.monotonic()
                done = self.install()
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertGreater(time.monotonic() - begun, 1.4)
                self.assertEqual(done.stderr.count("Waiting for another program"), 1, done.stderr)
                self.assertTrue(self.installed())

    def test_it_ends_with_a_sentence_when_the_lock_is_never_free(self):
        holder = self.hold("lists")
        done = self.install(seconds=3)
        holder.stdin.close()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("still holds the packages", done.stderr)
        self.assertFalse(self.installed())

    def test_what_is_no_lock_fails_at_once(self):
        (self.work / "packages.txt").write_text("[test]\nsnug-no-such-package\n")
        begun = time.monotonic()
        done = self.install()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("snug-no-such-package", done.stderr)
        self.assertLess(time.monotonic() - begun, 30)


if __name__ == "__main__":
    unittest.main()
