"""Tasks, waits and the end of a run, with tasks that are generators of the test."""

from __future__ import annotations

import json
from collections.abc import Callable, Generator
from itertools import pairwise

import pytest

from motionlang.kernel import Controller, Scheduler, Source, Stuck, Task, Wait, run
from motionlang.kernel.lang import wait_idle, wait_until
from motionlang.kernel.report import text as report_text

Steps = Generator[float | Wait, tuple[float, float], float]


def controller() -> Controller:
    c = Controller(2)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


class Written(Task):
    """A task that is a generator: it yields the time that it has reached or a wait, and returns its end."""

    def __init__(self, name: str, make: Callable[[float, float], Steps]) -> None:
        super().__init__(name)
        self._make = make
        self._steps: Steps | None = None

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        try:
            if self._steps is None:
                self._steps = self._make(now, horizon)
                found = next(self._steps)
            else:
                found = self._steps.send((now, horizon))
        except StopIteration as end:
            self.done = True
            return float(end.value), None
        return (found.since, found) if isinstance(found, Wait) else (found, None)


def task(make: Callable[[float, float], Steps]) -> Written:
    return Written("parent", make)


def test_a_run_ends_when_the_program_has_ended_and_every_axis_is_at_rest() -> None:
    c = controller()

    def program(t: float, h: float) -> Steps:
        c.load_by(0, 12.0)
        c.go([0])
        return t + 1e-5
        yield t

    assert Scheduler(c, task(program)).run() == "ended"
    assert c.clock.now == 2.0


def test_waits_jump_straight_to_their_end() -> None:
    c = controller()
    times = []

    def program(t: float, h: float) -> Steps:
        c.load_by(0, 12.0)
        c.go([0])
        t, h = yield wait_idle(c, t, [0])
        times.append(t)
        t, h = yield wait_until(c, t, t + 3600.0)
        times.append(t)
        return t

    Scheduler(c, task(program)).run()
    assert times == [2.0, 3602.0]


def test_a_busy_program_meets_the_horizon_and_ends_at_until() -> None:
    c = controller()

    def program(t: float, h: float) -> Steps:
        while True:
            t += 1e-3
            if t >= h:
                t, h = yield t

    assert Scheduler(c, task(program)).run(until=1.0) == "until"
    assert c.clock.now == pytest.approx(1.0, abs=2e-3)


PRINTS, REPLIES = "PRINT TIME\n" * 9, ",TR0" * 9
RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
ENABLE = "1MN,1SV100,1SA1000,1DS1000"
# File, program, and the milliseconds after which it writes a line every millisecond. A statement of Mint begins where
# the last one ended, the first at 0; a command of MCCL takes its millisecond first. A move of 1 takes 2 * sqrt(1/1000),
# 63.2 ms; one of 10 just reaches the speed of 100 and takes 200 ms; a jog of 1 covers 0.05 in 50.5 ms.
WAITS = {
    "no wait": ("a.mnt", PRINTS, 0.0),
    "a WAIT": ("a.mnt", f"WAIT 5\n{PRINTS}", 6.0),
    "a WAIT of computed length": ("a.mnt", f"Dim w\nw = 4\nWAIT w\n{PRINTS}", 6.0),
    "two WAITs": ("a.mnt", f"WAIT 5\nWAIT 5\n{PRINTS}", 12.0),
    "a WAIT in a sub": ("a.mnt", f"Later()\n{PRINTS}Sub Later()\nWAIT 5\nEnd Sub\n", 7.0),
    "a PAUSE for a move": ("a.mnt", f"{RATES}MOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\n{PRINTS}", 68.2),
    "a PAUSE for a position": ("a.mnt", f"{RATES}JOG(0) = 1\nPAUSE POS(0) > 0.05\n{PRINTS}", 54.5),
    "a PAUSE for a time": ("a.mnt", f"PAUSE TIME >= 70\n{PRINTS}", 71.0),
    "WA": ("a.mcl", f"WA0.005{REPLIES}", 7.0),
    "WS": ("a.mcl", f"{ENABLE},1MR10,1WS{REPLIES}", 206.0),
    "WP": ("a.mcl", f"{ENABLE},1MR10,1WP5{REPLIES}", 106.0),
}


@pytest.mark.parametrize("name", WAITS)
@pytest.mark.parametrize("lines", [1, 4, 7])
def test_no_statement_begins_after_the_end_of_a_run(name: str, lines: int) -> None:
    file, text, begin = WAITS[name]
    until = (begin + lines - 0.5) * 1e-3
    result = run(Source(file, text), machine={"controller.instruction_time": 1e-3}, until=until)
    assert (result.status, len(result.output)) == ("until", lines)


def test_two_tasks_share_the_controllers_time() -> None:
    c = controller()
    done: list[str] = []

    def work(name: str) -> Callable[[float, float], Steps]:
        def program(t: float, h: float) -> Steps:
            for _ in range(1000):
                t += 1e-5
                if t >= h:
                    t, h = yield t
            done.append(name)
            return t

        return program

    scheduler = Scheduler(c, task(work("parent")))
    scheduler.start(task(work("child")))
    assert scheduler.run() == "ended"
    assert done[0] == "parent"
    assert c.clock.now == pytest.approx(0.02, abs=2e-3)


def test_a_task_that_waits_for_a_time_does_not_oversleep_while_another_computes() -> None:
    """The busy task's time slice ends when the other's wait does, not a quantum later."""
    c = controller()
    woken = []

    def sleeper(t: float, h: float) -> Steps:
        for moment in (0.00123, 0.0031, 0.0102):
            t, h = yield wait_until(c, t, moment)
            woken.append(t)
        return t

    def busy(t: float, h: float) -> Steps:
        while t < 0.02:
            t += 1e-5
            if t >= h:
                t, h = yield t
        return t

    s = Scheduler(c, task(busy))
    s.start(task(sleeper))
    s.run()
    assert woken == [pytest.approx(moment, abs=1.1e-5) for moment in (0.00123, 0.0031, 0.0102)]


def test_a_wait_that_is_always_due_and_never_over_cannot_hold_time() -> None:
    c = controller()

    def program(t: float, h: float) -> Steps:
        yield Wait(t, lambda: False, lambda: c.clock.now, "for a rounding error")
        return t

    assert Scheduler(c, task(program)).run(until=10.0) == "until"
    assert c.clock.now == 10.0


def slices(steps: dict[str, int], prepare: Callable[[Scheduler], None] = lambda scheduler: None) -> list[str]:
    """Return when each time slice of some tasks starts, in ms.

    `steps` has the steps of 0.25 ms that each task computes; the first task is the parent. `prepare` may change
    the tasks.
    """
    c, begun = controller(), list[str]()

    def work(name: str, count: int) -> Callable[[float, float], Steps]:
        def program(t: float, h: float) -> Steps:
            begun.append(f"{name} {t * 1e3:g}")
            for _ in range(count):
                t += 0.25e-3
                if t >= h:
                    t, h = yield t
                    begun.append(f"{name} {t * 1e3:g}")
            return t

        return program

    made = [Written(name, work(name, count)) for name, count in steps.items()]
    scheduler = Scheduler(c, made[0])
    for each in made[1:]:
        scheduler.start(each)
    prepare(scheduler)
    assert scheduler.run() == "ended"
    return begun


def test_tasks_alternate_in_time_slices() -> None:
    """A slice takes 1 ms, or less if the task ends within it."""
    begun = slices({"parent": 9, "first": 6, "second": 3})
    assert begun == ["parent 0", "first 1", "second 2", "parent 2.75", "first 3.75", "parent 4.25"]


def test_a_task_may_have_shorter_slices() -> None:
    def prepare(scheduler: Scheduler) -> None:
        scheduler.tasks[0].max_slice = 0.5e-3

    begun = slices({"parent": 5, "first": 6}, prepare)
    assert begun == ["parent 0", "first 0.5", "parent 1.5", "first 2", "parent 2.5"]


def test_the_innermost_handler_is_stuck_first() -> None:
    """While a handler waits, no task continues; of the tasks the parent is reported."""

    def program(t: float, h: float) -> Steps:
        yield Wait(t, lambda: False, lambda: float("inf"), "for input 3")
        return t

    for handlers, name in (((), "parent"), (("outer",), "outer"), (("outer", "inner"), "inner")):
        parent, first, *others = (Written(each, program) for each in ("parent", "first", *handlers))
        scheduler = Scheduler(controller(), parent)
        scheduler.start(first)
        for each in others:
            scheduler.interrupt(each)
        with pytest.raises(Stuck) as caught:
            scheduler.run()
        assert caught.value.task.name == name


def test_a_wait_passes_within_its_statement_only_if_the_task_is_alone() -> None:
    """The wait ends at 0.5 s; an event at 0.25 s does not end it."""

    def passes(until: float = 9.0, tasks: int = 1, ends: float = 0.5, pace: RealTime | None = None) -> bool:
        c = controller()
        c.clock.at(0.25, lambda: None)
        scheduler = Scheduler(c, task(computing(1)), pace)
        scheduler.until = until
        for _ in range(tasks - 1):
            scheduler.start(task(computing(1)))
        wait = Wait(0.125, lambda: c.clock.now >= ends, lambda: ends, "for a time")
        passed = scheduler.passes(wait)
        assert c.clock.now == (ends if passed else c.clock.now)
        return passed

    assert passes()
    assert not passes(until=0.5)
    assert not passes(tasks=2)
    assert not passes(ends=float("inf"))
    assert not passes(pace=RealTime())


@pytest.mark.parametrize(
    ("name", "text"), [("a.mnt", "Dim n As Integer\nWhile 1\n n = n + 1\nWend"), ("a.mcl", "MD1,AA1,RP\nMC1")]
)
def test_a_program_that_only_computes_is_paced(name: str, text: str) -> None:
    times = [0.0]
    run(Source(name, text), until=0.5, pace=times.append)
    assert max(later - earlier for earlier, later in pairwise(times)) < 0.011
    assert times[-1] == pytest.approx(0.5, abs=1e-3)


def test_a_handler_runs_to_its_end_before_any_task() -> None:
    def prepare(scheduler: Scheduler) -> None:
        scheduler.interrupt(scheduler.tasks.pop())

    begun = slices({"parent": 5, "first": 2, "handler": 6}, prepare)
    assert begun == ["handler 0", "handler 1", "parent 1.5", "first 2.5", "parent 3"]


def test_an_event_after_a_handler_or_a_task_is_located_at_the_line_of_the_parent() -> None:
    """The handler runs every 10 ms and the task once; the parent waits in line 3."""
    text = (
        "TIMEREVENT = 10\nRun Brief\nWAIT(55)\nEnd\nEvent TIMER\nEnd Event\nTask Brief\n  n = 1\nEnd Task\n"
    )
    report = json.loads(report_text(run(Source("a.mnt", text))))
    assert [event["line"] for event in report["events"]] == [3] * 5


def test_an_event_after_the_end_of_the_program_has_no_line() -> None:
    """The limit of 50 is reached after half a second, and nothing waits for it."""
    text = "SOFTLIMITFORWARD(0) = 50 : SOFTLIMITMODE(0) = 2\nSPEED(0) = 100\nJOG(0) = 100\n"
    report = json.loads(report_text(run(Source("a.mnt", text), until=1.0)))
    assert [(event["kind"], event["line"], event["commanded_by"]) for event in report["events"]] == [
        ("soft limit", 0, 3),
        ("velocity jump", 0, 3),
    ]


def test_motion_settles_after_the_program() -> None:
    """The move ends at 2 s; a jog has no end."""
    for until, settled, time in (
        (1.5, False, 1.5),
        (2.0, True, 2.0),
        (9.0, True, 2.0),
        (float("inf"), True, 2.0),
    ):
        c = controller()
        c.load_by(0, 12.0)
        c.go([0])
        assert Scheduler(c, task(computing(1))).settle(until) is settled
        assert c.clock.now == time
    for until, time in ((1.5, 1.5), (float("inf"), 0.0)):
        c = controller()
        c.jog(0, 4.0)
        assert Scheduler(c, task(computing(1))).settle(until) is False
        assert c.clock.now == time


def computing(steps: int) -> Callable[[float, float], Steps]:
    def program(t: float, h: float) -> Steps:
        for _ in range(steps):
            t, h = yield t + 1e-5
        return t

    return program


class RealTime:
    """Collects the times at which a run is synchronised with real time."""

    def __init__(self) -> None:
        self.times: list[float] = []

    def __call__(self, now: float) -> None:
        self.times.append(round(now, 6))


def test_a_run_in_real_time_is_paced_before_each_jump() -> None:
    """The program waits until 0.5 s and 1 s, and its move ends at 3 s."""
    c, real = controller(), RealTime()

    def program(t: float, h: float) -> Steps:
        t, h = yield wait_until(c, t, 0.5)
        t, h = yield wait_until(c, t, 1.0)
        c.load_by(0, 12.0)
        c.go([0])
        return t

    assert Scheduler(c, task(program), real).run() == "ended"
    assert real.times == [0.0, 0.5, 0.5, 1.0, 1.0, 3.0]
