"""The header of MCAPI 4.4.1: its constants, structures and functions, with MCCL and remarks.

The methods of the Python class (`binding.py`) are made from this table when they are imported. The C header, the
C stubs and the page of functions are derived files (`tools/mcapi_files.py`). The dispatcher checks the arguments
of a call against it. The implementation of a call is in `calls/`, unless the column of MCCL is sufficient, such
as `aMA{position}`: `a` is the axis, and the braces name the argument that is the parameter.

Kinds of arguments, after the letters of C: h handle, s short, i int, W unsigned short, D DWORD, u unsigned
int, d double, str text, w window. `>` marks a result. `[n]` after a name is an array whose length is the
argument n, `<type>` a value whose type is the argument `type`. `memory` is never transported. A structure has
its name as its kind. A pointer with `?` may be NULL. An axis with `*` may be 0 although no command says so.

Results of a function: "" for none, a kind alone for the error code. A kind is followed by `=` for a value, `?`
for a value whose 0 is no error, and `!` for a value that is an error code.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, ClassVar

Value = int | float | str

# ------------------------------------------------------------------------------------------------ constants

# The text of each error code.
MESSAGES: dict[int, str] = {}


def _error(code: int, text: str) -> int:
    MESSAGES[code] = text
    return code


def text_of(code: int) -> str:
    """Return the text of an error code."""
    return MESSAGES.get(code, f"unknown error {code}")


MC_ALL_AXES = 0
MC_ABSOLUTE = 0
MC_RELATIVE = 1
MC_BLOCK_COMPOUND, MC_BLOCK_TASK, MC_BLOCK_MACRO, MC_BLOCK_RESETM, MC_BLOCK_CANCEL = 0, 1, 2, 3, 4
MC_BLOCK_CONTR_USER, MC_BLOCK_CONTR_LIN, MC_BLOCK_CONTR_CW, MC_BLOCK_CONTR_CCW = 5, 6, 7, 8
MC_CAPTURE_ACTUAL, MC_CAPTURE_ERROR, MC_CAPTURE_OPTIMAL, MC_CAPTURE_TORQUE = 16, 32, 64, 128
MC_CAPTURE_ADVANCED, MC_CAPTURE_AUXILIARY, MC_CAPTURE_STATUS = 256, 512, 1024
MC_COMPARE_DISABLE, MC_COMPARE_ENABLE, MC_COMPARE_STATIC, MC_COMPARE_TOGGLE = 0, 1, 1, 2
MC_COMPARE_ONESHOT, MC_COMPARE_STROBE, MC_COMPARE_INVERT = 3, 5, 0x0080
MC_COUNT_CAPTURE, MC_COUNT_COMPARE, MC_COUNT_CONTOUR, MC_COUNT_FILTER, MC_COUNT_FILTERMAX = 1, 2, 4, 8, 16
MC_COUNT_RECORD = 32
MC_CURRENT_FULL, MC_CURRENT_HALF = 1, 2
MC_DIO_FIXED, MC_DIO_INPUT, MC_DIO_OUTPUT, MC_DIO_HIGH, MC_DIO_LOW, MC_DIO_LATCH = 256, 1, 2, 4, 8, 16
MC_DIO_LATCHABLE, MC_DIO_STEPPER = 512, 1024
MC_DIR_POSITIVE, MC_DIR_NEGATIVE = 1, 2
MC_ENC_FAULT_PRI, MC_ENC_FAULT_AUX = 1, 2
MC_INT_NORMAL, MC_INT_FREEZE, MC_INT_ZERO = 0, 1, 2
MC_IM_OPENLOOP, MC_IM_CLOSEDLOOP = 0, 1
MC_LIMIT_ABRUPT, MC_LIMIT_BOTH, MC_LIMIT_INVERT, MC_LIMIT_MINUS, MC_LIMIT_OFF = 4, 3, 0x0080, 2, 0
MC_LIMIT_PLUS, MC_LIMIT_SMOOTH = 1, 8
MC_LRN_POSITION, MC_LRN_TARGET = 1, 2
MC_MAX_ID = 15
MC_MODE_CONTOUR, MC_MODE_GAIN, MC_MODE_POSITION, MC_MODE_TORQUE, MC_MODE_VELOCITY = 0, 1, 2, 3, 4
MC_MODE_UNKNOWN = 5
MC_MODULE_TYPE, MC_MODULE_SUBTYPE = 0x000F, 0x00F0
MC_OM_BIPOLAR, MC_OM_UNIPOLAR, MC_OM_PULSE_DIR, MC_OM_CW_CCW, MC_OM_BI_PWM, MC_OM_UNI_PWM = 0, 1, 0, 1, 2, 3
MC_OM_PIEZO, MC_OM_SINE_NOENC, MC_OM_SINE_ENC = 4, 0x8000, 0xC000
MC_OPEN_ASCII, MC_OPEN_BINARY, MC_OPEN_EXCLUSIVE = 1, 2, 0x8000
MC_PHASE_STD, MC_PHASE_REV = 0, 1
MC_PROF_UNKNOWN, MC_PROF_TRAPEZOID, MC_PROF_SCURVE, MC_PROF_PARABOLIC = 0, 1, 2, 4
MC_RATE_UNKNOWN, MC_RATE_LOW, MC_RATE_MEDIUM, MC_RATE_HIGH = 0, 1, 2, 4
MC_STAT_BUSY, MC_STAT_MTR_ENABLE, MC_STAT_MODE_VEL, MC_STAT_TRAJ, MC_STAT_DIR = 0, 1, 2, 3, 4
MC_STAT_JOG_ENAB, MC_STAT_HOMED, MC_STAT_ERROR, MC_STAT_LOOK_INDEX, MC_STAT_LOOK_EDGE = 5, 6, 7, 8, 9
MC_STAT_BREAKPOINT, MC_STAT_FOLLOWING, MC_STAT_AMP_ENABLE, MC_STAT_AMP_FAULT = 10, 11, 12, 13
MC_STAT_PLIM_ENAB, MC_STAT_PLIM_TRIP, MC_STAT_MLIM_ENAB, MC_STAT_MLIM_TRIP = 14, 15, 16, 17
MC_STAT_PSOFT_ENAB, MC_STAT_PSOFT_TRIP, MC_STAT_MSOFT_ENAB, MC_STAT_MSOFT_TRIP = 18, 19, 20, 21
MC_STAT_INP_INDEX, MC_STAT_INP_HOME, MC_STAT_INP_AMP, MC_STAT_INP_AUX, MC_STAT_INP_PLIM = 22, 23, 24, 25, 26
MC_STAT_INP_MLIM, MC_STAT_INP_USER1, MC_STAT_INP_USER2, MC_STAT_PHASE, MC_STAT_FULL_STEP = 27, 28, 29, 30, 31
MC_STAT_HALF_STEP, MC_STAT_JOGGING, MC_STAT_PJOG_ENAB, MC_STAT_PJOG_ON, MC_STAT_MJOG_ENAB = 32, 33, 34, 35, 36
MC_STAT_MJOG_ON, MC_STAT_INP_PJOG, MC_STAT_INP_MJOG, MC_STAT_STOPPING, MC_STAT_PROG_DIR = 37, 38, 39, 40, 41
MC_STAT_AT_TARGET, MC_STAT_ACCEL, MC_STAT_MODE_POS, MC_STAT_MODE_TRQE, MC_STAT_MODE_ARC = 42, 43, 44, 45, 46
MC_STAT_MODE_CNTR, MC_STAT_MODE_SLAVE, MC_STAT_LMT_ABORT, MC_STAT_LMT_STOP = 47, 48, 49, 50
MC_STAT_CAPTURE, MC_STAT_RECORD, MC_STAT_SYNC, MC_STAT_MODE_LIN, MC_STAT_INDEX_FOUND = 51, 52, 53, 54, 55
MC_STAT_POS_CAPT, MC_STAT_NULL, MC_STAT_EDGE_FOUND, MC_STAT_PRI_ENC_FAULT = 56, 57, 58, 59
MC_STAT_AUX_ENC_FAULT, MC_STAT_LOOK_AUX_IDX, MC_STAT_AUX_IDX_FND = 60, 61, 62
MC_STEP_FULL, MC_STEP_HALF = 1, 2
MC_THREAD = 0x100
MC_TYPE_NONE, MC_TYPE_REG, MC_TYPE_LONG, MC_TYPE_FLOAT, MC_TYPE_DOUBLE, MC_TYPE_STRING = 0, 1, 2, 3, 4, 5
MC_TYPE_SERVO, MC_TYPE_STEPPER = 1, 2
NO_CONTROLLER = 0
DCXPC100, DCXAT100, DCXAT200, DC2PC100, DC2STN, DCXAT300, DCXPCI300, DCXPCI100 = 1, 2, 3, 4, 5, 6, 7, 8
MFXPCI1000, MFXETH1000 = 9, 10
MC100, MC110, MC150, MC160, MC200, MC210, MC260, MC300, MC302, MC320 = 5, 4, 6, 7, 0, 16, 1, 2, 22, 162
MC360, MC362, MC400, MC500 = 3, 23, 8, 12
MF300, MF310 = 10, 9
NO_MODULE = 15
MFXSERVO, MFXSTEPPER = 252, 253
DC2SERVO, DC2STEPPER = 254, 255
MCERRMASK_UNSUPPORTED = 0x00000001
MCERRMASK_HANDLE = 0x00000002
MCERRMASK_AXIS = 0x00000004
MCERRMASK_PARAMETER = 0x00000008
MCERRMASK_IO = 0x00000010
MCERRMASK_SYSTEM = 0x00000020
MCERRMASK_STANDARD = 0xFFFFFFFE
MCERR_NOERROR = _error(0, "no error")
MCERR_NO_CONTROLLER = _error(1, "no controller has this id")
MCERR_OUT_OF_HANDLES = _error(2, "no handle is free")
MCERR_OPEN_EXCLUSIVE = _error(3, "the interface is open exclusively, or open already")
MCERR_MODE_UNAVAIL = _error(4, "the controller is open in another mode")
MCERR_UNSUPPORTED_MODE = _error(5, "the handle does not support this mode")
MCERR_INIT_DRIVER = _error(6, "the driver could not be initialised")
MCERR_NOT_PRESENT = _error(7, "the controller is not present")
MCERR_ALLOC_MEM = _error(8, "out of memory")
MCERR_WINDOWSERROR = 9
MCERR_OS_ERROR = _error(9, "the operating system reported an error")
MCERR_NOTSUPPORTED = _error(11, "the controller does not support this function")
MCERR_OBSOLETE = _error(12, "the function is obsolete")
MCERR_CONTROLLER = _error(13, "invalid controller handle")
MCERR_WINDOW = _error(14, "invalid window handle")
MCERR_AXIS_NUMBER = _error(15, "axis number out of range")
MCERR_AXIS_TYPE = _error(16, "the axis type does not support this function")
MCERR_ALL_AXES = _error(17, "the function does not take all axes")
MCERR_AXIS_ACTIVE = _error(31, "the axis is enabled or moving")
MCERR_RANGE = _error(18, "parameter out of range")
MCERR_CONSTANT = _error(19, "inappropriate constant")
MCERR_NOT_INITIALIZED = _error(30, "the feature is not initialised")
MCERR_UNKNOWN_REPLY = _error(20, "the controller rejected the command")
MCERR_NO_REPLY = _error(21, "the controller did not reply")
MCERR_REPLY_SIZE = _error(22, "the reply has the wrong size")
MCERR_REPLY_AXIS = _error(23, "the reply is of another axis")
MCERR_REPLY_COMMAND = _error(24, "the reply is to another command")
MCERR_TIMEOUT = _error(25, "the controller did not respond in time")
MCERR_BLOCK_MODE = _error(26, "block mode error")
MCERR_COMM_PORT = _error(27, "communications port error")
MCERR_CANCEL = _error(28, "the operation was cancelled")
MCERR_NOT_FOUND = _error(29, "the data to restore was not found")
MCERR_SOCKET = _error(32, "no connection to the controller")
MC_LINEAR = 1
MC_CIRC_CW, MC_CIRC_CCW = 2, 3
MC_CENTER_ABS, MC_CENTER_REL = 0, 1
MC_DATA_ACTUAL, MC_DATA_OPTIMAL, MC_DATA_ERROR, MC_DATA_TORQUE = 0, 1, 2, 3
MC_LIMIT_HIGH, MC_LIMIT_LOW = 1, 2
MC_BLOCK_CONTR_CC = 7

CONSTANTS = {name: value for name, value in globals().items() if isinstance(value, int)}

# ----------------------------------------------------------------------------------------------- structures

STRUCTURES: dict[str, type[ApiStructure]] = {}


@dataclass(eq=False, slots=True)
class Field:
    """A field of a structure: "i", "s", "d" or "D", and its number of elements."""

    kind: str
    name: str
    count: int


class ApiStructure(SimpleNamespace):
    """A structure of MCAPI: attributes that are initially 0.

    `layout` has the names of the fields after the letter of their kind, with `*` and the number of elements of an
    array. `older` has the field counts of earlier versions. `fields` are those that are transported: all but
    `cbSize`, which has no influence on results.
    """

    layout: ClassVar[str]
    older: ClassVar[tuple[int, ...]] = ()
    fields: ClassVar[tuple[Field, ...]]
    has_size: ClassVar[bool]
    cbSize = 0  # noqa: N815

    def __init_subclass__(cls) -> None:
        found, kind = [], ""
        for word in cls.layout.split():
            if len(word) == 1:
                kind = word
            else:
                name, _, count = word.partition("*")
                found.append(Field(kind, name, int(count or 1)))
        cls.has_size = found[0].name == "cbSize"
        cls.fields = tuple(found[cls.has_size :])
        STRUCTURES[cls.__name__] = cls

    def __init__(self) -> None:
        super().__init__()
        self.fill((0.0 if field.kind == "d" else 0) for field in self.fields for _ in range(field.count))

    @classmethod
    def names(cls) -> list[str]:
        """Return the name of the field of each transported value."""
        return [field.name for field in cls.fields for _ in range(field.count)]

    def values(self) -> list[float]:
        """Return the values that are transported."""
        found: list[float] = []
        for field in self.fields:
            value = getattr(self, field.name)
            found += value if field.count > 1 else [value]
        return found

    def fill(self, values: Iterable[Any]) -> None:
        """Set the values from an answer."""
        following = iter(values)
        for field in self.fields:
            found = [next(following) for _ in range(field.count)]
            setattr(self, field.name, found if field.count > 1 else found[0])


class MCAXISCONFIG(ApiStructure):
    """The module of an axis."""

    layout = (
        "i cbSize ModuleType ModuleLocation MotorType CaptureModes CapturePoints CaptureAndCompare d "
        "HighRate MediumRate LowRate HighStepMin HighStepMax MediumStepMin MediumStepMax LowStepMin "
        "LowStepMax i AuxEncoder"
    )
    older = (16,)


class MCCOMMUTATION(ApiStructure):
    """Commutation of a brushless motor."""

    layout = "i cbSize d PhaseA PhaseB i Divisor PreScale Repeat"


class MCCONTOUR(ApiStructure):
    """Vector settings of an axis."""

    layout = "d VectorAccel VectorDecel VectorVelocity VelocityOverride"


class MCFILTEREX(ApiStructure):
    """Settings of the servo loop."""

    layout = (
        "i cbSize d Gain IntegralGain IntegrationLimit i IntegralOption d DerivativeGain DerSamplePeriod "
        "FollowingError VelocityGain AccelGain DecelGain EncoderScaling i UpdateRate d PositionDeadband "
        "DelayAtTarget OutputOffset OutputDeadband"
    )
    older = (13,)


class MCFILTER(ApiStructure):
    """Settings of the servo loop, without gain."""

    layout = (
        "d DerivativeGain DerSamplePeriod IntegralGain IntegrationLimit VelocityGain AccelGain DecelGain "
        "FollowingError"
    )


class MCJOGEX(ApiStructure):
    """Joystick settings, with the channel."""

    layout = "i cbSize d Acceleration MinVelocity Deadband Gain Offset i Channel"


class MCJOG(ApiStructure):
    """Joystick settings."""

    layout = "d Acceleration MinVelocity Deadband Gain Offset"


class MCMOTIONEX(ApiStructure):
    """Settings of motion."""

    layout = (
        "i cbSize d Acceleration Deceleration Velocity MinVelocity i Direction d Torque Deadband "
        "DeadbandDelay i StepSize Current HardLimitMode SoftLimitMode d SoftLimitLow SoftLimitHigh i "
        "EnableAmpFault"
    )


class MCMOTION(ApiStructure):
    """Settings of motion, with gain and rate."""

    layout = (
        "d Acceleration Deceleration Velocity MinVelocity s Direction d Gain Torque Deadband DeadbandDelay "
        "s StepSize Current HardLimitMode SoftLimitMode d SoftLimitLow SoftLimitHigh s EnableAmpFault Rate"
    )


class MCPARAMEX(ApiStructure):
    """Capabilities of a controller."""

    layout = (
        "i cbSize ID ControllerType NumberAxes MaximumAxes MaximumModules Precision DigitalIO AnalogInput "
        "AnalogOutput PointStorage CanDoScaling CanDoContouring CanChangeProfile CanChangeRates SoftLimits "
        "MultiTasking AmpFault d AnalogInpMin AnalogInpMax i AnalogInpRes d AnalogOutMin AnalogOutMax i "
        "AnalogOutRes OutputMode AtTarget OutputControl LineModeAscii"
    )
    older = (18, 24, 27)


class MCPARAM(ApiStructure):
    """Capabilities of a controller, for older hosts."""

    layout = (
        "s ID ControllerType NumberAxes DigitalIO AnalogInput AnalogOutput AxisType*8 PointStorage "
        "CanDoScaling CanDoContouring CanChangeProfile CanChangeRates SoftLimits MultiTasking AmpFault"
    )


class MCSCALE(ApiStructure):
    """User units."""

    layout = "d Constant Offset Rate Scale Zero Time"


class MCSTATUSEX(ApiStructure):
    """The four status words of an axis."""

    layout = "i cbSize D Status AuxStatus ProfileStatus ModeStatus"


# ------------------------------------------------------------------------------------------------ functions

# Kinds of integers, with their bits; negative is signed.
BITS = {"h": -16, "s": -16, "i": -32, "W": 16, "D": 32, "u": 32, "w": 64}


@dataclass(eq=False, slots=True)
class Argument:
    """An argument of a function.

    `size` and `type` name the arguments that hold its length and its type. `takes_all` is true for an axis that
    may be 0.
    """

    kind: str
    name: str
    out: bool
    size: str
    type: str
    optional: bool
    takes_all: bool


@dataclass(eq=False, slots=True)
class ApiFunction:
    """A row of the table.

    `unsupported` is the reason why a call returns MCERR_NOTSUPPORTED, or "". `python` has the parameters of the
    method in PMC's Python binding, where they differ from those of C.
    """

    name: str
    result: str
    arguments: tuple[Argument, ...]
    mccl: str
    help: str
    unsupported: str
    python: str

    @property
    def kind(self) -> str:
        """The kind of the result, "" for none."""
        return self.result[:1]

    @property
    def is_value(self) -> bool:
        """True if the result is a value instead of an error code."""
        return len(self.result) > 1

    @property
    def zero_may_fail(self) -> bool:
        """True if a value of 0 may mean an error."""
        return self.result.endswith("=")

    @property
    def has_handle(self) -> bool:
        return self.name not in ("MCOpen", "MCTranslateErrorEx")

    @property
    def outputs(self) -> tuple[Argument, ...]:
        return tuple(each for each in self.arguments if each.out)

    @property
    def effect(self) -> str:
        """The effect of a call, or the reason why it has none."""
        return self.help or f"Not supported: {self.unsupported}."

    def failed(self, code: int) -> int:
        """Return what a call returns that fails with an error code."""
        if self.name == "MCOpen":
            return -code
        return 0 if self.result.endswith(("=", "?")) else code


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
        bare = name.rstrip("?*")
        bare, _, size = bare.partition("[")
        bare, _, of = bare.partition("<")
        found.append(
            Argument(
                kind.lstrip(">"),
                bare,
                kind[0] == ">",
                size.rstrip("]"),
                of.rstrip(">"),
                name.endswith("?"),
                name.endswith("*"),
            )
        )
    return tuple(found)


def _f(
    name: str,
    result: str,
    arguments: str,
    mccl: str,
    help: str,
    *,
    unsupported: str = "",
    python: str = "",
) -> ApiFunction:
    return ApiFunction(name, result, _arguments(arguments), mccl, help, unsupported, python)


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
       "kind 1 line, 2 clockwise or 3 anticlockwise arc."),
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
    _f("MCEnableInterrupt", "i", "w hWnd, W axis, D mask, memory lpIntFunc", "", "",
       unsupported="a virtual board raises no interrupts in its host"),
    _f("MCEnableJog", "", "W axis, s state", "aJN, aJF", "Switch jogging by the joystick on or off."),
    _f("MCEnableSync", "", "W axis, s state", "aSN, aNS", "Let contour paths wait for MCGoEx, or not."),
    _f("MCErrorNotify", "", "w hWnd, D errormask", "", "", unsupported=_NO_WINDOW),
    _f("MCFindAuxEncIdx", "i", "W axis, d position", "aAF{position}", "Wait for the index mark of the auxiliary "
       "encoder and set the position there."),
    _f("MCFindEdge", "i", "W axis, d position", "aFE{position}", "Wait for the home edge and set the position there."),
    _f("MCFindIndex", "i", "W axis, d position", "aFI{position}", "Wait for the index mark and set the "
       "position there."),
    _f("MCGetAccelerationEx", "i", "W axis, >d acceleration", "", "Acceleration of moves (SA)."),
    _f("MCGetAnalog", "W=", "W channel", "TA", "An analogue input as 12 bits over ±10 V."),
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
       "MCGetConfigurationEx."),
    _f("MCGetConfigurationEx", "i", ">MCPARAMEX param", "", "Capabilities of the model."),
    _f("MCGetContourConfig", "s", "W axis, >MCCONTOUR contour", "", "Vector settings of the axis (VA, VD, VV, VO)."),
    _f("MCGetContouringCount", "i=", "W axis", "aTX", "Number of contour paths carried out."),
    _f("MCGetCount", "i", "W axis, i type, >i count", "aTX, aPR", "4: contour paths carried out, 32: points recorded. "
       "The other counts are of functions that are not supported."),
    _f("MCGetDecelerationEx", "i", "W axis, >d deceleration", "", "Deceleration of moves (DS)."),
    _f("MCGetDigitalFilter", "i", "W axis, >d coeff[num], i num, >i actual", "", "", unsupported=_NO_FILTER,
       python="axis, coeff, num, actual=None"),
    _f("MCGetDigitalIO", "s=", "W channel", "TC", "1 if the channel is on."),
    _f("MCGetDigitalIOConfig", "i", "W channel, >W mode", "", "Direction and logic of the channel, as "
       "MCConfigureDigitalIO takes them."),
    _f("MCGetDigitalIOEx", "i", "W channel, >u state", "TC", "1 if the channel is on."),
    _f("MCGetError", "s!", "", "", "The last error of the handle, which it then forgets."),
    _f("MCGetFilterConfig", "s", "W axis, >MCFILTER filter", "", "Settings of the servo loop, without gain."),
    _f("MCGetFilterConfigEx", "i", "W axis, >MCFILTEREX filter", "", "Settings of the servo loop. IntegralOption, "
       "which has no command, is 0."),
    _f("MCGetFollowingError", "i", "W axis, >d error", "aTF", "Optimal minus actual position."),
    _f("MCGetGain", "i", "W axis, >d gain", "aTG", "Proportional gain."),
    _f("MCGetIndexEx", "i", "W axis, >d index", "aTZ", "Position at which the index was last seen."),
    _f("MCGetInstalledModules", "i", ">i modules[size], i size", "", "Codes of the modules by site; 15 is an empty "
       "site.", python="size=16"),
    _f("MCGetJogConfig", "s", "W axis, >MCJOG jog", "", "Joystick settings."),
    _f("MCGetJogConfigEx", "i", "W axis, >MCJOGEX jog", "", "Joystick settings; the channel is the number of the "
       "axis."),
    _f("MCGetLimits", "i", "W axis, >s hardlimitmode, >s softlimitmode, >d softlimitminus, >d softlimitplus", "",
       "Modes and positions of the limits (LM, LN, HL, LL)."),
    _f("MCGetModuleInputMode", "i", "W axis, >i mode", "", "Input mode (IM)."),
    _f("MCGetModuleOutputMode", "i", "W axis, >W mode", "", "Output mode (OM)."),
    _f("MCGetMotionConfig", "s", "W axis, >MCMOTION motion", "", "Settings of motion, with gain and rate."),
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
    _f("MCGetTrajectoryRate", "i", ">i rate", "", "", unsupported=_NO_RATE, python="axis=0"),
    _f("MCGetVectorVelocity", "i", "W axis, >d velocity", "", "Vector velocity (VV)."),
    _f("MCGetVelocityActual", "i", "W axis, >d velocity", "aTV", "Actual velocity."),
    _f("MCGetVelocityEx", "i", "W axis, >d velocity", "", "Velocity of moves (SV)."),
    _f("MCGetVelocityOverride", "i", "W axis, >d override", "", "Override of contour paths (VO)."),
    _f("MCGetVersion", "D=", "", "", "263169: version 4.4.1, one byte per number, the third byte first."),
    _f("MCGo", "", "W axis", "aGO", "Run in velocity mode, or release contour paths."),
    _f("MCGoEx", "i", "W axis, d param", "aGO", "Run in velocity mode, or release contour paths; the parameter has "
       "no effect."),
    _f("MCGoHome", "", "W axis", "aGH", "Move to position 0."),
    _f("MCIndexArm", "i", "W axis, d position", "aIA{position}", "Arm the capture of the index mark."),
    _f("MCInterruptOnPosition", "i", "W axis, i mode, d position", "aIP, aIR", "Set a breakpoint, absolute (0) or "
       "relative (1): status bit 10 shows it."),
    _f("MCIsAtTarget", "i?", "W axis*, d timeout", "aTS", "1 when the axis is at target; waits up to the time-out."),
    _f("MCIsDigitalFilter", "i?", "W axis", "", "", unsupported=_NO_FILTER),
    _f("MCIsEdgeFound", "i?", "W axis*, d timeout", "aTS", "1 when the home edge has been found; waits up to the "
       "time-out."),
    _f("MCIsIndexFound", "i?", "W axis*, d timeout", "aTS", "1 when the index mark has been found; waits up to the "
       "time-out."),
    _f("MCIsStopped", "i?", "W axis*, d timeout", "aTS", "1 when the trajectory is complete; waits up to the time-out, "
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
    _f("MCReset", "", "W axis*", "aRT", "Reset the axis, or the whole board for axis 0.", python="axis, distance=0.0"),
    _f("MCSetAcceleration", "", "W axis, d rate", "aSA{rate}", "Acceleration of moves."),
    _f("MCSetAnalog", "", "W channel, W value", "AL, OA", "An analogue output as 12 bits over ±10 V; changes the "
       "accumulator."),
    _f("MCSetAnalogEx", "i", "i channel, D value", "AL, OA", "An analogue output as 12 bits over ±10 V; changes the "
       "accumulator."),
    _f("MCSetAuxEncPos", "", "W axis, d position", "aAH{position}", "Set the position of the auxiliary encoder."),
    _f("MCSetCommutation", "i", "W axis, MCCOMMUTATION commutation", "", "", unsupported="no command for "
       "commutation is known"),
    _f("MCSetContourConfig", "s", "W axis, MCCONTOUR contour", "aVA, aVD, aVV, aVO", "Vector settings of the axis."),
    _f("MCSetDeceleration", "", "W axis, d rate", "aDS{rate}", "Deceleration of moves."),
    _f("MCSetDigitalFilter", "i", "W axis, d coeff[num], i num", "", "", unsupported=_NO_FILTER),
    _f("MCSetFilterConfig", "s", "W axis, MCFILTER filter", "aSD, aFR, aSI, aIL, aVG, aAG, aDG, aSE", "Settings of "
       "the servo loop, without gain."),
    _f("MCSetFilterConfigEx", "i", "W axis, MCFILTEREX filter",
       "aSG, aSI, aIL, aSD, aFR, aSE, aVG, aAG, aDG, aES, aHS, aMS, aLS, aDB, aDT, aOO, aOB", "Settings of the servo "
       "loop. A field for which the model has no command is skipped."),
    _f("MCSetGain", "i", "W axis, d gain", "aSG{gain}", "Proportional gain."),
    _f("MCSetJogConfig", "s", "W axis, MCJOG jog", "aJA, aJV, aJB, aJG, aJO", "Joystick settings."),
    _f("MCSetJogConfigEx", "i", "W axis, MCJOGEX jog", "aJA, aJV, aJB, aJG, aJO", "Joystick settings; the channel has "
       "no effect."),
    _f("MCSetLimits", "i", "W axis, s hardlimitmode, s softlimitmode, d softlimitminus, d softlimitplus",
       "aLL, aHL, aLM, aLF, aLN", "Modes and positions of the limits."),
    _f("MCSetModuleInputMode", "i", "W axis, i Mode", "aIM{Mode}", "Input mode of a stepper."),
    _f("MCSetModuleOutputMode", "", "W axis, W mode", "aOM{mode}", "Output mode."),
    _f("MCSetMotionConfig", "s", "W axis, MCMOTION motion",
       "aSA, aDS, aSV, aMV, aDI, aSG, aSQ, aDB, aDT, aFS, aSH, aFC, aHC, aLM, aLN, aLF, aLL, aHL, aFN, aFF, aHS, aMS, "
       "aLS", "Settings of motion, with gain and rate."),
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
    _f("MCSetTrajectoryRate", "i", "i rate", "", "", unsupported=_NO_RATE, python="axis, rate"),
    _f("MCSetVectorVelocity", "i", "W axis, d velocity", "aVV{velocity}", "Vector velocity."),
    _f("MCSetVelocity", "", "W axis, d rate", "aSV{rate}", "Velocity of moves."),
    _f("MCSetVelocityOverride", "i", "W axis, d override", "aVO{override}", "Override of contour paths."),
    _f("MCStop", "", "W axis", "aST", "Stop at the programmed deceleration."),
    _f("MCTranslateErrorEx", "i!", "s nError, >buf buffer[length], i length", "", "The text of an error code."),
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
    _f("pmccmd", "s", "s size, memory buffer", "", "", unsupported=_NO_CODES),
    _f("pmccmdex", "i", "W axis*, W command, v argument<type>?, i type", "", "Carry out the command with this numeric "
       "code. Only DW is known to have one, 253; `mccl.codes.XX` in the machine file gives others. A code that is not "
       "known is answered with 11."),
    _f("pmccmdrpyex", "i", "W axis*, W cmd, v arg<arg_type>?, i arg_type, >v rpy<rpy_type>, i rpy_type", "",
       "pmccmdex, then pmcrpyex."),
    _f("pmcgetc", "s=", "", "", "The next character of the ASCII interface, 0 if there is none."),
    _f("pmcgetram", "", "W offset, memory buffer, s size", "", "", unsupported=_NO_MEMORY),
    _f("pmcgetramex", "i", "D offset, memory buffer, D size", "", "", unsupported=_NO_MEMORY),
    _f("pmcgets", "s=", ">buf buffer[size], s size", "", "Text of the ASCII interface up to the first CR or prompt; "
       "the result is its length. Waits while the board is busy.", python="buffer, size"),
    _f("pmclock", "D!", "D wait_msec", "", "Reserve the interface for this handle: 0, or 25 if another has it for "
       "longer than the time."),
    _f("pmclookupvar", "i", "str varname, >D address", "LU", "Address of a variable of the board, 4 counts apart; "
       "valid only here.", python="varname, address=None"),
    _f("pmcputc", "s=", "s character", "", "Send a character to the ASCII interface: 1 if it was taken."),
    _f("pmcputram", "", "W offset, memory buffer, s size", "", "", unsupported=_NO_MEMORY),
    _f("pmcputramex", "i", "D offset, memory buffer, D size", "", "", unsupported=_NO_MEMORY),
    _f("pmcputs", "s=", "str buffer", "", "Send text to the ASCII interface: the number of characters taken."),
    _f("pmcrdy", "s=", "", "", "1 if the interface is idle."),
    _f("pmcrpy", "s", "s size, memory buffer", "", "", unsupported=_NO_CODES),
    _f("pmcrpyex", "i", ">v reply<type>, i type", "", "The reply of the last pmccmdex as a number."),
    _f("pmcunlock", "", "", "", "End pmclock."),
)  # fmt: skip
FUNCTIONS = {each.name: each for each in _FUNCTIONS}
