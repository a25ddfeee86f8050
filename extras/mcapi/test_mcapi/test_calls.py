"""Calls to a virtual board; the figures are calculated by hand from the profiles."""

from __future__ import annotations

import math

import pytest

import motionlang_mcapi as mc
from motionlang_mcapi import Mcapi, McapiException
from test_mcapi.conftest import opened

# A move of 5000 counts at 100 000 counts/s² never reaches 40 000 counts/s: it takes twice the root of s/a.
SHORT, SHORT_TIME = 5000.0, 2.0 * math.sqrt(5000.0 / 100_000.0)


def test_an_axis_moves_for_the_time_of_its_profile(host: Mcapi) -> None:
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, SHORT)
    began = host.now
    assert host.IsStopped(1, 0.0) == 0
    assert host.IsStopped(1, 10.0) == 1
    # The call before takes a millisecond at least, and the command 10 µs.
    assert host.now - began == pytest.approx(SHORT_TIME, abs=1e-4)
    assert host.GetPositionEx(1) == SHORT
    assert host.GetTargetEx(1) == SHORT


def test_a_poll_ends_at_its_time_out(host: Mcapi) -> None:
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, SHORT)
    host.advance(0.0)
    began = host.now
    assert host.IsStopped(1, 0.1) == 0
    assert host.now - began == pytest.approx(0.1)


def test_half_way_of_a_symmetrical_move(host: Mcapi) -> None:
    """After half the time T, half the distance is covered; the speed is a·T/2."""
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, SHORT)
    began = host.now
    host.advance(SHORT_TIME / 2.0 - (host.now - began) - mc.VirtualBoard().step)
    assert host.GetOptimalEx(1) == pytest.approx(SHORT / 2.0, abs=2.0)
    assert host.GetVelocityActual(1) == pytest.approx(100_000.0 * SHORT_TIME / 2.0, rel=0.01)


def test_a_macro_from_a_block(host: Mcapi) -> None:
    """Macro 1 sets the accumulator; after a reset of the macros a call of it fails."""
    host.BlockBegin(mc.MC_BLOCK_MACRO, 1)
    host.SetRegister(0, 123, mc.MC_TYPE_LONG)
    assert host.BlockEnd() == 0
    host.SetRegister(0, 0, mc.MC_TYPE_LONG)
    host.MacroCall(1)
    assert host.GetRegister(0, mc.MC_TYPE_LONG) == 123
    host.BlockBegin(mc.MC_BLOCK_RESETM, 0)
    with pytest.raises(McapiException):
        host.MacroCall(1)


def test_binary_replies_are_numbers_whatever_the_ascii_form() -> None:
    """4096 is 1000 in hexadecimal, and 255 has no decimal digit."""
    host = opened({"mccl.codes.TP": 20, "mccl.codes.HM": 21, "assumptions.mccl.reply-form": "01=1234"})
    host.SetPosition(1, 255.0)
    host.pmccmdex(0, 21, 0, mc.MC_TYPE_NONE)
    assert host.pmccmdrpyex(1, 20, 0, mc.MC_TYPE_NONE, mc.MC_TYPE_LONG) == 255
    host.SetPosition(1, 4096.0)
    assert host.pmccmdrpyex(1, 20, 0, mc.MC_TYPE_NONE, mc.MC_TYPE_LONG) == 4096


def test_a_compound_block_runs_as_one_line(host: Mcapi) -> None:
    """Nothing moves before the end of the block, whose wait delays the call."""
    host.EnableAxis(1, True)
    host.BlockBegin(mc.MC_BLOCK_COMPOUND, 0)
    host.MoveRelative(1, SHORT)
    host.WaitForStop(1, 0.0)
    host.MoveRelative(1, SHORT)
    host.WaitForStop(1, 0.25)
    assert host.IsStopped(1, 0.0) == 1
    began = host.now
    host.BlockEnd()
    assert host.GetPositionEx(1) == 2.0 * SHORT
    assert host.now - began == pytest.approx(2.0 * SHORT_TIME + 0.25, abs=3e-3)


def test_a_task_runs_in_the_background(host: Mcapi) -> None:
    host.EnableAxis(1, True)
    host.BlockBegin(mc.MC_BLOCK_TASK, 0)
    host.MoveRelative(1, SHORT)
    host.WaitForStop(1, 0.0)
    host.MoveRelative(1, -SHORT)
    task = host.BlockEnd()
    assert task == 1
    host.advance(3.0 * SHORT_TIME)
    assert host.GetPositionEx(1) == 0.0
    with pytest.raises(McapiException):
        host.CancelTask(task)


def test_blocks_start_no_more_tasks_than_a_program_may(host: Mcapi) -> None:
    for k in range(33):
        host.BlockBegin(mc.MC_BLOCK_TASK, 0)
        host.Wait(100.0)
        if k < 32:
            assert host.BlockEnd() == k + 1
    with pytest.raises(McapiException) as caught:
        host.BlockEnd()
    assert caught.value.code == mc.MCERR_RANGE


def test_an_error_that_was_raised_is_not_raised_again(host: Mcapi) -> None:
    """MCDecodeStatus answers 0 for a clear bit and for an error."""
    with pytest.raises(McapiException):
        host.MoveToPoint(1, 4)
    assert host.DecodeStatus(host.GetStatus(1), mc.MC_STAT_BREAKPOINT) == 0
    assert host.GetError() == 0


def test_an_axis_whose_path_waits_has_not_stopped(host: Mcapi) -> None:
    """The paths of different axes run one after another; axis 1 is last."""
    for axis in (1, 2):
        host.EnableAxis(axis, True)
        host.SetOperatingMode(axis, 1, mc.MC_MODE_CONTOUR)
    for axis in (2, 1):
        host.BlockBegin(mc.MC_BLOCK_CONTR_LIN, 1)
        host.MoveRelative(axis, SHORT)
        host.BlockEnd()
    assert (host.IsStopped(1, 0.0), host.IsAtTarget(1, 0.0), host.GetTargetEx(1)) == (0, 0, SHORT)
    assert host.DecodeStatus(host.GetStatus(1), mc.MC_STAT_TRAJ) == 0
    began = host.now
    assert host.IsStopped(1, 10.0) == 1
    assert host.now - began == pytest.approx(2.0 * SHORT_TIME, abs=0.02)
    assert host.GetPositionEx(1) == SHORT


def test_a_quarter_circle_from_a_contour_block(host: Mcapi) -> None:
    """The arc ends on the other axis; its length r·π/2 is covered at vector velocity."""
    radius, velocity, accel = 1000.0, 1000.0, 1e6
    for axis in (1, 2):
        host.EnableAxis(axis, True)
        host.SetOperatingMode(axis, 1, mc.MC_MODE_CONTOUR)
    contour = mc.MCCONTOUR()
    contour.VectorAccel = contour.VectorDecel = accel
    contour.VectorVelocity, contour.VelocityOverride = velocity, 1.0
    host.SetContourConfig(1, contour)
    host.BlockBegin(mc.MC_BLOCK_CONTR_CCW, 1)
    host.ArcCenter(1, mc.MC_ABSOLUTE, -radius)
    host.ArcCenter(2, mc.MC_ABSOLUTE, 0.0)
    host.MoveAbsolute(1, -radius)
    host.MoveAbsolute(2, radius)
    host.BlockEnd()
    began = host.now
    assert host.IsStopped(0, 10.0) == 1
    assert host.now - began == pytest.approx(radius * math.pi / 2.0 / velocity + velocity / accel, abs=3e-3)
    assert (host.GetPositionEx(1), host.GetPositionEx(2)) == (-radius, radius)
    assert host.GetCount(1, mc.MC_COUNT_CONTOUR) == 1


def test_velocity_mode_in_both_directions(host: Mcapi) -> None:
    host.EnableAxis(2, True)
    host.SetOperatingMode(2, 0, mc.MC_MODE_VELOCITY)
    host.SetVelocity(2, 10_000.0)
    host.Direction(2, mc.MC_DIR_NEGATIVE)
    host.GoEx(2, 0.0)
    host.advance(1.0)
    assert host.GetVelocityActual(2) == -10_000.0
    assert host.GetOperatingMode(2) == mc.MC_MODE_VELOCITY
    host.Stop(2)
    assert host.IsStopped(2, 1.0) == 1


def test_settings_of_an_ascii_host_are_read_from_the_board(host: Mcapi) -> None:
    """No value is cached: a structure has the settings that another host has made."""
    port = host.board.console.open(echo=False)
    port.feed(b"1SV1234,1SA5678,1SG0.5,1DB7,1LM6,1LN3,1HL99,1US10,1SQ12345\r")
    host.advance(0.01)
    motion, filter, scale = mc.MCMOTIONEX(), mc.MCFILTEREX(), mc.MCSCALE()
    host.GetMotionConfigEx(1, motion)
    host.GetFilterConfigEx(1, filter)
    host.GetScale(1, scale)
    assert (motion.Velocity, motion.Acceleration, motion.Torque) == (1234.0, 5678.0, 12345.0)
    assert (filter.Gain, filter.PositionDeadband) == (0.5, 7.0)
    assert scale.Scale == 10.0
    # LM6 is smooth for the hard limits and abrupt for the soft ones, in MCAPI 8 and 4; LN3 enables both hard ones.
    assert host.GetLimits(1) == (mc.MC_LIMIT_SMOOTH | mc.MC_LIMIT_BOTH, mc.MC_LIMIT_ABRUPT, 0.0, 99.0)


def test_a_structure_is_read_back(host: Mcapi) -> None:
    motion, found = mc.MCMOTIONEX(), mc.MCMOTIONEX()
    values = [1000.0, 2000.0, 3000.0, 4.0, 2, 5.0, 6.0, 0.7, 2, 2, 11, 7, -8.0, 9.0, 1]
    motion.fill(values)
    host.SetMotionConfigEx(1, motion)
    host.GetMotionConfigEx(1, found)
    assert found.values() == values


def test_a_field_without_a_command_is_skipped() -> None:
    """A DCX-PCI100 has no feed-forward, only one loop rate and only one acceleration.

    FR3 sets its derivative period.
    """
    host = opened({"controller.model": "dcx-pci100"})
    filter, found = mc.MCFILTEREX(), mc.MCFILTEREX()
    filter.Gain, filter.DerivativeGain, filter.DerSamplePeriod = 2211.0, 6000.0, 0.001364
    filter.VelocityGain, filter.UpdateRate, filter.EncoderScaling = 5.0, mc.MC_RATE_LOW, 1.0
    host.SetFilterConfigEx(1, filter)
    host.GetFilterConfigEx(1, found)
    assert (found.Gain, found.DerivativeGain, found.VelocityGain) == (2211.0, 6000.0, 0.0)
    assert found.DerSamplePeriod == pytest.approx(4 * 0.000341)
    host.SetDeceleration(1, 5.0)
    assert host.GetDecelerationEx(1) == host.GetAccelerationEx(1)


def test_scale_takes_effect_when_the_axis_is_switched_on(host: Mcapi) -> None:
    """First the values of PMC's self-test, then 40 counts per unit.

    1000 counts are 25 units, minus both zeros.
    """
    host.EnableAxis(1, False)
    scale, found = mc.MCSCALE(), mc.MCSCALE()
    scale.fill([10.0, 20.0, 30.0, 40.0, 50.0, 1.0])
    host.SetScale(1, scale)
    assert host.GetPositionEx(1) == 0.0
    host.EnableAxis(1, True)
    host.GetScale(1, found)
    assert found.values() == scale.values()
    host.MoveAbsolute(1, 0.0)
    assert host.IsStopped(1, 1000.0) == 1
    port = host.board.console.open(echo=False)
    assert port is not None
    assert host.GetPositionEx(1) == 0.0
    assert host.board.console.board.controller.position(1) == (20.0 + 50.0) * 40.0


def test_status_bits_by_their_names(host: Mcapi) -> None:
    host.EnableAxis(1, False)
    assert host.DecodeStatus(host.GetStatus(1), mc.MC_STAT_MTR_ENABLE) == 0
    host.EnableAxis(1, True)
    assert host.DecodeStatus(host.GetStatus(1), mc.MC_STAT_MTR_ENABLE) == 1
    status = mc.MCSTATUSEX()
    host.GetStatusEx(1, status)
    for flag, wanted in ((mc.MC_STAT_TRAJ, 1), (mc.MC_STAT_MODE_POS, 1), (mc.MC_STAT_MODE_VEL, 0)):
        assert host.DecodeStatusEx(status, flag) == wanted
    host.MoveAbsolute(1, SHORT)
    host.GetStatusEx(1, status)
    assert host.DecodeStatusEx(status, mc.MC_STAT_ACCEL) == 1
    assert host.DecodeStatusEx(status, mc.MC_STAT_TRAJ) == 0


# The capabilities of each model: gains with fractions, scaling, contouring, other profiles, other rates, tasks, a bit
# for the target, and switches of the output.
ABILITIES = {
    "dcx-pc100": (0, 0, 0, 0, 0, 0, 0, 0),
    "dcx-pci100": (0, 1, 1, 0, 0, 1, 0, 0),
    "dcx-at200": (1, 1, 1, 1, 1, 1, 0, 0),
    "dcx-pci300": (1, 1, 1, 1, 1, 1, 0, 0),
    "multiflex": (1, 1, 1, 1, 1, 1, 1, 1),
}


@pytest.mark.parametrize("model", ABILITIES)
def test_the_capabilities_of_a_model(model: str) -> None:
    """Analogue inputs and outputs of every model have 12 bits for -10 V to 10 V."""
    host = opened({"controller.model": model, "controller.axes": 3, "axis.2.motor": "stepper"})
    param, old = mc.MCPARAMEX(), mc.MCPARAM()
    host.GetConfigurationEx(param)
    assert (param.AnalogInpMin, param.AnalogInpMax, param.AnalogInpRes) == (-10.0, 10.0, 12)
    assert (param.AnalogOutMin, param.AnalogOutMax, param.AnalogOutRes) == (-10.0, 10.0, 12)
    precision, *abilities, at_target, switches = ABILITIES[model]
    assert (param.Precision, param.AtTarget, param.OutputControl) == (precision, at_target, switches)
    host.GetConfiguration(old)
    for each in (param, old):
        scaling, contouring = each.CanDoScaling, each.CanDoContouring
        profile, rates = each.CanChangeProfile, each.CanChangeRates
        assert [scaling, contouring, profile, rates, each.MultiTasking] == abilities
        assert (each.ID, each.SoftLimits, each.AmpFault, each.PointStorage) == (0, 1, 1, 256)
    assert list(old.AxisType) == [mc.MC_TYPE_SERVO, mc.MC_TYPE_STEPPER, mc.MC_TYPE_SERVO, 0, 0, 0, 0, 0]


def test_a_board_with_rates_gives_all_three_and_a_stepper_its_three_ranges() -> None:
    """A MultiFlex has loop rates of 4, 2 and 1 kHz; ranges are 1, 1/8, 1/64 of 5 MHz."""
    host, axis = opened({"axis.2.motor": "stepper"}), mc.MCAXISCONFIG()
    host.GetAxisConfiguration(2, axis)
    assert (axis.HighRate, axis.MediumRate, axis.LowRate) == (4000.0, 2000.0, 1000.0)
    assert (axis.HighStepMin, axis.HighStepMax) == (0.0, 5e6)
    assert (axis.MediumStepMax, axis.LowStepMax) == (625_000.0, 78_125.0)


def test_an_ascii_handle_has_its_own_accumulator() -> None:
    """Binary handles share one interface, ASCII handles another."""
    first = opened()
    second, third = Mcapi(first.board), Mcapi(first.board)
    assert second.Open(0, mc.MC_OPEN_BINARY) == 2
    assert third.Open(0, mc.MC_OPEN_ASCII) == 3
    first.SetRegister(0, 11, mc.MC_TYPE_LONG)
    third.pmcputs("AL22\r")
    assert second.GetRegister(0, mc.MC_TYPE_LONG) == 11
    assert third.GetRegister(0, mc.MC_TYPE_LONG) == 22


def test_text_of_a_board_that_ends_lines_with_cr() -> None:
    """The prompt of an older board needs a separate read."""
    host = opened({"controller.model": "dcx-at200"}, mc.MC_OPEN_ASCII)
    buffer = bytearray(255)
    host.pmcputs("TC1\r")
    assert host.pmcgets(buffer, 255) == 5
    assert buffer[:5] == b"01 0\r"
    assert host.pmcgets(buffer, 255) == 1
    assert buffer[:1] == b">"


def test_text_waits_for_the_board() -> None:
    """The answer comes only after the move."""
    host = opened(mode=mc.MC_OPEN_ASCII)
    buffer = bytearray(255)
    host.pmcputs("1MN,1MR5000,1WS,1TP\r")
    assert host.pmcrdy() == 0
    began = host.now
    host.pmcgets(buffer, 255)
    assert buffer.startswith(b"01 5000\n")
    assert host.now - began == pytest.approx(SHORT_TIME, abs=2e-3)
    assert host.pmcrdy() == 1


def test_a_wait_of_the_interface_gives_up_after_the_time_out(host: Mcapi) -> None:
    """The call returns 25, but the board still waits, which delays the next call."""
    assert host.SetTimeoutEx(0.1) == 0.0
    with pytest.raises(McapiException) as caught:
        host.Wait(1.0)
    assert caught.value.code == mc.MCERR_TIMEOUT
    assert host.now == pytest.approx(0.1, abs=5e-3)
    assert host.SetTimeoutEx(0.0) == 0.1
    assert host.GetPositionEx(1) == 0.0
    assert host.now == pytest.approx(1.0, abs=5e-3)


def test_a_reserved_interface(host: Mcapi) -> None:
    """While one handle has reserved it, another waits until its own time-out."""
    other = Mcapi(host.board)
    other.Open(0, mc.MC_OPEN_BINARY)
    assert host.pmclock(0) == 0
    began = host.now
    assert other.pmclock(500) == mc.MCERR_TIMEOUT
    assert host.now - began == pytest.approx(0.5 + 0.001, abs=1e-4)  # a call takes 1 ms
    third = Mcapi(host.board)
    third.Open(0, mc.MC_OPEN_BINARY)
    third.Close()  # not the handle that has it
    assert other.pmclock(50) == mc.MCERR_TIMEOUT
    host.pmcunlock()
    assert other.pmclock(50) == 0
    other.Close()
    assert host.pmclock(50) == 0


def test_a_home_edge_and_its_flag() -> None:
    """At the edge of the switch, 1000, the position becomes 0 while the axis runs."""
    host = opened({"axis.1.home_switch": [1000.0, 1100.0]})
    host.EnableAxis(1, True)
    host.SetOperatingMode(1, 0, mc.MC_MODE_VELOCITY)
    host.SetVelocity(1, 5000.0)
    host.GoEx(1, 0.0)
    host.EdgeArm(1, 0.0)
    assert host.IsEdgeFound(1, 0.0) == 0
    host.WaitForEdge(1, 1)
    assert host.IsEdgeFound(1, 1.0) == 1
    host.Stop(1)
    assert host.IsStopped(1, 1.0) == 1
    # It runs on for v²/2a = 125 counts, and for the milliseconds of the calls in between.
    assert 125.0 <= host.GetPositionEx(1) <= 125.0 + 3.0 * 5.0


def test_a_host_without_a_handle_has_no_share_in_that_of_another() -> None:
    """Both use the same board, on which the first has handle 1."""
    first = opened()
    assert first.GetPositionEx(1) == 0.0
    second = Mcapi(first.board)
    with pytest.raises(McapiException):
        second.GetPositionEx(1)
    second.Close()  # it has nothing to close
    assert first.GetPositionEx(1) == 0.0
