"""Generated programs, rewritten in the notation of Mint v4, do the same after `check --fix --model mintmt`."""

from __future__ import annotations

import re

import pytest

from motionlang.commands.diff.runs import compared_runs, runs_text
from motionlang.kernel import Source, dialect_of, run
from motionlang.kernel.mint import table
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.traversal import names_of
from tests.cell import cell
from tests.cli.programs import Cell
from tests.generated.motion import UNTIL, generate

__all__ = ["cell"]

# The first seeds, of which two thirds are Mint; with those of the long run 500 programs of v4.
FIRST, MANY = range(9, 11), range(11, 1010)
_BLOCKS = {
    " As Float": "",
    " As Integer": "",
    " Then\n": " DO\n",
    "End If": "ENDIF",
    "End Event": "RETURN",
    "Event ": "#",
}


def as_v4(text: str) -> str:
    """Return a program of MintMT with one task in the notation of Mint v4, and with prints."""
    for new, old in _BLOCKS.items():
        text = text.replace(new, old)
    text = text.replace("WAIT =", '? "at ", faults, " ", faults / 4, " ", POS(0) : WAIT =')
    rows = table()
    names = [
        name
        for name in names_of(parse(Source("a.mnt", text)))
        if (row := rows.get(name.name)) is not None
        and row.kind not in ("function", "constant", "statement")
        and name.args
    ]
    for name in sorted(names, key=lambda each: each.start, reverse=True):
        inside = text[name.start + len(name.name) + 1 : name.end - 1]
        index = f".{inside}" if inside.isdigit() else f"[{inside}]"
        text = f"{text[: name.start]}{name.name}{index}{text[name.end :]}"
    return text


def port(seed: int, cell: Cell) -> bool:
    """Compare a program of v4 with its port; return False for a seed whose program v4 does not have."""
    made = generate(seed)
    if made.language != "mint" or "Task " in made.text:
        return False
    old = Source("old.prg", as_v4(made.text))
    language = dialect_of(old.name)
    assert language is not None
    assert language.program(old).target.model == "mint4", old.text
    written = cell.write("new.prg", old.text)
    ran = cell("check", "new.prg", "--fix", "--model", "mintmt")
    assert not re.search(r"^error", ran.out, re.MULTILINE), ran.out
    new = Source.read(written)
    models = {"mint4": old, "mintmt": new}
    before, after = (
        run(source, machine={**made.machine, "controller.model": model}, until=UNTIL)
        for model, source in models.items()
    )
    found = compared_runs(before, after)
    assert found.same, f"seed {seed}: {runs_text(found)}"
    return True


def test_programs_of_the_first_seeds_do_the_same_after_a_port(cell: Cell) -> None:
    assert sum(port(seed, cell) for seed in FIRST) > 0


@pytest.mark.long
def test_500_programs_do_the_same_after_a_port(cell: Cell) -> None:
    assert sum(port(seed, cell) for seed in MANY) >= 500
