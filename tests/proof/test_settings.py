"""The proof rejects a controller that ignores settings changed in motion."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.kernel import Axis, Source
from motionlang.kernel.controller import settings
from motionlang.kernel.controller.motion import jog
from motionlang.kernel.controller.motion.follow import Gear
from tests.proof import prove, run

RATES = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 200 : FEEDRATEMODE(0) = 2\n"
MOTIONS = {
    "move": "MOVER(0) = 100",
    "path": "VECTORR(0, 1) = 60, 80",
    "arc": "CIRCLER(0, 1) = 0, 20, 300",
    "S-ramps": "PROFILEMODE(0) = 1 : ACCELJERK(0) = 500 : DECELJERK(0) = 900 : VECTORR(0, 1) = 60, 80",
}


def messages(text: str, name: str = "t.mnt") -> list[str]:
    return [each.message for each in prove(run(Source(name, text))).violations]


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize(
    "setting", ["SPEED(0) = 20", "MAXSPEED(0) = 5", "FEEDRATEOVERRIDE(0) = 0", "DECEL(0) = 90"]
)
def test_a_setting_that_is_ignored(motion: str, setting: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rates of an arc in progress are not checked."""
    text = f"{RATES}{MOTIONS[motion]} : GO(0)\nWAIT 300\n{setting}\nWAIT 9000\n"
    assert messages(text) == []
    monkeypatch.setattr(settings, "apply_in_motion", lambda *_: None)
    assert bool(messages(text)) is ((motion, setting) != ("arc", "DECEL(0) = 90"))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        (f"{RATES}JOG(0) = 50\nWAIT 800\nJOG(0) = 20\nWAIT 800\n", "t.mnt"),
        ("1MN,1SV5000,1SA10000,1DS20000,1PT\n1VM,1DI0,1GO,WA0.8,1SV2000,1GO,WA0.6,MF\n", "t.mcl"),
    ],
)
def test_another_velocity_that_is_ignored(text: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    honest = jog.begin_jog

    def only_first(a: Axis, *rest: Any) -> None:
        if a.move is None:
            honest(a, *rest)

    assert messages(text, name) == []
    monkeypatch.setattr(jog, "begin_jog", only_first)
    assert messages(text, name) != []


def test_another_ratio_that_is_ignored(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "MASTERSOURCE(1) = _msPOS : FOLLOW(1) = 0.5\nJOG(0) = 20\nWAIT 1000\nFOLLOW(1) = 0.6\nWAIT 100\n"
    assert messages(text) == []
    monkeypatch.setattr(Gear, "set_ratio", lambda *_: None)
    assert messages(text) == ["axis 1 at 1.000040 s: it follows at 0.5, commanded 0.6"]
