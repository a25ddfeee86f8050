"""The functions and structures of MCAPI 4.4.1, with arguments, MCCL and remarks.

C stubs, the Python class and the page of functions are generated from this table (`tests/mcapi_files.py`). The
dispatcher checks the arguments of a call against it. The implementation of a call is in `calls/`, unless the
column of MCCL is sufficient, such as `aMA{position}`: `a` is the axis, and the braces name the argument that is
the parameter.

Kinds of arguments, after the letters of C: h handle, s short, i int, W unsigned short, D DWORD, u unsigned
int, d double, str text, w window. `>` marks a result. `[n]` after a name is an array whose length is the
argument n, `<type>` a value whose type is the argument `type`. `memory` is never transported. A structure has
its name as its kind. A pointer with `?` may be NULL.

Results of a function: "" for none, a kind followed by `=` for a value, a kind alone for the error code.
"""

from __future__ import annotations

from motionlang.record import record

Value = int | float | str

# Kinds of integers, with their bits; negative is signed.
BITS = {"h": -16, "s": -16, "i": -32, "W": 16, "D": 32, "u": 32, "w": 64}


@record
class Field:
    """A field of a structure: "i", "s", "d" or "D", and its number of elements."""

    kind: str
    name: str
    count: int


@record
class Structure:
    """A structure and its fields; `older` has the field counts of earlier versions."""

    name: str
    fields: tuple[Field, ...]
    older: tuple[int, ...]

    @property
    def has_size(self) -> bool:
        """True if the first field is `cbSize`, which has no influence on results."""
        return self.fields[0].name == "cbSize"

    @property
    def values(self) -> tuple[Field, ...]:
        """The fields that are transported: all but `cbSize`."""
        return self.fields[1:] if self.has_size else self.fields

    @property
    def count(self) -> int:
        """The number of transported values."""
        return len([field for field in self.values for _ in range(field.count)])


@record
class Argument:
    """An argument of a function.

    `size` and `type` name the arguments that hold its length and its type.
    """

    kind: str
    name: str
    out: bool
    size: str
    type: str
    optional: bool


@record
class Function:
    """A row of the table.

    `in_binding` is true if PMC's Python binding has the function. `unsupported` is the reason why a call
    returns MCERR_NOTSUPPORTED, or "".
    """

    name: str
    result: str
    arguments: tuple[Argument, ...]
    mccl: str
    help: str
    in_binding: bool
    unsupported: str

    @property
    def kind(self) -> str:
        """The kind of the result, "" for none."""
        return self.result.rstrip("=")

    @property
    def is_value(self) -> bool:
        """True if the result is a value instead of an error code."""
        return self.result.endswith("=")

    @property
    def has_handle(self) -> bool:
        return self.name not in ("MCOpen", "MCTranslateErrorEx")

    @property
    def inputs(self) -> tuple[Argument, ...]:
        return tuple(each for each in self.arguments if not each.out)

    @property
    def outputs(self) -> tuple[Argument, ...]:
        return tuple(each for each in self.arguments if each.out)


def _structure(name: str, fields: str, older: tuple[int, ...] = ()) -> Structure:
    found, kind = [], "i"
    for word in fields.split():
        if word in ("i", "s", "d", "D"):
            kind = word
        else:
            bare, _, count = word.partition("*")
            found.append(Field(kind, bare, int(count or 1)))
    return Structure(name, tuple(found), older)


_STRUCTURES = (
    _structure("MCAXISCONFIG", "i cbSize ModuleType ModuleLocation MotorType CaptureModes CapturePoints "
               "CaptureAndCompare d HighRate MediumRate LowRate HighStepMin HighStepMax MediumStepMin MediumStepMax "
               "LowStepMin LowStepMax i AuxEncoder", (16,)),
    _structure("MCCOMMUTATION", "i cbSize d PhaseA PhaseB i Divisor PreScale Repeat"),
    _structure("MCCONTOUR", "d VectorAccel VectorDecel VectorVelocity VelocityOverride"),
    _structure("MCFILTEREX", "i cbSize d Gain IntegralGain IntegrationLimit i IntegralOption d DerivativeGain "
               "DerSamplePeriod FollowingError VelocityGain AccelGain DecelGain EncoderScaling i UpdateRate "
               "d PositionDeadband DelayAtTarget OutputOffset OutputDeadband", (13,)),
    _structure("MCFILTER", "d DerivativeGain DerSamplePeriod IntegralGain IntegrationLimit VelocityGain AccelGain "
               "DecelGain FollowingError"),
    _structure("MCJOGEX", "i cbSize d Acceleration MinVelocity Deadband Gain Offset i Channel"),
    _structure("MCJOG", "d Acceleration MinVelocity Deadband Gain Offset"),
    _structure("MCMOTIONEX", "i cbSize d Acceleration Deceleration Velocity MinVelocity i Direction d Torque "
               "Deadband DeadbandDelay i StepSize Current HardLimitMode SoftLimitMode d SoftLimitLow SoftLimitHigh "
               "i EnableAmpFault"),
    _structure("MCMOTION", "d Acceleration Deceleration Velocity MinVelocity s Direction d Gain Torque Deadband "
               "DeadbandDelay s StepSize Current HardLimitMode SoftLimitMode d SoftLimitLow SoftLimitHigh "
               "s EnableAmpFault Rate"),
    _structure("MCPARAMEX", "i cbSize ID ControllerType NumberAxes MaximumAxes MaximumModules Precision DigitalIO "
               "AnalogInput AnalogOutput PointStorage CanDoScaling CanDoContouring CanChangeProfile CanChangeRates "
               "SoftLimits MultiTasking AmpFault d AnalogInpMin AnalogInpMax i AnalogInpRes d AnalogOutMin "
               "AnalogOutMax i AnalogOutRes OutputMode AtTarget OutputControl LineModeAscii", (18, 24, 27)),
    _structure("MCPARAM", "s ID ControllerType NumberAxes DigitalIO AnalogInput AnalogOutput AxisType*8 PointStorage "
               "CanDoScaling CanDoContouring CanChangeProfile CanChangeRates SoftLimits MultiTasking AmpFault"),
    _structure("MCSCALE", "d Constant Offset Rate Scale Zero Time"),
    _structure("MCSTATUSEX", "i cbSize D Status AuxStatus ProfileStatus ModeStatus"),
)  # fmt: skip
STRUCTURES = {each.name: each for each in _STRUCTURES}

_NO_COMPARE = "position compare has no documented command and no documented output"
_NO_FILTER = "the commands of the digital filter are known only by name"
_NO_CAPTURE = "high-speed capture has no documented way to read what it caught"
_NO_MEMORY = "the memory of a board is not documented"
_NO_CODES = "the packets of binary commands are not documented"
_NO_WINDOW = "a virtual board sends no window messages"
_NO_RATE = "the profiles here are exact and have no rate"


def _arguments(text: str) -> tuple[Argument, ...]:
    found = []
    for each in text.split(", ") if text else ():
        kind, _, name = each.partition(" ")
        optional, name = name.endswith("?"), name.rstrip("?")
        name, _, size = name.partition("[")
        name, _, of = name.partition("<")
        found.append(
            Argument(kind.lstrip(">"), name, kind[0] == ">", size.rstrip("]"), of.rstrip(">"), optional)
        )
    return tuple(found)


def _f(
    name: str,
    result: str,
    arguments: str,
    mccl: str,
    help: str,
    *,
    only_c: bool = False,
    unsupported: str = "",
) -> Function:
    return Function(name, result, _arguments(arguments), mccl, help, not only_c, unsupported)


_FUNCTIONS = (
    _f("MCAbort", "", "W axis", "aAB", "Stop the axis at once; the motor stays on."),
    _f("MCArcCenter", "i", "W axis, s type, d position", "aCA, aCR", "Centre of the arc of the contour path that a "
       "block describes, absolute (0) or from its start (1)."),
    _f("MCArcEndAngle", "i", "W axis, s type, d angle", "aEA, aER", "Ending angle of the arc, degrees, absolute (0) "
       "or from its start (1)."),
    _f("MCArcRadius", "i", "W axis, d radius", "aRR{radius}", "Radius of the arc."),
    _f("MCBlockBegin", "i", "i mode, i num", "MD, GT, CP, RM", "Collect the commands that follow: 0 a compound line, "
       "1 a task, 2 macro num, 5 to 8 a contour path under axis num. 3 clears all macros and 4 discards the block; "
       "both act at once and need no end."),
    _f("MCBlockEnd", "i", ">i taskID?", "", "Carry out the block; the result is the number of a task."),
    _f("MCCancelTask", "i", "i taskID", "ET{taskID}", "End a background task."),
    _f("MCCaptureData", "i", "W axis, i points, d period, d delay", "aPR{points}", "Record points; period and delay "
       "have no effect, because the period is 1 ms."),
    _f("MCClose", "s", "", "", "Close the handle and discards its block."),
    _f("MCConfigureCompare", "i", "W axis, d values[num], i num, d inc, i mode, d period", "", "",
       unsupported=_NO_COMPARE),
    _f("MCConfigureDigitalIO", "s=", "W channel, W mode", "CI, CT, CH, CL", "Make the channel an input (1) or output "
       "(2), active high (4) or low (8). The result is 1 for success."),
    _f("MCContourDistance", "i", "W axis, d distance", "aCD{distance}", "Length along a user-defined path."),
    _f("MCContourPath", "i", "W axis, W wMode, str buffer", "aCP", "Carry out the commands in the text as one path of "
       "kind 1 line, 2 clockwise or 3 anticlockwise arc.", only_c=True),
    _f("MCDecodeStatus", "i=", "D status, i bit", "", "1 if the flag of the list MC_STAT is set in a primary status "
       "word of this model."),
    _f("MCDecodeStatusEx", "i=", "MCSTATUSEX status, i bit", "", "1 if the flag is set in the four words."),
    _f("MCDirection", "", "W axis, W dir", "aDI", "Direction of velocity mode, 1 positive or 2 negative."),
    _f("MCEdgeArm", "i", "W axis, d position", "aEL{position}", "Arm the capture of the home edge."),
    _f("MCEnableAxis", "", "W axis, s state", "aMN, aMF", "Switch the axis on or off."),
    _f("MCEnableBacklash", "i", "W axis, d backlash, s state", "aBD, aBN, aBF", "Switch backlash compensation on "
       "or off."),
    _f("MCEnableCapture", "i", "W axis, i count", "", "", unsupported=_NO_CAPTURE),
    _f("MCEnableCompare", "i", "W axis, i count", "", "", unsupported=_NO_COMPARE),
    _f("MCEnableDigitalFilter", "i", "W axis, i state", "", "", unsupported=_NO_FILTER),
    _f("MCEnableDigitalIO", "", "W channel, s state", "CN, CF", "Switch an output channel on or off."),
    _f("MCEnableEncoderFault", "i", "W axis, i state", "", "", unsupported="no command for the detection of encoder "
       "faults is known"),
    _f("MCEnableGearing", "", "W axis, W master, d ratio, s state", "aSS, aSM", "Slave the axis to its master, or "
       "release it."),
    _f("MCEnableInterrupt", "i", "w hWnd, W axis, D mask, memory lpIntFunc", "", "", only_c=True,
       unsupported="a virtual board raises no interrupts in its host"),
    _f("MCEnableJog", "", "W axis, s state", "aJN, aJF", "Switch jogging by the joystick on or off."),
    _f("MCEnableSync", "", "W axis, s state", "aSN, aNS", "Let contour paths wait for MCGoEx, or not."),
    _f("MCErrorNotify", "", "w hWnd, D errormask", "", "", only_c=True, unsupported=_NO_WINDOW),
    _f("MCFindAuxEncIdx", "i", "W axis, d position", "aAF{position}", "Wait for the index mark of the auxiliary "
       "encoder and set the position there."),
    _f("MCFindEdge", "i", "W axis, d position", "aFE{position}", "Wait for the home edge and set the position there."),
    _f("MCFindIndex", "i", "W axis, d position", "aFI{position}", "Wait for the index mark and set the "
       "position there."),
    _f("MCGetAccelerationEx", "i", "W axis, >d acceleration", "", "Acceleration of moves (SA)."),
    _f("MCGetAnalog", "W=", "W channel", "TA", "An analogue input as 12 bits over ±10 V.", only_c=True),
    _f("MCGetAnalogEx", "i", "i channel, >D value", "TA", "An analogue input as 12 bits over ±10 V."),
    _f("MCGetAuxEncIdxEx", "i", "W axis, >d index", "aAZ", "Position of the auxiliary encoder at its index."),
    _f("MCGetAuxEncPosEx", "i", "W axis, >d position", "aAT", "Position of the auxiliary encoder."),
    _f("MCGetAxisConfiguration", "i", "W axis, >MCAXISCONFIG axiscfg", "", "The module that the model has for the "
       "axis."),
    _f("MCGetBreakpointEx", "i", "W axis, >d breakpoint", "aTB", "Position of the breakpoint, 0 if there is none."),
    _f("MCGetCaptureData", "i", "W axis, i type, i start, i points, >d data[points]", "aDO, aDR, aDQ", "Recorded "
       "points: 16 actual, 32 error, 64 optimal, 128 torque."),
    _f("MCGetCaptureSettings", "i", "W axis, >i points, >d period, >d delay, >i index", "aPR", "Settings of the last "
       "recording, and its number of points."),
    _f("MCGetConfiguration", "", ">MCPARAM param", "", "Capabilities of the model; for hosts older than "
       "MCGetConfigurationEx.", only_c=True),
    _f("MCGetConfigurationEx", "i", ">MCPARAMEX param", "", "Capabilities of the model."),
    _f("MCGetContourConfig", "s", "W axis, >MCCONTOUR contour", "", "Vector settings of the axis (VA, VD, VV, VO)."),
    _f("MCGetContouringCount", "i=", "W axis", "aTX", "Number of contour paths carried out.", only_c=True),
    _f("MCGetCount", "i", "W axis, i type, >i count", "aTX, aPR", "4: contour paths carried out, 32: points recorded. "
       "The other counts are of functions that are not supported."),
    _f("MCGetDecelerationEx", "i", "W axis, >d deceleration", "", "Deceleration of moves (DS)."),
    _f("MCGetDigitalFilter", "i", "W axis, >d coeff[num], i num, >i actual", "", "", unsupported=_NO_FILTER),
    _f("MCGetDigitalIO", "s=", "W channel", "TC", "1 if the channel is on.", only_c=True),
    _f("MCGetDigitalIOConfig", "i", "W channel, >W mode", "", "Direction and logic of the channel, as "
       "MCConfigureDigitalIO takes them."),
    _f("MCGetDigitalIOEx", "i", "W channel, >u state", "TC", "1 if the channel is on."),
    _f("MCGetError", "s=", "", "", "The last error of the handle, which it then forgets."),
    _f("MCGetFilterConfig", "s", "W axis, >MCFILTER filter", "", "Settings of the servo loop, without gain.",
       only_c=True),
    _f("MCGetFilterConfigEx", "i", "W axis, >MCFILTEREX filter", "", "Settings of the servo loop. IntegralOption, "
       "which has no command, is 0."),
    _f("MCGetFollowingError", "i", "W axis, >d error", "aTF", "Optimal minus actual position."),
    _f("MCGetGain", "i", "W axis, >d gain", "aTG", "Proportional gain."),
    _f("MCGetIndexEx", "i", "W axis, >d index", "aTZ", "Position at which the index was last seen."),
    _f("MCGetInstalledModules", "i", ">i modules[size], i size", "", "Codes of the modules by site; 15 is an empty "
       "site."),
    _f("MCGetJogConfig", "s", "W axis, >MCJOG jog", "", "Joystick settings.", only_c=True),
    _f("MCGetJogConfigEx", "i", "W axis, >MCJOGEX jog", "", "Joystick settings; the channel is the number of the "
       "axis."),
    _f("MCGetLimits", "i", "W axis, >s hardlimitmode, >s softlimitmode, >d softlimitminus, >d softlimitplus", "",
       "Modes and positions of the limits (LM, LN, HL, LL)."),
    _f("MCGetModuleInputMode", "i", "W axis, >i mode", "", "Input mode (IM)."),
    _f("MCGetModuleOutputMode", "i", "W axis, >W mode", "", "Output mode (OM)."),
    _f("MCGetMotionConfig", "s", "W axis, >MCMOTION motion", "", "Settings of motion, with gain and rate.",
       only_c=True),
    _f("MCGetMotionConfigEx", "i", "W axis, >MCMOTIONEX motion", "", "Settings of motion."),
    _f("MCGetOperatingMode", "i", "W axis, >i mode", "", "0 contour, 1 gain, 2 position, 3 torque, 4 velocity."),
    _f("MCGetOptimalEx", "i", "W axis, >d optimal", "aTO", "Position of the trajectory."),
    _f("MCGetPositionEx", "i", "W axis, >d position", "aTP", "Actual position."),
    _f("MCGetProfile", "i", "W axis, >W profile", "", "1 trapezoid, 2 S-curve, 4 parabola."),
    _f("MCGetRegister", "i", "i reg, >v value<type>, i type", "TR{reg}", "A register; 0 to 9 are those of the "
       "interface."),
    _f("MCGetScale", "s", "W axis, >MCSCALE scale", "", "User units, also those that wait for the next MN."),
    _f("MCGetServoOutputPhase", "i", "W axis, >W phase", "", "Output phase (PH)."),
    _f("MCGetStatus", "D=", "W axis", "aTS", "Primary status word."),
    _f("MCGetStatusEx", "i", "W axis, >MCSTATUSEX status", "aTS0, aTS1, aTS2, aTS3", "The four status words; the last "
       "three are 0 on a model with one."),
    _f("MCGetTargetEx", "i", "W axis, >d target", "aTT", "Target."),
    _f("MCGetTorque", "i", "W axis, >d torque", "aTQ", "Torque limit, as it was set."),
    _f("MCGetTrajectoryRate", "i", ">i rate", "", "", unsupported=_NO_RATE),
    _f("MCGetVectorVelocity", "i", "W axis, >d velocity", "", "Vector velocity (VV)."),
    _f("MCGetVelocityActual", "i", "W axis, >d velocity", "aTV", "Actual velocity."),
    _f("MCGetVelocityEx", "i", "W axis, >d velocity", "", "Velocity of moves (SV)."),
    _f("MCGetVelocityOverride", "i", "W axis, >d override", "", "Override of contour paths (VO)."),
    _f("MCGetVersion", "D=", "", "", "263169: version 4.4.1, one byte per number, the third byte first."),
    _f("MCGo", "", "W axis", "aGO", "Run in velocity mode, or release contour paths.", only_c=True),
    _f("MCGoEx", "i", "W axis, d param", "aGO", "Run in velocity mode, or release contour paths; the parameter has "
       "no effect."),
    _f("MCGoHome", "", "W axis", "aGH", "Move to position 0."),
    _f("MCIndexArm", "i", "W axis, d position", "aIA{position}", "Arm the capture of the index mark."),
    _f("MCInterruptOnPosition", "i", "W axis, i mode, d position", "aIP, aIR", "Set a breakpoint, absolute (0) or "
       "relative (1): status bit 10 shows it."),
    _f("MCIsAtTarget", "i=", "W axis, d timeout", "aTS", "1 when the axis is at target; waits up to the time-out."),
    _f("MCIsDigitalFilter", "i=", "W axis", "", "", unsupported=_NO_FILTER),
    _f("MCIsEdgeFound", "i=", "W axis, d timeout", "aTS", "1 when the home edge has been found; waits up to the "
       "time-out."),
    _f("MCIsIndexFound", "i=", "W axis, d timeout", "aTS", "1 when the index mark has been found; waits up to the "
       "time-out."),
    _f("MCIsStopped", "i=", "W axis, d timeout", "aTS", "1 when the trajectory is complete; waits up to the time-out, "
       "and blocks no other client."),
    _f("MCLearnPoint", "i", "W axis, i index, W mode", "aLP, aLT", "Learn the position (1) or target (2)."),
    _f("MCMacroCall", "", "W macro", "MC{macro}", "Carry out a macro."),
    _f("MCMoveAbsolute", "", "W axis, d position", "aMA{position}", "Move to a position."),
    _f("MCMoveRelative", "", "W axis, d distance", "aMR{distance}", "Move by a distance from the target."),
    _f("MCMoveToPoint", "i", "W axis, i index", "aMP{index}", "Move to a learned point."),
    _f("MCOpen", "h=", "s nID, W mode, str name?", "", "Open a handle: 1 ASCII, 2 binary, plus 32768 for exclusive. "
       "The result is the handle, or minus the error code. Every id from 0 to 15 is the one board; the name has no "
       "effect."),
    _f("MCReopen", "i", "W newmode", "", "Change the mode of a handle."),
    _f("MCRepeat", "i", "i count", "RP{count}", "Repeat the block so far; only in a block."),
    _f("MCReset", "", "W axis", "aRT", "Reset the axis, or the whole board for axis 0."),
    _f("MCSetAcceleration", "", "W axis, d rate", "aSA{rate}", "Acceleration of moves."),
    _f("MCSetAnalog", "", "W channel, W value", "AL, OA", "An analogue output as 12 bits over ±10 V; changes the "
       "accumulator.", only_c=True),
    _f("MCSetAnalogEx", "i", "i channel, D value", "AL, OA", "An analogue output as 12 bits over ±10 V; changes the "
       "accumulator."),
    _f("MCSetAuxEncPos", "", "W axis, d position", "aAH{position}", "Set the position of the auxiliary encoder."),
    _f("MCSetCommutation", "i", "W axis, MCCOMMUTATION commutation", "", "", unsupported="no command for "
       "commutation is known"),
    _f("MCSetContourConfig", "s", "W axis, MCCONTOUR contour", "aVA, aVD, aVV, aVO", "Vector settings of the axis."),
    _f("MCSetDeceleration", "", "W axis, d rate", "aDS{rate}", "Deceleration of moves."),
    _f("MCSetDigitalFilter", "i", "W axis, d coeff[num], i num", "", "", unsupported=_NO_FILTER),
    _f("MCSetFilterConfig", "s", "W axis, MCFILTER filter", "aSD, aFR, aSI, aIL, aVG, aAG, aDG, aSE", "Settings of "
       "the servo loop, without gain.", only_c=True),
    _f("MCSetFilterConfigEx", "i", "W axis, MCFILTEREX filter",
       "aSG, aSI, aIL, aSD, aFR, aSE, aVG, aAG, aDG, aES, aHS, aMS, aLS, aDB, aDT, aOO, aOB", "Settings of the servo "
       "loop. A field for which the model has no command is skipped."),
    _f("MCSetGain", "i", "W axis, d gain", "aSG{gain}", "Proportional gain."),
    _f("MCSetJogConfig", "s", "W axis, MCJOG jog", "aJA, aJV, aJB, aJG, aJO", "Joystick settings.", only_c=True),
    _f("MCSetJogConfigEx", "i", "W axis, MCJOGEX jog", "aJA, aJV, aJB, aJG, aJO", "Joystick settings; the channel has "
       "no effect."),
    _f("MCSetLimits", "i", "W axis, s hardlimitmode, s softlimitmode, d softlimitminus, d softlimitplus",
       "aLL, aHL, aLM, aLF, aLN", "Modes and positions of the limits."),
    _f("MCSetModuleInputMode", "i", "W axis, i Mode", "aIM{Mode}", "Input mode of a stepper."),
    _f("MCSetModuleOutputMode", "", "W axis, W mode", "aOM{mode}", "Output mode."),
    _f("MCSetMotionConfig", "s", "W axis, MCMOTION motion",
       "aSA, aDS, aSV, aMV, aDI, aSG, aSQ, aDB, aDT, aFS, aSH, aFC, aHC, aLM, aLN, aLF, aLL, aHL, aFN, aFF, aHS, aMS, "
       "aLS", "Settings of motion, with gain and rate.", only_c=True),
    _f("MCSetMotionConfigEx", "i", "W axis, MCMOTIONEX motion",
       "aSA, aDS, aSV, aMV, aDI, aSQ, aDB, aDT, aFS, aSH, aFC, aHC, aLM, aLN, aLF, aLL, aHL, aFN, aFF",
       "Settings of motion. A field for which the model has no command is skipped."),
    _f("MCSetOperatingMode", "", "W axis, W caxis, W mode", "aCM, aGM, aPM, aQM, aVM", "0 contour under caxis, 1 gain, "
       "2 position, 3 torque, 4 velocity."),
    _f("MCSetPosition", "", "W axis, d position", "aDH{position}", "Set the current position."),
    _f("MCSetProfile", "", "W axis, W mode", "aPT, aPS, aPP", "1 trapezoid, 2 S-curve, 4 parabola."),
    _f("MCSetRegister", "i", "i reg, v value<type>, i type", "AL, AR", "A register, through the accumulator."),
    _f("MCSetScale", "s", "W axis, MCSCALE scale", "aUK, aUO, aUR, aUS, aUZ, UT", "User units; those of the axis take "
       "effect when it is next switched on."),
    _f("MCSetServoOutputPhase", "", "W axis, W phase", "aPH{phase}", "Output phase, 0 standard or 1 reversed."),
    _f("MCSetTimeoutEx", "i", "d timeout, >d oldtimeOut?", "", "Seconds after which a call of this handle gives up "
       "with 25; 0 is never."),
    _f("MCSetTorque", "i", "W axis, d torque", "aSQ{torque}", "Torque limit, volts."),
    _f("MCSetTrajectoryRate", "i", "i rate", "", "", unsupported=_NO_RATE),
    _f("MCSetVectorVelocity", "i", "W axis, d velocity", "aVV{velocity}", "Vector velocity."),
    _f("MCSetVelocity", "", "W axis, d rate", "aSV{rate}", "Velocity of moves."),
    _f("MCSetVelocityOverride", "i", "W axis, d override", "aVO{override}", "Override of contour paths."),
    _f("MCStop", "", "W axis", "aST", "Stop at the programmed deceleration."),
    _f("MCTranslateErrorEx", "i=", "s nError, >buf buffer[length], i length", "", "The text of an error code."),
    _f("MCWait", "", "d period", "WA{period}", "Wait for a time. Like all functions named MCWait it blocks the "
       "interface."),
    _f("MCWaitForDigitalIO", "", "W channel, s state", "WN, WF", "Wait until the channel is on or off."),
    _f("MCWaitForEdge", "i", "W axis, s state", "aWE", "Wait until the home switch is on (1) or off (0)."),
    _f("MCWaitForIndex", "i", "W axis", "aWI", "Wait for the index mark."),
    _f("MCWaitForPosition", "", "W axis, d position", "aWP{position}", "Wait until the axis passes a position."),
    _f("MCWaitForRelative", "", "W axis, d distance", "aWR{distance}", "Wait until the axis has moved this far."),
    _f("MCWaitForStop", "", "W axis, d period", "aWS{period}", "Wait until the trajectory is complete, then for a "
       "time."),
    _f("MCWaitForTarget", "", "W axis, d period", "aWT{period}", "Wait until the axis is at target, then for a time."),
    _f("pmccmd", "s", "s size, memory buffer", "", "", only_c=True, unsupported=_NO_CODES),
    _f("pmccmdex", "i", "W axis, W command, v argument<type>?, i type", "", "Carry out the command with this numeric "
       "code. Only DW is known to have one, 253; `mccl.codes.XX` in the machine file gives others. A code that is not "
       "known is answered with 11."),
    _f("pmccmdrpyex", "i", "W axis, W cmd, v arg<arg_type>?, i arg_type, >v rpy<rpy_type>, i rpy_type", "",
       "pmccmdex, then pmcrpyex."),
    _f("pmcgetc", "s=", "", "", "The next character of the ASCII interface, 0 if there is none."),
    _f("pmcgetram", "", "W offset, memory buffer, s size", "", "", only_c=True, unsupported=_NO_MEMORY),
    _f("pmcgetramex", "i", "D offset, memory buffer, D size", "", "", unsupported=_NO_MEMORY),
    _f("pmcgets", "s=", ">buf buffer[size], s size", "", "Text of the ASCII interface up to the first CR or prompt; "
       "the result is its length. Waits while the board is busy."),
    _f("pmclock", "D=", "D wait_msec", "", "Reserve the interface for this handle: 0, or 25 if another has it for "
       "longer than the time."),
    _f("pmclookupvar", "i", "str varname, >D address", "LU", "Address of a variable of the board, 4 counts apart; "
       "valid only here."),
    _f("pmcputc", "s=", "s character", "", "Send a character to the ASCII interface: 1 if it was taken."),
    _f("pmcputram", "", "W offset, memory buffer, s size", "", "", only_c=True, unsupported=_NO_MEMORY),
    _f("pmcputramex", "i", "D offset, memory buffer, D size", "", "", unsupported=_NO_MEMORY),
    _f("pmcputs", "s=", "str buffer", "", "Send text to the ASCII interface: the number of characters taken."),
    _f("pmcrdy", "s=", "", "", "1 if the interface is idle."),
    _f("pmcrpy", "s", "s size, memory buffer", "", "", only_c=True, unsupported=_NO_CODES),
    _f("pmcrpyex", "i", ">v reply<type>, i type", "", "The reply of the last pmccmdex as a number."),
    _f("pmcunlock", "", "", "", "End pmclock."),
)  # fmt: skip
FUNCTIONS: dict[str, Function] = {each.name: each for each in _FUNCTIONS}
