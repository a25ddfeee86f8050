"""Links between pages lead to a page and a heading that exist.

Pages that messages name exist, too.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from tests.trees import nodes_of, text_of

ROOT = Path(__file__).parents[1]
PAGES = [
    *(ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("extras/*/README.md"))),
    *(INDEXED := sorted([*(ROOT / "docs").rglob("*.md"), *ROOT.glob("extras/*/docs/**/*.md")])),
]
_LINK = re.compile(r"\]\((?!https?:|mailto:)([^)#\s]*)(?:#([^)\s]+))?\)")
_FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)


@cache
def anchors(page: Path) -> set[str]:
    """Return the anchors that GitHub makes for the headings of a page."""
    text = _FENCED.sub("", page.read_text(encoding="utf-8"))
    found: set[str] = set()
    numbers: Counter[str] = Counter()
    for heading in re.findall(r"^#+ (.*?)\s*$", text, re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = "".join(c for c in plain if c.isalnum() or c in " -_").replace(" ", "-")
        found.add(f"{anchor}-{numbers[anchor]}" if numbers[anchor] else anchor)
        numbers[anchor] += 1
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_each_link_leads_somewhere(page: Path) -> None:
    lost = []
    for path, anchor in _LINK.findall(_FENCED.sub("", page.read_text(encoding="utf-8"))):
        target = (page.parent / path).resolve() if path else page
        if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target)):
            lost.append(f"{path}#{anchor}" if anchor else path)
    assert lost == []


def test_the_index_has_every_page() -> None:
    index = ROOT / "docs" / "README.md"
    linked = {(index.parent / path).resolve() for path, _ in _LINK.findall(index.read_text(encoding="utf-8"))}
    # Their own indexes have the pages of the keywords, and of the commands.
    pages = [
        page
        for page in INDEXED
        if page.parent.parent.name != "keywords" and page.parent.name != "commands" and page != index
    ]
    assert [str(page.relative_to(ROOT)) for page in pages if page not in linked] == []
    assert {"mint.md", "mccl.md"} <= {page.name for page in linked}


def test_messages_name_pages_that_exist() -> None:
    named = {
        name
        for path in (ROOT / "motionlang").rglob("*.py")
        if "docs/" in text_of(path)
        for node in nodes_of(path)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
        for name in re.findall(r"docs/[\w/.-]+\.\w+", node.value)
    }
    assert "docs/diagnostics.md" in named
    assert sorted(name for name in named if not (ROOT / name).exists()) == []
