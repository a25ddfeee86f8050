"""The proof rejects a planner that ignores settings changed in motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from motionlang import prove, run
from motionlang.kernel import Axis, Source
from motionlang.kernel.controller.core import Core
from motionlang.kernel.controller.motion import feedrate
from motionlang.kernel.controller.motion.jog import jog as honest

RATES = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 200 : FEEDRATEMODE(0) = 2\n"
SMOOTH = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 500 : DECELJERK(0) = 900\n"
MOTIONS = {
    "move": "MOVER(0) = 100 : GO(0)\n",
    "path": "VECTORR(0, 1) = 60, 80 : GO(0)\n",
    "arc": "CIRCLER(0, 1) = 0, 20, 300 : GO(0)\n",
    "blend": (
        "MOVEBUFFERSIZE(0, 1) = 9;\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 5\n"
        "VECTORR(0, 1) = 60, 0 : VECTORR(0, 1) = 0, 60 : GO(0)\n"
    ),
}
SETTINGS = ("SPEED(0) = 20", "FEEDRATEOVERRIDE(0) = 40", "MAXSPEED(0) = 5")


@pytest.fixture
def deaf(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Return a function that makes a jogging axis ignore commands."""

    def forge() -> None:

        def jog(controller: Core, a: Axis, *rest: Any) -> None:
            if a.move is None:
                honest(controller, a, *rest)

        monkeypatch.setattr("motionlang.kernel.controller.axis_verbs.jog", jog)

    return forge


def messages(text: str, name: str = "t.mnt") -> list[str]:
    return [each.message for each in prove(run(Source(name, text), prove=True)).violations]


@pytest.mark.parametrize("ramps", ["", SMOOTH], ids=["trapezoids", "S-ramps"])
@pytest.mark.parametrize("setting", SETTINGS)
@pytest.mark.parametrize("motion", MOTIONS)
def test_a_lower_speed_is_heeded(
    motion: str, setting: str, ramps: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = f"{ramps}{RATES}{MOTIONS[motion]}WAIT 800\n{setting}\nPAUSE IDLE(0)\n"
    assert messages(text) == []
    monkeypatch.setattr(feedrate, "changed", lambda *_: None)
    assert messages(text)


@pytest.mark.parametrize("motion", ["move", "path"])
@pytest.mark.parametrize("setting", ["ACCEL(0) = 60", "DECEL(0) = 90", "ACCEL(0) = 60 : SPEED(0) = 40"])
def test_lower_rates_are_heeded(motion: str, setting: str, monkeypatch: pytest.MonkeyPatch) -> None:
    text = f"{RATES}{MOTIONS[motion]}WAIT 300\n{setting}\nPAUSE IDLE(0)\n"
    assert messages(text) == []
    monkeypatch.setattr(feedrate, "changed", lambda *_: None)
    assert messages(text)


def test_rates_that_come_too_late_need_not_be_heeded() -> None:
    # From 50 at 200 it stops within 6.25, at 40 within 31.25: 1.2 s before its end the distance does not
    # suffice.
    assert messages(f"{RATES}{MOTIONS['move']}WAIT 2200\nDECEL(0) = 40\nPAUSE IDLE(0)\n") == []


@pytest.mark.parametrize("velocity", ["20", "-30", "0"])
def test_a_jog_heeds_another_velocity(velocity: str, deaf: Callable[[], None]) -> None:
    text = f"{RATES}JOG(0) = 50\nWAIT 800\nJOG(0) = {velocity}\nWAIT 800\n"
    assert messages(text) == []
    deaf()
    assert len(messages(text)) == 1


def test_velocity_mode_heeds_another_velocity(deaf: Callable[[], None]) -> None:
    text = "1MN,1SV5000,1SA10000,1DS20000,1PT\n1VM,1DI0,1GO,WA0.8,1SV2000,1GO,WA0.6,MF\n"
    assert messages(text, "t.mcl") == []
    deaf()
    assert messages(text, "t.mcl")[0].endswith("it goes to 5000 counts/s, commanded 2000")


def test_an_override_of_0_is_heeded(monkeypatch: pytest.MonkeyPatch) -> None:
    text = f"{RATES}{MOTIONS['move']}WAIT 800\nFEEDRATEOVERRIDE(0) = 0\nWAIT 900\n"
    assert messages(text) == []
    monkeypatch.setattr(feedrate, "changed", lambda *_: None)
    assert len(messages(text)) == 1
