"""Going back by snapshots: from where, and what a user has changed on the way."""

from __future__ import annotations

from random import Random

import pytest

from motionlang.ide.debug import checkpoints
from motionlang.ide.debug.breakpoints import Breakpoint, Watched
from motionlang.ide.debug.checkpoints import Checkpoint, Checkpoints
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.replay import NEAR
from motionlang.kernel import Hook, Source, dialect, entries, run
from motionlang.kernel.lang import Snapshot
from tests.ide.debug.walks import go_to_number, snapshot
from tests.ide.debug.whole import whole

# 4 statements an iteration; R10 counts.
COUNTS = "AL0,AR10\nRA10,AA1,AR10,WA0.001,RP1500\nTR10\n"


def mccl(text: str, settings: dict[str, object] | None = None) -> Debugger:
    debugger = Debugger(Source("a.mcl", text), dialect("mccl"), settings or {})
    debugger.start()
    return debugger


def count(debugger: Debugger) -> int:
    found = debugger.state().named("R10")
    assert found is not None
    assert isinstance(found[1].value, int)
    return found[1].value


@pytest.fixture
def dense(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checkpoints, "FIRST", 3)
    monkeypatch.setattr(checkpoints, "MAX_CHECKPOINTS", 6)


def test_a_step_back_repeats_an_eighth_of_the_run_at_most(monkeypatch: pytest.MonkeyPatch) -> None:
    """The next ones begin `NEAR` statements before the stop."""
    debugger = mccl(COUNTS)
    while debugger.go_on() is not None:
        pass
    last = debugger._replay.hook.count
    assert last > 6000
    begun: list[int] = []
    back = debugger._replay.back

    def noted(to: checkpoints.Checkpoint | None, target: float = 0.0) -> None:
        begun.append(0 if to is None else to.number)
        back(to, target)

    monkeypatch.setattr(debugger._replay, "back", noted)
    for k in range(4):
        stop = debugger.step_back()
        assert stop is not None
        assert stop.number == last - k
        assert min(begun) > (last * 7 // 8 if not k else last - 2 * NEAR)
        begun.clear()
    debugger.abandon()


@pytest.mark.usefixtures("dense")
def test_what_a_user_changes_is_part_of_the_state() -> None:
    """A change is there again, whether a snapshot has it or the run makes it once more."""
    debugger, draw = mccl(COUNTS), Random(1)
    seen: dict[int, object] = {}
    for k in range(1, 12):
        for _ in range(draw.randrange(1, 30)):
            stop = debugger.step_in()
        assert stop is not None
        debugger.assign(("module", "R10"), 1000 * k)
        seen[stop.number] = snapshot(debugger)
        stop = debugger.step_in()
        assert stop is not None
        seen[stop.number] = snapshot(debugger)
    for number in draw.sample(sorted(seen), len(seen)):
        go_to_number(debugger, number)
        assert snapshot(debugger) == seen[number]
    debugger.abandon()


@pytest.mark.usefixtures("dense")
def test_an_input_of_a_user_comes_again_after_going_back() -> None:
    debugger = mccl("WN5,AL1,AR10\nWF5,AL2,AR10\nWA0.1,TR10\n", {})
    debugger.step_in()
    debugger.go_back_to_line(1)
    debugger.enter(entries({}, inputs=["5=1@0.5..0.75"]))
    for line, time in ((2, 0.5), (3, 0.75)):
        stop = debugger.go_to_line(line)
        assert stop is not None
        assert stop.time == pytest.approx(time, abs=1e-3)
    debugger.go_to_time(0.0)
    stop = debugger.go_to_line(3)
    assert stop is not None
    assert stop.time == pytest.approx(0.75, abs=1e-3)
    debugger.abandon()


@pytest.mark.usefixtures("dense")
def test_hits_are_counted_from_the_start_whatever_the_debugger_did_before() -> None:
    debugger = mccl(COUNTS)
    offsets = debugger.offsets_at(2)
    debugger.set_breakpoints([Breakpoint(offsets, hits="% 100")])
    numbers = []
    for _ in range(3):
        stop = debugger.go_on()
        assert stop is not None
        numbers.append(stop.number)
    debugger.step_back()
    debugger.last_change(("module", "R10"))
    debugger.go_to_time(0.11)
    for number in numbers[1:]:
        stop = debugger.go_on()
        assert stop is not None
        assert stop.number == number
    for number in numbers[1::-1]:
        stop = debugger.reverse()
        assert stop is not None
        assert stop.number == number
    debugger.abandon()


@pytest.mark.usefixtures("dense")
def test_a_watched_register_is_found_backward_as_forward() -> None:
    debugger = mccl(COUNTS)
    debugger.watched = [Watched(("module", "R10"))]
    forward = []
    for _ in range(9):
        stop = debugger.go_on()
        assert stop is not None
        forward.append((stop.number, stop.text))
    backward = [(stop.number, stop.text) for _ in range(8) if (stop := debugger.reverse()) is not None]
    assert backward == forward[-2::-1]
    debugger.abandon()


EVENTS = """\
Dim n As Integer, m As Integer, k As Integer
For k = 1 To 20
  n = n + 1
  n = n + 2
  n = 2 * n
  If n > 1000 Then n = 0
Next
Print n, m
End
Event IN1
  m = n
  n = n + 7
End Event
"""


ERRORS = """\
n = 0
#again
n = n + 1
If n < 3 Then Goto again
x = 1 / (n - 3)
Event ONERROR
  While ERRORREADNEXT(_egALL, 0)
    Print ERRSTRING, ", line ", ERRLINE
  End While
End Event
"""


def test_a_round_for_a_snapshot_does_not_set_the_clock() -> None:
    """The handler of an error begins at the time of the last statement that has set it."""
    source, hook = Source("a.mnt", ERRORS), Hook(lambda task, time, offset: None)
    hook.round_at = 0
    assert whole(run(source, machine={}, hook=hook)) == whole(run(source, machine={}))


@pytest.mark.parametrize("round_at", [0, 1 << 60])
@pytest.mark.parametrize("at", [k * 1.3e-5 for k in range(1, 20)])
def test_a_round_for_a_snapshot_lets_no_event_come_earlier(at: float, round_at: int) -> None:
    source = Source("a.mnt", EVENTS)
    settings: dict[str, object] = {"input": [{"channel": 1, "at": at, "value": 1}]}
    hook = Hook(lambda task, time, offset: None)
    hook.round_at = round_at
    assert whole(run(source, machine=settings, hook=hook)) == whole(run(source, machine=settings))


def checkpoint(number: int) -> Checkpoint:
    return Checkpoint(number, float(number), Snapshot(None), {}, 0, 0, 0)


def test_the_checkpoints_before_a_statement_and_a_time() -> None:
    made = Checkpoints()
    for number in (16, 32, 50):
        made.add(checkpoint(number))
    assert [[each.number for each in made.before(number)] for number in (16, 17, 50, 51)] == [
        [], [16], [16, 32], [16, 32, 50],
    ]  # fmt: skip
    found = [made.before_time(time) for time in (16.0, 20.0, 32.0, 99.0)]
    assert [each and each.number for each in found] == [None, 16, 16, 50]
    assert made.due == 66
    made.drop_after(made.before(33)[-1])
    assert ([each.number for each in made.before(99)], made.due) == ([16, 32], 48)
    made.drop_after(None)
    assert (made.before(99), made.due) == ([], 16)


def test_of_too_many_checkpoints_every_second_one_is_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checkpoints, "MAX_CHECKPOINTS", 4)
    made = Checkpoints()
    while made.due < 500:
        made.add(checkpoint(int(made.due)))
    assert [each.number for each in made.before(999)] == [16, 144, 272, 400]
    assert made.due == 528
