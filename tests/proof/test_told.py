"""What a proof finds in a run whose program asked for something else: `told.mnt` and `told.mcl` have the cases."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from motionlang.kernel import Source, read_machine
from tests.proof import prove, run
from tests.spec.cases import Case, cases, located

PAGES = [Path(__file__).with_name(name) for name in ("told.mnt", "told.mcl")]
CASES = [case for path in PAGES for case in cases(path)]
TWO_SIDES = re.compile(r"\{([^{}]*?) ?→ ([^{}]*)\}")
IGNORED = re.compile(r"\{ignored: ([^{}]*)\}")
# Statements take next to no time, so that the figures are those of the motion.
FINE = {"controller.instruction_time": 1e-9}


def ran(case: Case, side: int) -> Any:
    """Return the run of what moves, side 1, or of what the proof is told, side 2."""
    texts = [
        IGNORED.sub(r"\1" if side == 2 else "", TWO_SIDES.sub(rf"\{side}", case.source(machine)))
        for machine in (False, True)
    ]
    settings = FINE | dict(read_machine(Source("told.machine.toml", texts[1])))
    result = run(Source(case.path.name, texts[0]), machine=settings)
    assert [each.message for each in result.diagnostics] == []
    return result


def ignored_orders(result: Any, told: Any) -> Iterator[tuple[tuple[int, float], Any]]:
    """Yield the order that begins a profile in one run alone, with its axis and time."""
    for number, a in told.controller.axes.items():
        own = result.controller.axes[number].starts
        for start, order in zip(a.starts, told.controller.motion_listener.of[number], strict=True):
            if start not in own:
                yield (number, start), order


def as_told(case: Case) -> Any:
    """Return the run of a case, with the orders that its proof is told."""
    result = ran(case, 1)
    assert [each.message for each in prove(result).violations] == []
    told = ran(case, 2)
    if IGNORED.search(case.source()):
        at, order = min(ignored_orders(result, told), key=lambda each: each[0][1])
        result.controller.motion_listener.unheeded[at] = order
    else:
        result.controller.motion_listener = told.controller.motion_listener
    return result


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.title} {' '.join(case.row.values())}")
def test_a_proof_finds_what_is_written_beside_the_program(case: Case) -> None:
    proof = prove(as_told(case))
    expected = sorted((line, text) for _, line, text in located(case, "?") if text != "proof: none")
    found = sorted((each.line, f"proof: {each.message}") for each in proof.violations)
    assert found == expected
    if case.has(">"):
        assert proof.lines() == case.texts(">")
