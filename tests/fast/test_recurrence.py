"""Periods of several tasks are skipped only if their joint state recurs."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import run
from motionlang.controller.faults import Rejected
from motionlang.fast import recurrence
from motionlang.fast.recurrence import Recurrence
from motionlang.lang.dependencies import Dependencies
from motionlang.lang.statement_time import StatementTime
from motionlang.lang.task import Task
from motionlang.lang.waits import Delay, Wait
from motionlang.mint.runtime.task import MintTask
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import cases
from tests.counted_calls import count_calls
from tests.generated.tasks import every_iteration

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.dependencies import Note

SETTER = """\
Task Other
  Loop
    WAIT(100)
    a = 1
  End Loop
End Task
"""
COUNTED = f"""\
Dim a As Integer, n As Integer
Run Other
While n < 20
  While a = 0
  End While
  a = 0
  n = n + 1
  WAIT(50)
End While
PRINT n, " ", TIME
End
{SETTER}"""
# The reading is outside the polling loop.
TIMED = f"""\
Dim a As Integer
Run Other
Loop
  While a = 0
  End While
  a = 0
  If TIME > 1050 Then Exit Loop
End Loop
PRINT TIME
End
{SETTER}"""
# `n` is 0 whenever a time slice ends while Late waits; only the partly computed sum has counted.
HALF_WORKED_OUT = """\
Dim n As Integer, m As Integer, ready As Integer
Run Other
Repeat
  n = m
  m = 0
  m = n + Late()
Until m = 20
PRINT m, " ", TIME
End
Function Late() As Integer
  While ready = 0
  End While
  ready = 0
  Late = 1
End Function
Task Other
  Loop
    WAIT(10)
    n = 0
    WAIT(10)
    ready = 1
  End Loop
End Task
"""
# Both arrays are equal whenever a time slice ends while Count polls; the one that it counts in is decided
# before.
BY_REFERENCE = """\
Type Pair
  n As Integer
  m As Integer
End Type
Dim p(2) As Pair, i As Integer, k As Integer, ready As Integer
Run Other
Loop
  i = 2 - k
  Count(p(i).n)
  If p(1).n = 1 And p(2).n = 1 Then Exit Loop
  p(1).n = 0
End Loop
PRINT TIME
End
Sub Count(ByRef n As Integer)
  i = 0
  While ready = 0
  End While
  ready = 0
  n = n + 1
End Sub
Task Other
  Loop
    WAIT(20)
    ready = 1
  End Loop
End Task
"""
# A flag that is reset within the iteration of a loop, and a task that waits for it.
GIVEN_BACK = """\
Dim a As Integer
Run Other
Loop
  a = 1
  OUTX(1) = INX(1)
  a = 0
  OUTX(2) = INX(2)
  If TIME > 900 Then Exit Loop
End Loop
PRINT TIME
End
Task Other
  PAUSE a = 1
  PRINT "seen ", TIME
End Task
"""

# At 1000 uu/s², 50 uu/s are reached after 0.05 s.
CROSSED = """\
Dim m As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run Beat
Run Watch
MOVEA(0) = 30 : GO(0)
Repeat
  OUTX(6) = 0
Until IDLE(0)
End
Task Beat
  Loop
    If TIME > 400 Then m = m + 1
    WAIT(5)
  End Loop
End Task
Task Watch
  PAUSE VEL(0) > 50
  OUTX(1) = 1
End Task
"""


def ran(text: str, until: float | None = None, cost: float = 1e-5) -> Run:
    machine: dict[str, object] = {"controller.instruction_time": cost}
    return run(Source("a.mnt", text), machine=machine, cache=False, until=until)


def test_a_level_that_is_passed_as_a_search_looks_for_it_ends_a_pause() -> None:
    """The PAUSE ends as the level is passed, and OUTX takes a statement."""
    found = ran(CROSSED, 0.2, 1e-4)
    (move,), (switched,) = found.machine.log.moves, found.machine.log.outputs
    assert switched.time == pytest.approx(move.start_time + 0.05 + 1e-4, abs=1e-9)


def test_a_counter_that_the_polling_loop_does_not_name_counts() -> None:
    """Other begins at 1.03 ms and sets `a` every 100.03 ms, lastly at 2 001.6 ms.

    That is the 20th time. Another 50 ms pass after it.
    """
    assert ran(COUNTED).output == ["20 2051"]


def test_a_time_that_is_read_outside_the_polling_loop_passes() -> None:
    """`a` is set 1.03 ms after each multiple of 100.03 ms.

    The first of these times after 1050 ms is 1 101.36 ms.
    """
    assert ran(TIMED).output == ["1101"]


@pytest.mark.parametrize("beside", ["If INX(1) Then OUTX(1) = 1", "WAIT(7)", "While INX(1) = 0 : End While"])
def test_loop_until_a_time_ends_on_time_next_to_a_polling_task(beside: str) -> None:
    text = f"Run Other\nWhile TIME < 400\nEnd While\nPRINT TIME\nEnd\nTask Other\nLoop\n  {beside}\nEnd Loop\nEnd Task"
    (printed,) = ran(text).output
    assert 400 <= int(printed) <= 401  # the other task may have had the time slice


def test_values_of_an_expression_before_its_wait_belong_to_the_state() -> None:
    """Task Other begins at 1.05 ms and makes twenty iterations of 20.05 ms."""
    assert ran(HALF_WORKED_OUT, until=3.0).output == ["20 402"]


@pytest.mark.parametrize("text", [BY_REFERENCE, GIVEN_BACK, COUNTED, TIMED, HALF_WORKED_OUT])
@pytest.mark.parametrize("cost", [1e-5, 0.7310585e-5, 3e-5])
def test_it_is_as_every_iteration_has_it(text: str, cost: float) -> None:
    skipped = ran(text, until=3.0, cost=cost)
    with every_iteration():
        carried_out = ran(text, until=3.0, cost=cost)
    assert (skipped.output, skipped.time) == (carried_out.output, carried_out.time)


def test_tasks_that_hand_a_variable_to_and_fro_for_ever_are_skipped() -> None:
    """Each task changes the variable that the other one polls, in a joint period."""
    text = COUNTED.replace("  n = n + 1\n", "")
    result = ran(text)
    assert result.time == pytest.approx(28_800.0)
    assert len(result.machine.log.waits) == 6


def test_an_hour_is_skipped_after_many_searches_have_failed(monkeypatch: pytest.MonkeyPatch) -> None:
    """An output changes every 3 ms for 0.6 s, so no search for a period succeeds.

    After that nothing happens until 3600 s.
    """
    text = (
        "Dim k As Integer\nRun Lamp\nRun Guard\nFor k = 1 To 200\n  OUTX(2) = k Mod 2\n  WAIT(3)\nNext\n"
        "PAUSE INX(3)\nPRINT TIME\nEnd\nTask Lamp\nLoop\n  If INX(1) Then OUTX(1) = 1 Else OUTX(1) = 0\n"
        "End Loop\nEnd Task\nTask Guard\nLoop\n  If INX(5) Then STOP(0)\nEnd Loop\nEnd Task\n"
    )
    resumed = count_calls(monkeypatch, (MintTask, "resume"))
    machine: dict[str, object] = {"input": [{"channel": 3, "at": 3600.0}]}
    found = run(Source("a.mnt", text), machine=machine, cache=False, until=4000.0)
    (passed,) = map(int, found.output)
    assert 3_600_000 <= passed <= 3_600_002  # the others may each have a time slice of 1 ms before
    assert resumed.calls == 1154


def test_a_stop_on_an_axis_that_is_stopping_is_no_event() -> None:
    """From 40 at 500/s² the axis stops in 0.08 s; only the first STOP is logged."""
    text = (
        "SPEED(0) = 50 : DECEL(0) = 500\nRun T1\nJOG(0) = 40\nWAIT(200)\nWhile Not IDLE(0)\n  STOP(0)\n"
        "End While\nEnd\nTask T1\n  Loop\n    WAIT(1)\n  End Loop\nEnd Task\n"
    )
    fast, plain = (run(Source("a.mnt", text), cache=False, fast=fast) for fast in (True, False))
    stops = [
        [each.time for each in found.machine.log.events if each.kind == "stop"] for found in (fast, plain)
    ]
    assert stops[0] == stops[1]
    assert len(stops[0]) == 1


class Poller(Task):
    """A task that only polls, with a state that the test sets."""

    def __init__(self, world: World, wait: Delay | None = None) -> None:
        super().__init__("poller")
        self._world, self.wait = world, wait
        self.contents: bytes | None = b"at the loop"
        self.poll_check = 0, True

    @property
    def shared(self) -> Any:
        return self._world.shared

    def state(self, alive: dict[int, object], since: float = 0.0) -> bytes | None:
        return self.contents


class World:
    """Two tasks, their clock, and the search for their period.

    A statement takes 10 µs. Each of `waits` is the length of a task's WAIT and its end, s; None for a task that polls
    without one. `event` is the time of the next event.
    """

    def __init__(self, *waits: tuple[float, float] | None, cost: float = 1e-5, event: float = inf) -> None:
        self.event, self.acts, self.variables = event, 0, b"variables"
        # What was logged as repeated: the mark and the time of the period's start, its end, that of the
        # repetitions, and their number.
        self.repeated: list[tuple[object, ...]] = []
        clock: Any = SimpleNamespace(now=0.0, fired=0, leaps=0, next_time=lambda: self.event)
        self.clock = clock
        self.statements, self.dependencies, self.paced = (
            StatementTime(cost),
            Dependencies(clock),
            list[float](),
        )
        self.shared: Any = SimpleNamespace(
            dependencies=self.dependencies,
            acted=lambda: (self.acts, 0),
            state=lambda alive: self.variables,
        )
        self.tasks = [Poller(self, each and self.delay(*each)) for each in waits or (None, None)]
        machine: Any = SimpleNamespace(
            clock=clock,
            statements=self.statements,
            log=SimpleNamespace(
                events=list[object](),
                mark_period=lambda: clock.now,
                repeat_period=lambda *period: self.repeated.append(period),
            ),
        )
        self.events = machine.log.events
        self.recurrence = Recurrence(machine, self.paced.append)

    def delay(self, length: float, end: float) -> Delay:
        return Delay(self.clock, end - length, end)

    def slice(
        self,
        count: float,
        *ends: float | None,
        base: float = 0.0,
        next_index: int = 0,
        until: float = inf,
        without_waits: bool = False,
    ) -> float:
        """End a time slice at a statement, and the WAITs at `ends`.

        Return the statement after that.
        """
        self.statements.base = base
        self.clock.now = self.statements.leave(count)
        for task, end in zip(self.tasks, ends, strict=False):
            if end is not None and task.wait is not None:
                assert isinstance(task.wait, Delay)
                task.wait.move(end)
        for task in self.tasks:
            self.recurrence.has_run(task)
        self.recurrence.leap(self.tasks, next_index, until, without_waits)
        return self.statements.count

    def times(self) -> tuple[float, ...]:
        """Return the present time, the base of the statements, and the ends of the WAITs."""
        return (
            self.clock.now,
            self.statements.base,
            *(each.wait.ends for each in self.tasks if each.wait is not None and each.wait.ends is not None),
        )


@cases(
    "event, until, count",
    (
        (1.0, inf, 300 + 498 * 200),
        (inf, 1.0, 300 + 498 * 200),
        (1.0, 0.5, 300 + 248 * 200),
        (0.009 + 5e-8, inf, 300 + 2 * 200),
        (0.009 + 1.5e-7, inf, 300 + 3 * 200),
        (0.0051, inf, 300 + 200),
        (0.005, inf, 300),
        (0.0031, inf, 300),
    ),
)
def test_periods_are_repeated_up_to_an_event_or_the_end(event: float, until: float, count: float) -> None:
    """The states after 100 and after 300 statements are equal, so a period takes 2 ms.

    Up to 1 s, 498 of them fit after the 3 ms. One that would end less than 0.1 µs before an event does not.
    """
    world = World(event=event)
    assert [world.slice(each, until=until) for each in (100.0, 300.0)] == [100.0, count]
    assert world.times() == (count * 1e-5, 0.0)
    assert world.clock.leaps == (count > 300)
    assert world.paced == [count * 1e-5] * (count > 300)


def changing_at(world: World, moment: float, level: float = inf) -> Note:
    """Return the dependency of a value that changes at `moment`, and then at `level`."""
    return (lambda *about: moment if world.clock.now <= moment else level), ()


@cases(
    "moment, level, count, states",
    (
        (0.5, 0.5, 300 + 248 * 200, 2),  # 0.003 + 248 * 0.002 = 0.499
        (0.001, inf, 300, 0),  # it may have changed as the first state was stored
        (0.001 - 1e-8, inf, 300, 0),
        (0.001 - 1.5e-7, inf, 300 + 498 * 200, 2),
        (0.002, inf, 300, 0),
        (0.0009, 0.0031, 300, 2),
        (0.0009, 0.0052, 300 + 200, 2),
        (0.0009, 0.009 + 1.5e-7, 300 + 2 * 200, 2),
        (0.0009, 0.009 + 2.5e-7, 300 + 3 * 200, 2),
        (0.0009, 0.003 + 1e-7, 300, 0),
        (0.0009, 0.003 + 1.5e-7, 300, 2),
    ),
)
def test_periods_are_repeated_up_to_a_change_of_a_reading(
    moment: float, level: float, count: float, states: int
) -> None:
    """A reading that may have changed since the first state ends the search.

    It is relied on only up to 0.1 µs before its change. The last period ends more than 0.2 µs before the change.
    """
    world = World(event=1.0)
    world.slice(100.0)
    assert world.dependencies.read is not None
    world.dependencies.read.add(changing_at(world, moment, level))
    assert world.slice(300.0) == count
    assert len(world.recurrence._numbers) == states
    assert world.times() == (count * 1e-5, 0.0)


def test_tasks_of_which_none_is_ever_woken_are_stuck() -> None:
    world = World()
    world.slice(100.0)
    with pytest.raises(Rejected) as error:
        world.slice(300.0)
    assert error.value.code == "never"


@cases(
    "ends, base, count, times",
    (
        # 5 ms later the WAIT ends 5 ms later: 198 periods fit before 1 s.
        ((None, 0.009), 0.0, 600.0, (0.006 + 198 * 0.005, 0.0, 0.009 + 198 * 0.005)),
        ((None, 0.0090001), 0.0, 600.0, (0.006, 0.0, 0.0090001)),
        # The statements count from the end of a WAIT, 7 ms later: 141 periods fit.
        ((None, 0.011), 0.007, 100.0, (0.008 + 141 * 0.007, 0.007 + 141 * 0.007, 0.011 + 141 * 0.007)),
        # A base that is no whole number of units, and another statement.
        ((None, 0.007 + 1 / 3 * 1e-6 + 0.004), 0.007 + 1 / 3 * 1e-6, 100.0, None),
        ((None, 0.011 + 1e-5), 0.007, 101.0, (0.00801, 0.007, 0.01101)),
    ),
)
def test_waits_of_a_period_end_later_by_the_skipped_time(
    ends: tuple[float | None, ...], base: float, count: float, times: tuple[float, ...] | None
) -> None:
    """The first state is that of statement 100, at 1 ms; a WAIT of 5 ms ends at 4 ms."""
    world = World(None, (0.005, 0.004), event=1.0)
    world.slice(100.0)
    world.slice(count, *ends, base=base)
    wait = world.tasks[1].wait
    assert isinstance(wait, Delay)
    assert world.times() == pytest.approx(times or (base + 0.001, base, ends[1]), rel=1e-15)
    assert wait.ends - wait.since == pytest.approx(0.005, rel=1e-12)
    assert world.clock.leaps == (world.clock.now > 0.5)


@cases("before, base, leaps", ((0.0, 0.007, 1), (0.0, 0.007 + 1e-6 / 3, 0), (1e-6 / 3, 0.007, 0)))
def test_waits_of_a_period_begin_at_whole_units(before: float, base: float, leaps: int) -> None:
    """A third of a µs is no whole number of 10 ps, so its multiples are rounded."""
    world = World(None, (0.005, before + 0.004), event=1.0)
    world.slice(100.0, base=before)
    world.slice(100.0, None, base + 0.004, base=base)
    assert world.clock.leaps == leaps


@cases(
    "waits, end, leaps",
    (
        ((None, None), 0.0, 1),
        ((None, (0.005, 0.004)), 0.009, 0),
        ((None, (0.005, 0.004)), 0.004 + 15_000 * 1e-11, 0),
        ((None, (0.005, 0.004)), 0.004 + 15_000 * 33_333 * 1e-11, 0),
    ),
)
def test_a_statement_of_no_whole_number_of_units_has_no_period_with_a_wait(
    waits: tuple[tuple[float, float] | None, ...], end: float, leaps: int
) -> None:
    """A statement takes 1 / 3 µs, which is 33 333.3 units of 10 ps.

    15 000 statements lie between the states.
    """
    world = World(*waits, cost=1e-6 / 3, event=1.0)
    world.slice(3000.0)
    world.slice(3000.0 + 15_000.0, None, end)
    assert world.clock.leaps == leaps


@cases("event, left", ((1.0, 0.006 + 198 * 0.005), (0.0105, 0.008)))
def test_the_longest_period_that_fits_is_repeated(event: float, left: float) -> None:
    """The state at 6 ms is that at 1 ms, and but for the WAIT that at 5 ms.

    If a period of 5 ms does not fit before an event, two of 1 ms fit before the end of the WAIT at 9 ms.
    """
    world = World(None, (0.005, 0.004), event=event)
    for count, end in ((100.0, 0.004), (500.0, 0.009), (600.0, 0.009)):
        world.slice(count, None, end)
    assert world.clock.leaps == 1
    assert world.clock.now == pytest.approx(left, rel=1e-12)


def test_no_state_is_compared_with_one_that_was_dropped() -> None:
    """A reading changes by the third state, so all states are dropped.

    The variables are new in the last three states. The numbers of contents begin again, so they must not be compared
    with earlier ones.
    """
    world = World(None, (0.005, 0.1), event=1.0)
    for count, end, variables in (
        *((100.0, 0.1, b"a"), (600.0, 0.1, b"b"), (1100.0, 0.105, b"b")),
        *((1200.0, 0.105, b"c"), (1300.0, 0.105, b"d"), (1400.0, 0.105, b"e")),
    ):
        world.variables = variables
        world.slice(count, None, end)
        if count == 100.0:
            assert world.dependencies.read is not None
            world.dependencies.read.add(changing_at(world, 0.002, 0.0065))
    assert world.clock.leaps == 0


def test_a_task_alone_may_have_a_period() -> None:
    world = World(None, event=1.0)
    assert leaps_after(world, 100.0, 300.0) == 1


def leaps_after(world: World, *counts: float, **given: Any) -> int:
    """Return how often periods are skipped, with states after some statements."""
    for count in counts:
        world.slice(count, **given)
    return int(world.clock.leaps)


def fired(world: World) -> None:
    world.clock.fired += 1


def acted(world: World) -> None:
    world.acts += 1


def logged(world: World) -> None:
    world.events.append("stop")


def assigned(world: World) -> None:
    world.variables = b"others"


def moved(world: World) -> None:
    world.tasks[1].contents = b"behind the loop"


def read_by_others(world: World) -> None:
    world.dependencies.begin_all()


def computed(world: World) -> None:
    world.tasks[1].poll_check = None


def nothing(world: World) -> None:
    pass


@cases(
    "change, leaps",
    (
        (nothing, [1, 1]),
        (fired, [0, 1]),
        (acted, [0, 1]),
        (logged, [0, 1]),
        (assigned, [0, 1]),
        (moved, [0, 1]),
        (read_by_others, [0, 1]),
        (computed, [0, 0]),
    ),
)
def test_what_changes_between_two_states_ends_their_period(
    change: Callable[[World], None], leaps: list[int]
) -> None:
    """The change comes after the first state; two states follow it."""
    world = World(event=1.0)
    assert leaps_after(world, 100.0) == 0
    change(world)
    assert [leaps_after(world, world.statements.count + 200.0) for _ in range(2)] == leaps


def test_a_task_that_has_not_run_keeps_its_state() -> None:
    world = World(event=1.0)
    world.slice(100.0)
    moved(world)
    world.statements.base, world.clock.now = 0.0, world.statements.leave(300.0)
    world.recurrence.has_run(world.tasks[0])
    world.recurrence.leap(world.tasks, 0, inf)
    assert world.clock.leaps == 1


def test_states_are_dropped_when_a_task_acts() -> None:
    """The readings are no longer collected; to drop nothing is allowed."""
    world = World(event=1.0)
    world.recurrence.forget()
    world.slice(100.0)
    assert world.dependencies.read is not None
    world.recurrence.forget()
    assert world.dependencies.read is None
    assert leaps_after(world, 300.0) == 0
    world.tasks[0].poll_check = None
    world.slice(500.0)
    assert world.dependencies.read is None


def test_tasks_whose_statements_do_not_end_now_are_not_compared() -> None:
    world = World(event=1.0)
    world.slice(100.0)
    world.statements.leave(300.0)  # the clock is still at 1 ms
    world.recurrence.leap(world.tasks, 0, inf)
    assert world.dependencies.read is None
    assert world.clock.leaps == 0


def test_tasks_of_a_program_that_cannot_be_compared_are_executed() -> None:
    world = World(event=1.0)
    world.shared = None
    assert leaps_after(world, 100.0, 300.0) == 0
    world = World(event=1.0)
    world.tasks[1].contents = None
    assert leaps_after(world, 100.0, 300.0) == 0


def test_alternating_tasks_are_compared_at_one_task_alone() -> None:
    """Only the first and the last state have the same next task.

    Between them no state is stored.
    """
    world = World(event=1.0)
    world.slice(100.0)
    stored = len(world.recurrence._met)
    world.slice(200.0, next_index=1)
    assert len(world.recurrence._met) == stored
    assert leaps_after(world, 300.0) == 1
    # A task with a WAIT may come next at any state.
    world = World(None, (0.005, 0.004), event=1.0)
    world.slice(100.0)
    stored = len(world.recurrence._met)
    world.slice(200.0, next_index=1)
    assert len(world.recurrence._met) > stored


@cases(
    "waits, ends, without_waits, leaps, left",
    (
        # A WAIT of 100 ms ends at 100 ms; shorter ones repeat up to then, from 6 ms on.
        (((0.005, 0.004), (0.1, 0.1)), (0.009, 0.1), False, 1, 0.006 + 18 * 0.005),
        # It is not four times as long as the other one, so both are of one period.
        (((0.005, 0.004), (0.0199, 0.1)), (0.009, 0.1), False, 0, 0.006),
        (((0.005, 0.004), (0.02, 0.1)), (0.009, 0.1), False, 0, 0.006),
        (((0.005, 0.004), (0.0201, 0.1)), (0.009, 0.1), False, 1, 0.006 + 18 * 0.005),
        # Next to a task without a WAIT, any WAIT may also end a period of that task alone.
        ((None, (0.005, 0.1)), (None, 0.1), False, 1, 0.006 + 18 * 0.005),
        ((None, (0.005, 0.1)), (None, 0.1), True, 1, 0.006 + 18 * 0.005),
        ((None, (0.005, 0.004)), (None, 0.009), True, 0, 0.006),
        ((None, (0.005, 0.004)), (None, 0.009), False, 1, 0.006 + 198 * 0.005),
        (((0.005, 0.004), (0.005, 0.004)), (0.009, 0.009), True, 0, 0.006),
    ),
)
def test_a_longer_wait_may_end_the_periods_of_shorter_ones(
    waits: tuple[tuple[float, float] | None, ...],
    ends: tuple[float | None, ...],
    without_waits: bool,
    leaps: int,
    left: float,
) -> None:
    """The states are those at 1 ms and at 6 ms; the next event comes at 1 s.

    With `without_waits` no WAIT may end in a period.
    """
    world = World(*waits, event=1.0)
    world.slice(100.0, without_waits=without_waits)
    world.slice(600.0, *ends, without_waits=without_waits)
    assert world.clock.leaps == leaps
    assert world.clock.now == pytest.approx(left, rel=1e-12)


@pytest.mark.parametrize("is_over", [False, True])
def test_a_wait_outside_the_period_that_is_over_ends_the_search(is_over: bool) -> None:
    """The condition of another task holds, although it is not due before 0.1 s."""
    world = World(None, None, event=1.0)
    world.tasks[1].poll_check = None
    world.tasks[1].wait = Wait(0.0, lambda: is_over, lambda: 0.1, "for a condition")
    assert leaps_after(world, 100.0, 600.0) == (not is_over)


@pytest.mark.parametrize(("limit", "most"), [("MAX_STATES", 1), ("MAX_BYTES", 24)])
def test_the_states_that_are_stored_are_limited(
    limit: str, most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The variables have 9 bytes, and each state of a task 1.

    So 24 bytes are exceeded by the contents of 16 states: 9 and 16. Then all are dropped.
    """
    monkeypatch.setattr(recurrence, limit, most)
    world = World(event=1.0)
    sizes = []
    for number in range(40):
        world.tasks[0].contents = world.tasks[1].contents = bytes([number])
        world.slice(100.0 * number)
        sizes.append(len(world.recurrence._met))
    assert sizes[: {"MAX_STATES": 4, "MAX_BYTES": 19}[limit]] == (
        [1, 2, 1, 2] if limit == "MAX_STATES" else [*range(1, 17), 1, 2, 3]
    )


def is_eager(world: World, failures: int, tasks: int) -> bool:
    world.recurrence._failures = failures
    return world.recurrence.is_eager(tasks)


def test_searches_that_fail_back_off() -> None:
    """Each of the tasks may fail twice. Then a pause replaces every second search.

    State 4 is the fifth failure, one too many. State 5 begins a pause of 2 more states, state 9 one of 4, state 15 one
    of 8, and state 25 one of 16.
    """
    world, searches = World(event=1.0), []
    for number in range(41):
        acted(world)
        failures = world.recurrence._failures
        world.slice(100.0 * number)
        assert (world.dependencies.read is not None) == (world.recurrence._failures > failures)
        if world.dependencies.read is not None:
            searches.append(number)
    assert searches == [0, 1, 2, 3, 4, 5 + 2 + 1, 9 + 4 + 1, 15 + 8 + 1]
    eager = [(4, 2), (5, 2), (6, 2), (5, 3), (7, 3)]
    assert [is_eager(world, *each) for each in eager] == [True, False, False, True, False]


def test_a_pause_has_at_most_2048_states() -> None:
    """After one that has skipped something, the search is as eager as at first."""
    world = World(event=1.0)
    world.recurrence._failures = 4 + 11
    world.slice(0.0)
    assert world.recurrence._back_off == 2048
    world.recurrence._failures, world.recurrence._back_off, world.recurrence._backed_off = 4 + 12, 0, False
    world.slice(0.0)
    assert world.recurrence._back_off == 2048
    world.recurrence._back_off = 0
    assert leaps_after(world, 100.0, 300.0) == 1
    assert world.recurrence._failures == 0
