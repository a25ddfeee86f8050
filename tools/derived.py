"""Writer of every derived file: `python -m tools.derived`.

Derived files are the tables of grammars, the indexes of keywords, and the pages in `docs/` and `tests/spec/`
that show the vocabulary. `tests/test_derived.py` compares each with its source.
"""

from __future__ import annotations

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from pkgutil import resolve_name

# In this order: a program cannot use a new keyword before the grammar has its tokens and the indexes its row. Each
# group has a process of its own, so that it imports the files that the groups before it wrote.
GRAMMARS = "motionlang.kernel.tables"
GROUPS: tuple[tuple[str, ...], ...] = (
    ("tools.keyword_index:files",),
    ("tools.assumption_index:files",),
    (
        "tools.keyword_pages:mint",
        "tools.keyword_pages:mccl",
        "tools.keyword_pages:menu",
        "tools.mint_manual:files",
        "tools.machine_page:files",
        "tools.fidelity_page:files",
        "tools.sources_page:files",
        "tools.report_types:files",
        "tools.command_pages:files",
        "tools.diagnostics_page:files",
        "tools.vscode_grammars:files",
        "tools.stages_page:files",
        "tools.kernel_names:files",
        "tools.seam:files",
        "tools.highlight_tables:files",
    ),
)
if find_spec("motionlang_mcapi"):
    GROUPS += (("extras.mcapi.mcapi_files:files",),)
# The text of each file of a writer, None if the file must not exist.
Files = dict[Path, str | None]


def derived(writer: str) -> Files:
    """Return the files of a writer as they have to be."""
    files: Files = resolve_name(writer)()
    return files


def write(writer: str) -> None:
    """Write and delete files as a writer requires."""
    print(f"== {writer}", flush=True)
    for path, text in derived(writer).items():
        if text is None:
            path.unlink()
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")


def main(writers: list[str]) -> int:
    """Write the files of the given writers in this process, or all derived files; return 1 if one fails."""
    for writer in writers:
        write(writer)
    for command in () if writers else ((GRAMMARS,), *(("tools.derived", *group) for group in GROUPS)):
        if subprocess.run([sys.executable, "-m", *command], check=False).returncode:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
