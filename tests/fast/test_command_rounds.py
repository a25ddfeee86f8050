"""Iterations of several MCCL tasks are skipped together, with an equal result."""

from __future__ import annotations

from math import inf
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import execution
from motionlang.fast.command_rounds import CommandRounds, advanced
from motionlang.mccl.runtime.task import CommandTask
from motionlang.source import Source
from tests.cases import one_in
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
