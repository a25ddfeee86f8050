"""The limits of a For loop read, call and command as any other expression does."""

from __future__ import annotations

import pytest

from motionlang.mint.lint import check
from motionlang.source import Source

_LIMITS = ("Act(3) To 5", "1 To Act(3)", "1 To 9 Step Act(2)")


def codes(text: str, act: str = "") -> list[str]:
    """Return the codes of the findings; `act` is the body of the function Act."""
    body = f"Function Act(ByVal n As Integer) As Integer\n  {act}\n  Act = n\nEnd Function\n" if act else ""
    return [each.code for each in check(Source("a.mnt", text + body))]


@pytest.mark.parametrize("limits", _LIMITS)
def test_a_limit_may_load_the_move_that_go_starts(limits: str) -> None:
    assert codes(f"For i = {limits}\n  PRINT i\nNext\nGO(0)\n", "MOVEA(0) = 5") == []
    assert codes("Act(3)\nFor i = 1 To 3\n  PRINT i\nNext\nGO(0)\n", "PRINT n") == ["nothing-loaded"]


@pytest.mark.parametrize("limits", _LIMITS)
def test_a_limit_may_start_a_loaded_move(limits: str) -> None:
    assert codes(f"MOVEA(0) = 5\nFor i = {limits}\n  PRINT i\nNext\n", "GO(0)") == []
    assert codes("MOVEA(0) = 5\nFor i = 1 To 3\n  PRINT i\nNext\n") == ["never-started"]


@pytest.mark.parametrize("limits", _LIMITS)
def test_an_axis_that_a_limit_commands_is_commanded_by_its_task(limits: str) -> None:
    main, task = (
        "Run T\nMOVEA(0) = 3 : GO(0)\nEnd\nTask T\n",
        f"For i = {limits}\n  PRINT i\nNext\nEnd Task\n",
    )
    assert codes(main + task, "MOVEA(0) = 5 : GO(0)") == ["two-tasks"]
    assert codes(main + task, "MOVEA(1) = 5 : GO(1)") == []


def test_a_setting_that_a_limit_reads_is_used() -> None:
    loop = "SPEED(0) = 5\nFor i = 1 To {}\n  PRINT i\nNext\nSPEED(0) = 6\nMOVER(0) = 5 : GO(0)\n"
    assert codes(loop.format("SPEED(0)")) == []
    assert codes(loop.format("5")) == ["unused-setting"]
