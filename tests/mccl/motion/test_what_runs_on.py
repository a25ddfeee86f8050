"""Axes that run on, waits for a position, auxiliary encoders and searches.

The cases by hand.
"""

from __future__ import annotations

import pytest

from tests.cases import cases
from tests.mccl.conftest import Runner

HEAD = "MN,SV1000,SA10000,DS10000\n"


@cases(
    "ending, velocity",
    [
        ("NO", 500), ("1ST,1WS", 0), ("1AB", 0), ("1MF,1MN", 0), ("1RT,1MN", 0), ("ST,WS", 0), ("AB", 0), ("MF,MN", 0),
        ("1PM,1MA0,1WS", 0), ("1PM,1MA900,1WS", 0), ("1ST,1WS,2PM,1SM2", 0),
        # PM alone stops nothing, nor does DI, and an axis keeps its new velocity.
        ("1PM", 500), ("1DI1", -500), ("1VM", 500), ("2ST", 500),
    ],
)  # fmt: skip
def test_a_new_velocity_applies_at_once_only_while_the_axis_runs_in_velocity_mode(
    ending: str, velocity: int, mccl: Runner
) -> None:
    result = mccl(f"{HEAD}1VM,1GO,WA0.5,{ending}\n1SV500,WA0.5,1TV,1AB", until=9.0)
    assert [line for line in result.output if "?" not in line] == [f"01 {velocity}"]


def test_a_fault_ends_velocity_mode_too(mccl: Runner) -> None:
    machine = {"fault": [{"axis": 1, "kind": "following-error", "at": 0.3}]}
    assert mccl(f"{HEAD}1VM,1GO,WA0.5,1MN,1SV500,WA0.5,1TV", machine=machine).output == ["01 0"]


@cases("setting", ["1DS0", "1SV0"])
def test_a_reversal_without_a_velocity_or_a_deceleration_is_a_parameter_error(
    setting: str, mccl: Runner
) -> None:
    assert mccl(f"{HEAD}1MR1000,WA0.5,{setting},1MA-100,1TP", until=9.0).output == ["?-1"]


@cases(
    "target, stalls",
    [
        # After 0.5 s the axis is at 450 and needs 50 counts to stop: at 500.
        ("600", False), ("502", False), ("500", True), ("498", True), ("0", True), ("-600", True),
    ],
)  # fmt: skip
def test_a_target_that_needs_a_reversal_stalls_the_interpreter(
    target: str, stalls: bool, mccl: Runner
) -> None:
    result = mccl(f"{HEAD}1MR1000,WA0.5,1MA{target},1TP,1WS,1TP")
    here, end = (int(line.split()[1]) for line in result.output)
    assert here == pytest.approx(500 if stalls else 450, abs=1)
    assert end == int(target)


@cases(
    "commands, output",
    [
        # From where the axis is, in the given direction.
        ("1MR1000,1WP300,1TP,1WS", ["01 300"]),
        ("1MR-1000,1WP-300,1TP,1WS", ["01 -300"]),
        ("1MR1000,1WR300,1TP,1WS", ["01 300"]),
        ("1MR-1000,1WR-300,1TP,1WS", ["01 -300"]),
        ("1MR1000,WA0.25,1WR300,1TP,1WS", ["01 500"]),
        ("1MR1000,1WS,1WP1000,1TP", ["01 1000"]),
        ("1MR1000,WA0.25,1WR0,1TP,1WS", ["01 200"]),
        # Bit 10: off while the wait lasts, on from then, off again with the next breakpoint.
        ('MD1,LU"STATUS",1RL@0,AN1024,AR20,WA0.4,1RL0\nGT1,1MR1000,1WP300,TR20,1WS', ["0"]),
        # A wait replaces the breakpoint of IP.
        ('MD1,WA0.3,LU"STATUS",AR10,1RL@10,AN1024,AR20\nGT1,1IP100,1MR1000,1WP500,TR20,1WS', ["0"]),
        ('LU"STATUS",AR10,1MR1000,1WP300,1RL@10,AN1024,TR0,1IP700,1RL@10,AN1024,TR0,1WS', ["1024", "0"]),
        ('LU"STATUS",AR10,1MR1000,WA0.25,1IR0,1RL@10,AN1024,TR0,1WS', ["1024"]),
        ('LU"STATUS",AR10,1MR1000,1IR300,1IR900,WA0.6,1RL@10,AN1024,TR0,1WS,1RL@10,AN1024,TR0', ["0", "1024"]),
        ('LU"STATUS",AR10,1MR-1000,1IP-300,1WS,1RL@10,AN1024,TR0,1TB', ["1024", "01 -300"]),
        ("1IP500,1TB,1IR30,1TB", ["01 500", "01 30"]),
    ],
)  # fmt: skip
def test_a_wait_for_a_position_and_a_breakpoint(commands: str, output: list[str], mccl: Runner) -> None:
    found = [line for line in mccl(HEAD + commands).output if not line.startswith("?")]
    assert found == output


@cases(
    "text, output",
    [("1US10,1MN,1IP5,1TB", ["01 5.000000"]), ("1US10,1MN,1MR50,1WP5,1TP,1WS", ["01 5.000000"])],
)
def test_positions_of_waits_are_in_user_units(text: str, output: list[str], mccl: Runner) -> None:
    assert mccl(HEAD + text).output == output


@cases(
    "velocity, wait, found, later",
    [
        # Marks every 400 counts. Forwards from 500: 800. Backwards from -500: -800.
        (1000.0, 0.5, 0.8, "01 10"), (-1000.0, 0.5, 0.8, "01 -10"),
        # From just before and just behind a mark.
        (1000.0, 0.399, 0.4, "01 10"), (1000.0, 0.401, 0.8, "01 10"), (-1000.0, 0.401, 0.8, "01 -10"),
        # On the mark at 0 the search is for the next one, in either direction.
        (1000.0, 0.0, 0.4, "01 10"), (-1000.0, 0.0, 0.4, "01 -10"),
    ],
)  # fmt: skip
def test_the_next_index_mark_of_an_auxiliary_encoder(
    velocity: float, wait: float, found: float, later: str, mccl: Runner
) -> None:
    """The mark becomes position 0, and 10 ms later the encoder is 10 counts beyond it."""
    machine = {"encoder": [{"aux": 1, "velocity": velocity, "index_every": 400.0}]}
    result = mccl(f"WA{wait},1AF0,CN33,1AZ,WA0.00998,1AT", machine=machine)
    assert result.controller.log.outputs[0].time == pytest.approx(found, abs=1e-4)
    assert result.output == ["01 0", later]


@cases(
    "start, back, mark",
    [(0, 0, 1000), (0, 1, -1000), (300, 0, 1000), (300, 1, 0), (-300, 0, 0), (-300, 1, -1000), (1000, 0, 2000),
     (1000, 1, 0), (999, 0, 1000), (1001, 1, 1000), (-1000, 1, -2000)],
)  # fmt: skip
def test_the_next_index_mark_of_an_axis(start: int, back: int, mark: int, mccl: Runner) -> None:
    """Marks every 1000 counts.

    WI waits for one without a change of the zero, FI gives it a position.
    """
    begin = f"{HEAD}1MA{start},1WS,1VM,1DI{back},1GO,"
    machine = {"axis.1.index_every": 1000.0}
    waited = mccl(f"{begin}1WI,1TP,1TZ,1AB", machine=machine)
    assert waited.output == [f"01 {mark}"] * 2
    found = mccl(f"{begin}1FI7,1TP,1TZ,1AB", machine=machine)
    assert found.output == ["01 7"] * 2


@cases(
    "commands, output",
    [
        ("1MR500,1WS,1LP5,1MR100,1WS,1MP5,1WS,1TP", ["01 500"]),
        ("1MR500,1LT5,1WS,1MR100,1WS,1MP5,1WS,1TP", ["01 500"]),
        ("1MR500,WA0.25,1LP5,1WS,1MP5,1WS,1TP", ["01 200"]),
        ("1LP0,1LP255,1MP0,1MP255,1TP", ["01 0"]),
        ("1LP256", ["?-1"]),
        ("1MP5", ["?-1"]),
        ("1LP5,1MR9,1WS,2MP5", ["?-1"]),
        ("1LP5,MR9,WS,MP5,WS,1TP,2TP", ["01 0", "02 9"]),
        ("1VM,1GO,1LT5", ["?-1"]),
        ("1LP5,RT\n1MN,1MP5", ["?-1"]),
    ],
)
def test_learned_points(commands: str, output: list[str], mccl: Runner) -> None:
    assert mccl(HEAD + commands, until=9.0).output == output


@cases(
    "taken, points",
    [("1PR5,WA0.0025,1DO0", 3), ("1PR5,WA1,1DO0", 5), ("1PR5,1DO0", 1), ("1PR5,WA0.0025,1PR0,WA1,1DO0", 3),
     ("1PR5,WA0.0025,1DO2", 2), ("1PR5,WA0.0025,1DO9", 3), ("1PR5,WA1,1PR0,1DO0", 5), ("1PR1,WA1,1DR0", 1),
     ("1PR5,WA0.00097,1DQ0", 1), ("1PR5,WA0.001,1DQ0", 2), ("1PR9,1PR2,WA1,1DR0", 2)],
)  # fmt: skip
def test_the_number_of_points_recorded(taken: str, points: int, mccl: Runner) -> None:
    """One at once, and one more each millisecond."""
    assert len(mccl(f"1MN,{taken}").output) == points
