"""Draw random rows and facts to check against their sources.

Run `python -m tests.commands.evidence.draw 2026-11-21`. The date is the seed, so anyone can repeat a draw. A row is a
keyword with the evidence of its meaning; a fact is another fact of a keyword, such as its default. Compare
each with the source that it names, and note those that claim more than the source.
"""

from __future__ import annotations

import sys
from random import Random
from typing import TYPE_CHECKING

from motionlang.commands.evidence.fact_evidence import of_word
from motionlang.kernel import dialect, dialects

if TYPE_CHECKING:
    from motionlang.kernel import Keyword

ROWS, FACTS = 60, 40


def drawn(seed: str) -> tuple[list[tuple[str, Keyword, str]], list[tuple[str, Keyword, str]]]:
    """Return the drawn rows and facts: language, row and the name of the fact."""
    every = [(language, row) for language in dialects() for row in dialect(language).table()]
    facts = [
        (language, row, fact)
        for language, row in every
        for fact in of_word(language, row)
        if fact not in ("meaning", "index")
    ]
    random = Random(seed)
    rows = [(language, row, "meaning") for language, row in random.sample(every, ROWS)]
    return rows, random.sample(facts, FACTS)


def line(language: str, row: Keyword, fact: str) -> str:
    """Return the line of a drawn fact, with its value and its evidence."""
    value = {
        "meaning": row.help,
        "short": row.short,
        "unit": row.unit,
        "default": f"{row.default}",
        "range": row.accepted,
    }[fact]
    return f"{language:4}  {row.name:24}  {fact:8}  {of_word(language, row)[fact]}  |  {value}"


def main(arguments: list[str]) -> int:
    """Print a draw; 2 if no date is given."""
    if len(arguments) != 1:
        print("usage: python -m tests.commands.evidence.draw DATE", file=sys.stderr)
        return 2
    rows, facts = drawn(arguments[0])
    for each in [*rows, *facts]:
        print(line(*each))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
