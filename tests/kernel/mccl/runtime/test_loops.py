"""Loops of one task and of several are skipped with an equal result."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Any

import pytest

from motionlang.kernel import Source, run
from motionlang.kernel.mccl import CommandTask
from tests.cases import blocks, cases, covering, one_in
from tests.counted_calls import count_calls
from tests.generated.compared import counting_skips, every_iteration

MOVES = "1MN,1SV1000,1SA20000,1DS20000"
WATCH = "MD5,IN5,CN34,NO,IF5,CF34,NO,RP\n"
PROGRAMS = blocks(Path(__file__).with_name("loops.txt"))
# A controller of a quarter of the usual speed, so that a loop has a quarter of the iterations.
MACHINE: dict[str, object] = {
    "controller.instruction_time": 4e-5,
    "input": [
        {"channel": 5, "at": 0.0203, "for": 0.0113, "every": 0.0417},
        {"channel": 6, "at": 0.1},
    ],
}
HEAD = 'LU"STATUS",AR21,LU"POSITION",AR22\n'
# Parts of a loop that counts; `@` is a number.
COUNT_PARTS = (
    "RA5@,AA1,AR5@", "RA5@,AS3,AR5@", "RA50,AA2,AR50", "IN@,CN4@,NO", "IF@,CF4@,NO", "NO", "AL@", "IB700,CN4@,NO",
    "IG900,CF4@,NO", "IE1000,TR50,NO", "1RL@21,IC3,CN4@,NO", "1RL@22,IG200,CF4@,NO", "RA52,IE@,CN47,NO", "AL@,AR52",
    "IN@,RA5@,AA1,AR5@", "RA5@,AA0.5,AR5@", "RA51,AA@50,AR51", "WA0.001", "RA7,AA1,AR7", "IU40,AL1,NO", "MC9",
)  # fmt: skip
# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 50, 10, 100


def outcome(text: str, until: float = 2.0) -> dict[str, Any]:
    """Return everything that the run of a program shows."""
    result = run(Source("a.mcl", text), machine=MACHINE, until=until)
    report: Any = result.report
    switched = [(each.time, each.channel, each.value) for each in result.machine.log.outputs]
    compared = ("status", "time", "output", "moves", "axes", "notes", "events", "diagnostics")
    # A command takes 40 µs, so a sum of them is not at the border of two digits.
    seconds: dict[str, float] = {}
    for each in result.machine.log.slices.up_to(result.time):
        for task, taken in zip(each.tasks, each.seconds, strict=True):
            seconds[task] = seconds.get(task, 0.0) + taken
    computed = {task: round(each, 8) for task, each in seconds.items()}
    return {key: report[key] for key in compared} | {"outputs": switched, "computed": computed}


def plain(text: str, until: float = 2.0) -> dict[str, Any]:
    """Return the same of a run in which every iteration is carried out."""
    with every_iteration():
        return outcome(text, until)


@pytest.mark.parametrize("name", PROGRAMS)
def test_skipping_changes_nothing(name: str) -> None:
    assert outcome(PROGRAMS[name]) == plain(PROGRAMS[name])


# Parts of a watch; `@` is a number.
WATCH_PARTS = (
    "IN@,CN4@,NO", "IF@,CF4@,NO", "NO", "AL@,AR@", "1RL@21,IC3,CN4@,NO", "1RL@22,IG200,CF4@,NO", "RA7,AA@,AR7",
    "RA5@,AA1,AR5@", "WA0.00@", "IN@,JR2,NO,NO", "AC", "IB@,AL1,NO", "1RV@23,IB500,CN4@,NO", "MC2@", "RA50,IE@,CN47,NO",
)  # fmt: skip


def watches(seed: int) -> str:
    """Return a program of two to four random polling loops alongside moves."""
    random = Random(seed)
    count = random.randint(2, 4)
    lines = ['LU"STATUS",AR21,LU"POSITION",AR22,LU"VELOCITY",AR23', "MD25,IN5,CN45,NO", "MD26,IF6,CF45,NO"]
    for task in range(count):
        chunks = [random.choice(WATCH_PARTS).replace("@", "%") for _ in range(random.randint(1, 4))]
        body = ",".join(chunks).replace("L%21", "L@21").replace("L%22", "L@22").replace("V%23", "V@23")
        end = random.choice(("RP", "RP", f"MJ{task + 10}"))
        lines.append(f"MD{task + 10},{body.replace('%', str(random.choice((5, 6))))},{end}")
    lines += [f"GT{task + 10}" for task in range(count)]
    return "\n".join([*lines, f"{MOVES},1MR{random.randint(50, 300)},1WS,WA0.0307,1TP,1MR-20,1WS,TR7"])


@pytest.mark.parametrize("seed", one_in(2, range(8)))
def test_skipping_in_random_watches_changes_nothing(seed: int) -> None:
    text = watches(seed)
    assert outcome(text, until=0.3) == plain(text, until=0.3), text


def test_an_hour_of_two_watches_is_over_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """3600 counts at 1 count/s take an hour, and the ramps 1 s more."""
    resumed = count_calls(monkeypatch, (CommandTask, "resume"))
    text = "MD5,IN15,CN34,NO,RP\nMD6,IN16,CN35,NO,RP\nGT5\nGT6\n1MN,1SV1,1SA1,1DS1,1MR3600,1WS,1TP"
    result = run(Source("a.mcl", text), until=4000.0)
    assert result.output == ["01 3600"]
    assert 3601.0 <= result.time < 3601.01
    assert resumed.calls < 100


def test_counts_of_two_tasks_advance_with_the_skipped_iterations(monkeypatch: pytest.MonkeyPatch) -> None:
    """100 s have 10 million commands of 10 µs.

    An iteration of each of the two counts takes one in ten of them.
    """
    resumed = count_calls(monkeypatch, (CommandTask, "resume"))
    text = "MD5,RA40,AA1,AR40,NO,RP\nMD6,RA41,AA3,AR41,NO,RP\nGT5\nGT6\nWA100,TR40,TR41"
    result = run(Source("a.mcl", text), until=101.0)
    (first, second) = map(int, result.output)
    assert abs(first - 1_000_000) <= 1
    assert abs(second - 3_000_000) <= 3
    assert resumed.calls < 200


def test_a_register_that_the_loop_recalls_by_another_one_is_no_counter() -> None:
    """RA@51 recalls register 40, whose number is in register 51.

    Register 40 exceeds 5000 after 5001 iterations of seven commands; IG skips CN41 and NO until then.
    """
    text = "AL40,AR51\nMD6,RA40,AA1,AR40,RA@51,IG5000,CN41,NO,AL0,JR-8\nMC6"
    found = outcome(text)
    assert found == plain(text)
    ((time, channel, value),) = found["outputs"]
    assert (channel, value) == (41, 1)
    assert 1.4 < time < 1.4012


@cases(
    "loop, counted",
    (
        ("RA40,AA1,AR40,1RL@21,IC3,JR-5,NO", 1),
        ("1RL@21,RA40,AA3,AR40,1RL@21,IC3,JR-6,NO", 3),
        ("RA40,AA1,AR40,IG100,CN41,NO,1RL@21,IC3,JR-8,NO", 1),
        ("RA40,AS2,AR40,RA43,AA1,AR43,1RL@21,IC3,JR-8,NO", -2),
    ),
)
def test_a_counting_loop_is_skipped(loop: str, counted: int) -> None:
    """A move of 1000 takes 1.05 s, which is thousands of iterations of ten commands."""
    text = f"{HEAD}MD6,{loop}\n{MOVES}\n1MR1000,MC6,TR40,TR43\n"
    assert outcome(text) == plain(text)
    skips: list[int] = []
    with counting_skips(skips):
        found = outcome(text)
    assert sum(skips) > 1000
    assert int(found["output"][0].split()[-1]) / counted > 1000


def drawn(random: Random) -> list[str]:
    """Return random fragments of a loop; the first one counts."""
    return [
        random.choice(COUNT_PARTS[:3]),
        *(random.choice(COUNT_PARTS) for _ in range(random.randint(0, 3))),
    ]


def counts(seed: int) -> str:
    """Return a program with a loop of some fragments, in the background or foreground."""
    random = Random(seed)
    chunks = drawn(random)
    random.shuffle(chunks)
    loop = ",".join(
        chunk.replace("@", str(random.randint(0, 6))) if "RL@" not in chunk else chunk for chunk in chunks
    )
    loop = loop.replace("1RL@21,IC3,CN4@", "1RL@21,IC3,CN44").replace(
        "1RL@22,IG200,CF4@", "1RL@22,IG200,CF44"
    )
    macros = f"{HEAD}MD9,RA53,AA1,AR53\nAL0,AR50,AR51,AR52,AR53,AR54,AR55,AR56\n"
    if random.random() < 0.5:
        other = "MD7,IN5,CN46,NO,RP\nGT7\n" if random.random() < 0.3 else ""
        return f"{macros}MD6,{loop},RP\nGT6\n{other}{MOVES}\n1MR200,1WS,TR50,TR51,1MR-50,1WS,TR51,TR52,WA0.05,TR50"
    count = loop.count(",") + 1
    return (
        f"{macros}MD6,{loop},1RL@21,IC3,JR-{count + 2},NO\n{MOVES}\n1MR200,MC6,TR50,TR51,1MR-90,MC6,TR50,TR52"
    )


def is_equal(seed: int) -> bool:
    """True if a program has the same result without skipping."""
    text = counts(seed)
    return outcome(text, 0.6) == plain(text, 0.6)


@pytest.mark.slow
def test_generated_loops_are_equal() -> None:
    """The sample has every fragment, in background and foreground.

    It has loops alone and loops alongside another task.
    """
    seeds = covering(COUNT_PARTS, SLICE, lambda seed: drawn(Random(seed)))
    assert {("GT6" in text, "GT7" in text) for text in map(counts, seeds)} == {
        (False, False),
        (True, False),
        (True, True),
    }
    assert [seed for seed in seeds if not is_equal(seed)] == []


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_many_generated_loops_are_equal(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
