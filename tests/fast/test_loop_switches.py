"""Loops that switch outputs are skipped, and the log has every change."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import run
from motionlang.fast.loop_switches import LoopSwitches
from motionlang.lang.dependencies import Dependencies
from motionlang.lang.statement_time import StatementTime
from motionlang.source import Source
from tests.cases import cases, covering
from tests.generated.handlers import document

STEPS = (
    "OUTX(1) = 1", "OUTX(1) = 0", "OUTX(2) = Not OUTX(2)", "OUT(0) = 5", "OUT(0) = 0", "OUTX(3) = INX(1)", "n = n + 1",
    "OUTX(4) = n > 400", "OUTX(5) = POS(0) > 6", "x = POS(0)", "If INX(0) Then OUTX(6) = 1", "m = 1 - m", "k = INX(0)",
    "COMMS(1) = 4", "If n = 333 Then OUTX(7) = 1", "OUTX(1) = 1 : OUTX(1) = 0", "OUTX(2) = 1 : OUTX(2) = 0", "WAIT(1)",
)  # fmt: skip
ENDS = ("Not IDLE(0)", "TIME < 800", "POS(0) < 9", "INX(0) = 0 And TIME < 900", "n < 2500 And TIME < 900")
# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 40, 10, 100


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program with a loop of some steps alongside a move, and its machine."""
    random = Random(seed)
    lines = [
        "Dim n As Integer, m As Integer, k As Integer, x As Float",
        "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500",
    ]
    if random.random() < 0.1:
        lines += ["Run T1"]
    for _ in range(2):
        lines += [f"MOVER(0) = {random.randint(2, 12)} : GO(0)", f"While {random.choice(ENDS)}"]
        lines += [f"  {random.choice(STEPS)}" for _ in range(random.randint(1, 4))]
        lines += ["End While", 'PRINT TIME, " ", n, " ", m, " ", k, " ", x']
    if random.random() < 0.2:
        lines += ["End", "Event IN1", "  OUTX(8) = Not OUTX(8)", "End Event"]
    if "Run T1" in lines:
        lines += ["End"] * ("End" not in lines) + ["Task T1", "WAIT(200)", "OUTX(9) = 1", "End Task"]
    inputs: list[dict[str, object]] = [
        {"channel": random.randint(0, 1), "at": round(random.uniform(0, 0.8), 4), "for": 0.05}
        for _ in range(random.randint(0, 3))
    ]
    if random.random() < 0.1:
        inputs.append({"channel": 1, "output": 2, "delay": 0.004})
    return "\n".join(lines), {"controller.instruction_time": random.choice((4e-5, 2.924e-5)), "input": inputs}


def is_equal(seed: int) -> bool:
    """True if a program has the same result with accelerators and without."""
    given = program(seed)
    return document(*given, True) == document(*given, False)


@pytest.mark.slow
def test_generated_loops_are_equal() -> None:
    """The sample has every kind of step and of loop end.

    It also has a task, an event, and an input that follows an output.
    """
    kinds = (*STEPS, *ENDS, "Run T1", "Event IN1", "'delay'")
    seeds = covering(kinds, SLICE, lambda seed: "".join(map(str, program(seed))))
    assert [seed for seed in seeds if not is_equal(seed)] == []


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_many_generated_loops_are_equal(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []


def test_pulses_of_a_loop_are_all_in_the_log() -> None:
    """An iteration has three statements of 10 µs; the output is on for one of them."""
    text = "While TIME < 500\n  OUTX(1) = 1\n  OUTX(1) = 0\nEnd While\nPRINT TIME\n"
    found = run(Source("a.mnt", text), cache=False, fast=True)
    changes = found.machine.log.outputs
    assert found.machine.terminal.lines == ["500"]
    assert len(changes) in (2 * 16_666, 2 * 16_667)
    for number in (0, 1, 2, 3, 1000, 7777, 24_998, 33_331):
        iteration, off = divmod(number, 2)
        assert changes[number].time == pytest.approx(
            changes[0].time + 3e-5 * iteration + 1e-5 * off, abs=1e-11
        )
        assert (changes[number].channel, changes[number].value) == (1, 1 - off)


def test_the_iterations_are_not_executed(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = 0
    begin = LoopSwitches.begin

    def counted(self: LoopSwitches, *given: object) -> None:
        nonlocal calls
        calls += 1
        begin(self, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(LoopSwitches, "begin", counted)
    for body in ("OUTX(1) = 1\n  OUTX(1) = 0", "OUTX(1) = Not OUTX(1)"):
        run(Source("a.mnt", f"While TIME < 5000\n  {body}\nEnd While\n"), cache=False, fast=True)
    assert calls == 6


def test_an_output_that_alternates_has_a_change_for_each_iteration() -> None:
    """An iteration has two statements of 10 µs."""
    text = "While TIME < 500\n  OUTX(1) = Not OUTX(1)\nEnd While\n"
    changes = run(Source("a.mnt", text), cache=False, fast=True).machine.log.outputs
    assert len(changes) == 25_000
    assert {changes[number].value for number in range(0, 25_000, 2)} == {1}
    assert changes[24_999].time - changes[0].time == pytest.approx(24_999 * 2e-5, abs=1e-9)


class Stream(list[Any]):
    """A stream of a log; a template is stored as it is given."""

    def repeat(self, shape: object, pace: object) -> None:
        self.append((shape, pace))


class Loop:
    """A loop of two statements of 10 µs that toggles output 3.

    It runs alone on its controller, up to 1 ms.
    """

    def __init__(self) -> None:
        self.outputs, self.events = Stream(), Stream()
        clock: Any = SimpleNamespace(now=0.0)
        self.scheduler = SimpleNamespace(tasks=["main"], interrupts=list[str](), by_itself=True)
        self.switched = SimpleNamespace(values=(), listeners=list[object]())
        log = SimpleNamespace(outputs=self.outputs, streams=lambda: [self.events, self.outputs])
        self.dependencies = Dependencies(clock)
        environment: Any = SimpleNamespace(
            acts=7,
            switches=4,
            resumed=2,
            statements=StatementTime(1e-5),
            controller=SimpleNamespace(outputs=self.switched),
            machine=SimpleNamespace(log=log, scheduler=self.scheduler),
            dependencies=self.dependencies,
        )
        environment.statements.until = 0.001
        self.environment = environment
        self.made = LoopSwitches(environment)
        self.start: Any = None

    def begin(self, t: float, *counters: float, follows: bool = True, variables: object = 5) -> None:
        """Begin an iteration at a statement."""
        environment, base = self.environment, self.environment.statements.base
        state = environment.acts, variables
        self.start = (
            state,
            counters,
            t,
            base,
            base + t * 1e-5,
            environment.resumed,
            *self.dependencies.begin(),
        )
        self.made.begin(self.start, follows)

    def toggle(self, t: float) -> None:
        """Switch the output at a statement."""
        value = 1 - len(self.switched.values)
        self.switched.values = ((3, 1.0),) * value
        self.environment.acts += 1
        self.environment.switches += 1
        self.outputs.append((t * 1e-5, 3, value))

    def skip(
        self, t: float, *counters: float, levels: Any = (), carries: bool = False, variables: object = 5
    ) -> object:
        """End an iteration at a statement.

        Return the result, without counters if there are none.
        """
        state = self.environment.acts, variables
        found = self.made.skip(t, self.start, state, counters, levels, carries)
        return found if found is None or counters else found[:2]

    def two(self, *counters: float) -> None:
        """Execute two iterations up to the end of the second one, which is not checked."""
        self.begin(0.0, *counters)
        self.toggle(0.0)
        assert self.skip(2.0, *counters, variables=6) == (
            (2.0, 100.0, counters) if counters else (2.0, 100.0)
        )
        self.begin(2.0, *counters, variables=6)
        self.toggle(2.0)


PERIOD = [(0, (4.0,), (3, 1)), (0, (6.0,), (3, 0))]


@cases(
    "until, level, carries, times",
    (
        (0.001, inf, False, 24),
        (0.001, inf, True, 23),
        (0.00099, inf, False, 23),
        (1.0, inf, False, 24999),
        (1.0, 0.0005, False, 11),
        (0.00008, inf, False, 1),
        (0.00008, inf, True, 0),
        (0.00007, inf, False, 0),
        (0.00004, inf, False, None),
        (1.0, 0.00004, False, None),
        (inf, inf, False, None),
    ),
)
def test_a_period_of_two_iterations_is_repeated(
    until: float, level: float, carries: bool, times: int | None
) -> None:
    """A period has 4 statements, and the first one ends with statement 4.

    24 fit before statement 100. A reading changes at `level`. With `carries` the last iteration is executed.
    """
    loop = Loop()
    loop.two()
    loop.environment.statements.until = until
    if level < inf:
        assert loop.dependencies.notes is not None
        loop.dependencies.notes.append((lambda: level, ()))
    found = loop.skip(4.0, carries=carries)
    if times is None:
        assert found is None
        return
    assert found == (4.0 + 4 * times, round(until * 1e5))
    template = ((PERIOD, times, 0, 4.0), (0.0, 0, 0.0, 1e-5))
    assert loop.outputs == [(0.0, 3, 1), (2e-5, 3, 0), *[template] * (times > 0)]
    assert loop.made._begun == []
    assert loop.environment.statements.count == (4.0 + 4 * times if times else 0.0)


@cases(
    "counters, levels, times, after",
    (
        ((2.0, 5.0), ((9.0,), ()), 6, (2.0 + 6, 5.0)),
        ((2.0, 5.0), ((3.0,), ()), 0, (2.0, 5.0)),
        ((2.0, 5.0), ((), ()), 24, (26.0, 5.0)),
        ((1.0, 4.0), ((0.0,), (3.0,)), 24, (1.0, 4.0)),
    ),
)
def test_counters_advance_up_to_their_constants(
    counters: tuple[float, ...], levels: object, times: int, after: tuple[float, ...]
) -> None:
    """They begin with 1 and 5, or with 1 and 4.

    From 2 on, six more steps by 1 stay below 9.
    """
    loop = Loop()
    loop.two(1.0, counters[1])
    assert loop.skip(4.0, *counters, levels=levels) == (4.0 + 4 * times, 100.0, after)


def other_start(loop: Loop) -> None:
    loop.start = *loop.start[:-1], 77


def listened(loop: Loop) -> None:
    loop.switched.listeners.append("an input")


def waited(loop: Loop) -> None:
    loop.environment.statements.base = 0.5


def resumed(loop: Loop) -> None:
    loop.environment.resumed += 1


def other_task(loop: Loop) -> None:
    loop.scheduler.tasks.append("other")


def handler(loop: Loop) -> None:
    loop.scheduler.interrupts.append("timer")


def paced(loop: Loop) -> None:
    loop.scheduler.by_itself = False


def acted(loop: Loop) -> None:
    loop.environment.acts += 1


def logged(loop: Loop) -> None:
    loop.events.append("stop")


def between_statements(loop: Loop) -> None:
    loop.outputs[-1] = (2.5e-5, 3, 0)


def not_logged(loop: Loop) -> None:
    loop.outputs.clear()


def forgotten(loop: Loop) -> None:
    loop.made._begun.clear()


def not_recorded(loop: Loop) -> None:
    loop.dependencies.notes = []


def switched_64_times(loop: Loop) -> None:
    loop.outputs[:] = [(0.0, 3, 1)] * 64


def switched_65_times(loop: Loop) -> None:
    loop.outputs[:] = [(0.0, 3, 1)] * 65


@cases(
    "change",
    (
        *(
            other_start,
            listened,
            waited,
            resumed,
            other_task,
            handler,
            paced,
            acted,
            logged,
            between_statements,
        ),
        *(not_logged, forgotten, not_recorded, switched_65_times),
    ),
)
def test_an_iteration_that_may_not_repeat_is_not_skipped(change: Callable[[Loop], None]) -> None:
    loop = Loop()
    loop.two()
    change(loop)
    outputs = [*loop.outputs]
    assert loop.skip(4.0) is None
    assert loop.outputs == outputs


def test_a_period_has_at_most_64_switches() -> None:
    loop = Loop()
    loop.two()
    switched_64_times(loop)
    assert loop.skip(4.0) == (100.0, 100.0)


def test_a_period_has_at_most_eight_iterations() -> None:
    """The variables differ after each iteration; the ninth one begins a new search."""
    loop = Loop()
    for number in range(9):
        loop.begin(2.0 * number, variables=number)
        loop.toggle(2.0 * number)
        assert len(loop.made._begun) == number % 8 + 1
        found = loop.skip(2.0 * number + 2.0, variables=number + 1)
        assert found == (None if number == 7 else (2.0 * number + 2.0, 100.0))


@cases(
    "follows, change, begun",
    (
        (True, None, 3),
        (False, None, 1),
        (True, other_task, 0),
        (False, other_task, 0),
    ),
)
def test_iterations_in_a_row_are_compared(
    follows: bool, change: Callable[[Loop], None] | None, begun: int
) -> None:
    """They are dropped if one was not checked, or another task was started."""
    loop = Loop()
    loop.two()
    if change is not None:
        change(loop)
    loop.begin(4.0, follows=follows)
    assert len(loop.made._begun) == begun
