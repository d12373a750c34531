"""Runs every command of the README's shell blocks, except those that call make, and looks whether all that it and the
pages of docs/ link to is there: files, headings, the guide's pictures.

Usage: readme_test.py SNUG
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

SNUG = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"


def anchors(page):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#+ (.*)", page.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
        if re.match(r"\w+:", target):
            continue
        path, _, anchor = target.partition("#")
        linked = page.parent / path if path else page
        if not linked.exists() or (anchor and anchor not in anchors(linked)):
            yield f"{page.relative_to(ROOT)}: {target}"


def check_links():
    pages = [README, *sorted((ROOT / "docs").glob("*.md"))]
    wrong = [dead for page in pages for dead in dead_links(page)]
    shown = "".join(page.read_text() for page in pages)
    wrong += [f"{picture.name} is shown nowhere" for picture in (ROOT / "docs").rglob("*.png") if picture.name not in shown]
    if wrong:
        sys.exit("\n".join(wrong))


def main():
    check_links()
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
