"""The auxiliary encoder of an axis: moved by the machine, read by AT AH AF AZ."""

from __future__ import annotations

import pytest

from motionlang.mccl.keywords.motion_auxiliary import _passed
from tests.mccl.conftest import Runner

TURNING = {
    "encoder": [
        {"aux": 1, "velocity": 1000.0, "index_every": 400.0},
        {"aux": 2, "velocity": -50.0, "at": 1.0},
    ]
}


def test_it_turns_as_the_machine_file_says(mccl: Runner) -> None:
    result = mccl("WA1.00001,1AT,2AT,3AT,WA1,1AT,2AT", machine=TURNING)
    assert result.output == ["01 1000", "02 0", "03 0", "01 2000", "02 -50"]


def test_it_is_set_and_reported_in_user_units(mccl: Runner) -> None:
    result = mccl("WA0.5,1AH20,1AT,WA0.1,1AT\n1US10,1UZ7,1MN,1AT,1AH3,1AT", machine=TURNING)
    assert result.output == ["01 20", "01 120", "01 12.000000", "01 3.000000"]


def test_its_index_is_found_at_the_exact_moment(mccl: Runner) -> None:
    """Marks are at 400 and 800 counts; the second one, at 0.8 s, becomes position 5."""
    result = mccl("WA0.5,1AF5,1AT,1AZ,WA0.1,1AT,1AZ", machine=TURNING)
    assert result.output == ["01 5", "01 5", "01 105", "01 5"]
    assert result.time == pytest.approx(0.9, abs=1e-3)


def test_an_encoder_that_turns_backwards_finds_the_mark_behind_it(mccl: Runner) -> None:
    machine = {"encoder": [{"aux": 1, "velocity": -1000.0, "index_every": 400.0}]}
    assert mccl("WA0.5,1AF0,1AT,WA0.01,1AT", machine=machine).output == ["01 0", "01 -10"]


def test_an_index_that_never_comes(mccl: Runner) -> None:
    result = mccl("1AF0", machine={"encoder": [{"aux": 1, "velocity": 1000.0}]})
    assert [each.code for each in result.diagnostics] == ["never"]
    assert "index mark of the auxiliary encoder of axis 1" in result.diagnostics[0].message


def test_a_loop_that_watches_it_is_not_skipped(mccl: Runner) -> None:
    result = mccl('LU"AUXPOSITION",AR20\n1RL@20,IB700,JR-2,NO,1AT', machine=TURNING)
    assert result.output == ["01 700"]


def test_a_loop_that_watches_one_count_a_second_ends_at_the_third(mccl: Runner) -> None:
    """The ramp to 1 count/s at 1000 counts/s² costs 0.0005 s."""
    machine = {"encoder": [{"aux": 1, "velocity": 1.0, "accel": 1000.0}]}
    result = mccl('LU"AUXPOSITION",AR20\n1RL@20,IB3,JR-2,NO,CN33', machine=machine)
    (switched,) = result.controller.log.outputs
    assert switched.time == pytest.approx(3.0005, abs=1e-4)


def test_the_next_index_is_found_from_the_present_motion(mccl: Runner) -> None:
    """After a second each at 1000, 500 and 200 counts/s the encoder is at 1700 counts.

    The mark at 2000 is 300 counts away, which takes 1.5 s.
    """
    encoder = {"aux": 1, "accel": 1e9}
    machine = {
        "encoder": [
            {**encoder, "velocity": 1000.0, "index_every": 400.0},
            {**encoder, "velocity": 500.0, "at": 1.0},
            {**encoder, "velocity": 200.0, "at": 2.0},
        ]
    }
    result = mccl("WA3,1AT,1AF0,CN33", machine=machine)
    (switched,) = result.controller.log.outputs
    assert result.output == ["01 1700"]
    assert switched.time == pytest.approx(4.5, abs=1e-3)


def test_an_encoder_may_have_a_mark_at_each_count(mccl: Runner) -> None:
    """At 10 counts/s the count after 10.5 comes after 0.05 s."""
    machine = {"encoder": [{"aux": 1, "velocity": 10.0, "accel": 1e9, "index_every": 1.0}]}
    result = mccl("WA1.05,1AF5,1AT,CN33", machine=machine)
    (switched,) = result.controller.log.outputs
    assert result.output == ["01 5"]
    assert switched.time == pytest.approx(1.1, abs=1e-3)


@pytest.mark.parametrize(
    ("start", "here", "expected"),
    [
        (0.0, 400.0 - 2e-6, False), (0.0, 400.0 - 0.5e-6, True), (0.0, 400.0, True), (0.0, 401.0, True),
        (900.0, 400.0 + 2e-6, False), (900.0, 400.0 + 0.5e-6, True), (900.0, 400.0, True), (900.0, 399.0, True),
    ],
)  # fmt: skip
def test_a_mark_is_passed_from_either_side(start: float, here: float, expected: bool) -> None:
    """The mark is at 400 counts; a millionth of a count is rounding."""
    assert _passed(start, 400.0, here) is expected
