"""Released moves of a buffer begin as soon as no earlier entry blocks them."""

from __future__ import annotations

from motionlang import Run, run
from motionlang.source import Source


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text), cache=False, prove=True, until=30.0)
    assert [each.message for each in result.proof().violations] == []
    return result


def test_a_move_behind_a_path_that_is_thrown_away_begins() -> None:
    """The path waits for axis 1; CANCEL discards it, and axis 0 moves 36 at speed 10.

    That takes 3.6 s + 10/100 s.
    """
    text = """SPEED(0, 1) = 10; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 100;
MOVER(1) = 30 : GO(1)
VECTORR(0, 1) = 10, 0 : GO(0)
MOVEA(0) = 36 : GO(0)
WAIT 100
CANCEL(1)
"""
    result = ran(text)
    cancelled, begun = result.controller.log.moves
    assert (cancelled.axis, cancelled.ended) == (1, "cancel")
    assert begun.profile is not None
    assert cancelled.profile is not None
    assert (begun.axis, begun.start_time) == (0, cancelled.start_time + cancelled.profile.duration)
    assert abs(begun.profile.duration - 3.7) < 1e-9
    assert result.controller.axes[0].position(result.time) == 36.0


def test_cancelall_starts_nothing_that_it_throws_away_as_well() -> None:
    text = """SPEED(0, 1) = 10;
MOVER(0) = 30 : GO(0)
VECTORR(0, 1) = 10, 0 : GO(0)
MOVEA(1) = 36 : GO(1)
WAIT 100
CANCELALL
"""
    (cancelled,) = ran(text).controller.log.moves
    assert (cancelled.axis, cancelled.ended) == (0, "cancel")


def test_an_offset_that_waits_begins_with_the_following() -> None:
    """The offset of 7 at speed 10, with rates of 100, takes 0.7 s + 10/100 s."""
    text = """SPEED(1) = 10 : ACCEL(1) = 100 : DECEL(1) = 100 : MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0
JOG(0) = 20
MOVER(1) = 50 : GO(1)
OFFSET(1) = 7 : GO(1)
WAIT 1000
FOLLOW(1) = 0.5
WAIT 2000
CANCEL(1)
"""
    moves = ran(text).controller.log.moves
    (following,) = (move for move in moves if move.command == "FOLLOW")
    (offset,) = (move for move in moves if move.command == "OFFSET")
    assert offset.profile is not None
    assert offset.start_time == following.start_time
    assert abs(offset.profile.duration - 0.8) < 1e-9
    assert offset.profile.distance == 7.0
