"""Jogs with S-ramps have a continuous acceleration."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Run, Source

RATES = "SPEED(0) = 400 : ACCEL(0) = 1000 : DECEL(0) = 500\n"


def ran(text: str, until: float = 60.0) -> Run:
    result = run(Source("a.mnt", text), until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def test_s_ramp_into_another_jog_has_continuous_acceleration() -> None:
    text = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 5000 : DECELJERK(0) = 5000\nJOG(0) = 100\nWAIT = 80\nJOG(0) = 60\n"
    for end in ("WAIT = 500", "WAIT = 15\nSTOP(0)"):
        a = ran(RATES + text + end, until=2.0).controller.axes[0]
        for start, before in zip(a.starts[2:], a.profiles[1:], strict=False):
            time = start - a.starts[a.profiles.index(before)]
            gap = abs(before.acceleration(time - 1e-9) - a.at(start).acceleration)
            assert gap < 1e-3
