"""How many cases a test looks at, as tests/support/cases.h has it."""

import os

SHARE = int(os.environ.get("SNUG_CASES", 2000)) / 2000


def some_of(cases, least=1):
    """All of them, or, evenly from the whole and no fewer than `least`, the share that SNUG_CASES is of 2000."""
    cases = list(cases)
    count = max(min(least, len(cases)), min(len(cases), round(len(cases) * SHARE)))
    return [cases[i * len(cases) // count] for i in range(count)]
