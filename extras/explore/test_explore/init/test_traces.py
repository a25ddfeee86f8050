"""Old programs with their own traces, recorded in four ways: no rule is false without being a guess.

The answers that an operator has typed are in no recording; a run is compared once they are corrected.
"""

from __future__ import annotations

from collections import defaultdict
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from motionlang.kernel import Run, Source, dialect_of, read_machine
from motionlang_explore.exploration import explore
from motionlang_explore.init import draft
from test_explore.init.recordings import Logger, csv_of, machine_run
from tests.cases import cases
from tests.cli.programs import Cell

OLD = Path(__file__).parents[4] / "examples" / "old"
PROGRAMS = (
    "bagwelder.prg",
    "coiler.prg",
    "dispenser.mccl",
    "packer.prg",
    "pickplace.mccl",
    "rotary.mccl",
    "table.mccl",
    "winder.mnt",
)
UNTIL = 60.0
KINDS = ("before", "noise", "middle", "events")
# A change of an input is the same within this time, s, and this share of the time: a person is no clock.
NEAR, SHARE = 0.03, 0.01
Columns = dict[str, NDArray[np.float64]]
Changes = dict[int, list[tuple[float, int]]]


@cache
def played(program: str) -> tuple[Run, object]:
    """Return the run of a program in the world that init finds without a recording, and the answers there."""
    language = dialect_of(program)
    assert language is not None
    source = Source.read(str(OLD / program))
    parsed = language.program(source, is_debug=True)
    board: dict[str, object] = {"controller.model": parsed.target.model} if parsed.target.model else {}
    found = draft(explore(parsed, board), None, UNTIL, board)
    settings = {key: value for key, value in found.world.settings.items() if not key.startswith("run.")}
    settings |= board | found.exploration.switches.settings
    return machine_run(OLD / program, {**settings, "run.until": UNTIL}), settings.get("answer", [])


def columns(run: Run, kind: str) -> Columns:
    if kind == "before":
        return Logger(0.005, before=1.7).table(run)
    if kind == "noise":
        return Logger(0.005, jitter=0.5, noise=0.01).table(run)
    if kind == "middle":
        return Logger(0.005, before=-0.3 * run.time).table(run)
    table = {name: each for name, each in Logger(0.005).table(run).items() if not name.startswith("axis")}
    levels = np.array([each for name, each in table.items() if name != "time_s"])
    rows = np.concatenate(([True], (levels[:, 1:] != levels[:, :-1]).any(axis=0)))
    return {name: each[rows] for name, each in table.items()}


def changes(run: Run) -> Changes:
    found: Changes = defaultdict(list)
    for each in run.machine.log.inputs:
        level = int(bool(each.value))
        if level != (found[each.channel][-1][1] if found[each.channel] else 0):
            found[each.channel].append((each.time, level))
    return found


def is_same(mine: list[tuple[float, int]], right: list[tuple[float, int]]) -> bool:
    """True if nine of ten changes of an input are in both, with one more or less at the end."""
    agree = sum(
        any(level == b and abs(time - t) <= NEAR + SHARE * t for time, level in mine) for t, b in right
    )
    return agree >= 0.9 * len(right) - 1 and abs(len(mine) - len(right)) <= 1 + len(right) // 10


@pytest.mark.slow
@pytest.mark.parametrize("program", PROGRAMS)
@cases("kind", KINDS)
def test_no_rule_is_false_without_a_mark(cell: Cell, program: str, kind: str) -> None:
    run, answers = played(program)
    path = cell.write(program, (OLD / program).read_text())
    Path(path).with_suffix(".machine.toml").unlink(missing_ok=True)
    cell.write("rec.csv", csv_of(columns(run, kind)))
    ran = cell("init", program, "--recording", "rec.csv", "--format", "none")
    assert "is not one of" not in ran.err
    machine = Path(path).with_suffix(".machine.toml")
    settings = read_machine(Source.read(str(machine)))
    guessed = {each["channel"] for each in settings["input"] if "guess" in each}  # type: ignore[attr-defined]
    assert all("guess" in each for each in settings.get("answer", ()))  # type: ignore[attr-defined]
    kept = {key: value for key, value in settings.items() if not key.startswith("run.stop")}
    mine = changes(machine_run(Path(path), {**kept, "answer": answers, "run.until": UNTIL}))
    right = changes(run)
    false = [each for each in sorted(right) if not is_same(mine[each], right[each]) and each not in guessed]
    assert not false
