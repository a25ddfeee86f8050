"""A run interrupted between any two lines has a report, a trace and a valid proof."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from types import CodeType, FrameType
from typing import Any

import pytest

import motionlang
from motionlang.kernel import Run, Scheduler, Source, execution
from motionlang.kernel.report import moves
from motionlang.views.report import render
from tests.proof import prove, run

PACKAGE = Path(motionlang.__file__).parent
MINT = """Dim i As Integer
SPEED(0, 1) = 100, 100 : ACCEL(0, 1) = 1000, 1000 : DECEL(0, 1) = 1000, 1000
For i = 1 To 2
  MOVER(0) = 5 : GO(0)
  WAIT = 20
  MOVER(1) = 3 : GO(1)
  PAUSE IDLE(0, 1)
  VECTORR(0, 1) = 4, 5
  GO(0, 1)
  PAUSE IDLE(0, 1)
Next
JOG(0) = 40
WAIT = 60
JOG(0) = 60
WAIT = 60
STOP(0)
PAUSE IDLE(0)
"""
MCCL = "1MN,2MN,1SV5000,1SA50000,1DS50000\n1MR500,WA0.05,2MR300,1WS,2WS\n1VM,1GO,WA0.1,1ST,1WS\n"
# Where it is interrupted: anywhere, and where a move is written to the log and its track.
LOCATIONS = {
    "anywhere": ("/motionlang/kernel/controller/", "/motionlang/kernel/lang/"),
    "log": (
        "/kernel/controller/queue/life.py",
        "/tests/proof/expected_motion.py",
        "/motionlang/kernel/log/log.py",
    ),
}


# The functions that write moves to a track and the log.
STEPS = {
    "/motionlang/kernel/controller/queue/track.py": {"extend_track", "log_move"},
    "/motionlang/kernel/log/stream.py": {"add"},
}
# Moves that are read, one in motion and one completed.
PLAIN = """Dim i As Integer
Dim x As Float
SPEED(0, 1) = 100, 100 : ACCEL(0, 1) = 1000, 1000 : DECEL(0, 1) = 1000, 1000
For i = 1 To 2
  MOVER(0, 1) = 5, 3 : GO(0, 1)
  PAUSE IDLE(0, 1)
  MOVER(0) = 5 : GO(0)
  PAUSE IDLE(0)
  MOVER(0) = -2 : GO(0)
  WAIT = 20
  x = POS(0)
  PAUSE IDLE(0)
Next
"""


class Ended:
    """An interrupt (Ctrl-C) at the `at`-th executed line of some functions."""

    def __init__(self, locations: tuple[str, ...] | dict[str, set[str]], at: int) -> None:
        self.locations, self.at, self.count = locations, at, 0
        # The first and the last count at each line.
        self.first: dict[tuple[str, int], int] = {}
        self.last: dict[tuple[str, int], int] = {}
        self.counted: dict[CodeType, bool] = {}

    def counts(self, code: CodeType) -> bool:
        """True if the executed lines of a function are counted."""
        location = next((location for location in self.locations if location in code.co_filename), "")
        return bool(location) and (
            not isinstance(self.locations, dict) or code.co_name in self.locations[location]
        )

    def trace(self, frame: FrameType, event: str, argument: Any) -> Any:
        code = frame.f_code
        if (counts := self.counted.get(code)) is None:
            counts = self.counted[code] = self.counts(code)
        if not counts:
            return None
        if event == "line":
            self.count += 1
            self.first.setdefault((code.co_filename, frame.f_lineno), self.count)
            self.last[code.co_filename, frame.f_lineno] = self.count
            if self.count == self.at:
                sys.settrace(None)
                raise KeyboardInterrupt
        return self.trace


@contextmanager
def tracing(ended: Ended) -> Iterator[None]:
    sys.settrace(ended.trace)
    try:
        yield
    finally:
        sys.settrace(None)


def ran(source: Source, ended: Ended, monkeypatch: pytest.MonkeyPatch) -> Run:
    execute = execution._execute

    def watched(*given: Any) -> None:
        scheduler = Scheduler.run

        def run_watched(*given: Any) -> str:
            with tracing(ended):
                return scheduler(*given)

        with monkeypatch.context() as m:
            m.setattr(Scheduler, "run", run_watched)
            execute(*given)

    with monkeypatch.context() as m:
        m.setattr(execution, "_execute", watched)
        return run(source)


@pytest.mark.parametrize("count", [15, pytest.param(1000, marks=pytest.mark.long)])
@pytest.mark.parametrize("locations", LOCATIONS)
@pytest.mark.parametrize(("name", "text"), [("a.mnt", MINT), ("a.mcl", MCCL)])
def test_it_may_end_at_any_line(
    name: str, text: str, locations: str, count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    source, whole = Source(name, text), Ended(LOCATIONS[locations], 0)
    for _ in range(2):  # the first run imports, and fills caches
        whole.count = 0
        result = ran(source, whole, monkeypatch)
        assert (result.status, result.diagnostics, prove(result).holds) == ("ended", [], True)
    assert whole.count > 200
    for at in Random(name).sample(range(1, whole.count), min(count, whole.count - 1)):
        result = ran(source, Ended(LOCATIONS[locations], at), monkeypatch)
        assert result.status == "interrupted", at
        json.dumps(result.report)
        render(result)
        rows: list[dict[str, Any]] = list(moves(result))
        ends = [row["start_time"] + row["duration"] for row in rows]
        assert max(ends, default=0.0) <= result.time + 1e-9, at
        result.trace.sample(100.0)
        assert [each.message for each in prove(result).violations] == [], at


@pytest.mark.parametrize(("name", "text"), [("a.mnt", "WAIT = 100\n" * 3), ("a.mcl", "WA0.1\n" * 3)])
def test_ctrl_c_has_the_position_of_the_wait(name: str, text: str) -> None:
    """Of three waits of 0.1 s the third ends after 0.3 s."""

    def pace(time: float) -> None:
        if time > 0.25:
            raise KeyboardInterrupt

    (found,) = execution.run(Source(name, text), pace=pace).diagnostics
    assert (found.code, found.line, found.column) == ("interrupted", 3, 1)


def motion(result: Run) -> dict[int, list[tuple[float, str]]]:
    """Return the start time and shape of each recorded profile, by axis."""
    tracks = result.controller.axes
    assert all(len(a.starts) == len(a.profiles) and a.starts[-1] <= result.time for a in tracks.values())
    return {
        number: [
            (start, repr(profile))
            for start, profile in zip(a.starts, a.profiles, strict=True)
            if profile.shape != "hold"  # a rest is no longer on the track when the next move begins
        ]
        for number, a in tracks.items()
    }


def test_the_locations_exist() -> None:
    """If a file were renamed, no run would be interrupted in it."""
    root = PACKAGE.parent
    paths = (path for folder in (PACKAGE, root / "tests" / "proof") for path in folder.rglob("*.py"))
    files = [f"/{path.relative_to(root).as_posix()}" for path in paths]
    for location in (*STEPS, *(each for locations in LOCATIONS.values() for each in locations)):
        assert any(location in file for file in files), location
    for location, names in STEPS.items():
        (file,) = (file for file in files if location in file)
        text = (PACKAGE.parent / file[1:]).read_text(encoding="utf-8")
        assert all(f"def {name}(" in text for name in names), location


@pytest.mark.slow
@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.long)], ids=["some", "every"])
def test_plain_moves_are_whole_wherever_the_run_ends(every: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Interrupt each line that records a plain move.

    The run up to then is complete, with no duplicates. Each line is interrupted at its first and, every third, at
    its last execution. Of the other executions 5 are interrupted, or all with `long`.
    """
    source = Source("a.mnt", PLAIN)
    for _ in range(2):
        whole = Ended(STEPS, 0)
        result = ran(source, whole, monkeypatch)
        assert (result.status, result.diagnostics, prove(result).holds) == ("ended", [], True)
    ended = result
    begun = [(each.start_time, each.axis, each.line) for each in result.controller.log.moves]
    tracks = motion(result)
    chosen = {*whole.first.values(), *sorted(whole.last.values())[::3]}
    chosen |= {*Random(1).sample(range(1, whole.count), 5)}
    for at in range(1, whole.count + 1) if every else sorted(chosen):
        result = ran(source, Ended(STEPS, at), monkeypatch)
        assert result.status == "interrupted", at
        for number, a in result.controller.axes.items():
            assert a.position(result.time) == ended.controller.axes[number].position(result.time), at
        json.dumps(result.report)
        result.trace.sample(100.0)
        assert [each.message for each in prove(result).violations] == [], at
        found = [(each.start_time, each.axis, each.line) for each in result.controller.log.moves]
        assert found == begun[: len(found)], at
        assert len(found) >= sum(start < result.time for start, *_ in begun), at
        for number, track in motion(result).items():
            assert track == tracks[number][: len(track)], at
            assert len(track) >= sum(start < result.time for start, _ in tracks[number]), at
