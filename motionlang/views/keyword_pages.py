"""The keyword page of a dialect in the documentation, written from its table.

There is one section per group. Groups and keywords are in alphabetical order, because a page of hundreds of
keywords is for reference.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.assumptions.keyword_facts import facts
from motionlang.assumptions.questions import of_word
from motionlang.views.words import dialect_name

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.lang.keyword import Keyword


# The largest number of output lines shown for an example.
MAX_EXAMPLES = 12
# Titles of groups whose names are not titles.
TITLES = {
    "io": "Inputs and outputs",
    "v4": "Older keywords",
    "state": "State of an axis",
    "tables": "Cams and splines",
}
# Control characters, mapped to the symbols that represent them.
SIGNS = {code: 0x2400 + code for code in range(32) if code not in (9, 10)}


def markdown(rows: Sequence[Keyword], dialect: str, shown: Callable[[Keyword], Sequence[str]]) -> str:
    """Return the whole page.

    Keywords that are simulated come first, with all facts in the table, then the others. `shown` returns the
    output of a keyword's example.
    """
    simulated = [row for row in rows if row.simulated]
    known = [row for row in rows if not row.simulated]
    lines = [
        f"# {dialect_name(dialect)} keywords",
        "",
        (
            f"{len(simulated)} keywords are simulated; {len(known)} more are recognised but not "
            "simulated. Generated"
        ),
        (
            "from the keyword table by `python -m tests.derived`; `motionlang keywords KEYWORD` shows "
            "the same."
        ),
    ]
    groups = _groups(simulated)
    lines += ["", *(f"* [{_title(group)}](#{_title(group).lower().replace(' ', '-')})" for group in groups)]
    lines += ["* [Known, not simulated](#known-not-simulated)"]
    for group, members in groups.items():
        lines += ["", f"## {_title(group)}"]
        for row in members:
            lines += ["", *_entry(row, dialect, shown)]
    lines += ["", "## Known, not simulated"]
    apart = not {row.group for row in known} & {row.group for row in simulated}
    groups = _groups(known) if apart else {"": known}
    for group, members in groups.items():
        title = ["", f"### {_title(group)}"] if group else []
        lines += [*title, "", "| keyword | meaning |", "|---|---|"]
        lines += [f"| `{row.name}` | {_cell(row.help)} |" for row in members]
    return "\n".join(lines) + "\n"


def _groups(rows: Sequence[Keyword]) -> dict[str, list[Keyword]]:
    groups: dict[str, list[Keyword]] = {}
    for row in sorted(rows, key=lambda row: ((row.group or row.kind).lower(), row.name.lower())):
        groups.setdefault(row.group or row.kind, []).append(row)
    return groups


def _title(group: str) -> str:
    return TITLES.get(group, f"{group[:1].upper()}{group[1:]}")


def _entry(row: Keyword, dialect: str, shown: Callable[[Keyword], Sequence[str]]) -> list[str]:
    known = [f"{name}: {text}" for name, text in facts(row, dialect) if text and name != "group"]
    lines = [f"### {row.name}", "", row.help, "", " · ".join(known)]
    if row.example:
        lines += ["", f"```{dialect}", *row.example.splitlines(), "```"]
        output = [line.translate(SIGNS) for line in shown(row)]
        if len(output) > MAX_EXAMPLES:
            output = [*output[:MAX_EXAMPLES], "…"]
        lines += ["", "shows", "", "```text", *output, "```"] if output else []
    return lines + _open(row, dialect)


def _open(row: Keyword, dialect: str) -> list[str]:
    """Return the open questions on a keyword, one per line."""
    lines: list[str] = []
    for each in of_word(dialect, row):
        others = f"; or: {'; or '.join(each.alternatives)}" if each.alternatives else ""
        marked = f"`{each.name}`" if each.probe is None else f"`motionlang probe {each.name}`"
        lines.append(f"* {each.question}: {each.chosen}{others} ({marked})")
    return ["", "open", "", *lines] if lines else []


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
