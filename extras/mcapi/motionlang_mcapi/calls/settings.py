"""Settings of an axis: one command writes each, one value of the board reads it.

The structures are read and written by `SETTINGS`. A structure omits a command that the model does not have;
a function for that command alone is not supported.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, TypeAlias

from motionlang.kernel.mccl import AxisState, Board, Command, torque
from motionlang.kernel.mccl.axis import flags
from motionlang.kernel.mccl.axis.axis import CONTOUR, GAIN, POSITION, TORQUE, VELOCITY
from motionlang.kernel.mccl.axis.limits import ALL, HARD_MINUS, HARD_PLUS, SOFT_HIGH, SOFT_LOW
from motionlang.kernel.mccl.axis.status import SHAPES
from motionlang.kernel.mccl.keywords.reports import STORED_DEFAULTS
from motionlang_mcapi import table as mc
from motionlang_mcapi.calls.motion import DIRECTIONS, PROFILES, of
from motionlang_mcapi.command import command, lacks
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import commands, query
from motionlang_mcapi.table import STRUCTURES

if TYPE_CHECKING:
    from motionlang_mcapi.interface import Interface

Get: TypeAlias = Callable[[Board, AxisState], float]

Put: TypeAlias = Callable[[Board, int, float], list[Command]]

# The rate of the servo loop of each constant, and its command.
RATES = {mc.MC_RATE_LOW: 1000.0, mc.MC_RATE_MEDIUM: 2000.0, mc.MC_RATE_HIGH: 4000.0}
RATE_COMMANDS = {mc.MC_RATE_LOW: "LS", mc.MC_RATE_MEDIUM: "MS", mc.MC_RATE_HIGH: "HS"}
STEPS = {mc.MC_STEP_FULL: "FS", mc.MC_STEP_HALF: "SH"}
CURRENTS = {mc.MC_CURRENT_FULL: "FC", mc.MC_CURRENT_HALF: "HC"}
MODES = {
    CONTOUR: mc.MC_MODE_CONTOUR,
    GAIN: mc.MC_MODE_GAIN,
    POSITION: mc.MC_MODE_POSITION,
    TORQUE: mc.MC_MODE_TORQUE,
    VELOCITY: mc.MC_MODE_VELOCITY,
}


def _motion(name: str, unit: str) -> Get:
    return lambda board, axis: axis.reported(float(board.controller.setting(axis.number, name) or 0.0), unit)


def _stored_value(name: str) -> Get:
    return lambda board, axis: axis.stored.get(name, STORED_DEFAULTS.get(name, 0.0))


def _by(name: str) -> Put:
    """Return the writer of a setting that has its own command."""
    return lambda board, axis, value: [command(name, axis, value)]


def _chosen(names: dict[int, str]) -> Put:
    """Return the writer of a setting chosen by a constant; 0 does not change it."""
    return lambda board, axis, value: [command(of(names, int(value)), axis)] if value else []


def _derivative_period(board: Board, axis: AxisState) -> float:
    """Return the sampling period of the derivative term, s.

    FR stores it in servo periods, minus one.
    """
    return (axis.stored.get("kept_derivative_period", 0.0) + 1.0) * board.model.update


def _put_derivative_period(board: Board, axis: int, value: float) -> list[Command]:
    return [command("FR", axis, max(0, round(value / board.model.update) - 1))]


def _rate(board: Board, axis: AxisState) -> int:
    hertz = axis.stored.get("kept_rate", 4000.0)
    return next((constant for constant, each in RATES.items() if each == hertz), mc.MC_RATE_UNKNOWN)


def _direction(board: Board, axis: AxisState) -> int:
    return mc.MC_DIR_POSITIVE if axis.direction > 0 else mc.MC_DIR_NEGATIVE


def _put_direction(board: Board, axis: int, value: float) -> list[Command]:
    return [command("DI", axis, DIRECTIONS[int(value)])] if int(value) in DIRECTIONS else []


def _watches_amplifier(board: Board, axis: AxisState) -> int:
    return int(board.limits[axis.number].watches_amplifier)


def _put_amplifier(board: Board, axis: int, value: float) -> list[Command]:
    return [command("FN", axis) if value else command("FF", axis)]


# By the name of the field in every structure that has it.
SETTINGS: dict[str, tuple[Get, Put]] = {
    "Acceleration": (_motion("accel", "uu/s2"), _by("SA")),
    "Deceleration": (_motion("decel", "uu/s2"), _by("DS")),
    "Velocity": (_motion("speed", "uu/s"), _by("SV")),
    "MinVelocity": (lambda board, axis: axis.reported(axis.minimum, "uu/s"), _by("MV")),
    "Direction": (_direction, _put_direction),
    "Torque": (lambda board, axis: torque(axis), _by("SQ")),
    "Deadband": (lambda board, axis: axis.reported(axis.deadband, "uu"), _by("DB")),
    "DeadbandDelay": (lambda board, axis: axis.deadband_delay, _by("DT")),
    "StepSize": (lambda board, axis: mc.MC_STEP_HALF if axis.half_steps else mc.MC_STEP_FULL, _chosen(STEPS)),
    "Current": (
        lambda board, axis: (
            mc.MC_CURRENT_HALF if axis.stored.get("current", 1.0) < 1.0 else mc.MC_CURRENT_FULL
        ),
        _chosen(CURRENTS),
    ),
    "EnableAmpFault": (_watches_amplifier, _put_amplifier),
    "Gain": (_stored_value("kept_gain"), _by("SG")),
    "IntegralGain": (_stored_value("kept_integral"), _by("SI")),
    "IntegrationLimit": (_stored_value("kept_integral_limit"), _by("IL")),
    # No command is known for it.
    "IntegralOption": (lambda board, axis: mc.MC_INT_NORMAL, lambda board, axis, value: []),
    "DerivativeGain": (_stored_value("kept_derivative"), _by("SD")),
    "DerSamplePeriod": (_derivative_period, _put_derivative_period),
    "FollowingError": (_stored_value("kept_error_limit"), _by("SE")),
    "VelocityGain": (_stored_value("kept_velocity_gain"), _by("VG")),
    "AccelGain": (_stored_value("kept_accel_gain"), _by("AG")),
    "DecelGain": (_stored_value("kept_decel_gain"), _by("DG")),
    "EncoderScaling": (lambda board, axis: axis.stored.get("encoder_scaling", 1.0), _by("ES")),
    "UpdateRate": (_rate, _chosen(RATE_COMMANDS)),
    "Rate": (_rate, _chosen(RATE_COMMANDS)),
    "OutputOffset": (_stored_value("kept_output_offset"), _by("OO")),
    "OutputDeadband": (_stored_value("kept_output_deadband"), _by("OB")),
    "VectorAccel": (lambda board, axis: axis.reported(axis.vector.accel, "uu/s2"), _by("VA")),
    "VectorDecel": (lambda board, axis: axis.reported(axis.vector.decel, "uu/s2"), _by("VD")),
    "VectorVelocity": (lambda board, axis: axis.reported(axis.vector.velocity, "uu/s"), _by("VV")),
    "VelocityOverride": (lambda board, axis: axis.vector.override, _by("VO")),
}
SETTINGS["PositionDeadband"] = SETTINGS["Deadband"]
SETTINGS["DelayAtTarget"] = SETTINGS["DeadbandDelay"]
# The joystick has fields of the same names as the motion.
JOG: dict[str, tuple[Get, Put]] = {
    "Acceleration": (lambda board, axis: axis.reported(axis.jog.accel, "uu/s2"), _by("JA")),
    "MinVelocity": (lambda board, axis: axis.reported(axis.jog.minimum, "uu/s"), _by("JV")),
    "Deadband": (lambda board, axis: axis.jog.deadband, _by("JB")),
    "Gain": (lambda board, axis: axis.reported(axis.jog.gain, "uu/s"), _by("JG")),
    "Offset": (lambda board, axis: axis.jog.offset, _by("JO")),
    "Channel": (lambda board, axis: axis.number, lambda board, axis, value: []),
}
# Fields of limits, which are set together.
LIMITS = ("HardLimitMode", "SoftLimitMode", "SoftLimitLow", "SoftLimitHigh")


def _read_one(name: str, setting: str) -> None:
    get = SETTINGS[setting][0]
    query(name)(lambda interface, axis: get(interface.board, interface.board.axis(axis)))


for _name, _setting in (
    ("MCGetAccelerationEx", "Acceleration"),
    ("MCGetDecelerationEx", "Deceleration"),
    ("MCGetVelocityEx", "Velocity"),
    ("MCGetTorque", "Torque"),
    ("MCGetGain", "Gain"),
    ("MCGetVectorVelocity", "VectorVelocity"),
    ("MCGetVelocityOverride", "VelocityOverride"),
):
    _read_one(_name, _setting)


# ------------------------------------------------------------------------------------------------ structures


def _reader(function: str, structure: str, settings: dict[str, tuple[Get, Put]]) -> None:
    names = STRUCTURES[structure].names()

    def read(interface: Interface, axis: int) -> tuple[float, ...]:
        board, state = interface.board, interface.board.axis(axis)
        limits = dict(zip(LIMITS, get_limits(board, state), strict=True))
        return tuple(limits[name] if name in limits else settings[name][0](board, state) for name in names)

    query(function)(read)


def _writer(function: str, structure: str, argument: str, settings: dict[str, tuple[Get, Put]]) -> None:
    names = STRUCTURES[structure].names()

    def write(interface: Interface, axis: int, **given: tuple[float, ...]) -> list[Command]:
        values = dict(zip(names, given[argument], strict=True))
        board = interface.board
        found: list[Command] = []
        for name, value in values.items():
            if name in settings:
                found += settings[name][1](board, axis, value)
        if LIMITS[0] in values:
            found += put_limits(axis, *(values[name] for name in LIMITS))
        return only_known(interface, found)

    commands(function)(write)


def only_known(interface: Interface, found: Iterable[Command]) -> list[Command]:
    """Return those of the commands that the model has."""
    return [each for each in found if not lacks(interface.board.model, each.name)]


for _get, _set, _structure, _argument, _settings in (
    ("MCGetContourConfig", "MCSetContourConfig", "MCCONTOUR", "contour", SETTINGS),
    ("MCGetFilterConfig", "MCSetFilterConfig", "MCFILTER", "filter", SETTINGS),
    ("MCGetFilterConfigEx", "MCSetFilterConfigEx", "MCFILTEREX", "filter", SETTINGS),
    ("MCGetMotionConfig", "MCSetMotionConfig", "MCMOTION", "motion", SETTINGS),
    ("MCGetMotionConfigEx", "MCSetMotionConfigEx", "MCMOTIONEX", "motion", SETTINGS),
    ("MCGetJogConfig", "MCSetJogConfig", "MCJOG", "jog", JOG),
    ("MCGetJogConfigEx", "MCSetJogConfigEx", "MCJOGEX", "jog", JOG),
):
    _reader(_get, _structure, _settings)
    _writer(_set, _structure, _argument, _settings)


# ---------------------------------------------------------------------------------------------------- limits

_ABRUPT_OR_SMOOTH = mc.MC_LIMIT_ABRUPT | mc.MC_LIMIT_SMOOTH


def get_limits(board: Board, axis: AxisState) -> tuple[int, int, float, float]:
    """Return the modes of hard and soft limits, then low and high position."""
    mode, shown = axis.limit_mode, axis.flags
    hard = (mode & 3) << 2 | mode & mc.MC_LIMIT_INVERT
    hard |= mc.MC_LIMIT_PLUS if shown & flags.HARD_PLUS_ENABLED else 0
    hard |= mc.MC_LIMIT_MINUS if shown & flags.HARD_MINUS_ENABLED else 0
    soft = mode & _ABRUPT_OR_SMOOTH
    soft |= mc.MC_LIMIT_PLUS if shown & flags.SOFT_HIGH_ENABLED else 0
    soft |= mc.MC_LIMIT_MINUS if shown & flags.SOFT_LOW_ENABLED else 0
    return hard, soft, axis.reported(axis.soft_low), axis.reported(axis.soft_high)


def put_limits(axis: int, hard: float, soft: float, low: float, high: float) -> list[Command]:
    """Return the commands that set the limits.

    The positions are set before the modes that activate them.
    """
    hard, soft = int(hard), int(soft)
    known = mc.MC_LIMIT_BOTH | _ABRUPT_OR_SMOOTH
    for mode, allowed in ((hard, known | mc.MC_LIMIT_INVERT), (soft, known)):
        if mode & ~allowed or mode & _ABRUPT_OR_SMOOTH == _ABRUPT_OR_SMOOTH:
            raise CallRefused(mc.MCERR_CONSTANT)
    on = 0
    for mode, bit, limit in (
        (hard, mc.MC_LIMIT_PLUS, HARD_PLUS),
        (hard, mc.MC_LIMIT_MINUS, HARD_MINUS),
        (soft, mc.MC_LIMIT_PLUS, SOFT_HIGH),
        (soft, mc.MC_LIMIT_MINUS, SOFT_LOW),
    ):
        on |= limit if mode & bit else 0
    reaction = (hard & _ABRUPT_OR_SMOOTH) >> 2 | soft & _ABRUPT_OR_SMOOTH | hard & mc.MC_LIMIT_INVERT
    found = [command("LL", axis, low), command("HL", axis, high), command("LM", axis, reaction)]
    # LF0 and LN0 mean all limits.
    if on != ALL:
        found.append(command("LF", axis, ALL & ~on))
    if on:
        found.append(command("LN", axis, on))
    return found


@query("MCGetLimits")
def limits(interface: Interface, axis: int) -> tuple[int, int, float, float]:
    return get_limits(interface.board, interface.board.axis(axis))


@commands("MCSetLimits")
def set_limits(
    interface: Interface,
    axis: int,
    hardlimitmode: int,
    softlimitmode: int,
    softlimitminus: float,
    softlimitplus: float,
) -> list[Command]:
    """Set modes and positions of the limits."""
    return put_limits(axis, hardlimitmode, softlimitmode, softlimitminus, softlimitplus)


# --------------------------------------------------------------------------------------------- units, modes


@query("MCGetScale")
def scale(interface: Interface, axis: int) -> tuple[float, ...]:
    board = interface.board
    units = board.axis(axis).units
    return units.constant, units.offset, units.rate, units.counts, units.zero, board.time_unit


@commands("MCSetScale")
def set_scale(interface: Interface, axis: int, scale: tuple[float, ...]) -> list[Command]:
    """Set the units; raise Refused on a model that has none."""
    constant, offset, rate, counts, zero, time = scale
    if lacks(interface.board.model, "US"):
        raise CallRefused(mc.MCERR_NOTSUPPORTED)
    pairs = (("UK", constant), ("UO", offset), ("UR", rate), ("US", counts), ("UZ", zero))
    return [*(command(name, axis, value) for name, value in pairs), command("UT", value=time)]


@query("MCGetOperatingMode")
def operating_mode(interface: Interface, axis: int) -> int:
    return MODES[interface.board.axis(axis).mode]


@query("MCGetProfile")
def profile(interface: Interface, axis: int) -> int:
    found = SHAPES[str(interface.board.controller.setting(axis, "shape"))]
    assert found in PROFILES
    return found


@query("MCGetServoOutputPhase")
def phase(interface: Interface, axis: int) -> int:
    return int(interface.board.axis(axis).reversed_phase)


@query("MCGetModuleInputMode")
def input_mode(interface: Interface, axis: int) -> int:
    return int(interface.board.axis(axis).stored.get("input_mode", 0.0))


@query("MCGetModuleOutputMode")
def output_mode(interface: Interface, axis: int) -> int:
    return int(interface.board.axis(axis).stored.get("output_mode", 0.0))
