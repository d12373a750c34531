"""The ways of fabrication, as docs/options.md has them, which the table of options makes."""

import re
from pathlib import Path

ROW = re.search(r"^\| `workshop\.for` \|[^|]*\|([^|]*)\|", (Path(__file__).parents[2] / "docs/options.md").read_text(), re.M)
WAYS = re.findall(r"`(\w+)`", ROW[1])
