"""The keyword pages of the documents, written from the table of a dialect: one page a dialect, a section a group."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.views.keywords import facts
from motionlang.views.words import dialect_name

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.lang.keyword import Keyword


def markdown(rows: Sequence[Keyword], dialect: str) -> str:
    """The whole page: simulated words with all that the table knows, then those that are only known."""
    simulated = [row for row in rows if row.simulated]
    known = [row for row in rows if not row.simulated]
    lines = [
        f"# The words of {dialect_name(dialect)}",
        "",
        f"{len(simulated)} words are simulated, {len(known)} more are known and answered as not simulated. Written",
        "from the keyword table by `python -m tests.keyword_pages`; `motionlang keywords WORD` shows the same.",
    ]
    for group, members in _groups(simulated).items():
        lines += ["", f"## {group}"]
        for row in members:
            lines += ["", *_entry(row, dialect)]
    lines += ["", "## Known, not simulated"]
    apart = not {row.group for row in known} & {row.group for row in simulated}
    groups = _groups(known) if apart else {"": known}
    for group, members in groups.items():
        title = ["", f"### {group[:1].upper()}{group[1:]}"] if group else []
        lines += [*title, "", "| word | meaning |", "|---|---|"]
        lines += [f"| `{row.name}` | {_cell(row.help)} |" for row in members]
    return "\n".join(lines) + "\n"


def _groups(rows: Sequence[Keyword]) -> dict[str, list[Keyword]]:
    groups: dict[str, list[Keyword]] = {}
    for row in rows:
        groups.setdefault(row.group or row.kind, []).append(row)
    return groups


def _entry(row: Keyword, dialect: str) -> list[str]:
    known = [f"{name}: {text}" for name, text in facts(row) if text and name != "group"]
    lines = [f"### {row.name}", "", row.help, "", " · ".join(known)]
    if row.example:
        lines += ["", f"```{dialect}", *row.example.splitlines(), "```"]
    return lines


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
