"""Writer of docs/contributing/seam.md: the names of motionlang that motionlang-explore imports.

A name is marked if no other package of motionlang outside the kernel imports it, nor another distribution: it is there
for the exploration alone.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXPLORE = ROOT / "extras" / "explore" / "motionlang_explore"
PAGE = ROOT / "docs" / "contributing" / "seam.md"
HEAD = """\
# The names that motionlang exports for motionlang-explore

This list is the seam between the two products: what changes here changes both. It is derived from the imports
(`python -m tools.derived`), and it stays small. A name in *italics* is there for the exploration alone.

| module | names |
|---|---|
"""


def imported(path: Path) -> Iterator[tuple[str, str]]:
    """Yield the names that a file imports from motionlang, each with its module."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        module = node.module if isinstance(node, ast.ImportFrom) else None
        if isinstance(node, ast.ImportFrom) and module and module.split(".")[0] == "motionlang":
            yield from ((module, each.name) for each in node.names)


def files() -> dict[Path, str]:
    others = [
        path
        for path in [*(ROOT / "motionlang").rglob("*.py"), *ROOT.glob("extras/*/motionlang_*/**/*.py")]
        if EXPLORE not in path.parents and ROOT / "motionlang" / "kernel" not in path.parents
    ]
    shared = {name for path in others for name in imported(path)}
    used: defaultdict[str, set[str]] = defaultdict(set)
    for path in EXPLORE.rglob("*.py"):
        for module, name in imported(path):
            used[module].add(name)
    rows = [
        f"| `{module}` | {', '.join(_shown(name, (module, name) in shared) for name in sorted(names))} |\n"
        for module, names in sorted(used.items())
    ]
    count = sum(map(len, used.values()))
    alone = sum((module, name) not in shared for module, names in used.items() for name in names)
    return {
        PAGE: f"{HEAD}{''.join(rows)}\n{count} names of {len(used)} modules, {alone} for the exploration alone.\n"
    }


def _shown(name: str, is_shared: bool) -> str:
    return f"`{name}`" if is_shared else f"*`{name}`*"
