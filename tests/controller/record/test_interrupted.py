"""A run that is ended between any two lines of the interpreter has a report, a trace, and a proof that holds."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from random import Random
from types import FrameType
from typing import Any

import pytest

from motionlang import run
from motionlang.lang.scheduler import Scheduler
from motionlang.result import Run
from motionlang.source import Source

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
STOP(0)
PAUSE IDLE(0)
"""
MCCL = "1MN,2MN,1SV5000,1SA50000,1DS50000\n1MR500,WA0.05,2MR300,1WS,2WS\n1VM,1GO,WA0.1,1ST,1WS\n"
# Where it is ended: anywhere, and where a move comes into the log and onto its track.
PLACES = {
    "anywhere": ("/motionlang/controller/", "/motionlang/lang/"),
    "log": ("/controller/core.py", "/record/orders.py", "/record/log.py"),
}


class Ended:
    """Ctrl-C at the `at`-th line that is run at some places; counts those that were run."""

    def __init__(self, places: tuple[str, ...], at: int) -> None:
        self.places, self.at, self.count = places, at, 0

    def look(self, frame: FrameType, event: str, argument: Any) -> Any:
        if not any(place in frame.f_code.co_filename for place in self.places):
            return None
        if event == "line":
            self.count += 1
            if self.count == self.at:
                sys.settrace(None)
                raise KeyboardInterrupt
        return self.look


@contextmanager
def looking(ended: Ended) -> Iterator[None]:
    sys.settrace(ended.look)
    try:
        yield
    finally:
        sys.settrace(None)


def ran(source: Source, ended: Ended, monkeypatch: pytest.MonkeyPatch) -> Run:
    from motionlang import execution

    execute = execution._execute

    def watched(*given: Any) -> None:
        scheduler = Scheduler.run

        def run_watched(*given: Any) -> str:
            with looking(ended):
                return scheduler(*given)

        with monkeypatch.context() as m:
            m.setattr(Scheduler, "run", run_watched)
            execute(*given)

    with monkeypatch.context() as m:
        m.setattr(execution, "_execute", watched)
        return run(source, cache=False, prove=True)


@pytest.mark.parametrize("places", PLACES)
@pytest.mark.parametrize(("name", "text"), [("a.mnt", MINT), ("a.mcl", MCCL)])
def test_it_may_end_at_any_line(name: str, text: str, places: str, monkeypatch: pytest.MonkeyPatch) -> None:
    source, whole = Source(name, text), Ended(PLACES[places], 0)
    for _ in range(2):  # the first run imports, and fills what is kept
        whole.count = 0
        result = ran(source, whole, monkeypatch)
        assert (result.status, result.diagnostics, result.proof().holds) == ("ended", [], True)
    assert whole.count > 200
    for at in Random(name).sample(range(1, whole.count), min(100, whole.count - 1)):
        result = ran(source, Ended(PLACES[places], at), monkeypatch)
        assert result.status == "interrupted", at
        json.dumps(result.report)
        result.trace.sample(100.0)
        assert [each.message for each in result.proof().violations] == [], at
