"""Runs every command of the README's shell blocks, except those that call make.

Usage: readme_test.py SNUG
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

SNUG = Path(sys.argv[1]).resolve()
README = Path(__file__).resolve().parent.parent / "README.md"


def main():
    blocks = re.findall(r"```sh\n(.*?)```", README.read_text(), re.S)
    commands = [line for block in blocks for line in block.splitlines() if not line.startswith("make ")]
    if len(commands) < 5:
        sys.exit("the README has lost its commands")
    with tempfile.TemporaryDirectory() as work:
        (Path(work) / "build").mkdir()
        (Path(work) / "build" / "snug").symlink_to(SNUG)
        for command in commands:
            done = subprocess.run(command, shell=True, cwd=work, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{command}: status {done.returncode}\n{done.stderr}")
    print(f"{len(commands)} passed, 0 failed")


main()
