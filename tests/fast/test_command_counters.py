"""Polling MCCL loops that count in registers are skipped with an equal result."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from motionlang import execution
from motionlang.mccl.runtime.poll import Poll
from motionlang.source import Source
from tests.cases import cases, covering

MOVES = "1MN,1SV1000,1SA20000,1DS20000"
HEAD = 'LU"STATUS",AR21,LU"POSITION",AR22\n'
MACHINE: dict[str, object] = {
    "input": [{"channel": 5, "at": 0.0203, "for": 0.0113, "every": 0.0417}, {"channel": 6, "at": 0.1}],
}
# The generated loops run on a controller of a quarter of the speed, with a quarter of the iterations.
SLOW = MACHINE | {"controller.instruction_time": 4e-5}
# Chunks of a loop; `@` is a number.
CHUNKS = (
    "RA5@,AA1,AR5@", "RA5@,AS3,AR5@", "RA50,AA2,AR50", "IN@,CN4@,NO", "IF@,CF4@,NO", "NO", "AL@", "IB700,CN4@,NO",
    "IG900,CF4@,NO", "IE1000,TR50,NO", "1RL@21,IC3,CN4@,NO", "1RL@22,IG200,CF4@,NO", "RA52,IE@,CN47,NO", "AL@,AR52",
    "IN@,RA5@,AA1,AR5@", "RA5@,AA0.5,AR5@", "RA51,AA@50,AR51", "WA0.001", "RA7,AA1,AR7", "IU40,AL1,NO", "MC9",
)  # fmt: skip
# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 50, 10, 100


def outcome(
    text: str, fast: bool, until: float = 0.6, machine: dict[str, object] = MACHINE
) -> dict[str, Any]:
    """Return everything that the run of a program shows."""
    result = execution.run(Source("a.mcl", text), machine=machine, cache=False, fast=fast, until=until)
    report: Any = result.report
    switched = [(each.time, each.channel, each.value) for each in result.machine.log.outputs]
    compared = ("status", "time", "output", "moves", "axes", "notes", "events", "diagnostics")
    return {key: report[key] for key in compared} | {"outputs": switched}


def test_a_register_that_the_loop_recalls_by_another_one_is_no_counter() -> None:
    """RA@51 recalls register 40, whose number is in register 51.

    Register 40 exceeds 20000 after 20001 iterations of seven commands; IG skips CN41 and NO until then.
    """
    text = "AL40,AR51\nMD6,RA40,AA1,AR40,RA@51,IG20000,CN41,NO,AL0,JR-8\nMC6"
    found = outcome(text, True, 2.0)
    assert found == outcome(text, False, 2.0)
    ((time, channel, value),) = found["outputs"]
    assert (channel, value) == (41, 1)
    assert 1.4 < time < 1.4002


@cases(
    "loop, counted, jumps",
    (
        ("RA40,AA1,AR40,1RL@21,IC3,JR-5,NO", 1, 105),
        ("1RL@21,RA40,AA3,AR40,1RL@21,IC3,JR-6,NO", 3, 111),
        ("RA40,AA1,AR40,IG100,CN41,NO,1RL@21,IC3,JR-8,NO", 1, 115),
        ("RA40,AS2,AR40,RA43,AA1,AR43,1RL@21,IC3,JR-8,NO", -2, 104),
    ),
)
@pytest.mark.slow
def test_a_counting_loop_is_skipped(
    loop: str, counted: int, jumps: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A move of 1000 takes 1.05 s, which is thousands of iterations of ten commands.

    `jumps` of them are executed.
    """
    text = f"{HEAD}MD6,{loop}\n{MOVES}\n1MR1000,MC6,TR40,TR43\n"
    assert outcome(text, True, 5.0) == outcome(text, False, 5.0)
    calls = 0
    again = Poll.again

    def called(self: Poll) -> object:
        nonlocal calls
        calls += 1
        return again(self)

    monkeypatch.setattr(Poll, "again", called)
    found = outcome(text, True, 5.0)
    assert calls == jumps
    assert int(found["output"][0].split()[-1]) / counted > 1000


def drawn(random: Random) -> list[str]:
    """Return random fragments of a loop; the first one counts."""
    return [random.choice(CHUNKS[:3]), *(random.choice(CHUNKS) for _ in range(random.randint(0, 3)))]


def program(seed: int) -> str:
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
    """True if a program has the same result with accelerators and without."""
    text = program(seed)
    return outcome(text, True, machine=SLOW) == outcome(text, False, machine=SLOW)


@pytest.mark.slow
def test_generated_loops_are_equal() -> None:
    """The sample has every fragment, in background and foreground.

    It has loops alone and loops alongside another task.
    """
    seeds = covering(CHUNKS, SLICE, lambda seed: drawn(Random(seed)))
    assert {("GT6" in text, "GT7" in text) for text in map(program, seeds)} == {
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
