"""`diff --explore` never calls a changed constant "the same" if a run in the world of `init` shows it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang import Run, Source, diff, explore, run
from motionlang.kernel import dialect_for

FOLDER = Path(__file__).parents[1] / "exploration"
# Small programs of all kinds: the constant in the middle of each is changed. The others are tried by hand.
PROGRAMS = (
    "badcycle.mccl", "bank.prg", "both.mnt", "choices.prg", "clamp.mnt", "drop.mnt", "edge.mnt", "ends.prg",
    "guards.prg", "homing.mnt", "host.mnt", "key.prg", "keys.prg", "mark.prg", "menu.prg", "order.mnt", "reply.mnt",
    "start.mnt", "timeout.mnt", "wheel.mnt",
)  # fmt: skip
SECONDS = 60.0


def constants(source: Source) -> list[tuple[int, str]]:
    """Return the offset and the text of each whole number of a program."""
    tokens = dialect_for(source, None).tokens(source.text)
    return [(at, text) for kind, text, at in tokens if kind == "number" and re.fullmatch(r"\d+", text)]


def done(result: Run) -> list[object]:
    """Return what a run does, with its times."""
    log = result.machine.log
    moves = [(each.axis, each.command, round(each.start_time, 6)) for each in log.moves]
    return [result.status, moves, [each[:3] for each in log.outputs], [each[:2] for each in log.prints]]


@pytest.mark.slow
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_changed_constant_is_not_the_same(name: str) -> None:
    old = Source.read(FOLDER / name)
    numbers = constants(old)
    at, text = numbers[len(numbers) // 2]
    new = Source(name, f"{old.text[:at]}{int(text) + 1}{old.text[at + len(text) :]}")
    world = {**explore(old).world.settings, "run.until": SECONDS}
    before, after = (done(run(source, machine=world)) for source in (old, new))
    found = diff(old, new, explore=True)
    assert not found.same
    if before != after and not (found.differences or found.later):
        line = old.text.count("\n", 0, at) + 1
        named = [*found.uncompared["B"], *found.one_sided["B"], *found.hidden["B"]]
        assert line in named, named
