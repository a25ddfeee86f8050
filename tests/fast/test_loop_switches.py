"""Loops that switch outputs are skipped, and the log has every change."""

from __future__ import annotations

from random import Random

import pytest

from motionlang import run
from motionlang.fast.loop_switches import LoopSwitches
from motionlang.source import Source
from tests.cases import covering
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
    text = "While TIME < 5000\n  OUTX(1) = 1\n  OUTX(1) = 0\nEnd While\nPRINT TIME\n"
    found = run(Source("a.mnt", text), cache=False, fast=True)
    changes = found.machine.log.outputs
    assert found.machine.terminal.lines == ["5000"]
    assert len(changes) in (2 * 166_666, 2 * 166_667)
    for number in (0, 1, 2, 3, 1000, 77_777, 249_998, 333_331):
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
    assert calls == 8


def test_an_output_that_alternates_has_a_change_for_each_iteration() -> None:
    """An iteration has two statements of 10 µs."""
    text = "While TIME < 5000\n  OUTX(1) = Not OUTX(1)\nEnd While\n"
    changes = run(Source("a.mnt", text), cache=False, fast=True).machine.log.outputs
    assert len(changes) == 250_000
    assert {changes[number].value for number in range(0, 250_000, 2)} == {1}
    assert changes[249_999].time - changes[0].time == pytest.approx(249_999 * 2e-5, abs=1e-9)
