"""Interpolated position mode, as a master on the bus sees it: sub-modes, times, refusals."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from test_copley.bus import Master, SdoAbort

VALUE_RANGE, DEVICE_STATE = 0x06090030, 0x08000022
IDLE, WAITING, MOVING = "idle", "waiting", "moving"


@pytest.fixture
def off() -> Iterator[Master]:
    """A drive that is not switched on."""
    made = Master()
    yield made
    made.close()


@pytest.fixture
def server(off: Master) -> Master:
    """A drive that is switched on, in interpolated position mode, sub-mode -3."""
    for index, value in ((0x6060, 7), (0x60C0, -3), (0x6040, 6), (0x6040, 7), (0x6040, 15)):
        off.write(index, value)
    return off


def added(server: Master) -> list[tuple[int, int | None, int]]:
    return [(e.position, e.velocity, e.microseconds) for e in server.drive.buffer.entries]


@pytest.mark.parametrize(
    ("mode", "writes", "entry"),
    [
        (0, [(1, 500)], (500, None, 15_000)),
        (-1, [(1, 500)], (500, None, 15_000)),
        (-2, [(1, 500), (2, 20)], (500, None, 20_000)),
        (-3, [(1, 500), (2, 20), (3, -70)], (500, -70, 20_000)),
    ],
)
def test_the_last_sub_index_of_each_sub_mode_adds_the_point(
    server: Master, mode: int, writes: list[tuple[int, int]], entry: tuple[int, int | None, int]
) -> None:
    server.write(0x60C0, mode)
    server.write(0x60C2, 15, 1)
    for sub, value in writes:
        assert added(server) == []
        server.write(0x60C1, value, sub)
    assert added(server) == [entry]


@pytest.mark.parametrize(("mode", "sub"), [(0, 2), (0, 3), (-1, 2), (-1, 3), (-2, 3)])
def test_sub_indices_that_a_sub_mode_does_not_use_are_refused(server: Master, mode: int, sub: int) -> None:
    server.write(0x60C0, mode)
    with pytest.raises(SdoAbort) as refused:
        server.write(0x60C1, 1, sub)
    assert refused.value.args == (DEVICE_STATE,)
    assert added(server) == []


@pytest.mark.parametrize("mode", [1, 2, 3, -4, 32767])
def test_there_are_four_sub_modes(server: Master, mode: int) -> None:
    with pytest.raises(SdoAbort) as refused:
        server.write(0x60C0, mode)
    assert refused.value.args == (VALUE_RANGE,)


@pytest.mark.parametrize(
    ("units", "index", "microseconds"),
    [(1, -3, 1000), (15, -3, 15_000), (255, -6, 255), (20, -4, 2000), (7, -5, 70)],
)
def test_the_fixed_time_is_units_times_a_power_of_ten(
    server: Master, units: int, index: int, microseconds: int
) -> None:
    server.write(0x60C2, units, 1)
    server.write(0x60C2, index, 2)
    server.write(0x60C0, -1)
    server.write(0x60C1, 500, 1)
    assert added(server) == [(500, None, microseconds)]


@pytest.mark.parametrize(("sub", "value"), [(1, 0), (2, -2), (2, -7)])
def test_other_fixed_times_are_refused(server: Master, sub: int, value: int) -> None:
    with pytest.raises(SdoAbort) as refused:
        server.write(0x60C2, value, sub)
    assert refused.value.args == (VALUE_RANGE,)


def test_the_drive_must_be_switched_on_step_by_step(off: Master) -> None:
    off.write(0x6060, 7)
    off.write(0x6040, 0x1F)
    assert off.read(0x6041) & 0x6F == 0x40
    assert off.drive.state == IDLE
    for control, bits in ((0x06, 0x21), (0x07, 0x23), (0x0F, 0x27)):
        off.write(0x6040, control)
        assert off.read(0x6041) & 0x6F == bits


def test_only_interpolated_position_mode_starts(off: Master) -> None:
    for control in (0x06, 0x07, 0x0F, 0x1F):
        off.write(0x6040, control)
    assert off.drive.state == IDLE
    with pytest.raises(SdoAbort) as refused:
        off.write(0x6060, 4)
    assert refused.value.args == (VALUE_RANGE,)


def test_the_first_sub_mode_waits_for_three_points(off: Master) -> None:
    for index, value in ((0x6060, 7), (0x6040, 6), (0x6040, 7), (0x6040, 15), (0x6040, 31)):
        off.write(index, value)
    assert off.drive.state == WAITING
    for position, state in ((0, WAITING), (5, WAITING), (9, MOVING)):
        off.write(0x60C1, position, 1)
        assert off.drive.state == state


def test_modes_do_not_change_in_mid_move(server: Master) -> None:
    server.write(0x60C0, 0)
    server.write(0x6040, 0x1F)
    assert server.drive.state == WAITING
    for index, value in ((0x60C0, -1), (0x6060, 0)):
        with pytest.raises(SdoAbort) as refused:
            server.write(index, value)
        assert refused.value.args == (DEVICE_STATE,)


def test_a_full_buffer_refuses_the_record_and_latches_an_overflow(server: Master) -> None:
    server.write(0x60C0, -1)
    for n in range(32):
        server.write(0x60C1, n, 1)
    with pytest.raises(SdoAbort):
        server.write(0x60C1, 32, 1)
    assert server.read(0x2012) >> 24 & 7 == 2


def test_the_quick_stop_deceleration_brakes(server: Master) -> None:
    assert server.drive.abort_deceleration == 1_000_000.0
    server.write(0x6085, 5000)
    assert server.drive.abort_deceleration == 50_000.0
    assert server.read(0x6085) == 5000
    server.write(0x6085, 1)
    assert server.drive.abort_deceleration == 10.0
    with pytest.raises(SdoAbort):
        server.write(0x6085, 0)
