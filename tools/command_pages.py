"""Writer of the tables of options in docs/commands.

The tables come from the classes of the commands, through their parsers. A page has hand-written text around sections
that begin with `<!-- options: COMMAND -->`, `<!-- played -->` or, in its README, `<!-- commands -->`, and end with
`<!-- end -->`. Only these sections are generated.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from pathlib import Path

from motionlang.cli.commands import GROUPS, build_parser
from tests.extras import ABSENT, MISSING

if "explore" not in ABSENT:
    from motionlang_explore.playing import PLAYED

ROOT = Path(__file__).parents[1]
_SECTION = re.compile(r"(<!-- (commands|played|options: ([\w ]+)) -->\n).*?(<!-- end -->)", re.DOTALL)


def subparsers(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """Return the parsers of a parser's subcommands, by name."""
    return {
        name: each
        for action in parser._actions
        if isinstance(action, argparse._SubParsersAction)
        for name, each in action.choices.items()
    }


def parsers() -> dict[str, argparse.ArgumentParser]:
    """Return every parser that has options, by its command, such as "pvt plot"."""
    found: dict[str, argparse.ArgumentParser] = {}
    for name, parser in subparsers(build_parser("*")).items():
        below = subparsers(parser)
        found |= {f"{name} {each}": other for each, other in below.items()} if below else {name: parser}
    return found


def pages() -> list[Path]:
    """Return the pages, in order, without those of commands that need a distribution that is not installed."""
    found = [*ROOT.glob("docs/commands/*.md"), *ROOT.glob("extras/*/docs/commands/*.md")]
    return sorted(each for each in found if each.stem not in MISSING)


def written(text: str) -> str:
    """Return the text of a page with its generated sections updated."""
    known = parsers()

    def section(found: re.Match[str]) -> str:
        rows = _options(known[found[3]]) if found[3] else _played() if found[2] == "played" else _commands()
        body = "".join(rows)
        return f"{found[1]}{body}{found[4]}"

    return _SECTION.sub(section, text)


def _commands() -> Iterator[str]:
    for title, rows in GROUPS.items():
        yield f"\n| {title} | |\n|---|---|\n"
        for name, (_, summary) in rows.items():
            yield f"| [`{name}`]({name}.md) | {_cell(summary)} |\n"
    yield "\n"


def _played() -> Iterator[str]:
    yield "\n| of a world | is played | is not played |\n|---|---|---|\n"
    for row in PLAYED:
        yield f"| {' | '.join(row)} |\n"
    yield "\n"


def _options(parser: argparse.ArgumentParser) -> Iterator[str]:
    yield "\n"
    for group in parser._action_groups:
        rows = [
            f"| {_spelt(action)} | {_cell(parser._get_formatter()._expand_help(action))} |\n"
            for action in group._group_actions
            if action.dest != "help" and action.help is not argparse.SUPPRESS
        ]
        if rows:
            title = {"positional arguments": "argument", "options": "option"}.get(
                group.title or "", group.title
            )
            yield f"| {title} | |\n|---|---|\n{''.join(rows)}\n"


def _spelt(action: argparse.Action) -> str:
    """Return the name of an argument and a placeholder for its value."""
    value = action.metavar or ("|".join(map(str, action.choices)) if action.choices else action.dest)
    name = str(value) if not isinstance(value, tuple) else " ".join(value)
    if not action.option_strings:
        return f"`{_cell(name)}`"
    if action.nargs == 0:
        return ", ".join(f"`{each}`" for each in action.option_strings)
    end = f" [{name}]" if action.nargs == "?" else f" {name}"
    return ", ".join(f"`{each}{_cell(end)}`" for each in action.option_strings)


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def files() -> dict[Path, str]:
    return {page: written(page.read_text(encoding="utf-8")) for page in pages()}
