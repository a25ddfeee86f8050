"""Writer of every derived file: `python -m tests.derived`.

Derived files are the tables of grammars, the indexes of keywords, and the pages in `docs/` and `tests/spec/`
that show the vocabulary. For each there is a test that compares it with its source.
"""

from __future__ import annotations

import subprocess
import sys
from runpy import run_module

# In this order: a program cannot use a new keyword before the grammar has its tokens and the indexes its row. Each
# group has a process of its own, so that it imports the files that the groups before it wrote.
GROUPS = (
    ("motionlang.kernel.tables",),
    ("tests.keyword_index",),
    ("tests.assumption_index",),
    (
        "tests.keyword_pages",
        "tests.mint_manual",
        "tests.machine_page",
        "tests.fidelity_page",
        "tests.sources.page",
        "tests.report_types",
        "tests.mcapi_files",
        "tests.command_pages",
        "tests.diagnostics_page",
        "tests.vscode_grammars",
        "tests.stages_page",
        "tests.highlight_tables",
    ),
)


def main(modules: list[str]) -> int:
    """Run the given writers in this process, or all of them; return 1 if one fails."""
    for module in modules:
        print(f"== {module}", flush=True)
        sys.argv[1:] = []
        try:
            run_module(module, run_name="__main__")
        except SystemExit as end:
            if end.code:
                return 1
    for group in () if modules else GROUPS:
        if subprocess.run([sys.executable, "-m", "tests.derived", *group], check=False).returncode:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
