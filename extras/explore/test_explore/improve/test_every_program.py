"""A shorter cycle of every program, with limits of twice what it reaches: an answer, and no internal error."""

from __future__ import annotations

from math import inf
from pathlib import Path

import pytest

from motionlang import run
from motionlang.commands.certify.extremes import extremes
from motionlang.kernel import ProgramError, settings_next_to
from motionlang_explore.improve import NotPossible, improver_of
from motionlang_explore.improve.view import improvement_lines
from tests.cases import one_in

ROOT = Path(__file__).parents[4]
SUFFIXES = (".mnt", ".mcl", ".prg", ".mccl")
PROGRAMS = [path for folder in ("scripts", "examples") for path in sorted((ROOT / folder).rglob("*"))]


@pytest.mark.slow
@pytest.mark.parametrize(
    "path", one_in(6, [each for each in PROGRAMS if each.suffix in SUFFIXES]), ids=lambda path: path.name
)
def test_every_program_is_improved_or_says_why_not(path: Path) -> None:
    settings: dict[str, object] = {"run.until": 60.0, **settings_next_to(str(path))}
    made = run(str(path), machine=settings)
    for number, axis in made.controller.axes.items():
        reached = extremes(axis, made.time)
        for name in ("speed", "acceleration", "jerk"):
            most = getattr(reached, name).value
            if 0.0 < most < inf:
                settings.setdefault(f"axis.{number}.limits.{name}", 2.0 * most)
    try:
        found = improver_of(str(path), settings).improved()
    except (NotPossible, ProgramError):
        return
    assert improvement_lines(found, path.name, width=80, colour=False)
    assert found.after <= found.before
    assert all(each.verdict == "within" for each in found.limits)
