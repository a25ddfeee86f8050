"""The times of a transmit PDO, and those at which its drive is checked."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel.planners import plan_trapezoid
from motionlang_copley.drive import Drive
from motionlang_copley.node import DriveNode
from motionlang_copley.pdo import SentPdo, sent_pdo


def test_times_are_in_the_units_of_cia_301() -> None:
    """Sub-index 3 is in 100 µs, sub-index 5 in ms: 25 and 40 are 2.5 ms and 40 ms."""
    record = {2: 254, 3: 25, 5: 40}
    pdo = sent_pdo(record.__getitem__, 0x182, [(0x6041, 0)])
    assert (pdo.can_id, pdo.kind, pdo.addresses) == (0x182, 254, [(0x6041, 0)])
    assert (pdo.inhibit, pdo.timer) == pytest.approx((0.0025, 0.04))


@pytest.mark.parametrize(
    ("kind", "inhibit", "timer", "data", "now", "due"),
    [
        # New data are sent at once if there is no inhibit time, from the inhibit time on if there is one.
        (255, 0.0, 0.0, b"new", 2.0, True),
        (255, 0.25, 0.0, b"new", 2.125, False),
        (255, 0.25, 0.0, b"new", 2.25, True),
        (254, 0.25, 0.0, b"new", 2.5, True),
        # Old data are sent only by the timer, and no sooner than the inhibit time.
        (255, 0.0, 0.0, b"old", 9.0, False),
        (255, 0.0, 0.5, b"old", 2.25, False),
        (255, 0.0, 0.5, b"old", 2.5, True),
        (255, 0.75, 0.5, b"old", 2.5, False),
        (255, 0.75, 0.5, b"old", 2.75, True),
        # The other types are sent on SYNC.
        (1, 0.0, 0.5, b"new", 9.0, False),
        (0, 0.0, 0.5, b"new", 9.0, False),
        (253, 0.0, 0.5, b"new", 9.0, False),
    ],
)
def test_a_pdo_is_due_between_its_inhibit_time_and_its_timer(
    kind: int, inhibit: float, timer: float, data: bytes, now: float, due: bool
) -> None:
    """Its last transmission was at 2 s."""
    pdo = SentPdo(0x182, kind, inhibit, timer, [], data=b"old", at=2.0)
    assert pdo.is_due(data, now) is due


@pytest.mark.parametrize(
    ("kind", "timer", "at", "time"),
    [
        (255, 0.5, 2.0, 2.5),
        (254, 0.5, 2.0, 2.5),
        (255, 0.0, 2.0, inf),
        (1, 0.5, 2.0, inf),
        (255, 0.5, -inf, inf),
    ],
)
def test_a_pdo_is_checked_again_when_its_timer_ends(kind: int, timer: float, at: float, time: float) -> None:
    """`at` is its last transmission; without one or a timer, only data send it."""
    assert SentPdo(0x182, kind, 0.0, timer, [], at=at).next_time() == time


def test_a_drive_in_motion_is_updated_at_its_end() -> None:
    """A motion of 100 ms that begins at 50 ms ends at 150 ms; at rest nothing is due."""
    node = DriveNode(1, Drive())
    drive = node.drive
    drive.run_until(50_000)
    assert node.next_time() == inf
    drive.follow(plan_trapezoid(0.0, 10.0, 200.0, 4000.0, 4000.0), 0.1, drive.rest)
    assert node.next_time() == pytest.approx(0.15)
    drive.run_until(150_000)
    assert node.next_time() == inf


@pytest.mark.parametrize(
    ("kind", "sent"), [(1, [1, 2, 3, 4, 5, 6, 7]), (2, [2, 4, 6]), (3, [3, 6]), (240, []), (255, [])]
)
def test_a_pdo_of_type_n_is_sent_on_every_nth_sync(kind: int, sent: list[int]) -> None:
    pdo = SentPdo(0x182, kind, 0.0, 0.0, [])
    assert [sync for sync in range(1, 8) if pdo.on_sync(b"data")] == sent


@pytest.mark.parametrize(("kind", "sent"), [(240, 2), (241, 0), (253, 0)])
def test_the_slowest_pdo_is_sent_on_every_240th_sync(kind: int, sent: int) -> None:
    pdo = SentPdo(0x182, kind, 0.0, 0.0, [])
    assert [pdo.on_sync(b"data") for _ in range(500)].count(True) == sent


def test_a_pdo_of_type_0_is_sent_on_a_sync_if_its_data_have_changed() -> None:
    pdo = SentPdo(0x182, 0, 0.0, 0.0, [], data=b"old")
    assert [pdo.on_sync(data) for data in (b"old", b"new", b"old")] == [False, True, False]
