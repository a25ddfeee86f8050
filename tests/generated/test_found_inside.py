"""Wrong answers that were found, which only a change inside the controller shows."""

from __future__ import annotations

from math import pi, sqrt

import pytest

from motionlang.kernel import Run, Source
from motionlang.kernel.controller import settings
from motionlang.kernel.controller.motion.takeup import Takeup
from tests.proof import prove, run

RATES = "SPEED(0, 1) = 20; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 100;\n"
CONTOUR = "MOVEBUFFERSIZE(0, 1) = 9; : CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 180\n"


def proved(program: str) -> Run:
    """Return a run of a program without diagnostics whose proof passes."""
    result = run(Source("found.mnt", program), machine={"controller.instruction_time": 1e-9}, until=20.0)
    assert result.diagnostics == []
    assert [each.message for each in prove(result).violations] == []
    return result


def positions(result: Run, *axes: int) -> list[float]:
    return [result.controller.axes[axis].position(result.time) for axis in axes]


def test_rates_that_a_path_could_keep_are_asked_of_those_ahead_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """DECEL is lowered to 50 with 41 of the path left.

    A controller that ignores it brakes at 100, and the proof reports that.
    """
    monkeypatch.setattr(settings, "_replan", lambda axis, name: None)
    lines = "VECTORR(0, 1) = 51, 0\nVECTORR(0, 1) = 1, 0\nGO(0)\nWAIT = 600\nDECEL(0) = 50\nPAUSE IDLE(0)\n"
    program = Source("found.mnt", f"{RATES}{CONTOUR}{lines}")
    found = prove(run(program)).violations
    assert "the path deceleration reaches 100, above 50" in found[0].message


def test_the_play_of_an_axis_is_looked_up_once_for_a_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    """A jog at 1 is suspended and comes to rest after 10 µs.

    One second later the play has been looked up for three stretches of time, not for every nanosecond.
    """
    stretches, find = list[float](), Takeup._stretch

    def noted(play: Takeup, now: float) -> tuple[float, int]:
        stretches.append(now)
        assert len(stretches) < 20
        return find(play, now)

    monkeypatch.setattr(Takeup, "_stretch", noted)
    jog = "BACKLASH(0) = 1 : BACKLASHMODE(0) = 1\nJOG(0) = 1\nWAIT = 5\nSUSPEND(0) = 1\nWAIT = 1000\n"
    assert proved(f"{jog}PRINT ENCODER(0) > 0\nCANCEL(0)\n").output == ["1"]


def limit_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let an entry of the log have 50 pieces instead of 500, so that a test needs fewer of them."""
    for module in ("motionlang.kernel.controller.queue.track", "tests.proof.entries"):
        monkeypatch.setattr(f"{module}.MAX_PIECES", 50)


@pytest.mark.parametrize(
    ("path", "changes", "length", "ends"),
    [
        ("VECTORR(0, 1) = 18, 24", 110, 30.0, (18.0, 24.0)),
        ("CIRCLER(0, 1) = 5, 0, 360", 110, 10.0 * pi, (0.0, 0.0)),
        ("CIRCLEA(0, 1) = 10, 0, 180", 60, 10.0 * pi, (20.0, 0.0)),
    ],
)
def test_a_path_that_is_changed_often(
    path: str, changes: int, length: float, ends: tuple[float, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """After 50 changes, 500 without the patch, the path continues as another entry of the log.

    It keeps its original start. ACCEL has no effect after 0.3 s: at 20 with 100 the path takes length/20 + 20/100 s.
    """
    limit_pieces(monkeypatch)
    change = f"WAIT = 300\nFor k = 1 To {changes}\nACCEL(0) = 100 + k Mod 2\nWAIT = 1\nNext\nPAUSE IDLE(0)\n"
    result = proved(f"{RATES}Dim k As Integer\n{path} : GO(0)\n{change}")
    moves = result.controller.log.moves
    assert [each.ended for each in moves if each.axis == 0] == ["continued"] * (changes // 50) + [""]
    assert positions(result, 0, 1) == pytest.approx(ends)
    last = moves[-1]
    assert last.profile is not None
    assert last.start_time + last.profile.duration == pytest.approx(length / 20.0 + 0.2, abs=1e-6)


def test_a_helix_continues_in_the_log_on_all_its_axes_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Axes 0 and 1 turn back at quarters: their entries are full before axis 2's.

    The length is sqrt((10 pi)² + 8²), at 20 with 100.
    """
    limit_pieces(monkeypatch)
    change = "WAIT = 300\nFor k = 1 To 60\nACCEL(0) = 100 + k Mod 2\nWAIT = 1\nNext\nPAUSE IDLE(0)\n"
    result = proved(f"{RATES}Dim k As Integer\nHELIXR(0, 1, 2) = 5, 0, 360, 8 : GO(0)\n{change}")
    moves = result.controller.log.moves
    starts = [[each.start_time for each in moves if each.axis == axis] for axis in (0, 1, 2)]
    assert len(starts[0]) == 2
    assert starts[1:] == [starts[0]] * 2
    assert positions(result, 0, 1, 2) == pytest.approx([0.0, 0.0, 8.0])
    assert result.time == pytest.approx(sqrt(100.0 * pi * pi + 64.0) / 20.0 + 0.2, abs=1e-6)
