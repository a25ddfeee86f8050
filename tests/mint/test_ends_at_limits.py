"""An axis stops exactly at a limit, or beyond it by the computed distance."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

RATES = (
    "SPEED(0) = 9.7 : ACCEL(0) = 100 : DECEL(0) = 80 : ERRORDECEL(0) = 200\n"
    "SPEED(1) = 9.7 : ACCEL(1) = 100 : DECEL(1) = 80\n"
)
HANDLER = "\nEnd\nEvent ONERROR\nEnd Event"
LOW, HIGH = -4.1, 7.3
SOFT = f"SOFTLIMITFORWARD(0) = {HIGH} : SOFTLIMITREVERSE(0) = {LOW}\n"
TRAVEL: dict[str, object] = {"axis.0.travel": [LOW, HIGH]}


def ran(text: str, machine: dict[str, object] | None = None) -> Run:
    return run(Source("a.mnt", text + HANDLER), machine=machine, cache=False, until=60.0)


def test_a_limit_at_zero_leaves_the_axis_at_zero() -> None:
    text = (
        "SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100\nSOFTLIMITFORWARD(0) = 15\n"
        "MOVEA(0) = 3 : GO(0)\nPAUSE IDLE(0)\nMOVEA(0) = -10 : GO(0)\nPAUSE IDLE(0)\n"
        "PRINT POS(0)\nPRINT POS(0) = 0"
    )
    assert ran(text).output == ["0.0000", "1"]


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


COMMANDS = {
    "a path": "VECTORA(0, 1) = 20, 13 : GO(0)\nPAUSE IDLE(0)",
    "a speed that was changed": "MOVEA(0) = 30 : GO(0)\nWAIT = 300\nSPEED(0) = 4.1\nPAUSE IDLE(0)",
    "a new zero": "MOVEA(0) = 30 : GO(0)\nWAIT = 300\nPOS(0) = 0.17\nPAUSE IDLE(0)",
    "an S-ramp": "ACCELJERK(0) = 3000 : DECELJERK(0) = 3000 : PROFILEMODE(0) = 1\nMOVEA(0) = 30 : GO(0)\nPAUSE IDLE(0)",
    "a slave": "FOLLOW(0) = 1.3\nJOG(1) = 9.7\nPAUSE AXISERROR(0)",
}


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_that_end_at_a_limit(command: str) -> None:
    setup = "MASTERCHANNEL(0) = 1\n" if "FOLLOW" in COMMANDS[command] else ""
    begin = f"{setup}{RATES}{SOFT}MOVEA(0) = 0.1 : GO(0)\nPAUSE IDLE(0)\n"
    text = f"{begin}{COMMANDS[command]}\nPRINT POS(0) = {HIGH}\nSTOP(1)"
    assert ran(text).output == ["1"]


def test_mccl_limits() -> None:
    """1HL sets the high limit, LM2 stops at once, LN4 and 8 enable software limits."""
    text = "1MN,1SV9700,1HL7300,1LL-4100,1LM2,1LN12,1MR33,1WS,1MR20000,1WS"
    result = run(Source("a.mccl", text), cache=False)
    assert result.controller.demand(1) == 7300.0


MARK: dict[str, object] = {
    "axis.0.index_every": 3.3,
    "input": [{"channel": 3, "axis": 0, "between": [HIGH, 9.0]}],
}


@pytest.mark.parametrize("first", [0.1, 1.7, 3.0])
def test_a_latch_takes_the_position_of_its_mark(first: float) -> None:
    """Latch 1 captures at the edge of an input, latch 2 at the second index mark."""
    text = (
        f"{RATES}MOVEA(0) = {first} : GO(0)\nPAUSE IDLE(0)\nMOVEA(0) = 30 : GO(0)\n"
        "LATCHTRIGGERCHANNEL(1) = 3 : LATCHSOURCECHANNEL(1) = 0 : LATCHENABLE(1) = 1\nPAUSE LATCH(1)\n"
        "LATCHTRIGGERMODE(2) = 1 : LATCHSOURCECHANNEL(2) = 0 : LATCHENABLE(2) = 1\nPAUSE LATCH(2)\n"
        f"PRINT LATCHVALUE(1) = {HIGH}, LATCHVALUE(2) = {3 * 3.3}"
    )
    assert ran(text, MARK).output == ["11"]


@pytest.mark.parametrize("first", [0.1, 1.7, 3.0])
def test_homing_finds_the_edge_exactly(first: float) -> None:
    """HOMEPOS is the position that the edge had before it became zero."""
    machine: dict[str, object] = {"axis.0.home_switch": [-5.0, -1.3]}
    text = (
        f"{RATES}HOMESPEED(0) = 9.7 : HOMEBACKOFF(0) = 7\nMOVEA(0) = {first} : GO(0)\nPAUSE IDLE(0)\n"
        "HOME(0) = _hmNEGATIVE_SWITCH\nPAUSE IDLE(0)\nPRINT HOMEPOS(0) = -1.3, POS(0) = 0"
    )
    assert ran(text, machine).output == ["11"]
