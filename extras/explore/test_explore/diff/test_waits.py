"""Two programs that differ in one wait alone do the same, later: `diff --explore` never says that one "does not".

Each task of a drawn program has inputs, outputs and an axis of its own, so that no wait decides what another task does.
An input that comes and goes at fixed times is the exception: the slower program may miss it.
"""

from __future__ import annotations

import re
from random import Random

import pytest

from motionlang.kernel import Source
from motionlang_explore.diff.ways import ways_of
from motionlang_explore.diff.ways_view import found_words, ways_text

SEEDS = 6
WAIT = re.compile(r"WAIT = (\d+)")


def task(draw: Random, number: int) -> list[str]:
    """Return the loop of a task: it waits for an input, acts, and waits for the input to go."""
    acts = []
    for _ in range(draw.randint(1, 4)):
        output = 3 * number + draw.randrange(3)
        acts += draw.choice(
            [
                [f"OUTX({output}) = 1", f"WAIT = {draw.randrange(50, 900)}", f"OUTX({output}) = 0"],
                [f"MOVER({number}) = {draw.randint(1, 40)} : GO({number}) : PAUSE IDLE({number})"],
                [f"WAIT = {draw.randrange(50, 900)}", f'PRINT "task {number} goes on"'],
                [f"count{number} = count{number} + 1", f"PRINT count{number}"],
            ]
        )
    if number and draw.random() < 0.3:  # it waits for nothing, as a lamp that blinks
        return ["Loop", *acts, f"WAIT = {draw.randrange(200, 900)}", "End Loop"]
    return ["Loop", f"PAUSE INX({number})", *acts, f"PAUSE INX({number}) = 0", "End Loop"]


def program(draw: Random) -> str:
    """Return a program of one to three tasks, and perhaps a handler."""
    count = draw.randint(1, 3)
    lines = [f"Dim count{k} As Integer" for k in range(count)]
    lines += [f"Run Task{k}" for k in range(1, count)] + task(draw, 0)
    for k in range(1, count):
        lines += [f"Task Task{k}", *task(draw, k), "End Task"]
    if draw.random() < 0.5:
        lines += ["Event IN7", '  PRINT "button"', "End Event"]
    return "\n".join(lines) + "\n"


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(SEEDS))
def test_a_longer_wait_is_never_something_that_is_not_done(seed: int) -> None:
    draw = Random(seed)
    text = program(draw)
    while not WAIT.search(text):
        text = program(draw)
    found = draw.choice([*WAIT.finditer(text)])
    longer = int(int(found[1]) * draw.choice([0.6, 1.3, 1.9])) + 30
    other = f"{text[: found.start(1)]}{longer}{text[found.end(1) :]}"
    compared = ways_of(Source("a.mnt", text), Source("b.mnt", other))
    said = ways_text(compared, {})
    for each in compared.differences:
        has_pulse = any(change.moment.every for _, change in each.way.timeline)
        assert has_pulse or "does not" not in found_words(each), f"{found[0]} -> {longer}\n{text}{said}"
