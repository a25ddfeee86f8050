"""The class `Mcapi` with a method for every function, and the structures.

Written by `python -m tests.mcapi_files`, not by hand.
"""

# ruff: noqa
# fmt: off

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motionlang.mcapi.client import Binding, Structure


def _flat(values: Sequence[float]) -> list[float]:
    """Return an array as it is sent: its length, then its values."""
    return [len(values), *values]


class MCAXISCONFIG(Structure):
    """The structure MCAXISCONFIG."""

    cbSize: int
    ModuleType: int
    ModuleLocation: int
    MotorType: int
    CaptureModes: int
    CapturePoints: int
    CaptureAndCompare: int
    HighRate: float
    MediumRate: float
    LowRate: float
    HighStepMin: float
    HighStepMax: float
    MediumStepMin: float
    MediumStepMax: float
    LowStepMin: float
    LowStepMax: float
    AuxEncoder: int


class MCCOMMUTATION(Structure):
    """The structure MCCOMMUTATION."""

    cbSize: int
    PhaseA: float
    PhaseB: float
    Divisor: int
    PreScale: int
    Repeat: int


class MCCONTOUR(Structure):
    """The structure MCCONTOUR."""

    VectorAccel: float
    VectorDecel: float
    VectorVelocity: float
    VelocityOverride: float


class MCFILTEREX(Structure):
    """The structure MCFILTEREX."""

    cbSize: int
    Gain: float
    IntegralGain: float
    IntegrationLimit: float
    IntegralOption: int
    DerivativeGain: float
    DerSamplePeriod: float
    FollowingError: float
    VelocityGain: float
    AccelGain: float
    DecelGain: float
    EncoderScaling: float
    UpdateRate: int
    PositionDeadband: float
    DelayAtTarget: float
    OutputOffset: float
    OutputDeadband: float


class MCFILTER(Structure):
    """The structure MCFILTER."""

    DerivativeGain: float
    DerSamplePeriod: float
    IntegralGain: float
    IntegrationLimit: float
    VelocityGain: float
    AccelGain: float
    DecelGain: float
    FollowingError: float


class MCJOGEX(Structure):
    """The structure MCJOGEX."""

    cbSize: int
    Acceleration: float
    MinVelocity: float
    Deadband: float
    Gain: float
    Offset: float
    Channel: int


class MCJOG(Structure):
    """The structure MCJOG."""

    Acceleration: float
    MinVelocity: float
    Deadband: float
    Gain: float
    Offset: float


class MCMOTIONEX(Structure):
    """The structure MCMOTIONEX."""

    cbSize: int
    Acceleration: float
    Deceleration: float
    Velocity: float
    MinVelocity: float
    Direction: int
    Torque: float
    Deadband: float
    DeadbandDelay: float
    StepSize: int
    Current: int
    HardLimitMode: int
    SoftLimitMode: int
    SoftLimitLow: float
    SoftLimitHigh: float
    EnableAmpFault: int


class MCMOTION(Structure):
    """The structure MCMOTION."""

    Acceleration: float
    Deceleration: float
    Velocity: float
    MinVelocity: float
    Direction: int
    Gain: float
    Torque: float
    Deadband: float
    DeadbandDelay: float
    StepSize: int
    Current: int
    HardLimitMode: int
    SoftLimitMode: int
    SoftLimitLow: float
    SoftLimitHigh: float
    EnableAmpFault: int
    Rate: int


class MCPARAMEX(Structure):
    """The structure MCPARAMEX."""

    cbSize: int
    ID: int
    ControllerType: int
    NumberAxes: int
    MaximumAxes: int
    MaximumModules: int
    Precision: int
    DigitalIO: int
    AnalogInput: int
    AnalogOutput: int
    PointStorage: int
    CanDoScaling: int
    CanDoContouring: int
    CanChangeProfile: int
    CanChangeRates: int
    SoftLimits: int
    MultiTasking: int
    AmpFault: int
    AnalogInpMin: float
    AnalogInpMax: float
    AnalogInpRes: int
    AnalogOutMin: float
    AnalogOutMax: float
    AnalogOutRes: int
    OutputMode: int
    AtTarget: int
    OutputControl: int
    LineModeAscii: int


class MCPARAM(Structure):
    """The structure MCPARAM."""

    ID: int
    ControllerType: int
    NumberAxes: int
    DigitalIO: int
    AnalogInput: int
    AnalogOutput: int
    AxisType: list[int]
    PointStorage: int
    CanDoScaling: int
    CanDoContouring: int
    CanChangeProfile: int
    CanChangeRates: int
    SoftLimits: int
    MultiTasking: int
    AmpFault: int


class MCSCALE(Structure):
    """The structure MCSCALE."""

    Constant: float
    Offset: float
    Rate: float
    Scale: float
    Zero: float
    Time: float


class MCSTATUSEX(Structure):
    """The structure MCSTATUSEX."""

    cbSize: int
    Status: int
    AuxStatus: int
    ProfileStatus: int
    ModeStatus: int


class Mcapi(Binding):
    """MCAPI as PMC's Python binding has it, without the library."""

    def Abort(self, axis: int) -> None:
        """Stop the axis at once; the motor stays on."""
        self._do("MCAbort", int(axis))

    def ArcCenter(self, axis: int, type: int, position: float) -> None:
        """Call MCArcCenter.

        Centre of the arc of the contour path that a block describes, absolute (0) or from its start (1).
        """
        self._do("MCArcCenter", int(axis), int(type), position)

    def ArcEndAngle(self, axis: int, type: int, angle: float) -> None:
        """Ending angle of the arc, degrees, absolute (0) or from its start (1)."""
        self._do("MCArcEndAngle", int(axis), int(type), angle)

    def ArcRadius(self, axis: int, radius: float) -> None:
        """Radius of the arc."""
        self._do("MCArcRadius", int(axis), radius)

    def BlockBegin(self, mode: int, num: int) -> None:
        """Call MCBlockBegin.

        Collect the commands that follow: 0 a compound line, 1 a task, 2 macro num, 5 to 8 a contour path
        under axis num. 3 clears all macros and 4 discards the block; both act at once and need no end.
        """
        self._do("MCBlockBegin", int(mode), int(num))

    def BlockEnd(self) -> int:
        """Carry out the block; the result is the number of a task."""
        found: int = self._get("MCBlockEnd", 1)
        return found

    def CancelTask(self, taskID: int) -> None:
        """End a background task."""
        self._do("MCCancelTask", int(taskID))

    def CaptureData(self, axis: int, points: int, period: float, delay: float) -> None:
        """Call MCCaptureData.

        Record points; period and delay have no effect, because the period is 1 ms.
        """
        self._do("MCCaptureData", int(axis), int(points), period, delay)

    def ConfigureCompare(self, axis: int, values: list[float], num: int, inc: float, mode: int, period: float) -> None:
        """Call MCConfigureCompare, which is not supported: error 11."""
        self._do("MCConfigureCompare", int(axis), *_flat(values), int(num), inc, int(mode), period)

    def ConfigureDigitalIO(self, channel: int, mode: int) -> int:
        """Make the channel an input (1) or output (2), active high (4) or low (8)."""
        return self._value("MCConfigureDigitalIO", int(channel), int(mode))

    def ContourDistance(self, axis: int, distance: float) -> None:
        """Length along a user-defined path."""
        self._do("MCContourDistance", int(axis), distance)

    def ContourPath(self, axis: int, wMode: int, buffer: str) -> None:
        """Call MCContourPath.

        Carry out the commands in the text as one path of kind 1 line, 2 clockwise or 3 anticlockwise arc.
        """
        self._do("MCContourPath", int(axis), int(wMode), buffer)

    def DecodeStatus(self, status: int, bit: int) -> int:
        """Call MCDecodeStatus.

        1 if the flag of the list MC_STAT is set in a primary status word of this model.
        """
        return self._value("MCDecodeStatus", int(status), int(bit))

    def DecodeStatusEx(self, status: MCSTATUSEX, bit: int) -> int:
        """1 if the flag is set in the four words."""
        return self._value("MCDecodeStatusEx", *_flat(status.values()), int(bit))

    def Direction(self, axis: int, dir: int) -> None:
        """Direction of velocity mode, 1 positive or 2 negative."""
        self._do("MCDirection", int(axis), int(dir))

    def EdgeArm(self, axis: int, position: float) -> None:
        """Arm the capture of the home edge."""
        self._do("MCEdgeArm", int(axis), position)

    def EnableAxis(self, axis: int, state: int) -> None:
        """Switch the axis on or off."""
        self._do("MCEnableAxis", int(axis), int(state))

    def EnableBacklash(self, axis: int, backlash: float, state: int) -> None:
        """Switch backlash compensation on or off."""
        self._do("MCEnableBacklash", int(axis), backlash, int(state))

    def EnableCapture(self, axis: int, count: int) -> None:
        """Call MCEnableCapture, which is not supported: error 11."""
        self._do("MCEnableCapture", int(axis), int(count))

    def EnableCompare(self, axis: int, count: int) -> None:
        """Call MCEnableCompare, which is not supported: error 11."""
        self._do("MCEnableCompare", int(axis), int(count))

    def EnableDigitalFilter(self, axis: int, state: int) -> None:
        """Call MCEnableDigitalFilter, which is not supported: error 11."""
        self._do("MCEnableDigitalFilter", int(axis), int(state))

    def EnableDigitalIO(self, channel: int, state: int) -> None:
        """Switch an output channel on or off."""
        self._do("MCEnableDigitalIO", int(channel), int(state))

    def EnableEncoderFault(self, axis: int, state: int) -> None:
        """Call MCEnableEncoderFault, which is not supported: error 11."""
        self._do("MCEnableEncoderFault", int(axis), int(state))

    def EnableGearing(self, axis: int, master: int, ratio: float, state: int) -> None:
        """Slave the axis to its master, or release it."""
        self._do("MCEnableGearing", int(axis), int(master), ratio, int(state))

    def EnableInterrupt(self, hWnd: int, axis: int, mask: int, lpIntFunc: object) -> None:
        """Call MCEnableInterrupt, which is not supported: error 11."""
        self._do("MCEnableInterrupt", int(hWnd), int(axis), int(mask), 1)

    def EnableJog(self, axis: int, state: int) -> None:
        """Switch jogging by the joystick on or off."""
        self._do("MCEnableJog", int(axis), int(state))

    def EnableSync(self, axis: int, state: int) -> None:
        """Let contour paths wait for MCGoEx, or not."""
        self._do("MCEnableSync", int(axis), int(state))

    def ErrorNotify(self, hWnd: int, errormask: int) -> None:
        """Call MCErrorNotify, which is not supported: error 11."""
        self._do("MCErrorNotify", int(hWnd), int(errormask))

    def FindAuxEncIdx(self, axis: int, position: float) -> None:
        """Call MCFindAuxEncIdx.

        Wait for the index mark of the auxiliary encoder and set the position there.
        """
        self._do("MCFindAuxEncIdx", int(axis), position)

    def FindEdge(self, axis: int, position: float) -> None:
        """Wait for the home edge and set the position there."""
        self._do("MCFindEdge", int(axis), position)

    def FindIndex(self, axis: int, position: float) -> None:
        """Wait for the index mark and set the position there."""
        self._do("MCFindIndex", int(axis), position)

    def GetAccelerationEx(self, axis: int) -> float:
        """Acceleration of moves (SA)."""
        found: float = self._get("MCGetAccelerationEx", int(axis), 1)
        return found

    def GetAnalog(self, channel: int) -> int:
        """An analogue input as 12 bits over ±10 V."""
        return self._value("MCGetAnalog", int(channel))

    def GetAnalogEx(self, channel: int) -> int:
        """An analogue input as 12 bits over ±10 V."""
        found: int = self._get("MCGetAnalogEx", int(channel), 1)
        return found

    def GetAuxEncIdxEx(self, axis: int) -> float:
        """Position of the auxiliary encoder at its index."""
        found: float = self._get("MCGetAuxEncIdxEx", int(axis), 1)
        return found

    def GetAuxEncPosEx(self, axis: int) -> float:
        """Position of the auxiliary encoder."""
        found: float = self._get("MCGetAuxEncPosEx", int(axis), 1)
        return found

    def GetAxisConfiguration(self, axis: int, axiscfg: MCAXISCONFIG) -> None:
        """The module that the model has for the axis."""
        self._fill(axiscfg, "MCGetAxisConfiguration", int(axis), 1)

    def GetBreakpointEx(self, axis: int) -> float:
        """Position of the breakpoint, 0 if there is none."""
        found: float = self._get("MCGetBreakpointEx", int(axis), 1)
        return found

    def GetCaptureData(self, axis: int, type: int, start: int, points: int) -> list[Any]:
        """Recorded points: 16 actual, 32 error, 64 optimal, 128 torque."""
        return list(self._do("MCGetCaptureData", int(axis), int(type), int(start), int(points), 1))

    def GetCaptureSettings(self, axis: int) -> tuple[Any, ...]:
        """Settings of the last recording, and its number of points."""
        return self._do("MCGetCaptureSettings", int(axis), 1, 1, 1, 1)

    def GetConfiguration(self, param: MCPARAM) -> None:
        """Capabilities of the model; for hosts older than MCGetConfigurationEx."""
        self._fill(param, "MCGetConfiguration", 1)

    def GetConfigurationEx(self, param: MCPARAMEX) -> None:
        """Capabilities of the model."""
        self._fill(param, "MCGetConfigurationEx", 1)

    def GetContourConfig(self, axis: int, contour: MCCONTOUR) -> None:
        """Vector settings of the axis (VA, VD, VV, VO)."""
        self._fill(contour, "MCGetContourConfig", int(axis), 1)

    def GetContouringCount(self, axis: int) -> int:
        """Number of contour paths carried out."""
        return self._value("MCGetContouringCount", int(axis))

    def GetCount(self, axis: int, type: int) -> int:
        """4: contour paths carried out, 32: points recorded."""
        found: int = self._get("MCGetCount", int(axis), int(type), 1)
        return found

    def GetDecelerationEx(self, axis: int) -> float:
        """Deceleration of moves (DS)."""
        found: float = self._get("MCGetDecelerationEx", int(axis), 1)
        return found

    def GetDigitalFilter(self, axis: int, coeff: list[float], num: int, actual: object = None) -> list[Any]:
        """Call MCGetDigitalFilter, which is not supported: error 11."""
        return list(self._do("MCGetDigitalFilter", int(axis), 1, int(num), 1))

    def GetDigitalIO(self, channel: int) -> int:
        """1 if the channel is on."""
        return self._value("MCGetDigitalIO", int(channel))

    def GetDigitalIOConfig(self, channel: int) -> int:
        """Direction and logic of the channel, as MCConfigureDigitalIO takes them."""
        found: int = self._get("MCGetDigitalIOConfig", int(channel), 1)
        return found

    def GetDigitalIOEx(self, channel: int) -> int:
        """1 if the channel is on."""
        found: int = self._get("MCGetDigitalIOEx", int(channel), 1)
        return found

    def GetFilterConfig(self, axis: int, filter: MCFILTER) -> None:
        """Settings of the servo loop, without gain."""
        self._fill(filter, "MCGetFilterConfig", int(axis), 1)

    def GetFilterConfigEx(self, axis: int, filter: MCFILTEREX) -> None:
        """Settings of the servo loop."""
        self._fill(filter, "MCGetFilterConfigEx", int(axis), 1)

    def GetFollowingError(self, axis: int) -> float:
        """Optimal minus actual position."""
        found: float = self._get("MCGetFollowingError", int(axis), 1)
        return found

    def GetGain(self, axis: int) -> float:
        """Proportional gain."""
        found: float = self._get("MCGetGain", int(axis), 1)
        return found

    def GetIndexEx(self, axis: int) -> float:
        """Position at which the index was last seen."""
        found: float = self._get("MCGetIndexEx", int(axis), 1)
        return found

    def GetInstalledModules(self, size: int = 16) -> list[Any]:
        """Codes of the modules by site; 15 is an empty site."""
        return list(self._do("MCGetInstalledModules", 1, int(size)))

    def GetJogConfig(self, axis: int, jog: MCJOG) -> None:
        """Joystick settings."""
        self._fill(jog, "MCGetJogConfig", int(axis), 1)

    def GetJogConfigEx(self, axis: int, jog: MCJOGEX) -> None:
        """Joystick settings; the channel is the number of the axis."""
        self._fill(jog, "MCGetJogConfigEx", int(axis), 1)

    def GetLimits(self, axis: int) -> tuple[Any, ...]:
        """Modes and positions of the limits (LM, LN, HL, LL)."""
        return self._do("MCGetLimits", int(axis), 1, 1, 1, 1)

    def GetModuleInputMode(self, axis: int) -> int:
        """Input mode (IM)."""
        found: int = self._get("MCGetModuleInputMode", int(axis), 1)
        return found

    def GetModuleOutputMode(self, axis: int) -> int:
        """Output mode (OM)."""
        found: int = self._get("MCGetModuleOutputMode", int(axis), 1)
        return found

    def GetMotionConfig(self, axis: int, motion: MCMOTION) -> None:
        """Settings of motion, with gain and rate."""
        self._fill(motion, "MCGetMotionConfig", int(axis), 1)

    def GetMotionConfigEx(self, axis: int, motion: MCMOTIONEX) -> None:
        """Settings of motion."""
        self._fill(motion, "MCGetMotionConfigEx", int(axis), 1)

    def GetOperatingMode(self, axis: int) -> int:
        """0 contour, 1 gain, 2 position, 3 torque, 4 velocity."""
        found: int = self._get("MCGetOperatingMode", int(axis), 1)
        return found

    def GetOptimalEx(self, axis: int) -> float:
        """Position of the trajectory."""
        found: float = self._get("MCGetOptimalEx", int(axis), 1)
        return found

    def GetPositionEx(self, axis: int) -> float:
        """Actual position."""
        found: float = self._get("MCGetPositionEx", int(axis), 1)
        return found

    def GetProfile(self, axis: int) -> int:
        """1 trapezoid, 2 S-curve, 4 parabola."""
        found: int = self._get("MCGetProfile", int(axis), 1)
        return found

    def GetRegister(self, reg: int, type: int) -> Any:
        """A register; 0 to 9 are those of the interface."""
        return self._get("MCGetRegister", int(reg), 1, int(type))

    def GetScale(self, axis: int, scale: MCSCALE) -> None:
        """User units, also those that wait for the next MN."""
        self._fill(scale, "MCGetScale", int(axis), 1)

    def GetServoOutputPhase(self, axis: int) -> int:
        """Output phase (PH)."""
        found: int = self._get("MCGetServoOutputPhase", int(axis), 1)
        return found

    def GetStatus(self, axis: int) -> int:
        """Primary status word."""
        return self._value("MCGetStatus", int(axis))

    def GetStatusEx(self, axis: int, status: MCSTATUSEX) -> None:
        """The four status words; the last three are 0 on a model with one."""
        self._fill(status, "MCGetStatusEx", int(axis), 1)

    def GetTargetEx(self, axis: int) -> float:
        """Target."""
        found: float = self._get("MCGetTargetEx", int(axis), 1)
        return found

    def GetTorque(self, axis: int) -> float:
        """Torque limit, as it was set."""
        found: float = self._get("MCGetTorque", int(axis), 1)
        return found

    def GetTrajectoryRate(self, axis: int = 0) -> int:
        """Call MCGetTrajectoryRate, which is not supported: error 11."""
        found: int = self._get("MCGetTrajectoryRate", 1)
        return found

    def GetVectorVelocity(self, axis: int) -> float:
        """Vector velocity (VV)."""
        found: float = self._get("MCGetVectorVelocity", int(axis), 1)
        return found

    def GetVelocityActual(self, axis: int) -> float:
        """Actual velocity."""
        found: float = self._get("MCGetVelocityActual", int(axis), 1)
        return found

    def GetVelocityEx(self, axis: int) -> float:
        """Velocity of moves (SV)."""
        found: float = self._get("MCGetVelocityEx", int(axis), 1)
        return found

    def GetVelocityOverride(self, axis: int) -> float:
        """Override of contour paths (VO)."""
        found: float = self._get("MCGetVelocityOverride", int(axis), 1)
        return found

    def GetVersion(self) -> int:
        """263169: version 4.4.1, one byte per number, the third byte first."""
        return self._value("MCGetVersion")

    def Go(self, axis: int) -> None:
        """Run in velocity mode, or release contour paths."""
        self._do("MCGo", int(axis))

    def GoEx(self, axis: int, param: float) -> None:
        """Call MCGoEx.

        Run in velocity mode, or release contour paths; the parameter has no effect.
        """
        self._do("MCGoEx", int(axis), param)

    def GoHome(self, axis: int) -> None:
        """Move to position 0."""
        self._do("MCGoHome", int(axis))

    def IndexArm(self, axis: int, position: float) -> None:
        """Arm the capture of the index mark."""
        self._do("MCIndexArm", int(axis), position)

    def InterruptOnPosition(self, axis: int, mode: int, position: float) -> None:
        """Set a breakpoint, absolute (0) or relative (1): status bit 10 shows it."""
        self._do("MCInterruptOnPosition", int(axis), int(mode), position)

    def IsAtTarget(self, axis: int, timeout: float) -> int:
        """1 when the axis is at target; waits up to the time-out."""
        return self._is("MCIsAtTarget", int(axis), timeout)

    def IsDigitalFilter(self, axis: int) -> int:
        """Call MCIsDigitalFilter, which is not supported: error 11."""
        return self._is("MCIsDigitalFilter", int(axis))

    def IsEdgeFound(self, axis: int, timeout: float) -> int:
        """1 when the home edge has been found; waits up to the time-out."""
        return self._is("MCIsEdgeFound", int(axis), timeout)

    def IsIndexFound(self, axis: int, timeout: float) -> int:
        """1 when the index mark has been found; waits up to the time-out."""
        return self._is("MCIsIndexFound", int(axis), timeout)

    def IsStopped(self, axis: int, timeout: float) -> int:
        """Call MCIsStopped.

        1 when the trajectory is complete; waits up to the time-out, and blocks no other client.
        """
        return self._is("MCIsStopped", int(axis), timeout)

    def LearnPoint(self, axis: int, index: int, mode: int) -> None:
        """Learn the position (1) or target (2)."""
        self._do("MCLearnPoint", int(axis), int(index), int(mode))

    def MacroCall(self, macro: int) -> None:
        """Carry out a macro."""
        self._do("MCMacroCall", int(macro))

    def MoveAbsolute(self, axis: int, position: float) -> None:
        """Move to a position."""
        self._do("MCMoveAbsolute", int(axis), position)

    def MoveRelative(self, axis: int, distance: float) -> None:
        """Move by a distance from the target."""
        self._do("MCMoveRelative", int(axis), distance)

    def MoveToPoint(self, axis: int, index: int) -> None:
        """Move to a learned point."""
        self._do("MCMoveToPoint", int(axis), int(index))

    def Reopen(self, newmode: int) -> None:
        """Change the mode of a handle."""
        self._do("MCReopen", int(newmode))

    def Repeat(self, count: int) -> None:
        """Repeat the block so far; only in a block."""
        self._do("MCRepeat", int(count))

    def Reset(self, axis: int, distance: float = 0.0) -> None:
        """Reset the axis, or the whole board for axis 0."""
        self._do("MCReset", int(axis))

    def SetAcceleration(self, axis: int, rate: float) -> None:
        """Acceleration of moves."""
        self._do("MCSetAcceleration", int(axis), rate)

    def SetAnalog(self, channel: int, value: int) -> None:
        """An analogue output as 12 bits over ±10 V; changes the accumulator."""
        self._do("MCSetAnalog", int(channel), int(value))

    def SetAnalogEx(self, channel: int, value: int) -> None:
        """An analogue output as 12 bits over ±10 V; changes the accumulator."""
        self._do("MCSetAnalogEx", int(channel), int(value))

    def SetAuxEncPos(self, axis: int, position: float) -> None:
        """Set the position of the auxiliary encoder."""
        self._do("MCSetAuxEncPos", int(axis), position)

    def SetCommutation(self, axis: int, commutation: MCCOMMUTATION) -> None:
        """Call MCSetCommutation, which is not supported: error 11."""
        self._do("MCSetCommutation", int(axis), *_flat(commutation.values()))

    def SetContourConfig(self, axis: int, contour: MCCONTOUR) -> None:
        """Vector settings of the axis."""
        self._do("MCSetContourConfig", int(axis), *_flat(contour.values()))

    def SetDeceleration(self, axis: int, rate: float) -> None:
        """Deceleration of moves."""
        self._do("MCSetDeceleration", int(axis), rate)

    def SetDigitalFilter(self, axis: int, coeff: list[float], num: int) -> None:
        """Call MCSetDigitalFilter, which is not supported: error 11."""
        self._do("MCSetDigitalFilter", int(axis), *_flat(coeff), int(num))

    def SetFilterConfig(self, axis: int, filter: MCFILTER) -> None:
        """Settings of the servo loop, without gain."""
        self._do("MCSetFilterConfig", int(axis), *_flat(filter.values()))

    def SetFilterConfigEx(self, axis: int, filter: MCFILTEREX) -> None:
        """Settings of the servo loop."""
        self._do("MCSetFilterConfigEx", int(axis), *_flat(filter.values()))

    def SetGain(self, axis: int, gain: float) -> None:
        """Proportional gain."""
        self._do("MCSetGain", int(axis), gain)

    def SetJogConfig(self, axis: int, jog: MCJOG) -> None:
        """Joystick settings."""
        self._do("MCSetJogConfig", int(axis), *_flat(jog.values()))

    def SetJogConfigEx(self, axis: int, jog: MCJOGEX) -> None:
        """Joystick settings; the channel has no effect."""
        self._do("MCSetJogConfigEx", int(axis), *_flat(jog.values()))

    def SetLimits(self, axis: int, hardlimitmode: int, softlimitmode: int, softlimitminus: float, softlimitplus: float) -> None:
        """Modes and positions of the limits."""
        self._do("MCSetLimits", int(axis), int(hardlimitmode), int(softlimitmode), softlimitminus, softlimitplus)

    def SetModuleInputMode(self, axis: int, Mode: int) -> None:
        """Input mode of a stepper."""
        self._do("MCSetModuleInputMode", int(axis), int(Mode))

    def SetModuleOutputMode(self, axis: int, mode: int) -> None:
        """Output mode."""
        self._do("MCSetModuleOutputMode", int(axis), int(mode))

    def SetMotionConfig(self, axis: int, motion: MCMOTION) -> None:
        """Settings of motion, with gain and rate."""
        self._do("MCSetMotionConfig", int(axis), *_flat(motion.values()))

    def SetMotionConfigEx(self, axis: int, motion: MCMOTIONEX) -> None:
        """Settings of motion."""
        self._do("MCSetMotionConfigEx", int(axis), *_flat(motion.values()))

    def SetOperatingMode(self, axis: int, caxis: int, mode: int) -> None:
        """0 contour under caxis, 1 gain, 2 position, 3 torque, 4 velocity."""
        self._do("MCSetOperatingMode", int(axis), int(caxis), int(mode))

    def SetPosition(self, axis: int, position: float) -> None:
        """Set the current position."""
        self._do("MCSetPosition", int(axis), position)

    def SetProfile(self, axis: int, mode: int) -> None:
        """1 trapezoid, 2 S-curve, 4 parabola."""
        self._do("MCSetProfile", int(axis), int(mode))

    def SetRegister(self, reg: int, value: Any, type: int) -> None:
        """A register, through the accumulator."""
        self._do("MCSetRegister", int(reg), value, int(type))

    def SetScale(self, axis: int, scale: MCSCALE) -> None:
        """User units; those of the axis take effect when it is next switched on."""
        self._do("MCSetScale", int(axis), *_flat(scale.values()))

    def SetServoOutputPhase(self, axis: int, phase: int) -> None:
        """Output phase, 0 standard or 1 reversed."""
        self._do("MCSetServoOutputPhase", int(axis), int(phase))

    def SetTimeoutEx(self, timeout: float) -> float:
        """Seconds after which a call of this handle gives up with 25; 0 is never."""
        found: float = self._get("MCSetTimeoutEx", timeout, 1)
        return found

    def SetTorque(self, axis: int, torque: float) -> None:
        """Torque limit, volts."""
        self._do("MCSetTorque", int(axis), torque)

    def SetTrajectoryRate(self, axis: int, rate: int) -> None:
        """Call MCSetTrajectoryRate, which is not supported: error 11."""
        self._do("MCSetTrajectoryRate", int(rate))

    def SetVectorVelocity(self, axis: int, velocity: float) -> None:
        """Vector velocity."""
        self._do("MCSetVectorVelocity", int(axis), velocity)

    def SetVelocity(self, axis: int, rate: float) -> None:
        """Velocity of moves."""
        self._do("MCSetVelocity", int(axis), rate)

    def SetVelocityOverride(self, axis: int, override: float) -> None:
        """Override of contour paths."""
        self._do("MCSetVelocityOverride", int(axis), override)

    def Stop(self, axis: int) -> None:
        """Stop at the programmed deceleration."""
        self._do("MCStop", int(axis))

    def Wait(self, period: float) -> None:
        """Wait for a time."""
        self._do("MCWait", period)

    def WaitForDigitalIO(self, channel: int, state: int) -> None:
        """Wait until the channel is on or off."""
        self._do("MCWaitForDigitalIO", int(channel), int(state))

    def WaitForEdge(self, axis: int, state: int) -> None:
        """Wait until the home switch is on (1) or off (0)."""
        self._do("MCWaitForEdge", int(axis), int(state))

    def WaitForIndex(self, axis: int) -> None:
        """Wait for the index mark."""
        self._do("MCWaitForIndex", int(axis))

    def WaitForPosition(self, axis: int, position: float) -> None:
        """Wait until the axis passes a position."""
        self._do("MCWaitForPosition", int(axis), position)

    def WaitForRelative(self, axis: int, distance: float) -> None:
        """Wait until the axis has moved this far."""
        self._do("MCWaitForRelative", int(axis), distance)

    def WaitForStop(self, axis: int, period: float) -> None:
        """Wait until the trajectory is complete, then for a time."""
        self._do("MCWaitForStop", int(axis), period)

    def WaitForTarget(self, axis: int, period: float) -> None:
        """Wait until the axis is at target, then for a time."""
        self._do("MCWaitForTarget", int(axis), period)

    def pmccmd(self, size: int, buffer: object) -> None:
        """Call pmccmd, which is not supported: error 11."""
        self._do("pmccmd", int(size), 1)

    def pmccmdex(self, axis: int, command: int, argument: Any | None, type: int) -> None:
        """Carry out the command with this numeric code."""
        self._do("pmccmdex", int(axis), int(command), argument, int(type))

    def pmccmdrpyex(self, axis: int, cmd: int, arg: Any | None, arg_type: int, rpy_type: int) -> Any:
        """pmccmdex, then pmcrpyex."""
        return self._get("pmccmdrpyex", int(axis), int(cmd), arg, int(arg_type), 1, int(rpy_type))

    def pmcgetc(self) -> int:
        """The next character of the ASCII interface, 0 if there is none."""
        return self._value("pmcgetc")

    def pmcgetram(self, offset: int, buffer: object, size: int) -> None:
        """Call pmcgetram, which is not supported: error 11."""
        self._do("pmcgetram", int(offset), 1, int(size))

    def pmcgetramex(self, offset: int, buffer: object, size: int) -> None:
        """Call pmcgetramex, which is not supported: error 11."""
        self._do("pmcgetramex", int(offset), 1, int(size))

    def pmcgets(self, buffer: bytearray, size: int) -> int:
        """Call pmcgets.

        Text of the ASCII interface up to the first CR or prompt; the result is its length. Waits while the
        board is busy.
        """
        return self._text(buffer, "pmcgets", 1, int(size))

    def pmclock(self, wait_msec: int) -> int:
        """Call pmclock.

        Reserve the interface for this handle: 0, or 25 if another has it for longer than the time.
        """
        return self._is("pmclock", int(wait_msec))

    def pmclookupvar(self, varname: str, address: object = None) -> int:
        """Address of a variable of the board, 4 counts apart; valid only here."""
        found: int = self._get("pmclookupvar", varname, 1)
        return found

    def pmcputc(self, character: int) -> int:
        """Send a character to the ASCII interface: 1 if it was taken."""
        return self._value("pmcputc", int(character))

    def pmcputram(self, offset: int, buffer: object, size: int) -> None:
        """Call pmcputram, which is not supported: error 11."""
        self._do("pmcputram", int(offset), 1, int(size))

    def pmcputramex(self, offset: int, buffer: object, size: int) -> None:
        """Call pmcputramex, which is not supported: error 11."""
        self._do("pmcputramex", int(offset), 1, int(size))

    def pmcputs(self, buffer: str) -> int:
        """Send text to the ASCII interface: the number of characters taken."""
        return self._value("pmcputs", buffer)

    def pmcrdy(self) -> int:
        """1 if the interface is idle."""
        return self._value("pmcrdy")

    def pmcrpy(self, size: int, buffer: object) -> None:
        """Call pmcrpy, which is not supported: error 11."""
        self._do("pmcrpy", int(size), 1)

    def pmcrpyex(self, type: int) -> Any:
        """The reply of the last pmccmdex as a number."""
        return self._get("pmcrpyex", 1, int(type))

    def pmcunlock(self) -> None:
        """End pmclock."""
        self._do("pmcunlock")
