"""Figures, times and spans of pictures in the wording that every view uses."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.tools import count_of
from motionlang.views.figure_layout import visible
from motionlang.views.formatting import clock_time, dialect_name, figure, peak_of, significant
from motionlang.views.lanes import ChannelLane, lanes
from motionlang.views.report import MAX_WRITES, writes_table
from motionlang.views.window import WHOLE, Window


@pytest.mark.parametrize(
    ("seconds", "wanted"),
    [
        (0.0, "0 s"),
        (0.25, "0.25 s"),
        (1e-6, "0.000001 s"),
        (12.0, "12 s"),
        (59.999999, "59.999999 s"),
        (60.0, "1 min 0 s"),
        (61.5, "1 min 1.5 s"),
        (100.0, "1 min 40 s"),
        (119.9996, "2 min 0 s"),
        (3599.999, "59 min 59.999 s"),
        (3599.9999, "1 h 00 min 0 s"),
        (3600.0, "1 h 00 min 0 s"),
        (3661.4, "1 h 01 min 1 s"),
        (28_800.0, "8 h 00 min 0 s"),
        (90_061.0, "25 h 01 min 1 s"),
    ],
)
def test_a_machine_time(seconds: float, wanted: str) -> None:
    """Microseconds below a minute, milliseconds below an hour, then whole seconds."""
    assert clock_time(seconds) == wanted


@pytest.mark.parametrize(
    ("value", "digits", "wanted"),
    [
        (7e-05, 3, "0.00007"),
        (0.00012345, 3, "0.000123"),
        (-1.5e-07, 3, "-0.00000015"),
        (0.5, 3, "0.5"),
        (1234.0, 3, "1.23e+03"),
        (12.0, 3, "12"),
        (0.0, 3, "0"),
    ],
)
def test_significant_digits(value: float, digits: int, wanted: str) -> None:
    assert significant(value, digits) == wanted


@pytest.mark.parametrize(
    ("value", "decimals", "wanted"),
    [
        (1.23456, 3, "1.235"),
        (-0.0, 3, "0.000"),
        (0.0005, 3, "0.001"),
        (0.000499, 3, "0.000499"),
        (-0.000499, 3, "-0.000499"),
        (0.4, 0, "0.4"),
        (0.6, 0, "1"),
        (999_999_999.0, 3, "999999999.000"),
        (1e9, 3, "1e+09"),
        (-2e9, 3, "-2e+09"),
    ],
)
def test_a_figure_of_a_column(value: float, decimals: int, wanted: str) -> None:
    """A figure that would be too long, or only zeros, has six digits instead."""
    assert figure(value, decimals) == wanted


def test_nouns_and_names() -> None:
    assert [count_of(number, "move") for number in (0, 1, 2)] == ["0 moves", "1 move", "2 moves"]
    assert [dialect_name(name) for name in ("mint", "mccl", "other")] == ["Mint", "MCCL", "other"]
    assert peak_of(1234.5678) == "1234.57"


@pytest.mark.parametrize(
    ("spans", "wanted"),
    [
        ([], []),
        ([(1.0, 3.0)], [(1.0, 3.0)]),
        # A span has at least a pixel, also at the end of the window.
        ([(2.0, 2.25)], [(2.0, 3.0)]),
        ([(9.75, 10.0)], [(9.0, 10.0)]),
        # What is outside the window is cut off; what touches it has a pixel.
        ([(-5.0, -1.0), (11.0, 12.0)], []),
        ([(-5.0, 0.0)], [(0.0, 1.0)]),
        ([(-5.0, 2.0), (8.0, 99.0)], [(0.0, 2.0), (8.0, 10.0)]),
        # A gap of a pixel stays; a shorter one is widened at the cost of the span before it, or of the one after it.
        ([(0.0, 3.0), (4.0, 6.0)], [(0.0, 3.0), (4.0, 6.0)]),
        ([(0.0, 3.0), (3.5, 6.0)], [(0.0, 2.5), (3.5, 6.0)]),
        ([(0.0, 2.0), (2.0, 6.0)], [(0.0, 1.0), (2.0, 6.0)]),
        ([(0.0, 1.5), (1.75, 6.0)], [(0.0, 1.5), (2.5, 6.0)]),
        ([(0.0, 1.0), (1.25, 3.0)], [(0.0, 1.0), (2.0, 3.0)]),
        # Neither has room: two spans that overlap are one, others stay.
        ([(0.0, 1.0), (1.0, 1.5)], [(0.0, 2.0)]),
        ([(0.0, 1.5), (1.0, 1.25)], [(0.0, 2.0)]),
        ([(0.0, 1.0), (1.25, 1.5)], [(0.0, 1.0), (1.25, 2.25)]),
    ],
)
def test_spans_and_gaps_have_a_pixel(
    spans: list[tuple[float, float]], wanted: list[tuple[float, float]]
) -> None:
    """A pixel is 1 s, the window is 0 to 10 s."""
    assert visible(spans, (0.0, 10.0), 1.0) == wanted


def test_a_window_of_a_run() -> None:
    """A run of 5 s in which the axes 0 and 2 moved."""
    assert WHOLE.span(5.0) == (0.0, 5.0)
    assert Window(1.0, 2.0).span(5.0) == (1.0, 2.0)
    assert Window(1.0, 9.0).span(5.0) == (1.0, 5.0)
    assert WHOLE.span(0.0) == (0.0, 0.0)
    for begin in (5.0, 7.0):
        with pytest.raises(ValueError, match=f"the run ended after 5 s, before --from {begin:g} s"):
            Window(begin).span(5.0)
    assert WHOLE.of((0, 2)) == (0, 2)
    assert Window(axes=(2,)).of((0, 2)) == (2,)
    assert Window(axes=(2, 0)).of((0, 2)) == (0, 2)
    with pytest.raises(ValueError, match="axis 1 did not move in this run: 0, 2 did"):
        Window(axes=(1,)).of((0, 2))
    with pytest.raises(ValueError, match="axis 1 did not move in this run: none did"):
        Window(axes=(1,)).of(())


def test_the_times_in_which_a_channel_is_on() -> None:
    lane = ChannelLane("inputs", 1, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0], [0.0, 1.0, 2.0, 0.0, 0.0, 1.0])
    assert lane.spans(9.0) == [(1.0, 3.0), (5.0, 9.0)]
    assert ChannelLane("inputs", 1, [0.0, 1.0], [1.0, 0.0]).spans(9.0) == [(0.0, 1.0)]


def test_a_lane_for_each_channel_that_changed() -> None:
    """By group and number; a change at time 0 is the first value."""
    controller = Controller(1)
    controller.inputs[12] = 1
    controller.clock.advance(1.0)
    controller.outputs[3] = 1
    controller.inputs[4] = 1
    controller.analogue_outputs[1] = 12.5
    controller.clock.advance(2.0)
    controller.inputs[12] = 0
    found = [(each.group, each.name, each.is_digital, each.times, each.values) for each in lanes(controller)]
    assert found == [
        ("inputs", "in4", True, [0.0, 1.0], [0.0, 1.0]),
        ("inputs", "in12", True, [0.0, 2.0], [1.0, 0.0]),
        ("outputs", "out3", True, [0.0, 1.0], [0.0, 1.0]),
        ("analogue outputs", "aout1", False, [0.0, 1.0], [0.0, 12.5]),
    ]


def test_writes_to_other_devices() -> None:
    rows: list[dict[str, object]] = [
        {"server": 2, "kind": "register", "number": 7, "value": 2.0},
        {"bus": 1, "node": 5, "kind": "analogue-output", "number": 3, "value": 12.5},
    ]
    assert [line.split() for line in writes_table(rows).lines(100)[2:]] == [
        ["Modbus", "server", "2", "register", "7", "2"],
        ["node", "5", "of", "bus", "1", "analogue", "output", "3", "12.5"],
    ]
    many = writes_table(rows[:1] * (MAX_WRITES + 2)).lines(100)
    assert many[-1] == "… and 2 more: --format json has all"
    assert len(writes_table(rows[:1] * MAX_WRITES).lines(100)) == len(many) - 1
