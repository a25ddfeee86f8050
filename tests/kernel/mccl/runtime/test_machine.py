"""MCCL with a machine file: switches, marks, inputs, faults."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT
from tests.mccl_runs import Runner

MOTOR_ERROR, FOLLOWING, AMPLIFIER, PLUS, MINUS, HIGH, LOW = (1 << bit for bit in (7, 11, 13, 15, 17, 19, 21))


def status(line: str) -> int:
    """Return the status word in a reply of TS."""
    return int(line.split()[1])


@pytest.mark.parametrize(
    ("mode", "end", "enabled"),
    [(0, 5000.0, False), (1, 5000.0, True), (2, 5500.0, True)],
    ids=["off", "abrupt", "smooth"],
)
def test_a_limit_switch_does_what_lm_says(mode: int, end: float, enabled: bool, mccl: Runner) -> None:
    """A smooth stop from 10000 counts/s at 100000 counts/s2 takes 500 counts."""
    result = mccl(
        f"1MN,1SV10000,1LM{mode},1LN1,1MA20000,1WS,1TS,1TP", machine={"axis.1.travel": [-1000.0, 5000.0]}
    )
    assert status(result.output[0]) & (MOTOR_ERROR | PLUS) == MOTOR_ERROR | PLUS
    assert bool(status(result.output[0]) & 2) is enabled
    assert result.controller.position(1) == pytest.approx(end, abs=1e-6)


def test_a_limit_that_is_not_enabled_does_nothing(mccl: Runner) -> None:
    result = mccl("1MN,1MA20000,1WS,1TP", machine={"axis.1.travel": [-1000.0, 5000.0]})
    assert result.output == ["01 20000"]


def test_travel_shows_as_the_limit_inputs_whether_enabled_or_not(mccl: Runner) -> None:
    """Bits 26 and 27 are the limit inputs; a polling loop sees them within 0.2 counts.

    The axis moves at 10000 counts/s.
    """
    on_bit = '1LU"STATUS",1RL@0,IC{bit},JR-3,NO,1TP,1ST,1WS'
    text = (
        f"1MN,1SV10000,1VM,1GO\n{on_bit.format(bit=26)}\n1DI1,1GO\n{on_bit.format(bit=27)}\n1PM,1MA0,1WS,1TS"
    )
    plus, minus, last = mccl(text, machine={"axis.1.travel": [-1000.0, 5000.0]}).output
    assert 5000 <= status(plus) <= 5001
    assert -1001 <= status(minus) <= -1000
    assert status(last) & (1 << 26 | 1 << 27) == 0


def test_a_limit_that_was_passed_when_it_was_enabled_lets_go_again(mccl: Runner) -> None:
    text = "1MN,1SV10000,1MA5500,1WS,1LM1,1LN1,1MA4000,1WS,1TP,1MA9000,1WS,1TP"
    assert mccl(text, machine={"axis.1.travel": [-1000.0, 5000.0]}).output == ["01 4000", "01 5000"]


def test_a_reset_makes_positions_zero(mccl: Runner) -> None:
    assert mccl("1MN,2MN,1MA500,2MA600,1WS,2WS,1RT,1TP,2TP\nRT\n1TP,2TP").output == [
        "01 0",
        "02 600",
        "01 0",
        "02 0",
    ]


def test_a_reset_switches_outputs_off(mccl: Runner) -> None:
    assert mccl("CN33,TC33,RT\nTC33").output == ["33 1", "33 0"]


def test_a_reset_clears_all_registers(mccl: Runner) -> None:
    text = "AL7,AR5,AR10,RT\nTR0,TR5,TR10"
    assert mccl(text).output == ["0", "0", "0"]
    assert mccl("AL7,AR5,1RT\nTR0,TR5").output == ["7", "7"]


def test_off_a_limit_after_motor_on(mccl: Runner) -> None:
    text = "1MN,1LM1,1LN3,1MA20000,1WS,1MA0,1TP,1MN,1MA0,1WS,1TP,1TS"
    result = mccl(text, machine={"axis.1.travel": [-1000.0, 5000.0]})
    assert result.output[:2] == ["01 5000", "01 0"]
    assert status(result.output[2]) & (MOTOR_ERROR | PLUS) == 0
    assert [each.code for each in result.diagnostics] == ["disabled-axis"]
    assert "tripped" in result.diagnostics[0].message


def test_soft_limits(mccl: Runner) -> None:
    result = mccl(
        "1MN,1SV10000,1HL3000,1LL-2000,1LM4,1LN12,1MA9000,1WS,1TP,1TS,1MN,1MA-9000,1WS,1TP,1TS,1LF0"
    )
    assert result.output[0] == "01 3000"
    assert status(result.output[1]) & (MOTOR_ERROR | HIGH | LOW) == MOTOR_ERROR | HIGH
    assert result.output[2] == "01 -2000"
    assert status(result.output[3]) & (MOTOR_ERROR | HIGH | LOW) == MOTOR_ERROR | LOW


def test_a_limit_channel_with_inverted_polarity(mccl: Runner) -> None:
    """Channel 18 is the switch of axis 1's positive limit; closed is its normal state.

    It opens after 0.1 s.
    """
    result = mccl(
        "WA0.01,1MN,1LM129,1LN1,1SV1000,1MA5000,1WS,1TP",
        machine={"input": [{"channel": 18, "at": 0.0, "value": 1, "for": 0.11}]},
    )
    assert result.controller.position(1) == pytest.approx(1000 * (0.11 - 0.01 - 6e-5) - 5, abs=0.2)


@pytest.mark.parametrize(("kind", "bits"), [("following-error", FOLLOWING), ("error-input", AMPLIFIER)])
def test_faults_show_in_the_status(kind: str, bits: int, mccl: Runner) -> None:
    result = mccl("1MN,1FN0,1MR50000,1WS,1TS", machine={"fault": [{"axis": 1, "kind": kind, "at": 0.1}]})
    assert status(result.output[0]) & (MOTOR_ERROR | bits) == MOTOR_ERROR | bits
    (move,) = result.controller.log.moves
    assert move.ended == "fault"


def test_the_amplifier_fault_input_is_watched_only_if_told(mccl: Runner) -> None:
    machine: Any = {"input": [{"channel": 20, "at": 0.1}]}
    watched = mccl("1FN0,1MN,1MR50000,1WS,1TS", machine=machine)
    assert status(watched.output[0]) & (AMPLIFIER | 2) == AMPLIFIER
    free = mccl("1FF,1MN,1MR50000,1WS,1TP", machine=machine)
    assert free.output == ["01 50000"]


def test_find_index_gives_the_mark_its_position(mccl: Runner) -> None:
    """Marks are every 1000 counts; from 300 before one, the axis finds it and returns."""
    result = mccl(
        "1MN,1SV5000,1VM,1GO,1FI50,1TP,1ST,1WS,1TZ,1PM,1MA50,1WS,1TS",
        machine={"axis.1.index_every": 1000.0, "axis.1.start": 0.0},
    )
    assert result.output[:2] == ["01 50", "01 50"]
    assert status(result.output[2]) & (1 << 6)
    axis = result.controller.axes[1]
    assert axis.position(result.time) - axis.datum == pytest.approx(1000.0, abs=1e-6)


def test_an_armed_index_is_caught_while_the_program_does_something_else(mccl: Runner) -> None:
    result = mccl("1MN,1MR1500,1IA0,1WS,1TP,1WI,1TP", machine={"axis.1.index_every": 1000.0})
    assert result.output == ["01 1500", "01 500"]


def test_a_search_ends_with_its_command(mccl: Runner) -> None:
    """Nothing is caught at 1000 after ET, and WI waits for the mark at 2000."""
    machine = {"axis.1.index_every": 1000.0}
    for search in ("1FI100", "1WI"):
        run = mccl(
            f"MD1,{search}\n1MN,GT1,WA0.1,ET@0,1TS,1MR1500,1WS,1TP,1TZ,1MR1000,1WI,1TP,1WS", machine=machine
        )
        assert status(run.output[0]) & (1 << 8) == 0
        assert run.output[1:] == ["01 1500", "01 0", "01 2000"]


def test_find_edge_and_wait_edge(mccl: Runner) -> None:
    machine = {"axis.1.home_switch": [2000.0, 2500.0]}
    found = mccl("1MN,1SV5000,1VM,1GO,1FE0,1ST,1WS,1TP", machine=machine)
    assert found.output == ["01 125"]
    armed = mccl("1MN,1SV5000,1VM,1GO,1EL100,1WE0,1TP,1WE1,1TP,1ST,1WS", machine=machine)
    assert armed.output == ["01 100", "01 600"]


def test_a_mark_that_the_machine_does_not_have(mccl: Runner) -> None:
    result = mccl("1MN,1MR100,1FI0,1TP")
    assert result.status == "fault"
    assert result.diagnostics[0].code == "never"
    assert "index mark of axis 1" in result.diagnostics[0].message


def test_the_settings_of_a_joystick_apply_to_an_axis_that_follows_it(mccl: Runner) -> None:
    """Of 5 V: JG times the voltage beyond JO, none within JB or below JV."""
    text = "1MN,1JA1000000,1JN,WA1,1TV," + "".join(
        f"1{setting},WA1,1TV," for setting in ("JG2000", "JO1", "JB4.5", "JB0", "JV9000", "JV0", "JG0")
    )
    run = mccl(text, analog="1=50@0")
    assert [int(each.split()[1]) for each in run.output] == [5000, 10000, 8000, 0, 8000, 0, 8000, 0]


def test_a_joystick(mccl: Runner) -> None:
    """50 percent are 5 V, less an offset of 1 V: 4 V at 100 counts/s per volt."""
    result = mccl(
        "1MN,1JA1000000,1JG100,1JO1,1JB0.5,1JN,WA1,1TV,1JF,1WS,1TS1",
        machine={"analogue": [{"channel": 1, "value": 50.0, "at": 0.0, "for": 3.0}]},
    )
    assert result.output == ["01 400", "01 1"]


def test_a_joystick_that_is_not_enabled_moves_nothing(mccl: Runner) -> None:
    """5 percent are 0.5 V: 5 counts/s from JN on. Axis 8 has no joystick."""
    levels: list[dict[str, object]] = [{"channel": n, "value": 5.0, "at": 0.1 * n} for n in (1, 8)]
    text = "1MN,1JA1000000,1JG10,WA1,1TP,1JN,WA0.2,1TV"
    assert mccl(text, machine={"analogue": levels}).output == ["01 0", "01 5"]


def test_an_output_applies_to_a_motor_that_is_on(mccl: Runner) -> None:
    """In torque mode SQ is the output in volts. A motor that is off coasts."""
    machine = {"axis.1.plant.inertia": 2e-4}
    text = "1QM,1SQ2,WA0.1,1TP\n1MN,WA0.05,1MF,1SQ{},WA1,1TP"
    (first, coasts), (_, also) = (mccl(text.format(volts), machine=machine).output for volts in (2, 5))
    assert first == "01 0"
    assert coasts == also != first


def test_a_program_with_waits_on_inputs(mccl: Runner) -> None:
    result = mccl("WN7,TC7,WF7,TC7", machine={"input": [{"channel": 7, "at": 1.0, "for": 0.5}]})
    assert result.output == ["07 1", "07 0"]
    assert result.time == pytest.approx(1.5, abs=1e-4)


def test_a_wait_that_no_input_can_end(mccl: Runner) -> None:
    result = mccl("1TP\nWN7,1TP")
    assert result.output == ["01 0"]
    assert result.diagnostics[0].code == "never"
    assert "channel 7" in result.diagnostics[0].message
    assert result.diagnostics[0].line == 2


def test_a_model_in_any_case(mccl: Runner) -> None:
    machine: dict[str, object] = {"controller.model": "DCX-PCI300"}
    assert (
        mccl("CN10,1TP", machine=machine).output
        == mccl("CN10,1TP", machine={"controller.model": "dcx-pci300"}).output
    )
    assert check(Source("a.mccl", "CN10"), DIALECT, machine) == []


def test_an_unknown_model(mccl: Runner) -> None:
    result = mccl("1TP", machine={"controller.model": "mintmt"})
    assert [each.code for each in result.diagnostics] == ["machine-file"]
    assert "multiflex" in result.diagnostics[0].hint


def test_registers_can_be_given_from_outside(mccl: Runner) -> None:
    assert mccl("TR10,TR0", overrides={"R10": 5.0, "r0": 2.5}).output == ["5", "2.500000"]
    wrong = mccl("TR10", overrides={"SPEED": 5.0})
    assert [each.code for each in wrong.diagnostics] == ["unknown-word"]


def test_a_fault_when_the_program_comes_to_a_line(mccl: Runner) -> None:
    fault = {"axis": 1, "kind": "following-error", "line": 3}
    result = mccl("1MN,1SV10,1SA1000,1SD1000\n1MR1000\nWA0.5\n1TP", machine={"fault": [fault]})
    assert result.controller.faults(1) != 0
    assert result.controller.log.moves[0].ended == "fault"
