"""Divergence of two runs by tables of pieces, equal to a check of every time."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from motionlang.commands.diff import motion
from motionlang.commands.diff.motion import ROUNDING, SAMPLES, Divergence, divergence
from motionlang.kernel import Axis, Run, Source, WholeTrack, run, settings_next_to

SCRIPTS = Path(__file__).parents[3] / "scripts"
# The changes of a program; motion of the cam, the contour and the shear is in formulas in addition to pieces.
CHANGES = {
    "mint/palletiser.mnt": ("= 600, 600, 300", "= 600, 500, 300"),
    "mint/pick-and-place.mnt": ("= 800, 500", "= 700, 500"),
    "mint/cam-lift.mnt": ("= 180", "= 190"),
    "mint/contour-glue.mnt": ("= 2000", "= 1500"),
    "mint/flying-shear.mnt": ("= 200", "= 210"),
}


def sampled(a: Axis, b: Axis, end: float, tolerance: float) -> Divergence | None:
    """Return the divergence by checking the times one after the other."""
    edges = sorted({*WholeTrack(a).starts, *WholeTrack(b).starts, end})
    first, largest = None, (0.0, 0.0)
    for begin, finish in pairwise(edges):
        for n in range(1, SAMPLES + 1) if finish <= end else ():
            time = begin + (finish - begin) * n / SAMPLES
            one, other = (
                a.scale.position_to_user(a.position(time)),
                b.scale.position_to_user(b.position(time)),
            )
            distance = abs(one - other) - ROUNDING * max(abs(one), abs(other), 1.0)
            if distance > tolerance and first is None:
                first = time
            if distance > largest[0]:
                largest = distance, time
    return None if first is None else Divergence(a.index, first, *largest)


def pair(name: str) -> tuple[Run, Run]:
    path = SCRIPTS / name
    source, (was, is_) = Source.read(path), CHANGES[name]
    assert was in source.text
    settings = settings_next_to(path)
    return tuple(  # type: ignore[return-value]
        run(Source(source.name, text), machine=settings, until=60.0)
        for text in (source.text, source.text.replace(was, is_))
    )


@pytest.mark.parametrize("tolerance", [0.0, 0.5])
@pytest.mark.parametrize("name", CHANGES)
def test_it_is_what_looking_everywhere_finds(
    name: str, tolerance: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(motion, "TOGETHER", 7)  # even short runs are checked in several batches
    old, new = pair(name)
    end, expected = min(old.time, new.time), []
    for number, a in old.controller.axes.items():
        found = sampled(a, new.controller.axes[number], end, tolerance)
        if found is not None:
            expected.append(found)
    difference = divergence(old, new, tolerance)
    assert difference is not None
    (mine,) = (each for each in expected if each.axis == difference.axis)
    assert (difference.max_difference, difference.max_difference_at) == (
        mine.max_difference,
        mine.max_difference_at,
    )
    # The exact time is between the differing sample and the one before it.
    assert min(each.time for each in expected) >= difference.time


def waiting(milliseconds: int, axis: int = 0) -> Run:
    text = f"SPEED({axis}) = 100 : ACCEL({axis}) = 1000 : DECEL({axis}) = 1000\nWAIT({milliseconds})\n"
    return run(Source("a.mnt", f"{text}MOVER({axis}) = 100 : GO({axis}) : PAUSE IDLE({axis})\n"))


@pytest.mark.parametrize("together", [1, 50_000])
def test_the_divergence_of_a_later_start_by_hand(together: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The positions are 0.5 uu apart sqrt(2 * 0.5 / 1000) s after the first start.

    That is 0.031623 s at 1000 uu/s², and the first start is at 0.1 s. The later start is 0.1 s behind, so 10 uu at
    100 uu/s: from 0.3 s, when the second axis has its speed, to 1.1 s, when the first one slows down.
    """
    monkeypatch.setattr(motion, "TOGETHER", together)
    old, new = waiting(100), waiting(200)
    for one, other in ((old, new), (new, old)):
        found = divergence(one, other, 0.5)
        assert found is not None
        assert found.axis == 0
        assert found.time == pytest.approx(0.131623, abs=1e-4)
        assert found.max_difference == pytest.approx(10.0, abs=1e-3)
        assert 0.3 <= found.max_difference_at <= 1.1
    assert divergence(old, waiting(100), 0.0) is None
    assert divergence(old, new, 10.1) is None
