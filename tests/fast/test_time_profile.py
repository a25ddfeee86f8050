"""The time profile of tasks whose periods or ticks are skipped."""

from __future__ import annotations

import re
from types import ModuleType

import pytest

from motionlang import run
from motionlang.analysis.cycle.export import json_pieces
from motionlang.analysis.cycle.profile import TimeProfile
from motionlang.source import Source
from tests.cases import cases
from tests.generated import handlers, polls, tasks

# Two tasks; the one that polls on runs for 1 ms, then the other one for as long, and the parent waits 45 ms at a time.
ALTERNATING = """
Dim b As Integer
TIME = 0
Run T1
Loop
  WAIT(45)
  While TIME < 300
  End While
End Loop
End
Task T1
Loop
  While b = 0
  End While
End Loop
End Task
"""


def profile(text: str, machine: dict[str, object], fast: bool) -> TimeProfile:
    return TimeProfile(run(Source("a.mnt", text), machine=machine, cache=False, until=1.5, fast=fast))


@pytest.mark.parametrize("fast", [True, False])
def test_skipped_periods_compute_and_wait_like_the_others(fast: bool) -> None:
    """Both tasks poll from 0.045 to 0.3 s; a loop that is left counts as a wait."""
    parent, task = profile(ALTERNATING, {}, fast).tasks
    assert parent.waiting == {"time": pytest.approx(1.5, abs=2e-3)}
    assert parent.computing < 2e-3
    assert task.waiting == {}
    assert task.computing == pytest.approx(1.5 - (0.3 - 0.045) / 2, abs=2e-3)


@cases(
    "family, seeds",
    ((tasks, (15, 28, 34, 69)), (handlers, (5, 63, 65, 79, 89, 97, 98, 5084)), (polls, (5024, 5025, 5060))),
)
@pytest.mark.slow
def test_the_time_profile_does_not_depend_on_accelerators(family: ModuleType, seeds: tuple[int, ...]) -> None:
    """Up to rounding."""

    def figures(text: str, machine: dict[str, object], fast: bool) -> str:
        pieces = "".join(json_pieces(profile(text, machine, fast)))
        return re.sub(r"\d+\.\d+(e-\d+)?", lambda found: f"{float(found[0]):.8f}", pieces)

    for seed in seeds:
        text, machine = family.program(seed)
        assert figures(text, machine, True) == figures(text, machine, False), seed
