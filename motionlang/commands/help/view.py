"""The keywords of a language as text: a list of all, or a page about one."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Sequence

from motionlang.commands.evidence.fact_evidence import of_word
from motionlang.commands.evidence.keyword_facts import facts, standing
from motionlang.kernel import Keyword
from motionlang.views.formatting import dialect_name
from motionlang.views.table import Column, Table
from motionlang.views.terminal import cells, styled

# The heading of keywords that are known but not simulated, in the list.
KNOWN = "known, not simulated"
# Keywords that people use first; they and their groups begin the list.
FIRST = {
    "mint": "MOVER MOVEA GO SPEED ACCEL DECEL JOG POS IDLE VEL SCALEFACTOR HOME STOP CANCEL INX OUTX IN OUT WAIT PAUSE "
    "PRINT",
    "mccl": "MR MA GO WS ST SV SA DS MN MF US TP TV CN CF WN WF WA RP",
}


def listing(
    rows: Sequence[Keyword], dialect: str, *, width: int = 100, colour: bool = False, whole: bool = False
) -> str:
    """List all rows by group, one keyword per line.

    Keywords that are not simulated come last, several per line. Lines are truncated at `width` unless `whole` is
    set, for output that is searched or read by a program.
    """
    simulated = [row for row in rows if row.simulated]
    known = [row.name for row in rows if not row.simulated]
    count = f"{len(simulated)} simulated, {len(known)} known"
    lines = [f"{styled(dialect_name(dialect), 'bold', colour)} · {count}"]
    name_width = max((len(row.name) for row in simulated), default=0)
    short_width = max((len(row.short) for row in simulated), default=0)
    groups: dict[str, list[Keyword]] = {}
    first = {name: place for place, name in enumerate(FIRST[dialect].split())}
    for row in sorted(simulated, key=lambda row: first.get(row.name.upper(), len(first))):
        groups.setdefault(row.group or row.kind, []).append(row)
    for group, members in groups.items():
        lines += ["", styled(group, "bold", colour)]
        room = sys.maxsize if whole else width
        lines += [_entry(row, name_width, short_width, room, colour) for row in members]
    if known:
        lines += ["", styled(KNOWN, "bold", colour)]
        lines += textwrap.wrap(", ".join(known), width - 2, initial_indent="  ", subsequent_indent="  ")
    return "\n".join(lines) + "\n"


def page(rows: Sequence[Keyword], dialect: str, *, width: int = 100, colour: bool = False) -> str:
    """Return a page with all the table's facts about each keyword in `rows`."""
    return "\n".join(_page(row, dialect, width, colour) for row in rows)


# Signs with a meaning in Markdown.
SIGNS = str.maketrans({sign: f"\\{sign}" for sign in "\\`*_{}[]<>#|"})


def markdown(row: Keyword, dialect: str) -> str:
    """Return the help, the facts with their evidence and the example of a keyword in Markdown."""
    begin, colon, end = standing(row, dialect).partition(":")
    lines = [f"*{begin}*:{end}", ""] if colon else []
    lines += [row.help.translate(SIGNS), ""]
    known = [
        f"{name}: {text.translate(SIGNS)}" for name, text in facts(row, dialect) if text and name != "group"
    ]
    lines.append(" · ".join(known))
    lines += ["", f"```{dialect}", row.example, "```"] if row.example else []
    return "\n".join(lines)


# Fields of a row with another name in data.
FIELDS = {
    "below": "excludes_high",
    "driven": "machine_section",
    "every": "true_of_all",
    "gives": "sets",
    "meant": "synonyms",
    "solved": "solvable",
    "tunes": "servo_gain",
}


def keywords_table(rows: Sequence[tuple[str, Keyword]]) -> Table:
    """Return all facts about keywords, each with its language, as data."""
    found = []
    for dialect, row in rows:
        names = (
            name for name in sorted(vars(row)) if name not in ("actions", "simulated", "function", "word")
        )
        meaning = of_word(dialect, row)["meaning"]
        found.append({
            "dialect": dialect,
            **{FIELDS.get(name, name): getattr(row, name) for name in names},
            "simulated": row.simulated,
            "source": meaning.source,
            "strength": meaning.strength,
        })  # fmt: skip
    return Table("keywords", list(map(Column, dict.fromkeys(name for row in found for name in row))), found)


def evidence_table(rows: Sequence[tuple[str, Keyword]]) -> Table:
    """Return how well each fact about keywords is known, as data."""
    found = [
        {
            "dialect": dialect,
            "keyword": row.name,
            "fact": fact,
            "strength": each.strength,
            "source": each.source,
        }
        for dialect, row in rows
        for fact, each in of_word(dialect, row).items()
    ]
    columns = tuple(map(Column, ("dialect", "keyword", "fact", "strength", "source")))
    return Table("evidence", columns, found)


def _entry(row: Keyword, name_width: int, short_width: int, width: int, colour: bool) -> str:
    name = styled(row.name, "word", colour) + " " * (name_width - len(row.name))
    short = f"{row.short:<{short_width}}  " if short_width else ""
    room = max(10, width - name_width - len(short) - 12)
    help_text = row.help if cells(row.help) <= room else row.help[: room - 1].rstrip() + "…"
    return f"  {name}  {short}{row.unit:<7} {help_text}".rstrip()


def _wrapped(text: str, width: int, indent: int = 2) -> list[str]:
    return textwrap.wrap(text, width, initial_indent=" " * indent, subsequent_indent=" " * indent)


def _page(row: Keyword, dialect: str, width: int, colour: bool) -> str:
    title = f"{styled(row.name, 'bold', colour)} · {dialect_name(dialect)} {row.kind}"
    lines = [title, ""]
    about = standing(row, dialect)
    if about:
        first, *more = _wrapped(about, min(width, 88))
        begin, end = first.split(":", 1)
        lines += [f"  {styled(begin.strip(), 'warning', colour)}:{end}", *more, ""]
    lines += _wrapped(row.help, min(width, 88))
    known = [(name, text) for name, text in facts(row, dialect) if text]
    label = max(len(name) for name, _ in known)
    lines.append("")
    for name, text in known:
        first, *more = _wrapped(text, width, label + 4)
        lines += [f"  {styled(name, 'dim', colour)}{first[2 + len(name) :]}", *more]
    if row.example:
        lines += ["", *(f"    {styled(line, 'word', colour)}" for line in row.example.splitlines())]
    return "\n".join(lines) + "\n"
