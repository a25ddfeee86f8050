"""An axis stops exactly at a limit, or beyond it by the computed distance."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

RATES = (
    "SPEED(0) = 9.7 : ACCEL(0) = 100 : DECEL(0) = 80 : ERRORDECEL(0) = 200\n"
    "SPEED(1) = 9.7 : ACCEL(1) = 100 : DECEL(1) = 80\n"
)
HANDLER = "\nEnd\nEvent ONERROR\nEnd Event"
LOW, HIGH = -4.1, 7.3
SOFT = f"SOFTLIMITFORWARD(0) = {HIGH} : SOFTLIMITREVERSE(0) = {LOW}\n"
TRAVEL: dict[str, object] = {"axis.0.travel": [LOW, HIGH]}


def ran(text: str, machine: dict[str, object] | None = None) -> Run:
    return run(Source("a.mnt", text + HANDLER), machine=machine, until=60.0)


@pytest.mark.parametrize("counts", [1.0, 3.0, 1000.0, 13653.0])
@pytest.mark.parametrize("first", [0.1, 1.7, 3.0])
@pytest.mark.parametrize("limit", [LOW, HIGH])
@pytest.mark.parametrize("switch", [False, True])
@pytest.mark.parametrize("motion", ["MOVEA(0) = {} : GO(0)", "JOG(0) = {}"])
def test_a_crash_stop(counts: float, first: float, limit: float, switch: bool, motion: str) -> None:
    """A crash stop is exactly at the limit, in both directions, and the log agrees.

    The limits are software limits and switches.
    """
    far = 9.0 if limit > 0 else -9.0
    text = (
        f"SCALEFACTOR(0) = {counts}\n{RATES}{'' if switch else SOFT}MOVEA(0) = {first} : GO(0)\nPAUSE IDLE(0)\n"
        f"{motion.format(far)}\nPAUSE IDLE(0)\nPRINT POS(0) = {limit}"
    )
    result = ran(text, TRAVEL if switch else None)
    assert result.output == ["1"]
    profile = list(result.machine.log.moves)[-1].profile
    assert profile is not None
    assert profile.end == result.controller.position(0) == limit * counts
    (event,) = [each for each in result.machine.log.events if each.kind in ("limit", "soft limit")]
    assert event.value == event.limit == pytest.approx(limit, rel=1e-15)


@pytest.mark.parametrize("first", [0.1, 1.7, 3.0])
@pytest.mark.parametrize("limit", [LOW, HIGH])
def test_a_stop_at_errordecel(first: float, limit: float) -> None:
    """The stop takes v²/2a = 9.7² / 400 beyond the limit, in both directions."""
    text = (
        f"{RATES}{SOFT}SOFTLIMITMODE(0) = 3\nMOVEA(0) = {first} : GO(0)\nPAUSE IDLE(0)\n"
        f"JOG(0) = {9.7 if limit > 0 else -9.7}\nPAUSE IDLE(0)"
    )
    distance = (9.7 / 200.0 * 9.7) * 0.5
    assert ran(text).controller.position(0) == limit + (distance if limit > 0 else -distance)


def test_mccl_limits() -> None:
    """1HL sets the high limit, LM2 stops at once, LN4 and 8 enable software limits."""
    text = "1MN,1SV9700,1HL7300,1LL-4100,1LM2,1LN12,1MR33,1WS,1MR20000,1WS"
    result = run(Source("a.mccl", text))
    assert result.controller.demand(1) == 7300.0
