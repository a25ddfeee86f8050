"""Iterations of several MCCL tasks are skipped together, with an equal result."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import execution
from motionlang.fast.command_counters import Counter, TaskCounter
from motionlang.fast.command_rounds import CommandRounds, advanced
from motionlang.mccl.runtime.task import CommandTask
from motionlang.source import Source
from tests.cases import cases, one_in
from tests.counted_calls import count_calls

MOVES = "1MN,1SV1000,1SA20000,1DS20000"
WATCH = "MD5,IN5,CN34,NO,IF5,CF34,NO,RP\n"
PROGRAMS = {
    "two watches": f"{WATCH}MD6,IN6,CN35,NO,IF6,CF35,NO,RP\nGT5,AR30\nGT6,AR31\n"
    f"{MOVES},1MR300,1WS,TC34,1MR-100,1WS,TC35,ET@30,ET@31",
    "watches of different lengths": f"{WATCH}MD6,IN6,CN35,JR2,NO,NO,RP\nMD7,IF6,MC8,NO,RP\nMD8,AL3,AA4,AR7\n"
    f"GT5,AR30\nGT6,AR31\nGT7,AR32\n{MOVES},1MR300,1WS,WA0.0307,ET@30,ET@31,ET@32",
    "a watch beside a poll": f'{WATCH}LU"STATUS",AR21\n{MOVES}\nGT5,AR30\n1MR300,1RL@21,IC3,JR-2,NO,1TP,1TV,ET@30',
    "polls of two axes": 'LU"STATUS",AR21\nMD5,2RL@21,IC3,JR-2,NO,2TP,2MR40,MJ5\n2MN,2SV500,2MR90\n'
    f"{MOVES}\nGT5,AR30\n1MR300,1RL@21,IC3,JR-2,NO,1TP,1TV,ET@30",
    "a watch of what moves": f'LU"POSITION",AR20\n{WATCH}MD6,1RL@20,IG150,CN35,NO,RP\nGT5,AR30\nGT6,AR31\n'
    f"{MOVES},1MR300,1WS,TC35,ET@30,ET@31",
    "a watch that waits among others": f"{WATCH}MD6,IN6,CN35,NO,WA0.003,RP\nMD7,IF7,NO,NO,RP\nGT5,AR30\nGT6,AR31\n"
    f"GT7,AR32\n{MOVES},1MR300,1WS,TC35,ET@30,ET@31,ET@32",
    "a count among watches": f"{WATCH}MD6,RA40,AA1,AR40,IB3000,JR-4,NO\nMD7,RA41,NO,RP\nGT5,AR30\nGT6\nGT7,AR32\n"
    f"{MOVES},1MR300,1WS,TR40,ET@30,ET@32",
    "two counts": f"MD5,RA40,AA1,AR40,IB2500,JR-4,NO\nMD6,IN6,RA41,AA2,AR41,NO,RP\nMD7,IF6,NO,NO,RA3,AS1,AR3,RP\nGT5\n"
    f"GT6,AR31\nGT7,AR32\n{MOVES},1MR300,1WS,TR40,TR41,ET@31,ET@32",
    "a count that another task reads": f"MD5,RA40,AA1,AR40,NO,RP\nMD6,RA40,IG1500,CN35,NO,RP\nGT5,AR30\nGT6,AR31\n"
    f"{MOVES},1MR300,1WS,TR40,ET@30,ET@31",
    "registers of their own": f"MD6,RA1,AC,AR1,NO,RP\n{WATCH}GT5,AR30\nGT6,AR31\n{MOVES},1MR300,1WS,ET@30,ET@31",
}
# A controller of a quarter of the usual speed, so that a loop has a quarter of the iterations.
MACHINE: dict[str, object] = {
    "controller.instruction_time": 4e-5,
    "input": [
        {"channel": 5, "at": 0.0203, "for": 0.0113, "every": 0.0417},
        {"channel": 6, "at": 0.1},
    ],
}


def outcome(text: str, fast: bool, until: float = 2.0) -> dict[str, Any]:
    result = execution.run(Source("a.mcl", text), machine=MACHINE, cache=False, fast=fast, until=until)
    report: Any = result.report
    switched = [(each.time, each.channel, each.value) for each in result.machine.log.outputs]
    compared = ("status", "time", "output", "moves", "axes", "notes", "events", "diagnostics")
    # A command takes 40 µs, so a sum of them is not at the border of two digits.
    seconds: dict[str, float] = {}
    for each in result.machine.log.slices:
        for task, taken in zip(each.tasks, each.seconds, strict=True):
            seconds[task] = seconds.get(task, 0.0) + taken
    computed = {task: round(each, 8) for task, each in seconds.items()}
    return {key: report[key] for key in compared} | {"outputs": switched, "computed": computed}


@pytest.mark.parametrize("name", PROGRAMS)
def test_skipping_rounds_changes_nothing(name: str) -> None:
    assert outcome(PROGRAMS[name], True) == outcome(PROGRAMS[name], False)


# Parts of a watch; `@` is a number.
CHUNKS = (
    "IN@,CN4@,NO", "IF@,CF4@,NO", "NO", "AL@,AR@", "1RL@21,IC3,CN4@,NO", "1RL@22,IG200,CF4@,NO", "RA7,AA@,AR7",
    "RA5@,AA1,AR5@", "WA0.00@", "IN@,JR2,NO,NO", "AC", "IB@,AL1,NO", "1RV@23,IB500,CN4@,NO", "MC2@", "RA50,IE@,CN47,NO",
)  # fmt: skip


def random_program(seed: int) -> str:
    """Return a program of two to four random polling loops alongside moves."""
    random = Random(seed)
    count = random.randint(2, 4)
    lines = ['LU"STATUS",AR21,LU"POSITION",AR22,LU"VELOCITY",AR23', "MD25,IN5,CN45,NO", "MD26,IF6,CF45,NO"]
    for task in range(count):
        chunks = [random.choice(CHUNKS).replace("@", "%") for _ in range(random.randint(1, 4))]
        body = ",".join(chunks).replace("L%21", "L@21").replace("L%22", "L@22").replace("V%23", "V@23")
        end = random.choice(("RP", "RP", f"MJ{task + 10}"))
        lines.append(f"MD{task + 10},{body.replace('%', str(random.choice((5, 6))))},{end}")
    lines += [f"GT{task + 10}" for task in range(count)]
    return "\n".join([*lines, f"{MOVES},1MR{random.randint(50, 300)},1WS,WA0.0307,1TP,1MR-20,1WS,TR7"])


@pytest.mark.parametrize("seed", one_in(2, range(8)))
def test_skipping_rounds_of_random_watches_changes_nothing(seed: int) -> None:
    text = random_program(seed)
    assert outcome(text, True, until=0.3) == outcome(text, False, until=0.3), text


def test_an_hour_of_two_watches_is_over_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """3600 counts at 1 count/s take an hour, and the ramps 1 s more."""
    resumed = count_calls(monkeypatch, (CommandTask, "resume"))
    text = "MD5,IN15,CN34,NO,RP\nMD6,IN16,CN35,NO,RP\nGT5\nGT6\n1MN,1SV1,1SA1,1DS1,1MR3600,1WS,1TP"
    result = execution.run(Source("a.mcl", text), cache=False, until=4000.0)
    assert result.output == ["01 3600"]
    assert 3601.0 <= result.time < 3601.01
    assert resumed.calls == 43


def test_counts_of_two_tasks_advance_with_the_skipped_rounds(monkeypatch: pytest.MonkeyPatch) -> None:
    """100 s have 10 million commands of 10 µs.

    An iteration of each of the two counts takes one in ten of them.
    """
    resumed = count_calls(monkeypatch, (CommandTask, "resume"))
    text = "MD5,RA40,AA1,AR40,NO,RP\nMD6,RA41,AA3,AR41,NO,RP\nGT5\nGT6\nWA100,TR40,TR41"
    result = execution.run(Source("a.mcl", text), cache=False, until=101.0)
    (first, second) = map(int, result.output)
    assert abs(first - 1_000_000) <= 1
    assert abs(second - 3_000_000) <= 3
    assert resumed.calls == 80


@pytest.mark.parametrize("step", [1e-5, 0.1, 3.0, 2.0**-16, 2.0**-16 * 1.5])
def test_many_sums_at_once_are_the_same_to_the_last_bit(step: float) -> None:
    for begin in (0.0, 1e-9, 0.37, 1.0, 3.9999, 12345.6789):
        time = begin
        for _ in range(20_000):
            time += step
        assert advanced(begin, step, 20_000) == time


def test_a_sum_that_no_longer_changes_is_the_same() -> None:
    assert advanced(2.0**60, 1.0, 10**6) == 2.0**60


@pytest.mark.parametrize(
    ("values", "steps", "effects", "most"),
    [
        ([10, 0.0], [2, 0.0], 1, 44.0),  # up to 98, two at a time
        ([10, 0.0], [4, 0.0], 2, 22.0),
        ([10, 0.0], [2, 0.0], 2, 0),  # one of two effects is not a count
        ([10, 0.0], [0, 0.0], 1, 0),
        ([10.5, 0.0], [2, 0.0], 1, 0),
        ([10, 0.0], [0, 0.0], 0, inf),
        ([10, 0.0], [2, 0.0], 0, 0),  # the value changes without an effect
    ],
)
def test_rounds_up_to_the_next_comparison(
    values: list[float], steps: list[float], effects: int, most: float
) -> None:
    """A task counts by 2 in each iteration, and compares with 100."""
    counter = SimpleNamespace(counter=SimpleNamespace(step=2, levels=[100.0]))
    rounds: Any = SimpleNamespace(_values=lambda: values, _counters=[counter])
    assert CommandRounds._most(rounds, steps, effects) == most


def test_the_time_of_skipped_rounds_is_shared_by_the_running_tasks() -> None:
    """Three tasks run for 6 s, which the scheduler adds to the first; one waits."""
    running: list[Any] = [SimpleNamespace(name=name, wait=None) for name in ("a", "b", "c")]
    tasks = [*running, SimpleNamespace(name="d", wait=object())]
    seconds = {"a": 1.0, "c": 2.0}
    log = SimpleNamespace(slices=SimpleNamespace(seconds=seconds))
    board: Any = SimpleNamespace(tasks=tasks, machine=SimpleNamespace(log=log))
    rounds: Any = SimpleNamespace(_board=board)
    CommandRounds._share(rounds, running[0], 6.0, 3)
    assert seconds == pytest.approx({"a": 1.0 - 4.0, "b": 2.0, "c": 2.0 + 2.0})
    CommandRounds._share(rounds, running[1], 6.0, 3)
    assert seconds == pytest.approx({"a": -1.0, "b": -2.0, "c": 6.0})


class Watch:
    """A task that repeats a line of ten commands; its jump back is command 9."""

    def __init__(self, name: str, read: Any) -> None:
        self.name, self.wait, self.line = name, None, SimpleNamespace(commands=())
        self.board = SimpleNamespace(assumptions={})
        self.pc, self.here, self.paid, self.then, self.path_open = 0, 9, True, None, None
        self.base, self.count, self.cost = 0.0, 0.0, 1e-5
        self.poll = SimpleNamespace(dependencies=SimpleNamespace(read=read))
        self.registers, self.memory = [7, 8, 9], {40: 100}
        self.calls, self.repeats = list[Any](), dict[int, int]()
        self.loop_log = SimpleNamespace(entered=1)

    def register(self, number: int) -> float:
        return self.registers[number] if number < 10 else self.memory[number]

    def set_register(self, number: int, value: int) -> None:
        if number < 10:
            self.registers[number] = value
        else:
            self.memory[number] = value


class Rounds:
    """Two watches of a board, A and B, whose rounds take 200 µs.

    The next event is at 1 s.
    """

    def __init__(self) -> None:
        self.event, self.until = 1.0, inf
        self.slices = dict[str, float]()
        self.scheduler: Any = SimpleNamespace(until=inf, by_itself=True)
        self.clock = SimpleNamespace(fired=3, made=8, next_time=lambda: self.event)
        log = SimpleNamespace(slices=SimpleNamespace(seconds=self.slices))
        board: Any = SimpleNamespace(
            machine=SimpleNamespace(scheduler=self.scheduler, log=log),
            controller=SimpleNamespace(clock=self.clock),
            waited=2,
            effects=5,
            tasks=[Watch("A", None), Watch("B", None)],
        )
        self.board = board
        self.made = CommandRounds(board)

    def jump(self, name: str, count: float) -> None:
        """Let a task jump back at a command, counted from 0 s."""
        for task in self.board.tasks:
            if task.name == name:
                task.count = count
                self.made.jumped(task)

    def rounds(self, *counts: float) -> float:
        """Let both tasks jump at these commands; return the time of A after them, s."""
        for count in counts:
            self.jump("B", count - 1)
            self.jump("A", count)
        first = self.board.tasks[0]
        return float(first.base + first.count * first.cost)


def test_rounds_up_to_an_event_are_skipped_when_a_state_recurs() -> None:
    """The first jump of B begins the search, by the jumps of A.

    The states after 20 and 40 commands are the same. After 0.4 ms 4998 rounds of 0.2 ms fit up to 1 s, which
    is too many for the last 0.1 µs.
    """
    rounds = Rounds()
    found = rounds.rounds(20.0, 40.0)
    assert found == advanced(40 * 1e-5, 1e-5, 4997 * 20)
    first = rounds.board.tasks[0]
    assert (first.base, first.count, rounds.made._met) == (found, 0, {})
    lasts = found - 40 * 1e-5
    assert rounds.slices == pytest.approx({"A": -lasts / 2, "B": lasts / 2})


def leaves(rounds: Rounds) -> None:
    """The task B leaves its line for another one."""
    rounds.board.tasks[1].line = SimpleNamespace(commands=())


def calls(rounds: Rounds) -> None:
    rounds.board.tasks[1].calls = [(object(), 3, {})]


def assigns(rounds: Rounds) -> None:
    rounds.board.tasks[1].registers[2] = 10


def becomes_a_float(rounds: Rounds) -> None:
    rounds.board.tasks[1].registers[2] = 9.0


def repeats(rounds: Rounds) -> None:
    rounds.board.tasks[0].repeats = {3: 1}


def acts(rounds: Rounds) -> None:
    rounds.board.effects += 1


def fires(rounds: Rounds) -> None:
    rounds.clock.fired += 1


def schedules(rounds: Rounds) -> None:
    rounds.clock.made += 1


def waits(rounds: Rounds) -> None:
    rounds.board.waited += 1


def starts(rounds: Rounds) -> None:
    rounds.board.tasks.append(Watch("C", rounds.made._read))


def is_paced(rounds: Rounds) -> None:
    rounds.scheduler.by_itself = False


def has_no_scheduler(rounds: Rounds) -> None:
    rounds.board.machine.scheduler = None


def takes_half_a_slice(rounds: Rounds) -> None:
    for task in rounds.board.tasks:
        task.cost = 5e-4


def reads_too_much(rounds: Rounds) -> None:
    rounds.board.tasks[1].poll.dependencies.read = set()


def never_ends(rounds: Rounds) -> None:
    rounds.event = inf


def waits_for_what_is_over(rounds: Rounds) -> None:
    rounds.board.tasks.append(Watch("C", None))
    rounds.board.tasks[2].wait = SimpleNamespace(ready=lambda: True, due=lambda: 0.5)


@pytest.mark.parametrize(
    "change",
    [
        *(leaves, calls, assigns, becomes_a_float, repeats, acts, fires, schedules, waits, starts, is_paced),
        *(has_no_scheduler, takes_half_a_slice, reads_too_much, never_ends),
    ],
)
def test_rounds_are_executed_if_something_else_has_changed(change: Callable[[Rounds], None]) -> None:
    """It changes between the first state and the second one."""
    rounds = Rounds()
    rounds.rounds(20.0)
    change(rounds)
    assert rounds.rounds(40.0) == 40 * rounds.board.tasks[0].cost
    assert rounds.slices == {}


def test_a_wait_that_is_over_ends_the_search() -> None:
    rounds = Rounds()
    waits_for_what_is_over(rounds)
    assert rounds.rounds(20.0, 40.0) == 40 * 1e-5


def test_a_short_command_fits_a_time_slice() -> None:
    """Rounds of 20 commands of 0.4 ms take 8 ms, and 122 fit between 16 ms and 1 s."""
    rounds = Rounds()
    for task in rounds.board.tasks:
        task.cost = 4e-4
    found = rounds.rounds(20.0, 40.0)
    assert found == advanced(0.016, 4e-4, 122 * 20)


@cases(
    "level, due, until, counts, rounds_",
    (
        # A reading changes before the event: the state must be met a third time.
        (0.01, inf, inf, (20.0, 40.0), 0),
        (0.01, inf, inf, (20.0, 40.0, 60.0), 46),
        (inf, 0.01, inf, (20.0, 40.0, 60.0), 46),
        (inf, inf, 0.01, (20.0, 40.0, 60.0), 46),
        (0.01 + 1.5e-7, inf, inf, (20.0, 40.0, 60.0), 47),
        (0.0008 + 3e-7, inf, inf, (20.0, 40.0, 60.0), 1),
        (0.0008 + 1e-8, inf, inf, (20.0, 40.0, 60.0), 0),
        (0.0006 + 5e-8, inf, inf, (20.0, 40.0, 60.0), 0),
        (0.0006, inf, inf, (20.0, 40.0, 60.0), 0),
    ),
)
def test_rounds_are_skipped_up_to_a_change(
    level: float, due: float, until: float, counts: tuple[float, ...], rounds_: int
) -> None:
    """After 0.6 ms 46 rounds of 0.2 ms fit up to 10 ms, less 0.1 µs."""
    rounds = Rounds()
    rounds.scheduler.until = until
    if due < inf:
        waiting = Watch("C", None)
        waiting.wait = SimpleNamespace(ready=lambda: False, due=lambda: due)  # type: ignore[assignment]
        rounds.board.tasks.append(waiting)
    rounds.jump("B", 19.0)
    rounds.made._read.add((lambda: level, ()))
    rounds.jump("A", 20.0)
    found = rounds.rounds(*counts[1:])
    assert found == advanced(counts[-1] * 1e-5, 1e-5, rounds_ * 20)
    assert (bool(rounds.slices), bool(rounds.made._met)) == (rounds_ > 0, rounds_ == 0)


def test_rounds_whose_times_add_up_to_more_are_not_skipped() -> None:
    """The sums of 18 million rounds are later than the product by several µs.

    So one round less ends 0.1 µs before the event, which comes 50 ns after the end of that number of rounds.
    """
    many = 18_000_000
    end = advanced(0.0004, 1e-5, many * 20)
    assert 1e-6 < end - (0.0004 + many * 0.0002) < 1e-4
    rounds = Rounds()
    rounds.event = end + 5e-8
    assert rounds.rounds(20.0, 40.0) == advanced(0.0004, 1e-5, (many - 1) * 20)


def test_states_are_compared_by_the_jumps_of_one_task() -> None:
    """After 2000 jumps of others, one of these takes the place of that task."""
    rounds = Rounds()
    rounds.jump("B", 1.0)
    for number in range(2, 4):
        rounds.jump("A", float(number))
    assert rounds.made._by is rounds.board.tasks[0]
    rounds.made._met.clear()
    rounds.board.machine.scheduler = None
    for number in range(1999):
        rounds.jump("B", 10.0 + number)
        assert rounds.made._by is rounds.board.tasks[0]
    rounds.jump("B", 10_000.0)
    assert (rounds.made._by, rounds.made._others) == (rounds.board.tasks[1], 0)


@pytest.mark.parametrize(("count", "begins"), [(2000, False), (2001, True)])
def test_two_thousand_states_are_stored(count: int, begins: bool) -> None:
    rounds = Rounds()
    rounds.jump("B", 1.0)
    rounds.made._met = dict.fromkeys(((k,) for k in range(count)), (1, 0.0, 0, []))
    rounds.jump("A", 2.0)
    assert len(rounds.made._met) == (0 if begins else count + 1)


def counting(step: int = 2, levels: tuple[float, ...] = (1000.0,)) -> Rounds:
    """Return two watches; A counts register 40 in a loop."""
    rounds = Rounds()
    for name in "BA":
        rounds.jump(name, 1.0)
    rounds.made._met.clear()
    counter = Counter(40, step, levels, True)
    rounds.made._counters = [TaskCounter(rounds.board.tasks[0], counter, True)]
    rounds.made._running = [(each, rounds.made._loops.get(each.name)) for each in rounds.board.tasks]
    return rounds


def count_once(rounds: Rounds, by: int = 2) -> None:
    first = rounds.board.tasks[0]
    first.memory[40] += by
    first.registers[0] = first.memory[40]
    rounds.board.effects += 1


@cases(
    "by, entered, levels, count",
    (
        # 102 and 104 in the two states; 447 more steps by 2 stay below 1000.
        (2, 1, (1000.0,), 104 + 2 * 447),
        (2, 1, (), 104 + 2 * 4997),
        (4, 1, (1000.0,), 106),
        (2, 2, (1000.0,), 104),
    ),
)
def test_counts_of_skipped_rounds(by: int, entered: int, levels: tuple[float, ...], count: int) -> None:
    """A round counts once, from 100 on, and 4997 rounds fit before the event.

    It does not repeat if one effect counts twice, or if the task has entered a line.
    """
    rounds = counting(levels=levels)
    first = rounds.board.tasks[0]
    count_once(rounds)
    rounds.jump("A", 20.0)
    count_once(rounds, by)
    first.loop_log.entered = entered
    rounds.jump("A", 40.0)
    assert (first.memory[40], first.registers[0]) == (count, count)
    assert rounds.made._effects == rounds.board.effects


def test_counters_and_accumulators_advance_by_their_steps() -> None:
    """The accumulator follows the counters; a step of 0 is no write."""
    rounds = counting()
    second = rounds.board.tasks[1]
    second.registers[0], second.memory = 5, {41: 9}
    rounds.made._counters += [
        TaskCounter(second, Counter(41, 1, (), False), True),
        TaskCounter(second, Counter(42, 1, (), False), False),
    ]
    rounds.made._effects, rounds.board.effects = 0, 9
    rounds.made._count([2, 1, 0, 2, 0], 10)
    assert (rounds.board.tasks[0].registers, rounds.board.tasks[0].memory) == ([27, 8, 9], {40: 120})
    assert (second.registers, second.memory) == ([5, 8, 9], {41: 19})
    assert rounds.made._effects == 9
