"""Ticks of TIMER with equal effects are skipped, and the log has all of them."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang import run
from motionlang.fast import timer_ticks
from motionlang.fast.timer_ticks import TimerTicks
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import cases
from tests.counted_calls import count_calls

# The ticks at which a handler of one path is executed: to find that they repeat, and the last ones.
FEW = 5


@pytest.fixture
def ticks(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return a list that gets the time of each tick whose handler is executed."""
    found: list[float] = []
    tick = TimerTicks._tick

    def counted(self: TimerTicks, scheduler: object, now: float, *given: object) -> bool:
        found.append(now)
        return tick(self, scheduler, now, *given)  # type: ignore[arg-type]

    monkeypatch.setattr(TimerTicks, "_tick", counted)
    return found


def ran(handler: str, wait: str = "WAIT(10000)", period: int = 1, **machine: Any) -> Run:
    """Run a program that waits while a timer ticks, and prints its variables."""
    text = (
        "Dim n As Integer, m As Integer\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
        f"TIMEREVENT = {period}\n{wait}\nPRINT n, ' ', m\nEnd\nEvent TIMER\n{handler}\nEnd Event\n".replace(
            "'", '"'
        )
    )
    found = run(Source("a.mnt", text), machine=machine, cache=False, fast=True)
    plain = run(Source("a.mnt", text), machine=machine, cache=False, fast=False)
    for stream in ("outputs", "events", "prints", "settings"):
        assert list(getattr(found.machine.log, stream)) == list(getattr(plain.machine.log, stream))
    return found


def printed(found: Run) -> list[int]:
    (line,) = found.machine.terminal.lines
    return [int(each) for each in line.split()]


@pytest.mark.slow
def test_a_counter_has_counted_every_tick(ticks: list[float]) -> None:
    """The timer starts at 30 µs, and the wait of 10 s ends after its 10 000th tick."""
    found = ran("n = n + 1")
    assert printed(found)[0] == 10_000
    assert len(found.machine.log.events) == 10_000
    assert len(ticks) == FEW


def test_the_log_has_a_handler_at_each_tick(ticks: list[float]) -> None:
    events = ran("n = n + 1").machine.log.events
    start = 3 * 1e-5
    assert [event.time for event in events] == [start + k * 0.001 for k in range(1, 10_001)]
    assert {event[1:] for event in events} == {events[0][1:], events[5][1:]}


def test_a_toggled_output_has_a_record_for_each_change() -> None:
    """The handler's first statement is executed at the time of its tick."""
    outputs = ran("OUTX(3) = Not OUTX(3)", period=10).machine.log.outputs
    start = 3 * 1e-5
    assert [(each.channel, each.value) for each in outputs] == [(3, k % 2) for k in range(1, 1001)]
    assert [each.time for each in outputs] == [start + k * (10 / 1000.0) for k in range(1, 1001)]


def test_a_pulse_within_a_tick_keeps_its_width() -> None:
    """OUTX takes 10 µs, so the output is on for one statement."""
    outputs = ran("OUTX(3) = 1\nOUTX(3) = 0", period=10).machine.log.outputs
    assert len(outputs) == 2000
    widths = [off.time - on.time for on, off in zip(outputs[::2], outputs[1::2], strict=True)]
    assert widths == pytest.approx([1e-5] * 1000)


@cases(
    "handler, n, m, count",
    (
        ("n = n + 1\nIf n >= 100 Then n = 0 : m = m + 1", 0, 100, 304),
        ("n = n + 1\nIf n = 7777 Then m = 5", 10_000, 5, 16),
        ("n = n + 1\nIf n > 2500 And n <= 5000 Then m = m + 1", 10_000, 2500, 19),
        ("n = n - 3", -30_000, 0, 13),
        ("n = 1 - n", 0, 0, 15),
        ("m = n\nn = n + 1", 10_000, 9999, 9999),
        ("If INX(2) Then n = n + 1", 4000, 0, 11),
        ("If POS(0) > 0 Then n = n + 1", 0, 0, 10),
    ),
)
@pytest.mark.slow
def test_a_handler_that_decides_does_so_at_the_right_tick(
    handler: str, n: int, m: int, count: int, ticks: list[float]
) -> None:
    """Input 2 is on from 3.0005 to 7.0005 s: at ticks 3001 to 7000.

    Of the 10 000 ticks `count` are executed: all if the effects of no two are equal.
    """
    ticks.clear()
    found = ran(handler, input=[{"channel": 2, "at": 3.0005, "for": 4.0}])
    assert printed(found)[:2] == [n, m]
    assert len(ticks) == count


def test_searches_that_fail_become_rare(monkeypatch: pytest.MonkeyPatch) -> None:
    """No two ticks are alike, so a search ends after 65 ticks.

    The next one begins at once, then after 1, 2, 4, … ticks: ten of them take 650 ticks and 511 between them, eleven
    1738.
    """
    searches = count_calls(monkeypatch, (timer_ticks._Search, "__init__"))
    text = "Dim n As Integer, m As Integer\nTIMEREVENT = 1\nWAIT(1700)\nEnd\nEvent TIMER\nm = n\nn = n + 1\nEnd Event\n"
    run(Source("a.mnt", text), cache=False, fast=True)
    assert searches.calls == 11


def test_a_handler_that_watches_a_move_sees_the_level_pass(ticks: list[float]) -> None:
    """After 0.1 s and 5 uu the axis moves 0.1 uu per tick; it passes 50 after 0.55 s."""
    found = ran("If n = 0 And POS(0) > 50 Then n = TIME", "MOVEA(0) = 90 : GO(0)\nPAUSE IDLE(0)")
    assert printed(found)[0] == pytest.approx(551, abs=1)
    assert len(ticks) == 8


def test_a_wait_for_a_counter_ends_at_its_tick() -> None:
    assert printed(ran("n = n + 1", "PAUSE n = 500"))[0] == 500


def test_a_handler_that_stops_its_timer_is_the_last_one() -> None:
    assert printed(ran("n = n + 1\nIf n = 1234 Then TIMEREVENT = 0"))[0] == 1234


PULSES = "OUTX(3) = 1\nOUTX(3) = 0\n"
# The handler, its period, ms, and the ticks that are executed of those in 2 s.
WORK: dict[str, tuple[str, int, int]] = {
    "a count": ("n = n + 1", 1, 5),
    "a count, at longer intervals": ("n = n + 1", 7, 4),
    "a toggle": ("OUTX(3) = Not OUTX(3)", 1, 5),
    "a pulse": (PULSES, 1, 4),
    "a count and a toggle": ("n = n + 1\nOUTX(3) = Not OUTX(3)", 1, 7),
    "a count beside a ring": ("n = (n + 1) Mod 5\nm = m + 1", 1, 14),
    "a ring of 63": ("n = (n + 1) Mod 63", 1, 109),
    "a ring of 64": ("n = (n + 1) Mod 64", 1, 79),
    "a ring of 65, which is not found": ("n = (n + 1) Mod 65", 1, 1999),
    "32 ticks of 8 records before the last one": (f"n = (n + 1) Mod 33\n{4 * PULSES}", 1, 52),
    "33 ticks of 8 records before the last one": (f"n = (n + 1) Mod 34\n{4 * PULSES}", 1, 1999),
    "an output that changes once": ("OUTX(3) = 1", 1, 4),
    "a text at each tenth tick": ("n = (n + 1) Mod 10\nIf n = 0 Then PRINT 7", 1, 1999),
    "a text at each hundredth tick": ("n = n + 1\nIf n >= 100 Then n = 0 : PRINT 7", 1, 81),
    "an action at each tick": ("SPEED(0) = 100 - n\nn = 1 - n", 1, 1999),
    "a wait in the handler": ("n = n + 1\nWAIT(0.1)", 1, 1999),
    "a reading that changes": ("n = n + 1\nIf TIME > 1000 Then m = m + 1", 1, 12),
    "a handler of 61 statements": ("n = n + 1\n" + "m = 3\n" * 60, 1, 5),
}


@pytest.mark.parametrize("name", WORK)
def test_only_what_repeats_within_64_ticks_and_256_records_is_skipped(name: str, ticks: list[float]) -> None:
    """To be repeated, a state must recur, and a count must advance equally twice."""
    handler, period, count = WORK[name]
    ran(handler, "WAIT(2000)", period)
    assert len(ticks) == count


@pytest.mark.parametrize(
    ("handler", "wait", "n"),
    [
        ("n = n + 1\nIf n = 50 Then TIMEREVENT = 2", "WAIT(100)", 50 + 25),
        ("n = n + 1\nIf n = 50 Then EVENTPEND(5, 0, 0)", "WAIT(100)", 100 + 1),
        (
            "n = n + 1",
            "WAIT(40) : EVENTDISABLE = 0x20 : WAIT(30.5) : EVENTDISABLE = 0 : WAIT(29.9)",
            40 + 1 + 30,
        ),
        ("n = n + 1", "PAUSE n >= 50 : WAIT(30)", 80),
        ("n = n + 1", "PAUSE INX(2)", 62),
        ("n = n + 1\nIf n = 50 Then OUTX(1) = 1", "PAUSE OUTX(1)", 50),
        ("n = n + 1\nIf INX(2) Then OUTX(1) = 1", "PAUSE OUTX(1)", 63),
        ("n = n + 1", "MOVEA(0) = 1 : GO(0) : PAUSE IDLE(0) : WAIT(10)", 73),
        ("n = n + 1", "MOVEA(0) = 1 : GO(0) : PAUSE POS(0) > 0.5", 31),
        ("n = n + 1", "PAUSE TIME > 50", 50),
    ],
)
def test_a_wait_ends_with_the_tick_or_the_event_that_ends_it(handler: str, wait: str, n: int) -> None:
    """Input 2 comes at 62.5 ms. A move of 1 takes 2 sqrt(1 / 1000) s = 63.2 ms.

    TIME is 51 after 51 ms, and the 51st tick comes 30 us later.
    """
    assert printed(ran(handler, wait, input=[{"channel": 2, "at": 0.0625}]))[0] == n


@pytest.mark.parametrize("cost", [2.5e-4, 1e-4])
@pytest.mark.parametrize("wait", ["WAIT(10)", "WAIT(9.5)", "WAIT(60)", "PAUSE TIME > 20"])
def test_a_wait_that_ends_at_a_tick_ends_as_without_accelerators(cost: float, wait: str) -> None:
    """Many times of statements are also those of ticks."""
    machine: dict[str, Any] = {"controller.instruction_time": cost}
    ran("n = n + 1", f"{wait}\nm = n\n{wait}", **machine)


@pytest.mark.parametrize("number", [3, 10, 500])
def test_a_run_that_ends_at_a_tick_ends_as_without_accelerators(number: int) -> None:
    text = "TIMEREVENT = 1\nWAIT(10000)\nEnd\nEvent TIMER\nOUTX(3) = Not OUTX(3)\nEnd Event\n"
    for until in (number * 0.001, number * 0.001 + 1e-9):
        fast, plain = (
            run(Source("a.mnt", text), cache=False, fast=fast, until=until) for fast in (True, False)
        )
        assert list(fast.machine.log.outputs) == list(plain.machine.log.outputs)
        assert len(fast.machine.log.events) == len(plain.machine.log.events)
