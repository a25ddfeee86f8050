"""What `diff --explore` says of a way that touches no change: played in both programs, it is the same."""

from __future__ import annotations

import re
from random import Random

import pytest

from motionlang.comparison.acts import compared
from motionlang.kernel import Source, dialect_for
from motionlang_explore.diff.ways import Player, all_ways, compared_ways
from motionlang_explore.exploration import explored
from test_explore.diff.test_waits import program

SEEDS = 6
NUMBER = re.compile(r"(?<![\w.])\d+")
ADDED = ("OUTX(9) = 1", "WAIT = 40", 'PRINT "added"', "MOVER(0) = 3 : GO(0)", "EXIT Loop")


def edited(draw: Random, text: str) -> str:
    """Return a program with another number, or with a line more, less, twice or elsewhere."""
    lines = text.splitlines()
    at, to = draw.randrange(len(lines)), draw.randrange(len(lines))
    numbers = [*NUMBER.finditer(lines[at])]
    choice = draw.randrange(5)
    if choice == 0 and numbers:
        one = draw.choice(numbers)
        lines[at] = f"{lines[at][: one.start()]}{int(one[0]) + draw.choice((1, 7))}{lines[at][one.end() :]}"
    elif choice == 1:
        lines.insert(at, draw.choice(ADDED))
    elif choice == 2:
        lines.insert(to, lines[at])
    elif choice == 3:
        lines.insert(to, lines.pop(at))
    else:
        del lines[at]
    return "\n".join(lines) + "\n"


def is_right(text: str, name: str) -> bool:
    source = Source(name, text)
    return not dialect_for(source, None).program(source, {}).errors


def untouched(name: str, text: str, other: str) -> int:
    """Return how many ways of two programs touch no change; each of them is the same when it is played in both."""
    a = explored(Source(name, text))
    players = Player(a), Player(explored(Source(name, other), a.switches.settings))
    compared_ways(*players, 1.0)
    found = 0
    for way in all_ways(*players):
        side = 0 if "A" in way.of else 1
        last = way.timeline[-1][0] if way.timeline else 0.0
        played = players[side].play(way.timeline, last)
        if players[side].text.is_untouched(played):
            found += 1
            result = compared(played, players[1 - side].play(way.timeline, last))
            assert not [*result.differences, *result.later], f"{way.timeline}\n{text}\n{other}"
    return found


@pytest.mark.slow
def test_a_way_that_touches_no_change_is_the_same() -> None:
    counts = []
    for seed in range(SEEDS):
        draw = Random(seed)
        text = program(draw)
        other = edited(draw, text)
        while other == text or not is_right(other, "a.mnt"):
            other = edited(draw, text)
        counts.append(untouched("a.mnt", text, other))
    assert any(counts), counts
