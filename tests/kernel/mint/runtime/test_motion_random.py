"""Random motion causes no traceback or hang, and the same program the same result."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Run, Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases, examples
from tests.kernel.mint.motion_programs import program


def ran(text: str) -> Run:
    return run(Source("a.mnt", text), until=3.0)


@cases("seed", range(examples(120)))
def test_a_random_program_comes_to_an_end_in_order(seed: int) -> None:
    text = program(seed)
    result = ran(text)
    for each in result.diagnostics:  # a full buffer that is never started is the program's own error
        assert each.code in ("never", "never-started", "short-ramp"), each.message
    check(DIALECT.program(Source("a.mnt", text)))


def test_the_programs_move_something() -> None:
    moves = {move.command for seed in range(40) for move in ran(program(seed)).controller.log.moves}
    assert {"MOVER", "MOVEA", "VECTORR", "CIRCLER", "JOG", "FOLLOW", "INCR"} <= moves


@pytest.mark.parametrize("seed", [3, 11])
def test_the_same_program_does_the_same_again(seed: int) -> None:
    first, second = ran(program(seed)), ran(program(seed))
    assert first.output == second.output
    assert first.report == second.report
