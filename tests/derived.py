"""Writes every file that is made from others: `python -m tests.derived`.

Tables of grammars, the indexes that a program finds its words by, and the pages in `docs/` and `tests/spec/` that show
the vocabulary. Each is compared with what would be written by a test of its own.
"""

from __future__ import annotations

import subprocess
import sys

# In this order: a program cannot find a new word before the grammar knows its tokens and the indexes its row.
WRITERS = (
    "motionlang.lang.parsing.generate",
    "tests.keyword_index",
    "motionlang.assumptions.indexing",
    "tests.keyword_pages",
    "tests.mint_manual",
    "tests.machine_page",
    "tests.fidelity_page",
)


def main() -> int:
    """Run every writer, each in a process of its own, as it imports what the one before it wrote; 1 if one fails."""
    for module in WRITERS:
        print(f"== {module}", flush=True)
        if subprocess.run([sys.executable, "-m", module], check=False).returncode:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
