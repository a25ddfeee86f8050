"""The proof of a run: it finds what is forged into a track, names what was ordered, and lists what is known."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.controller.axis import Axis
from motionlang.profile import Profile, hold, plan
from motionlang.result import Run
from motionlang.source import Source

FINE = {"controller.instruction_time": 1e-9}
MOVE = "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 50\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n"
JERKS = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"


def proved(program: str) -> Run:
    result = run(Source("move.mnt", program), machine=FINE, cache=False, prove=True)
    assert result.diagnostics == []
    return result


def found(result: Run) -> list[str]:
    return [f"{each.line}: {each.message}" for each in result.proof().violations]


def put(a: Axis, made: Callable[[Profile], Profile]) -> None:
    """Forge the first moving profile of a track, and of the log."""
    i = next(k for k, each in enumerate(a.profiles) if each.shape != "hold")
    a.profiles[i] = made(a.profiles[i])


FORGED: dict[str, tuple[Callable[[Profile], Profile], str]] = {
    "a jump": (lambda p: p.shifted(1.0), "the position jumps by 1 counts"),
    "too fast": (lambda _: plan("trapezoid", 0.0, 100.0, 25.0, 100.0, 50.0), "the speed reaches 25 counts"),
    "too hard": (lambda _: plan("trapezoid", 0.0, 100.0, 20.0, 130.0, 50.0), "the acceleration reaches 130"),
    "brakes too hard": (
        lambda _: plan("trapezoid", 0.0, 100.0, 20.0, 100.0, 70.0),
        "the deceleration reaches 70",
    ),
    "elsewhere": (lambda _: plan("trapezoid", 0.0, 101.0, 20.0, 100.0, 50.0), "the position jumps by"),
    "not at all": (lambda _: hold(0.0).cut(5.3), "the log has it at"),
}


def test_a_sound_run_is_proved() -> None:
    proof = proved(MOVE).proof()
    assert proof.holds
    assert proof.counts == {"moves": 1, "profiles": 1, "joins": 2, "paths": 0}
    assert {name: round(share, 6) for name, share in proof.worst.items()} == {
        "speed": 1.0, "acceleration": 1.0, "deceleration": 1.0,
    }  # fmt: skip


@pytest.mark.parametrize("name", FORGED)
def test_what_is_forged_is_found(name: str) -> None:
    forge, message = FORGED[name]
    result = proved(MOVE)
    put(result.controller.axes[0], forge)
    assert any(message in each for each in found(result)), found(result)


def test_a_jerk_beyond_the_one_in_force_is_found() -> None:
    result = proved(JERKS + MOVE)
    assert found(result) == []
    put(
        result.controller.axes[0],
        lambda _: plan("scurve", 0.0, 100.0, 20.0, 100.0, 50.0, 0.0, 0.0, 900.0, 400.0),
    )
    assert any("the jerk reaches 900" in each for each in found(result))


def test_a_log_that_ends_elsewhere_is_found() -> None:
    result = proved(MOVE)
    result.controller.log.moves[0].target += 1.0
    assert found(result) == ["2: axis 0 from 0.000000 s: it ends at 100, sent to 101"]


def test_a_move_in_no_time_is_found() -> None:
    result = proved(MOVE)
    result.controller.log.moves[0].profile = Profile("trapezoid", 0.0, 100.0, 0.0, (0.0, 0.0, 0.0, 0.0))
    assert any("100 counts in no time" in each for each in found(result))


ORDERED = {
    "MOVER(0) = 100 : GO(0)\nWAIT 500\nCANCEL(0)\n": "a stop at once: cancelled, switched off, or at a limit",
    "MOVER(0) = 100 : GO(0)\nWAIT 500\nPOS(0) = 7\nPAUSE IDLE(0)\n": "a position that is given a new value",
    "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 10\nVECTORR(0, 1) = 50, 0\nVECTORR(0, 1) = 50, 5\nGO(0)\n"
    "PAUSE IDLE(0)\n": "a kink within CONTOURANGLE",
}


@pytest.mark.parametrize("program", ORDERED)
def test_what_is_ordered_has_its_name(program: str) -> None:
    proof = proved("SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\n" + program).proof()
    assert proof.holds
    assert list(proof.exceptions) == [ORDERED[program]]


# Paths of more than one pace, and a stop on one: each broke a bound once.
PACES = (
    # A path shorter than the ramp to its speed: 420.5 uu/s² without a forward pass.
    "FEEDRATEMODE(0) = 1 : CONTOURMODE(0) = 1 : ACCEL(0) = 90 : DECEL(0) = 60\nSPEED(0) = 29\nVECTORR(0, 1) = 1, 0\n"
    "SPEED(0) = 30\nVECTORR(0, 1) = 100, 0\nGO(0)\nPAUSE IDLE(0)\n",
    "SPEED(0) = 40 : ACCEL(0) = 300 : DECEL(0) = 500 : MAXACCEL(0) = 60 : MAXDECEL(0) = 60\n"
    "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 5\nVECTORR(0, 1) = 5, 0\nVECTORR(0, 1) = 40, 0.001\nGO(0)\n"
    "PAUSE IDLE(0)\n",
    # A stop in the midst of an S-ramp.
    "SPEED(0) = 20 : ACCEL(0) = 50 : DECEL(0) = 50 : PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
    "VECTORR(0, 1) = 40, 0 : GO(0)\nWAIT 350\nSTOP(0)\nPAUSE IDLE(0)\n",
)  # fmt: skip


@pytest.mark.parametrize("program", PACES)
def test_paths_of_other_paces_and_stops_on_them_keep_every_bound(program: str) -> None:
    assert found(proved(program)) == []


def test_a_run_that_kept_no_orders_cannot_be_proved() -> None:
    result = run(Source("move.mnt", MOVE), cache=False)
    with pytest.raises(ValueError, match="prove=True"):
        result.proof()
