"""What runs do is in the maps: transitions, channels and calls of the gallery and of generated programs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import motionlang
from motionlang.kernel import Source, dialect, settings_next_to
from tests.cases import examples
from tests.commands.map.proof import drawn, problems
from tests.commands.worlds import world_of

ROOT = Path(__file__).parents[3]
GALLERY = sorted(
    path
    for folder in ("scripts/mint", "scripts/mccl", "examples/old")
    for path in (ROOT / folder).iterdir()
    if path.suffix in (".mnt", ".mcl", ".mccl", ".prg")
)
SLICE = 200


@pytest.mark.slow
def test_runs_of_the_gallery_are_in_their_maps() -> None:
    found = {path.name: problems(Source.read(path), settings_next_to(path)) for path in GALLERY}
    assert {name: each for name, each in found.items() if each} == {}
    assert len(found) > 100


@pytest.mark.parametrize(
    "path", [each for each in GALLERY if each.parent.name == "old"], ids=lambda each: each.name
)
def test_cycles_of_the_old_programs_are_in_their_maps(path: Path) -> None:
    """In the world that `init` finds each program runs its cycle."""
    source, language = Source.read(path), dialect("mccl" if path.suffix == ".mccl" else "mint")
    settings = world_of(source, language)
    assert problems(source, settings, 30.0) == []
    made = motionlang.map(source, machine=settings, run=True, until=30.0)
    assert made.observed is not None
    transitions = [each for diagram in made.diagrams.diagrams for each in diagram.transitions]
    assert len(made.observed.taken) > 0.3 * len(transitions)


@pytest.mark.slow
def test_runs_of_generated_programs_are_in_their_maps() -> None:
    assert {seed: found for seed in range(examples(SLICE)) if (found := problems(*drawn(seed)))} == {}


PROGRAM = """\
Dim n As Integer
Run Blink
Repeat
  MOVER(0) = 10 : GO(0)
  PAUSE IDLE(0)
  n = n + 1
Until n = 3
WAIT = 2000
End
Task Blink
  Loop
    OUTX(1) = 1 - OUTX(1)
    WAIT(10)
  End Loop
End Task
"""


def counts(text: str, name: str = "a.mnt") -> dict[str, int]:
    """Return how often a run takes each transition, by "line -> line"."""
    made = motionlang.map(Source(name, text), machine={}, run=True)
    assert made.observed is not None
    assert made.observed.strays == []
    return {
        f"{_place(each.source)} -> {_place(each.target)}": taken.count
        for each, taken in made.observed.taken.items()
    }


def _place(state: Any) -> str:
    return str(state.line) if state.kind in ("wait", "call") else state.kind


def test_transitions_are_counted_in_iterations_that_are_skipped_as_well() -> None:
    """The lamp blinks each 10.02 ms until the program ends; most of that is skipped."""
    found = counts(PROGRAM)
    assert (found["start -> 5"], found["5 -> 5"], found["5 -> 8"]) == (1, 2, 1)
    assert found["13 -> 13"] == 205


def test_macros_and_repeats_are_counted() -> None:
    found = counts("MD1,1MR100,1WS0.1,CN9,WA0.1\n1MN,1SV1000,1SA10000,1DS10000,CT9\nMC1,RP4\n", "a.mcl")
    assert found == {
        "start -> 3": 1,
        "1 -> 1": 5,
        "1 -> return": 5,
        "3 -> 3": 4,
        "start -> 1": 5,
        "3 -> end": 1,
    }


def test_an_observed_run_is_the_same_run() -> None:
    made = motionlang.map(Source("a.mnt", PROGRAM), machine={}, run=True)
    assert made.run is not None
    assert made.run.report == motionlang.run(Source("a.mnt", PROGRAM), machine={}).report
