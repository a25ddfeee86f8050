"""The exploration finds how drawn machines make parts."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor

import pytest

from motionlang.kernel import Source, dialect_of, run
from motionlang_explore.exploration import PIECE, explore
from tests.generated.machines import SUFFIXES, machine

# A part takes up to half a minute.
UNTIL_S = 300.0


def _is_bad(line: str) -> bool:
    return "BAD" in line or "ALARM" in line


def _found(seed: int) -> tuple[bool, bool]:
    """Return whether a transition of the exploration makes a part, and whether its world makes three parts or more."""
    suffix, text, _ = machine(seed)
    source = Source(f"m{suffix}", text)
    dialect = dialect_of(source.name)
    assert dialect is not None
    program = dialect.program(source, is_debug=True)
    assert program.errors == []
    board = {"controller.model": program.target.model} if program.target.model else {}
    found = explore(program, board, seconds=PIECE)
    printed = [
        " ".join(act.words for act in transition.acts if not act.subject)
        for node in found.nodes
        for transition in node.transitions
    ]
    world = {**board, **found.switches.settings, **found.world.settings}
    lines = run(source, dialect=dialect, machine=world, until=UNTIL_S).output
    parts, bad = sum("PART" in line for line in lines), sum(map(_is_bad, lines))
    works = parts >= 3 and bad <= parts / 2
    has_way = parts >= 3 or any("PART" in words and not _is_bad(words) for words in printed)
    return has_way, works


@pytest.mark.parametrize(
    ("seeds", "ways", "worlds"),
    [
        pytest.param(range(1, 11), 9, 9, marks=pytest.mark.slow),
        pytest.param(range(11, 41), 27, 26, marks=pytest.mark.long),
    ],
    ids=["10", "30"],
)
def test_drawn_machines_make_parts(seeds: range, ways: int, worlds: int) -> None:
    with ProcessPoolExecutor(2) as processes:
        found = list(processes.map(_found, seeds))
    assert sum(way for way, _ in found) >= ways
    assert sum(works for _, works in found) >= worlds


def test_drawn_machines_are_programs_without_errors() -> None:
    """Each notation and each pattern is among them."""
    notations, patterns = set(), set()
    for seed in range(1, 61):
        suffix, text, notes = machine(seed)
        dialect = dialect_of(f"m{suffix}")
        assert dialect is not None
        program = dialect.program(Source(f"m{suffix}", text), is_debug=True)
        assert program.errors == [], (seed, notes)
        notations.add(suffix)
        patterns |= {*notes}
    assert notations == {*SUFFIXES.values()}
    assert {"handover", "keyswitch", "packed", "reset-held", "rise", "waitin"} <= patterns
