"""`motionlang help`: a command, a keyword or the code of a diagnostic, by its name."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from motionlang.cli.command import Refused, argument, option
from motionlang.cli.commands import COMMANDS, build_parser
from motionlang.cli.option_groups import OutputOptions, forms
from motionlang.commands.evidence import view as assumptions
from motionlang.commands.evidence.assumption import SETTLED, Assumption
from motionlang.commands.evidence.entries import assumptions as known
from motionlang.commands.evidence.entries import of_word
from motionlang.commands.evidence.fact_evidence import of_word as of_word_facts
from motionlang.commands.help.codes import codes, explanation
from motionlang.commands.help.keyword_search import search
from motionlang.commands.help.view import evidence_table, keywords_table, listing, page
from motionlang.kernel import CODES, Diagnostic, Keyword, dialect, dialects
from motionlang.kernel.lang import Vocabulary
from motionlang.kernel.tools import nearest
from motionlang.views.table import Document
from motionlang.views.terminal import PIPED_WIDTH, draws, is_terminal, plain, styled, wants_colour, width_of

# For a keyword whose meaning is remembered.
MEANING = (
    "its meaning is unconfirmed, too: run the example here and on a controller whose axes may "
    "move, and compare"
)
# The words for the list of all keywords, and for that of all codes.
ALL_KEYWORDS, ALL_CODES = "keywords", "codes"

# The keywords of each language that a word means.
Found = Mapping[str, Sequence[Keyword]]


@dataclass
class Meaning:
    """A meaning of a word: its kind, the words after `help` that lead to it alone, and its text."""

    what: str
    words: str
    text: Callable[[], str]


# A command of MCCL as manuals print it, or as a program has it: aPSn, 1MR100.
MCCL = re.compile(r"(?:a|\d+)?([A-Z]{2})(?:n|[-+]?[\d.]+)?", re.IGNORECASE)


@dataclass
class Help(OutputOptions):
    """Explain a command, a keyword or a diagnostic's code."""

    title: ClassVar[str] = "keywords"
    epilog: ClassVar[str] = """\
examples:
  motionlang help                       all commands
  motionlang help plot                  the options of a command
  motionlang help ACCELTIME             a keyword, by its name or short form
  motionlang help homing                a group of keywords
  motionlang help stop at an input      keywords, by words about them
  motionlang help keywords --lang mccl  all keywords of a language
  motionlang help never-started         the code in brackets of a diagnostic
  motionlang help codes                 all codes
  motionlang help mint.accel-default    the assumption that a note names
"""
    words: list[str] = argument("WORD", "what to explain; default: list all commands", many=True, default=[])
    format: str = forms("text", "json", "csv", "none", what="the output, as data of keywords only")
    lang: str | None = option("", "look for keywords of this language only", choices=dialects())

    def run(self) -> int:
        """Print what the words mean, or the keywords that they describe."""
        name = " ".join(self.words)
        if self.format in ("json", "csv"):
            found, _ = self._keywords(name)
            self.show(_document(found), "")
            return 0
        meanings = self._meanings(name)
        if not meanings:
            found, omitted = self._keywords(name)
            _write(_listings(found))
            sys.stdout.write(f"\n{omitted} more match; add a word\n" if omitted else "")
            return 0
        _write(meanings[0].text())
        note = styled("note:", "note", wants_colour(sys.stdout))
        for each in meanings[1:]:
            sys.stdout.write(f"\n{note} {name} is {each.what}, too: motionlang help {each.words}\n")
        return 0

    @property
    def _wants_all(self) -> bool:
        """True unless only keywords are looked for."""
        return self.lang is None and self.format == "text"

    def _meanings(self, name: str) -> list[Meaning]:
        """Return the command, keyword, code, assumption and group of a name; all but the first are only named."""
        found: list[Meaning] = []
        words = name.split()
        parser = _parser(words) if self._wants_all and (not words or words[0] in COMMANDS) else None
        if parser is not None:
            found.append(Meaning("a command", name, parser.format_help))
        if not words:
            return found
        pasted = re.fullmatch(r"(?:error|warning)\[(.*)\]:?", name.strip())
        keywords = {} if pasted else self._named(name)
        if keywords:
            what = f"a keyword of {' and '.join(dialect(each).title for each in keywords)}"
            found.append(Meaning(what, f"{name} --lang {next(iter(keywords))}", partial(_pages, keywords)))
        code = (pasted[1] if pasted else name).lower()
        if self._wants_all and code == ALL_CODES:
            found.append(Meaning("the list of codes", name, codes))
        elif self._wants_all and code in CODES:
            found.append(Meaning("the code of a diagnostic", f'"error[{code}]"', partial(explanation, code)))
        assumption = known().get(name) if self._wants_all and "." in name else None
        if assumption is not None:
            found.append(Meaning("an assumption", name, partial(_assumption, assumption)))
        groups = self._groups(name) if found and not keywords and not pasted else {}
        if groups:
            lang = f"{name} --lang {next(iter(groups))}"
            found.append(Meaning("a group of keywords", lang, partial(_listings, groups)))
        if not found and self._wants_all:  # to find commands of other packages takes longer than all else
            parser = _parser(words)
            if parser is not None:
                found.append(Meaning("a command", name, parser.format_help))
        return found

    def _keywords(self, name: str) -> tuple[Found, int]:
        """Return the keywords that a name, a group or words mean, and how many more do; Refused without any."""
        tables = self._tables()
        if name in ("", ALL_KEYWORDS):
            return {each: list(table) for each, table in tables.items()}, 0
        found: Found = {each: [row] for each, row in self._named(name).items()}
        found = found or self._groups(name)
        if found:
            return found, 0
        words = {
            word
            for table in tables.values()
            for row in table
            for word in (row.name, row.short, row.group)
            if word
        }
        if self._wants_all:
            words |= {*COMMANDS, *CODES}
        found, omitted = search(name, tables)
        meant = {
            each: [row for row in table if name.upper() in row.meant.split()]
            for each, table in tables.items()
        }
        meant = {each: rows for each, rows in meant.items() if rows}
        found = found or meant
        near = nearest(name, sorted(words))
        is_word = " " not in name and not meant
        if not found or (is_word and near is not None and _is_misspelt(name, near, found)):
            what, hint = "command, keyword or diagnostic", "help, help keywords and help codes list all"
            if not self._wants_all:
                what, hint = "keyword", "motionlang help keywords lists all keywords"
            hint = f"did you mean {near}?" if near else hint
            raise Refused([Diagnostic("unknown-word", f"there is no {what} {name}", hint=hint)])
        return found, omitted

    def _named(self, name: str) -> dict[str, Keyword]:
        """Return the keyword of each language that has one of this name, or that of its block or command."""
        tables = self._tables()
        found = {each: row for each, table in tables.items() if (row := table.get(name)) is not None}
        opened = ((each, tables[each].get(dialect(each).opener(name))) for each in tables if not found)
        found |= {each: row for each, row in opened if row is not None}
        command = MCCL.fullmatch(name)
        if not found and command is not None and "mccl" in tables:
            row = tables["mccl"].get(command[1])
            return {} if row is None else {"mccl": row}
        return found

    def _groups(self, name: str) -> dict[str, list[Keyword]]:
        return {each: members for each, table in self._tables().items() if (members := table.group(name))}

    def _tables(self) -> dict[str, Vocabulary]:
        return {each: dialect(each).table() for each in (dialects() if self.lang is None else (self.lang,))}


def _parser(words: Sequence[str]) -> argparse.ArgumentParser | None:
    """Return the parser of a command, such as `pvt plot`, or of all commands; None if there is none."""
    parser = build_parser(words[0] if words else "")
    for word in words:
        inner = next((each for each in parser._actions if isinstance(each, argparse._SubParsersAction)), None)
        if inner is None or word not in inner.choices:
            return None
        parser = inner.choices[word]
    return parser


def _is_misspelt(name: str, near: str, found: Found) -> bool:
    """True unless `name` is a part of keywords found, and the nearest one does not begin with it.

    JERK is near RK, but part of ACCELJERK.
    """
    part = name.lower()
    return near.lower().startswith(part) or not any(
        part in row.name.lower() for rows in found.values() for row in rows
    )


def _document(found: Found) -> Document:
    rows = [(language, row) for language, of_language in found.items() for row in of_language]
    open_ones = [
        ({"dialect": language, "keyword": row.name}, each)
        for language, row in rows
        for each in of_word(language, row)
    ]
    about = assumptions.assumptions_table(open_ones, ("dialect", "keyword"))
    return Document([keywords_table(rows), evidence_table(rows), about])


def _listings(found: Found) -> str:
    width, colour, whole = _width(), wants_colour(sys.stdout), not _is_seen()
    return "\n".join(
        listing(rows, language, width=width, colour=colour, whole=whole) for language, rows in found.items()
    )


def _pages(found: Mapping[str, Keyword]) -> str:
    return "\n".join(_page(row, language) for language, row in found.items())


def _assumption(found: Assumption) -> str:
    """Return an assumption as the pages of its keywords show it."""
    return assumptions.of_word([found], width=min(_width(), 88), colour=wants_colour(sys.stdout))


def _page(row: Keyword, language: str) -> str:
    """Return all facts of a keyword, and its open assumptions."""
    width, colour = _width(), wants_colour(sys.stdout)
    text = page([row], language, width=width, colour=colour)
    questions = of_word(language, row)
    if row.example and of_word_facts(language, row)["meaning"].strength not in SETTLED:
        text += f"\n  {MEANING}\n"
    if questions:
        text += "\n" + assumptions.of_word(questions, width=min(width, 88), colour=colour)
    return text


def _is_seen() -> bool:
    return is_terminal(sys.stdout) or "COLUMNS" in os.environ


def _width() -> int:
    return width_of(sys.stdout) if _is_seen() else PIPED_WIDTH


def _write(text: str) -> None:
    sys.stdout.write(text if draws(sys.stdout) else plain(text))
