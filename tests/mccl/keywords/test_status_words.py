"""TS: each bit of the status words, and when it shows."""

from __future__ import annotations

from typing import Any

import pytest

from tests.cases import cases
from tests.mccl.conftest import Runner

# 0.1 s and 50 counts up, 0.2 s and 100 counts down; 1000 counts take 0.1 + 0.85 + 0.2 s.
RATES = "1MN,1SV1000,1SA10000,1DS5000,"
ON = 1 << 1 | 1 << 12
AT_REST = ON | 1 << 2 | 1 << 3


def words(mccl: Runner, text: str, **options: object) -> list[int]:
    """Return the words that a program reports with TS."""
    return [int(line.split()[1]) for line in mccl(text, **options).output]


@cases(
    "at, word", [(0.002, 9), (0.099, 9), (0.102, 1), (0.5, 1), (0.949, 1), (0.952, 1), (1.149, 1), (1.152, 1)]
)
def test_the_profile_word_shows_the_acceleration(at: float, word: int, mccl: Runner) -> None:
    """8 while the axis accelerates, up to 0.1 s.

    Nothing more from there to its target.
    """
    assert words(mccl, f"{RATES}1MR1000,WA{at},1TS2") == [word]


@cases("after, word", [(0.002, 17), (0.199, 17), (0.201, 1)])
def test_the_profile_word_shows_that_the_axis_stops(after: float, word: int, mccl: Runner) -> None:
    """16 from ST to the standstill: from 1000 counts/s that takes 0.2 s."""
    assert words(mccl, f"{RATES}1MR1000,WA0.5,1ST,WA{after},1TS2") == [word]


@cases("shape, word", [("PT", 17), ("PS", 18), ("PP", 20)])
def test_a_stopping_axis_adds_16_to_its_shape(shape: str, word: int, mccl: Runner) -> None:
    assert words(mccl, f"{RATES}1{shape},1MR1000,WA0.5,1ST,WA0.01,1TS2") == [word]


@cases(
    "points, at, on",
    [(1, 0.0, False), (5, 0.0, True), (5, 0.0039, True), (5, 0.0041, False), (9, 0.0041, True)],
)
def test_bit_12_is_on_until_the_last_point_is_recorded(
    points: int, at: float, on: bool, mccl: Runner
) -> None:
    """There is a point every millisecond, the first one at PR.

    The fifth comes after 4 ms.
    """
    assert words(mccl, f"1PR{points},WA{at},1TS1,2TS1") == [1 + 4096 * on, 1]


def test_bit_12_goes_off_when_pr0_ends_the_recording(mccl: Runner) -> None:
    assert words(mccl, "1PR1000,WA0.01,1TS1,1PR0,1TS1") == [4097, 1]


def test_a_loop_may_wait_for_the_end_of_a_recording(mccl: Runner) -> None:
    """100 points take 99 ms; an iteration of the loop takes four commands, 40 us."""
    result = mccl("1MN,1SV1000,1SA100000000,1DS100000000,1MR1000,1PR100\n1GX,IS12,JR-2,NO,1TP,1DO3")
    assert int(result.output[0].split()[1]) == pytest.approx(99, abs=1)
    assert len(result.output) == 4


@cases("shape, number", [("PT", 1), ("PS", 2), ("PS0.2", 2), ("PP", 4)])
def test_the_profile_word_shows_the_shape(shape: str, number: int, mccl: Runner) -> None:
    text = f"{RATES}1{shape},1TS2,1MR1000,WA0.01,1TS2,WA0.5,1TS2,1WS,1TS2"
    assert words(mccl, text) == [number, number + 8, number, number]


@cases(
    "commands, word",
    [
        ("1PM", 1), ("1VM", 2), ("1QM", 4), ("1GM", 8), ("1CM1", 16),
        ("1CM1,1CP1,1MA9000,WA0.01", 16 + 64),
        ("1CM1,2MN,2CM1,1CP2,1CR9000,2CR0,1ER90,WA0.01", 16 + 32),
        ("1CM1,1CP1,1MA9,1WS", 16),
        ("1CM1,2MN,2CM1,1CP2,1CR9,2CR0,1ER90,1WS", 16),
        ("2MN,1SM2", 1 + 128),
        ("2MN,1SM2,1SM0", 1),
    ],
)  # fmt: skip
def test_the_mode_word(commands: str, word: int, mccl: Runner) -> None:
    """The mode, 32 on an arc and 64 on a line of a contour, 128 for a slave."""
    assert words(mccl, f"1MN,{commands},1TS3") == [word]


@cases(
    "commands, word",
    [
        ("1FS", 1), ("1SH", 2), ("1JN", 1 + 4), ("1JN,1JF", 1), ("1DI1", 1 + 1024), ("1DI0", 1), ("1SN", 1 + 8192),
        ("1SN,1NS", 1),
    ],
)  # fmt: skip
def test_the_auxiliary_word(commands: str, word: int, mccl: Runner) -> None:
    """Full or half steps, jogging, the direction of DI, synchronised contours."""
    assert words(mccl, f"1MN,{commands},1TS1") == [word]


@cases(
    "commands, word",
    [
        ("1MN", AT_REST),
        ("1MF", 1 << 2 | 1 << 3),
        ("1MN,1MR1000,WA0.1", ON),
        ("1MN,1MR-1000,WA0.1", ON | 1 << 4),
        ("1MN,1MR-1000,1WS", AT_REST | 1 << 4),
        ("1MN,1MR-1000,1WS,1MR10,1WS", AT_REST),
        ("1MN,1JN", AT_REST | 1 << 5),
        ("1MN,1IA0", AT_REST | 1 << 8),
        ("1MN,1EL0", AT_REST | 1 << 9),
        ("1MN,1IA0,1EL0", AT_REST | 1 << 9),
        ("1MN,1IP0", AT_REST | 1 << 10),
        ("1MN,1IP1", AT_REST),
        ("1MN,1PH1", AT_REST | 1 << 30),
        ("1MN,1LN1", AT_REST | 1 << 14),
        ("1MN,1LN2", AT_REST | 1 << 16),
        ("1MN,1LN4", AT_REST | 1 << 18),
        ("1MN,1LN8", AT_REST | 1 << 20),
        ("1MN,1LN0", AT_REST | 1 << 14 | 1 << 16 | 1 << 18 | 1 << 20),
        ("1MN,1LN0,1LF1", AT_REST | 1 << 16 | 1 << 18 | 1 << 20),
        ("1MN,1LN0,1LF10", AT_REST | 1 << 14 | 1 << 18),
        ("1MN,1LN0,1LF0", AT_REST),
    ],
)
def test_the_primary_word(commands: str, word: int, mccl: Runner) -> None:
    """An axis without limits, marks and inputs.

    Soft limits of 0 have no effect until it moves.
    """
    assert words(mccl, f"{commands},1TS") == [word]


# Axes 1 to 4 have the channels 17 to 32 in fours, the following axes those from 49 on.
CHANNELS = [
    (1, 17, 23), (1, 18, 26), (1, 19, 27), (1, 20, 24), (1, 201, 25), (1, 217, 28), (1, 233, 29),
    (2, 21, 23), (2, 24, 24), (4, 29, 23), (4, 32, 24), (5, 49, 23), (5, 52, 24), (8, 61, 23), (8, 64, 24),
    (8, 240, 29),
]  # fmt: skip


@cases("axis, channel, bit", CHANNELS)
def test_each_input_of_an_axis_is_a_channel_and_a_bit(
    axis: int, channel: int, bit: int, mccl: Runner
) -> None:
    """Home, amplifier fault, auxiliary, limits + and -, user inputs: bits 23 to 29.

    Off again at 0.2 s.
    """
    machine: Any = {"controller.axes": 8, "input": [{"channel": channel, "at": 0.1, "for": 0.1}]}
    off, on, again = words(mccl, f"{axis}MN,{axis}TS,WA0.15,{axis}TS,WA0.1,{axis}TS", machine=machine)
    assert (off, on, again) == (AT_REST, AT_REST | 1 << bit, AT_REST)


@cases(
    "position, on",
    [(1000, True), (999, False), (1001, False), (1500, False), (0, True), (-1000, True), (-999, False)],
)
def test_bit_22_is_on_at_an_index_mark(position: int, on: bool, mccl: Runner) -> None:
    """Marks are 1 count wide, every 1000 counts."""
    found = words(mccl, f"1MN,1MA{position},1WS,1TS", machine={"axis.1.index_every": 1000.0})
    assert [word & 1 << 22 for word in found] == [int(on) << 22]


@pytest.mark.parametrize("model", ["dcx-pci100", "dcx-at200", "dcx-pc100"])
def test_bit_2_is_velocity_mode_on_older_boards(model: str, mccl: Runner) -> None:
    machine = {"controller.model": model}
    found = words(mccl, "1MN,1TS,1VM,1TS,1PM,1TS", machine=machine)
    assert [word & 4 for word in found] == [0, 4, 0]
    assert mccl("1TS1", machine=machine).output == ["?-1"]


@cases(
    "commands, since",
    [
        # 10 counts before the end of a deceleration of 5000 counts/s2: sqrt(2 * 10 / 5000) = 0.06325 s.
        ("1DB10,1MR1000", 1.15 - 0.063246),
        ("1DB10,1MR-1000", 1.15 - 0.063246),
        ("1DB1,1MR1000", 1.15 - 0.02),
        ("1DB10,1DT0.02,1MR1000", 1.17 - 0.063246),
        ("1DT0.02,1MR1000", 1.17),
        ("1MR1000", 1.15),
        ("1DB2000,1MR1000", 0.0),
        ("1DB2000,1DT0.3,1MR1000", 0.3),
    ],
)
def test_bit_2_is_on_within_db_of_the_target_for_dt(commands: str, since: float, mccl: Runner) -> None:
    """WT ends then, and so does a loop that polls the bit."""
    for wait in ("1WT", 'LU"STATUS",1RL@0,IC2,JR-3,NO'):
        result = mccl(f"{RATES}WA1\n{commands}\n{wait}\nCN33")
        (switched,) = result.controller.log.outputs
        assert switched.time == pytest.approx(1.0 + since, abs=3e-4)


@cases(
    "commands, since",
    [
        ("1DB10,1DT0.05,1MR10", 0.05),
        # 1 count is travelled after sqrt(2 * 1 / 10000) = 0.01414 s.
        ("1DB10,1DT0.05,1MR11", 0.05 + 0.014142),
        ("1DB10,1MA5", 1.145 - 0.063246),
        ("1DB10,1MA-1000", 2.15 - 0.063246),
    ],
)
def test_the_distance_to_the_target_counts_from_where_the_axis_is(
    commands: str, since: float, mccl: Runner
) -> None:
    """The axis begins at 1000 counts at 2 s: 1.15 s of motion, 0.85 s of waiting.

    A target within DB at the start of the move is near enough at once.
    """
    result = mccl(f"{RATES}1MA1000,1WS,WA0.85\n{commands}\n1WT\nCN33")
    (switched,) = result.controller.log.outputs
    assert switched.time == pytest.approx(2.0 + since, abs=3e-4)


def test_a_wait_for_the_index_leaves_an_armed_edge_armed(mccl: Runner) -> None:
    result = mccl("1MN,1MR3000,1EL0,1WI,1WS,1TS", machine={"axis.1.index_every": 1000})
    assert int(result.output[0].split()[1]) & 0b11 << 8 == 1 << 9


@pytest.mark.parametrize(("search", "bits"), [("1FI0", 1 << 8), ("1FE0", 1 << 9)])
def test_an_axis_that_searches_shows_it(search: str, bits: int, mccl: Runner) -> None:
    """Neither the mark nor the switch ever comes."""
    text = f"MD1,{search}\n1MN,GT1\nWA0.1,1TS,2TS"
    assert words(mccl, text, until=1.0) == [ON | 1 << 2 | 1 << 3 | bits, 12]


def test_each_limit_has_a_bit_while_it_is_enabled(mccl: Runner) -> None:
    """LN and LF enable and disable 1 hard +, 2 hard -, 4 soft high, 8 soft low."""
    shown = {1: 1 << 14, 2: 1 << 16, 4: 1 << 18, 8: 1 << 20}
    for which in range(1, 16):
        enabled = sum(bit for limit, bit in shown.items() if which & limit)
        text = f"1MN,1HL50,1LL-50,1LN{which},1TS,1LF{which},1TS,1LN15,1LF{which},1TS"
        assert words(mccl, text) == [AT_REST | enabled, AT_REST, AT_REST | sum(shown.values()) - enabled]
