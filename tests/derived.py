"""Writer of every derived file: `python -m tests.derived`.

These are tables of grammars, the indexes of keywords, and the pages in `docs/` and `tests/spec/` that show
the vocabulary. A separate test compares each with its source.
"""

from __future__ import annotations

import subprocess
import sys

# In this order: a program cannot use a new keyword before the grammar has its tokens and the indexes its row.
WRITERS = (
    "motionlang.lang.parsing.generate",
    "tests.keyword_index",
    "motionlang.assumptions.indexing",
    "tests.keyword_pages",
    "tests.mint_manual",
    "tests.machine_page",
    "tests.fidelity_page",
    "tests.sources.page",
    "tests.report_types",
    "tests.mcapi_files",
    "tests.cli_page",
    "tests.diagnostics_page",
    "tests.vscode_grammars",
    "tests.stages_page",
    "tests.highlight_tables",
)


def main() -> int:
    """Run every writer in a process of its own; 1 if one fails.

    Each imports the files that the one before it wrote.
    """
    for module in WRITERS:
        print(f"== {module}", flush=True)
        if subprocess.run([sys.executable, "-m", module], check=False).returncode:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
