"""Seen from inside: records, packed moves and profiles of a log, by hand."""

from __future__ import annotations

from math import inf
from typing import Any

import pytest

from motionlang.kernel import Controller, WholeTrack
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.log import LoggedMove, Store, stream
from motionlang.kernel.log import log as log_module
from motionlang.kernel.log import moves as moves_module
from motionlang.kernel.log import profiles as profiles_module
from motionlang.kernel.log.moves import LoggedMoves
from motionlang.kernel.log.profiles import Profiles
from motionlang.kernel.log.records import TimeSlices
from motionlang.kernel.log.time_slices import TimeSliceStream
from motionlang.kernel.planners import Profile, hold, plan_trapezoid
from tests.kernel.log.test_records import filled, shuttled
from tests.proof.order import Order, PathOrder, Tie


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pack two profiles or moves at a time, and leave four profiles of each axis."""
    for module in (stream, moves_module, profiles_module):
        monkeypatch.setattr(module, "CHUNK", 2)
    monkeypatch.setattr(log_module, "LEFT_PROFILES", 4)


STARTS = [0.0, 1.0, 1.35, 2.0, 2.35, 3.0, 3.35, 4.0, 4.35, 5.0, 5.35]


@pytest.mark.usefixtures("small")
def test_the_profile_in_force_at_a_time_of_a_packed_track() -> None:
    """Of the eleven profiles of five moves four are not packed: those from 4 s on."""
    controller = shuttled(5)
    a = controller.axes[0]
    controller.log.pack([a])
    track = WholeTrack(a)
    assert a.older is not None
    assert (a.older.count, len(a.starts), controller.log.moves.packed) == (7, 4, 1)
    assert list(track.starts) == pytest.approx(STARTS)
    for number, start in enumerate(list(track.starts)):
        assert track.index_at(start) == number
        assert track.index_at(start + 0.1) == number
        assert track.index_at(start - 1e-9) == max(number - 1, 0)
        assert track.count(0.5, start) == number
        assert (a.older.in_force(start) if number < 7 else number) == number
    assert [profile.end for profile in track.profiles] == [0, 10, 10, 0, 0, 10, 10, 0, 0, 10, 10]
    assert track.count(1.1, 4.1) == 6
    for begin, end, first, past in ((0.0, 0.5, 0, 1), (1.1, 2.1, 0, 4), (2.1, 4.1, 2, 8), (4.4, 9.0, 7, 11)):
        starts, profiles = track.between(begin, end)
        assert list(starts) == pytest.approx(STARTS[first:past])
        assert len(profiles) == past - first
    assert [start for start, _ in a.older.between(0, 7)] == pytest.approx(STARTS[:7])
    assert [a.older.profile(k).end for k in range(7)] == [0, 10, 10, 0, 0, 10, 10]


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(("time", "first"), [(0.0, 0), (2.34, 0), (2.36, 2), (3.4, 4), (99.0, 4)])
def test_profiles_before_a_time_are_dropped(time: float, first: int) -> None:
    """Chunks begin at 0, 1.35 and 2.35 s, with the profiles 0, 2 and 4; the newest two of the old ones are left."""
    controller = shuttled(5)
    a = controller.axes[0]
    controller.log.pack([a])
    assert a.older is not None
    a.older.forget_before(time)
    assert (a.older.first, a.older.count) == (first, 7)
    assert a.older.in_force(0.0) == first
    assert [a.older.in_force(STARTS[k] + 0.01) for k in range(first, 7)] == list(range(first, 7))


class Interrupted(list[Any]):
    """A list from which nothing can be removed the first time."""

    armed = True

    def __delitem__(self, index: Any) -> None:
        if self.armed:
            self.armed = False
            raise KeyboardInterrupt
        super().__delitem__(index)


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", ["starts", "profiles"])
def test_an_interrupt_while_profiles_are_packed_is_completed(name: str) -> None:
    controller = shuttled(5)
    a = controller.axes[0]
    setattr(a, name, Interrupted(getattr(a, name)))
    with pytest.raises(KeyboardInterrupt):
        controller.log.pack([a])
    for _ in range(2):
        controller.log.finish_updates([a])
        assert a.older is not None
        assert (a.older.count, len(a.starts), len(a.profiles)) == (7, 4, 4)
        assert list(WholeTrack(a).starts) == pytest.approx(STARTS)
        assert a.older.in_force(3.4) == 6


def test_an_interrupt_before_the_first_profile_is_packed() -> None:
    controller = shuttled(1)
    a = controller.axes[0]
    a.older = Profiles(controller.log.store)
    controller.log.finish_updates([a])
    assert a.older is None


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize(
    ("moves", "more", "count", "first"), [(9, 0, 0, 0), (9, 1, 0, 0), (10, 0, 11, 8), (12, 0, 15, 12)]
)
def test_a_log_that_forgets_packs_profiles_and_drops_the_oldest(
    moves: int, more: int, count: int, first: int
) -> None:
    """A controller that retains one record of a kind retains ten profiles.

    It packs the others if there are more than twenty, in pairs, and drops most pairs that ended before its last move.
    """
    controller = shuttled(moves)
    a = controller.axes[0]
    if more:
        controller.define_position(0, 3.0)
    controller.forget_history(1)
    assert [move.line for move in controller.log.moves] == [moves]
    assert (0 if a.older is None else a.older.count) == count
    assert (0 if a.older is None else a.older.first) == first
    assert len(a.starts) == 1 + 2 * moves + more - count


@pytest.mark.parametrize(("most", "axes", "room"), [(20, 1, 16), (20, 2, 15), (7, 1, 4), (9, 1, 5)])
def test_room_for_profiles(
    most: int, axes: int, room: int, small: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four profiles of an axis are left of eleven; one that never moved has one."""
    monkeypatch.setattr(log_module, "MAX_PROFILES", most)
    controller = shuttled(5)
    several = [controller.axes[0], *Controller(axes - 1).axes.values()] if axes > 1 else [controller.axes[0]]
    controller.log.pack(several)
    assert controller.log.room == room
    assert [a.older is None for a in several] == [False, True][:axes]


@pytest.mark.usefixtures("small")
def test_packing_again_packs_what_has_been_added() -> None:
    """All but four of the profiles, and of the moves, are packed."""
    controller = Controller(1)
    a, log = controller.axes[0], controller.log
    found = []
    for _ in range(3):
        log.pack([a])
        found.append((0 if a.older is None else a.older.count, len(a.starts), log.moves.packed))
        for _ in range(2):
            controller.move_by(0, 10.0)
            controller.clock.advance(controller.idle_time(0) + 1.0)
    log.pack([a])
    assert [*found, (0 if a.older is None else a.older.count, len(a.starts), log.moves.packed)] == [
        (0, 1, 0),
        (1, 4, 0),
        (5, 4, 0),
        (9, 4, 2),
    ]


@pytest.mark.usefixtures("small")
def test_a_move_in_progress_stays_an_object_while_others_are_packed() -> None:
    controller = Controller(2)
    controller.move_to(0, 1e6, line=1)
    (long,) = controller.log.moves
    for k in range(3):
        controller.move_to(1, 10.0 + k, line=2 + k)
        controller.clock.advance(controller.idle_time(1))
    moves = controller.log.moves
    moves.pack(3)
    assert (moves.packed, len(moves), moves.number(long)) == (3, 4, 0)
    assert [each.line for each in moves] == [1, 2, 3, 4]
    assert moves[0] is long
    assert moves.number(moves[3]) == 3
    assert moves.moved() == {0, 1}
    controller.stop(0)
    controller.clock.advance(controller.idle_time(0))
    profile = long.profile
    assert profile is not None
    controller.move_to(0, 0.0, line=5)
    controller.clock.advance(controller.idle_time(0))
    moves.pack(2)
    first = moves[0]
    assert (first.line, first.ended, first.start_time, first.target) == (1, "stop", 0.0, profile.end)
    assert first.profile is not None
    assert (first.profile.end, first.profile.duration) == (profile.end, profile.duration)
    assert [each.line for each in moves] == [1, 2, 3, 4, 5]


FIELDS = (
    "axis",
    "command",
    "line",
    "target",
    "commanded_speed",
    "start_time",
    "scale",
    "zero",
    "offset",
    "ended",
)


def read_again(move: LoggedMove) -> LoggedMove:
    """Return a move that is over, as it is read when it is a row."""
    moves = LoggedMoves(Store())
    moves.add(move)
    moves.pack(1)
    assert moves.packed == 1
    return moves[0]


@pytest.mark.parametrize("action", [None, Action()])
@pytest.mark.parametrize("profile", [None, hold(4.0), plan_trapezoid(0.0, 10.0, 5.0, 100.0, 100.0)])
def test_a_packed_move_has_all_its_figures(action: Action | None, profile: Profile | None) -> None:
    figures = {
        "commanded_speed": 5.0,
        "start_time": 2.0,
        "scale": 100.0,
        "zero": 4.0,
        "offset": -3.0,
        "ended": "stop",
    }
    move = filled(**figures, action=action, profile=profile)
    again = read_again(move)
    assert again is not move
    assert [getattr(again, name) for name in FIELDS] == [getattr(move, name) for name in FIELDS]
    assert ((again.action is None) == (action is None), again.overlaid) == (True, False)
    if profile is None:
        assert again.profile is None
    else:
        assert again.profile is not None
        assert (again.profile.end, again.profile.duration) == (profile.end, profile.duration)
        assert again.profile.curve == profile.curve


def test_an_overlaid_move_is_one_when_it_is_read() -> None:
    class Overlaid(LoggedMove):
        overlaid = True

    again = read_again(Overlaid(0, "OFFSET", 3, 10.0))
    assert (again.overlaid, again.command) == (True, "OFFSET")


@pytest.mark.parametrize("index", range(3))
def test_a_move_continues_as_another_entry(index: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Entries are packed as their pieces reach ten, then counted from 0 again."""
    monkeypatch.setattr(moves_module, "MAX_WAITING", 10)
    moves = LoggedMoves(Store())
    for k in range(3):
        moves.add(filled(line=k, start_time=1.0, offset=5.0))
    move, done = moves[index], hold(4.0)
    moves.split(move, done, 3.0, 9)
    assert (moves.packed, len(moves), moves.number(move)) == (0, 4, 3)
    assert (moves[index].ended, moves[index].profile, moves[index].start_time) == ("continued", done, 1.0)
    assert (moves[3] is move, move.start_time, move.offset, moves[index].offset) == (True, 3.0, 0.0, 5.0)
    moves.split(move, done, 4.0, 1)
    assert (moves.packed, len(moves)) == (5, 5)
    moves.add(move)
    moves.split(move, done, 5.0, 9)
    assert (moves.packed, moves.number(move)) == (5, 6)
    moves.split(move, done, 6.0, 1)
    assert (moves.packed, len(moves)) == (8, 8)
    assert [each.line for each in moves] == [0, 1, 2, index, index, index, index, index]


def test_time_slices_without_a_wait_are_one_record() -> None:
    slices = TimeSliceStream(Store())
    slices.took("one", 1.0, 2.5, True)
    slices.took("one", 3.0, 4.0, False)
    slices.took("two", 4.0, 4.25, False)
    slices.took("one", 4.25, 6.25, True)
    slices.took("two", 7.0, 7.5, False)
    slices.close(8.0)
    slices.took("two", 9.0, 9.5, True)
    assert list(slices) == [
        TimeSlices(1.0, 2.5, ("one",), (1.5,)),
        TimeSlices(3.0, 6.25, ("one", "two"), (3.0, 0.25)),
        TimeSlices(7.0, 8.0, ("two",), (0.5,)),
        TimeSlices(9.0, 9.5, ("two",), (0.5,)),
    ]


PATH = PathOrder(
    *((0, 1), (1.0, 1.0), 2.0, 3, True, (3.0, 4.0), (0.0, 0.0), 0.0, (), (0, 1), 5.0),
    *((10.0, 11.0), (12.0, 13.0), (14.0, 15.0), 0.0),
    entry=6,
)


@pytest.mark.parametrize(
    ("order", "settings"),
    [
        (Order("jog", 7, 5.0, (1.0, 2.0), goal=-5.0), ("jog", 5.0, -5.0, (1.0, 2.0), None)),
        (
            Order("Gear", 7, tie=Tie(Controller(1).axes[0], 2.5)),
            ("Gear", inf, 0.0, (inf, inf), 2.5),
        ),
        (
            Order("path", 7, 5.0, (1.0, 2.0), path=PATH),
            ("path", 6, 5.0, (1.0, 2.0), ((10.0, 11.0), (12.0, 13.0), (14.0, 15.0)), False),
        ),
    ],
)
def test_the_settings_that_affect_a_motion_in_progress(order: Order, settings: tuple[object, ...]) -> None:
    assert order.settings == settings


@pytest.mark.parametrize(
    ("shape", "jerk", "bends"),
    [("trapezoid", inf, False), ("trapezoid", 1e9, True), ("scurve", inf, True), ("sinusoidal", inf, True)],
)
def test_an_order_whose_acceleration_is_continuous(shape: str, jerk: float, bends: bool) -> None:
    assert Order("move", 7, jerks=(jerk, inf), shape=shape).bends is bends
