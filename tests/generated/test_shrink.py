"""Reduction of a program with a finding."""

from __future__ import annotations

import pytest

from tests.generated import shrink
from tests.generated.motion import Generated, generate

PROGRAM = "SPEED(0) = 20 : ACCEL(0) = 100\nMOVER(0) = 30 : GO(0)\nWAIT = 100\nSTOP(0) : PAUSE IDLE(0)\n"


def test_what_has_nothing_to_do_with_it_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The finding needs the move, its stop, and one setting of the machine."""

    def findings(program: Generated) -> list[str]:
        has_it = "MOVER(0) = 30" in program.text and "STOP(0)" in program.text and "a" in program.machine
        return [f"proof: {len(program.text)}: too late"] if has_it else []

    monkeypatch.setattr(shrink, "findings", findings)
    found = shrink.shrunk(Generated(1, "mint", PROGRAM, {"a": 1, "b": 2}))
    assert found == Generated(1, "mint", "MOVER(0) = 30\nSTOP(0)\n", {"a": 1})


def test_a_program_without_a_finding_is_left_as_it_is() -> None:
    assert shrink.shrunk(generate(1)) == generate(1)
