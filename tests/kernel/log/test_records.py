"""Records, moves and profiles of a log, by hand."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.log import Log, LoggedMove, Waited
from motionlang.kernel.planners import pieces_of
from tests.kernel.tracks.test_figures import machine


def shuttled(moves: int) -> Controller:
    """Return an axis that has begun a move at each of the seconds 1, 2, 3 …

    A move of 10 takes 0.35 s (`test_figures.py`), so the profiles begin at 0, 1, 1.35, 2, 2.35 …
    """
    controller = machine()
    for k in range(1, moves + 1):
        controller.clock.advance(float(k))
        controller.move_to(0, 10.0 * (k % 2), line=k)
    controller.clock.advance(moves + 0.5)
    return controller


def filled(**more: Any) -> LoggedMove:
    move = LoggedMove(0, "MOVER", 3, 10.0)
    for name, value in more.items():
        setattr(move, name, value)
    return move


def test_the_waits_of_a_skipped_iteration_are_logged_once() -> None:
    """An iteration has begun at 1.0 s."""
    log = Log()
    mine = [
        Waited("main", 3, 1.0, 1.0, "axis", (0,), "idle", ()),
        Waited("main", 11, 1.5, 4.0, "time", (), "", (2, 5)),
    ]
    earlier = Waited("main", 1, 0.0, 0.9, "axis", (0,), "idle", ())
    begun_before = Waited("main", 2, 0.5, 1.0, "axis", (0,), "idle", ())
    other = Waited("other", 4, 1.0, 3.0, "axis", (0,), "idle", ())
    for wait in (earlier, other, begun_before, *mine):
        log.waits.add(wait)
    log.repeat_waits("main", 1.0, 3.0, 2)
    log.repeat_waits("absent", 1.0, 3.0, 7)
    assert log.waits[4] == Waited("main", 11, 1.5, 4.0, "time", (), "", (2, 5))
    assert [(each.at, each.since, each.until) for each in log.waits] == [
        (1, 0.0, 0.9), (4, 1.0, 3.0), (2, 0.5, 1.0), (3, 1.0, 1.0), (11, 1.5, 4.0),
        (3, 4.0, 4.0), (11, 4.5, 7.0), (3, 7.0, 7.0), (11, 7.5, 10.0),
    ]  # fmt: skip


def test_a_period_within_a_period_is_repeated_with_it() -> None:
    """A wait at 0 is repeated twice, 1 s apart, and this period of 3 s three times."""
    log = Log()
    outer = inner = log.mark_period()
    log.waits.add(Waited("one", 7, 0.0, 0.5, "time", (), "", ()))
    log.repeat_period(inner, 0.0, 1.0, 3.0, 2)
    log.repeat_period(outer, 0.0, 3.0, 12.0, 3)
    assert [wait.since for wait in log.waits] == [float(n) for n in range(12)]


def test_a_skipped_iteration_rests_during_its_waits() -> None:
    """A time slice from 0 to 4 has two skipped iterations, each with a WAIT of 1."""
    log = Log()
    log.slices.shared(0.0)
    log.waits.add(Waited("one", 7, 0.0, 1.0, "time", (), "", ()))
    log.repeat_waits("one", 0.0, 1.5, 2)
    log.slices.took("one", 0.0, 4.0, True)
    log.slices.took("one", 4.0, 5.0, True)
    assert [each.seconds for each in log.slices] == [(2.0,), (1.0,)]


def test_a_period_of_time_slices_and_waits_is_repeated() -> None:
    """Two tasks alternate, and one waits from 5 to 6; the period from 3 to 6 repeats."""
    log = Log()
    log.slices.shared(0.0)
    log.slices.took("one", 0.0, 1.0, False)
    log.slices.took("two", 1.0, 3.0, False)
    mark = log.mark_period()
    log.slices.took("one", 3.0, 4.0, False)
    log.slices.took("two", 4.0, 5.0, True)
    log.waits.add(Waited("two", 7, 5.0, 6.0, "time", (), "", ()))
    log.slices.took("one", 5.0, 6.0, False)
    log.repeat_period(mark, 3.0, 6.0, 21.0, 5)
    assert list(log.slices) == [
        (0.0, 5.0, ("one", "two"), (2.0, 3.0)),
        (5.0, 6.0, ("one",), (1.0,)),
        (6.0, 21.0, ("one", "two"), (10.0, 5.0)),
    ]
    assert [wait[2:4] for wait in log.waits] == [(5.0 + 3.0 * k, 6.0 + 3.0 * k) for k in range(6)]
    # Nothing is repeated twice, and the current record is open.
    log.slices.took("one", 21.0, 21.5, False)
    log.repeat_period(log.mark_period(), 21.5, 22.0, 24.0, 4)
    assert list(log.slices)[3:] == [(21.0, 22.0, ("one",), (0.5,))]
    log.slices.took("two", 24.0, 24.5, False)
    assert list(log.slices.up_to(25.0))[4:] == [(24.0, 25.0, ("two",), (0.5,))]
    assert len(log.slices) == 4
    assert len(log.waits) == 6


def test_an_event_has_the_source_offset_of_the_program() -> None:
    log = Log()
    log.note(1.0, "stop", 2, 3.0, 4.0, 5, "text")
    log.locate_by(lambda: 17)
    log.note(1.5, "cancel")
    assert [tuple(each) for each in log.events] == [
        (1.0, "stop", 2, 3.0, 4.0, -1, 5, "text"),
        (1.5, "cancel", None, None, None, 17, 0, ""),
    ]
    made = log.new_prints()
    assert log.streams()[-1] is made


def test_the_pieces_of_a_profile_that_is_replaced_at_its_knot() -> None:
    """A move of 100 has knots at 0.1 and 1.95 s; it is stopped as its first ramp ends."""
    controller = machine()
    controller.move_to(0, 100.0)
    controller.clock.advance(0.1)
    controller.stop(0)
    controller.clock.advance(2.0)
    track = controller.axes[0]
    begins, pieces = pieces_of(track.starts, track.profiles)
    assert begins == pytest.approx([0.0, 0.0, 0.1, 0.3])
    assert pieces[-1] == pytest.approx((7.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert pieces[0] == (0.0,) * 7
