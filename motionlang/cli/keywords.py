"""`motionlang keywords`: all keywords of a language, or the page of one keyword."""

from __future__ import annotations

import argparse
import os
import sys

from motionlang.assumptions.assumption import SETTLED
from motionlang.assumptions.facts import of_word as of_word_facts
from motionlang.assumptions.questions import of_word
from motionlang.cli.dialect_option import add_dialect
from motionlang.cli.format_options import add_format
from motionlang.cli.keyword_search import search
from motionlang.cli.parser import Commands, add_command, arrange
from motionlang.errors import Diagnostic, nearest
from motionlang.lang.dialect import dialect, dialects
from motionlang.lang.keyword import Keyword
from motionlang.views import assumptions
from motionlang.views.diagnostics import render
from motionlang.views.keywords import as_dict, listing, page
from motionlang.views.terminal import PIPED_WIDTH, draws, is_terminal, plain, wants_colour, width_of

# For a keyword whose meaning is remembered.
MEANING = (
    "its meaning is unconfirmed, too: run the example here and on a controller whose axes may "
    "move, and compare"
)
SCHEMA = "motionlang.keywords/2"


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang keywords` and its options."""
    parser = add_command(commands, "keywords", summary, _keywords)
    parser.add_argument(
        "name",
        metavar="NAME",
        nargs="*",
        help="the keyword, by its name or short form, a group of keywords, or words of its description",
    )
    add_dialect(parser, "the language; default: both")
    add_format(parser)
    arrange(parser, {"language": "dialect", "report": "format output"})


def _keywords(arguments: argparse.Namespace) -> int:
    return keywords_command(" ".join(arguments.name) or None, arguments.dialect, arguments.format == "json")


def keywords_command(name: str | None, dialect_name: str | None, as_json: bool) -> int:
    """Print the list, the page of a keyword or the list of a group; 1 if unknown."""
    names = dialects() if dialect_name is None else (dialect_name,)
    tables = {each: dialect(each).table() for each in names}
    single, omitted = name is not None, 0
    if name is None:
        found = {each: list(table) for each, table in tables.items()}
    else:
        found = {each: [row] for each, table in tables.items() if (row := table.get(name)) is not None}
        if not found:
            single = False
            found = {each: members for each, table in tables.items() if (members := table.group(name))}
        if not found:
            words = [
                word
                for table in tables.values()
                for row in table
                for word in (row.name, row.short, row.group)
                if word
            ]
            found, omitted = search(name, tables)
            near = nearest(name, words)
            if not found or (" " not in name and near is not None and _is_misspelt(name, near, found)):
                return _unknown(name, near)
    if as_json:
        rows = [
            {
                **as_dict(row, each),
                "assumptions": [assumptions.as_dict(open_one) for open_one in of_word(each, row)],
            }
            for each, rows in found.items()
            for row in rows
        ]
        import json

        sys.stdout.write(json.dumps({"schema": SCHEMA, "keywords": rows}, indent=1) + "\n")
    else:
        _print(found, single)
        if omitted:
            sys.stdout.write(f"\n{omitted} more match; add a word\n")
    return 0


def _is_misspelt(name: str, near: str, found: dict[str, list[Keyword]]) -> bool:
    """True unless `name` is a part of keywords found, and the nearest one does not begin with it.

    JERK is near RK, but part of ACCELJERK.
    """
    part = name.lower()
    return near.lower().startswith(part) or not any(
        part in row.name.lower() for rows in found.values() for row in rows
    )


def _print(found: dict[str, list[Keyword]], single: bool) -> None:
    colour = wants_colour(sys.stdout)
    seen = is_terminal(sys.stdout) or "COLUMNS" in os.environ
    width = width_of(sys.stdout) if seen else PIPED_WIDTH
    if single:
        pages = [_page(row, each, width, colour) for each, (row,) in found.items()]
    else:
        pages = [
            listing(rows, each, width=width, colour=colour, whole=not seen) for each, rows in found.items()
        ]
    text = "\n".join(pages)
    sys.stdout.write(text if draws(sys.stdout) else plain(text))


def _page(row: Keyword, language: str, width: int, colour: bool) -> str:
    """Return all facts of a keyword, and its open assumptions."""
    text = page([row], language, width=width, colour=colour)
    questions = of_word(language, row)
    if row.example and of_word_facts(language, row)["meaning"].strength not in SETTLED:
        text += f"\n  {MEANING}\n"
    if questions:
        axis = dialect(language).first_axis
        text += "\n" + assumptions.of_word(questions, axis, width=min(width, 88), colour=colour)
    return text


def _unknown(name: str, near: str | None) -> int:
    hint = f"did you mean {near}?" if near else "motionlang keywords lists all keywords"
    diagnostic = Diagnostic("unknown-word", f"there is no keyword {name}", hint=hint)
    sys.stderr.write(render(diagnostic, colour=wants_colour(sys.stderr)))
    return 1
