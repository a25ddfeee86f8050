"""The machine file's keys for a servo: `[axis.N.plant]` and `[axis.N.servo]`.

Each is a row: key, kind, default, range or choices, help. A plant gives an axis a simulated motor; the servo
section is needed only for gains that the program does not set.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from math import inf

from motionlang.kernel.servo.loop import ARITHMETICS, INTEGRAL_MODES, LIMIT_STYLES, Loop, Override
from motionlang.kernel.servo.plant import AMPLIFIERS, ENCODER_SIDES, Motor, VelocityDrive
from motionlang.kernel.tools import as_hint, nearest, shown

PLANT_KINDS = ("dc", "brushless", "drive")
# No motor parameter in SI units or counts is smaller or larger; beyond, its equations exceed the range of a
# float.
SMALLEST, LARGEST = 1e-12, 1e12


@dataclass(frozen=True, slots=True)
class Key:
    """One key of the machine file; `kind` is number, count, flag or text.

    A number must be between `low` and `high`, a text one of `choices`.
    """

    kind: str
    default: float | bool | str
    help: str
    low: float = -inf
    high: float = inf
    choices: tuple[str, ...] = ()
    # True if `low` itself is excluded.
    exclusive: bool = False


def _positive(default: float, text: str) -> Key:
    return Key("number", default, text, 0.0, exclusive=True)


def _not_negative(default: float, text: str) -> Key:
    return Key("number", default, text, 0.0)


_MOTOR, _DRIVE, _LOOP = Motor(), VelocityDrive(), Loop()
# The keys of a machine file that describe a plant.
PLANT: dict[str, Key] = {
    "kind": Key(
        "text", "dc", "A dc or brushless motor, or a drive with its own velocity loop.", choices=PLANT_KINDS
    ),
    "resistance": _positive(_MOTOR.resistance, "Winding resistance, ohm (terminal to terminal)."),
    "inductance": _not_negative(_MOTOR.inductance, "Winding inductance, H; 0: the current follows at once."),
    "torque_constant": _positive(
        _MOTOR.torque_constant, "Torque per current, N m/A; also the back-EMF, V s/rad."
    ),
    "inertia": _positive(_MOTOR.inertia, "Inertia of the motor, kg m²."),
    "load_inertia": _not_negative(_MOTOR.load_inertia, "Inertia of the load reflected to the motor, kg m²."),
    "viscous": _not_negative(_MOTOR.viscous, "Viscous friction, N m s/rad."),
    "coulomb": _not_negative(_MOTOR.coulomb, "Coulomb friction, N m."),
    "breakaway": _not_negative(
        _MOTOR.breakaway, "Torque to break away from rest, N m; 0: the Coulomb friction."
    ),
    "load_torque": Key(
        "number", _MOTOR.load_torque, "Constant torque in the negative direction (gravity), N m."
    ),
    "resonance": _not_negative(_MOTOR.resonance, "Frequency of motor against load, Hz; 0: a rigid coupling."),
    "resonance_damping": _not_negative(_MOTOR.resonance_damping, "Damping ratio of the resonance."),
    "backlash": _not_negative(_MOTOR.backlash, "Backlash between motor and load, counts."),
    "counts_per_rev": _positive(_MOTOR.counts_per_rev, "Encoder counts in one revolution of the motor."),
    "quantised": Key("flag", _MOTOR.quantised, "true: the encoder gives whole counts."),
    "encoder": Key("text", _MOTOR.encoder, "The side of the encoder: motor or load.", choices=ENCODER_SIDES),
    "amplifier": Key(
        "text",
        _MOTOR.amplifier,
        "The quantity that the output commands: voltage or current.",
        choices=AMPLIFIERS,
    ),
    "amplifier_gain": _positive(
        _MOTOR.amplifier_gain, "Gain of the amplifier: V or A for each volt of the controller's output."
    ),
    "speed_per_volt": _positive(_DRIVE.speed_per_volt, "For a drive: counts/s for each volt."),
    "time_constant": _positive(_DRIVE.time_constant, "For a drive: time constant of its response, s."),
}
# The keys of a machine file that describe a loop.
SERVO: dict[str, Key] = {
    "proportional": Key("number", 0.0, "V per count of following error; a program's own gains win."),
    "integral": Key("number", 0.0, "V per count and servo sample."),
    "derivative": Key("number", 0.0, "V per count and derivative sample."),
    "velocity_feedback": Key("number", 0.0, "V per count per servo sample of measured speed."),
    "velocity_ff": Key("number", 0.0, "V per count/s of commanded speed."),
    "accel_ff": Key("number", 0.0, "V per count/s² of commanded acceleration."),
    "decel_ff": Key("number", 0.0, "V per count/s² of commanded deceleration."),
    "integral_limit": _not_negative(
        10.0, "Limit of the integral contribution, V (integer arithmetic: before /16)."
    ),
    "limit_style": Key(
        "text",
        "sum",
        "sum: the sum stops at the limit; term: the sum winds up beyond it.",
        choices=LIMIT_STYLES,
    ),
    "integral_mode": Key(
        "text",
        "always",
        f"When the integral acts: {', '.join(INTEGRAL_MODES)}.",
        choices=tuple(INTEGRAL_MODES),
    ),
    "derivative_every": Key("count", 1, "Servo samples for each derivative sample.", 1, 100_000),
    "output_limit": Key("number", _LOOP.output_limit, "The greatest output, V.", 0.0, 10.0),
    "output_offset": Key("number", 0.0, "Added to every output, V.", -10.0, 10.0),
    "output_deadband": Key("number", 0.0, "A smaller output counts as 0, V.", 0.0, 10.0),
    "reversed": Key("flag", False, "true: the output is reversed."),
    "arithmetic": Key(
        "text", "real", f"The arithmetic of the loop: {', '.join(ARITHMETICS)}.", choices=ARITHMETICS
    ),
    "dac_bits": Key("count", 0, "Bits of the DAC; 0: no quantisation.", 0, 16),
    "bandwidth": _positive(
        50.0,
        "The bandwidth of suggested gains, Hz; they apply if neither this section nor the program has gains.",
    ),
    "servo_rate": Key(
        "number", _LOOP.servo_rate, "Servo samples per second, a multiple of trajectory_rate.", 1.0, 1e6
    ),
    "trajectory_rate": Key("number", _LOOP.trajectory_rate, "Trajectory points per second.", 1.0, 1e6),
    "override_steps": Key(
        "count", 0, "DAC override: the most DAC steps from the actual velocity; 0: no override.", 0, 32768
    ),
    "override_hold": Key("count", 1, "DAC override: the number of updates that the DAC is held.", 1, 100_000),
    "override_speed": _positive(100_000.0, "DAC override: speed at full scale, counts/s."),
}
# Every key as spelt in the machine file, with N for the axis.
KEYS: dict[str, Key] = {
    **{f"axis.N.plant.{name}": key for name, key in PLANT.items()},
    **{f"axis.N.servo.{name}": key for name, key in SERVO.items()},
}


def problem(key: Key, value: object) -> str | None:
    """Return an error text that continues "must be"; None if the value is valid."""
    if key.kind == "flag":
        return None if isinstance(value, bool) else "true or false"
    if key.kind == "text":
        return None if value in key.choices else " or ".join(f'"{choice}"' for choice in key.choices)
    if isinstance(value, bool) or not isinstance(value, int if key.kind == "count" else (int, float)):
        return "a whole number" if key.kind == "count" else "a number"
    inside = key.low < value <= key.high if key.exclusive else key.low <= value <= key.high
    if not inside:
        return _range_words(key)
    if abs(value) > LARGEST:
        return f"no larger than {LARGEST:.10g}"
    return f"0, or no smaller than {SMALLEST:.10g}" if 0.0 < abs(value) < SMALLEST else None


def _range_words(key: Key) -> str:
    if key.low == 0.0 and key.high == inf:
        return "greater than zero" if key.exclusive else "zero or more"
    if key.high == inf:
        return "a finite number"
    return f"{key.low:.10g} to {key.high:.10g}"


def setting_problem(key: str, generic: str, value: object) -> tuple[str, str] | None:
    """Return the error of a machine file key, and a hint; None if there is no error.

    `generic` is the key with N for its axis number.
    """
    row = KEYS.get(generic)
    if row is None:
        section, _, name = key.rpartition(".")
        table = PLANT if generic.startswith("axis.N.plant.") else SERVO
        near = nearest(name, table)
        return f"there is no key {key}", (
            f"did you mean {near}?" if near else f"[{section}] has {', '.join(table)}"
        )
    wrong = problem(row, value)
    return None if wrong is None else (f"{key} must be {wrong}, not {shown(value)}", as_hint(row.help))


def mistakes(settings: Mapping[str, object]) -> list[tuple[str, str, str]]:
    """Return the conflicts in the sections of every axis: section, error, and a hint."""
    found = []
    for axis in sorted({int(key.split(".")[1]) for key in settings if key.startswith("axis.")}):
        for name, make in (("plant", make_plant), ("servo", make_loop)):
            values = section(settings, axis, name)
            try:
                make(values)
            except ValueError as wrong:
                found.append((f"axis.{axis}.{name}", str(wrong), "docs/machine-file.md explains every key"))
    return found


def section(settings: Mapping[str, object], axis: int, name: str) -> dict[str, object]:
    """Return `axis.N.plant.…` or `axis.N.servo.…` of settings with dotted keys.

    The result is the input of `make_plant` or `make_loop`.
    """
    prefix = f"axis.{axis}.{name}."
    return {key[len(prefix) :]: value for key, value in settings.items() if key.startswith(prefix)}


def make_plant(values: Mapping[str, object]) -> Motor | VelocityDrive:
    """Return the plant of an `[axis.N.plant]` section (names without the prefix).

    Raises ValueError for an invalid entry.
    """
    given = _checked(values, PLANT, "plant")
    kind = given.pop("kind", "dc")
    wanted = VelocityDrive if kind == "drive" else Motor
    own = {field.name for field in fields(wanted)}
    for name in given:
        if name not in own:
            raise ValueError(f"{name} does not belong to a plant of kind {kind}")
    return wanted(**given)  # type: ignore[arg-type]


def make_loop(values: Mapping[str, object], base: Loop | None = None) -> Loop:
    """Return `base` with the entries of an `[axis.N.servo]` section.

    Raises ValueError for an invalid entry.
    """
    given = _checked(values, SERVO, "servo")
    override = {
        name: given.pop(name)
        for name in ("override_steps", "override_hold", "override_speed")
        if name in given
    }
    given.pop("bandwidth", None)
    loop = replace(base or Loop(), **given)  # type: ignore[arg-type]
    if not override.get("override_steps"):
        return loop
    defaults = {name: SERVO[name].default for name in ("override_hold", "override_speed")} | override
    made = Override(*(defaults[f"override_{name}"] for name in ("steps", "hold", "speed")))  # type: ignore[arg-type]
    return replace(loop, override=made)


def _checked(values: Mapping[str, object], table: dict[str, Key], section: str) -> dict[str, object]:
    for name, value in values.items():
        if name not in table:
            near = nearest(name, table)
            hint = f"did you mean {near}?" if near else f"it has {', '.join(table)}"
            raise ValueError(f"there is no key {name} in {section}; {hint}")
        wrong = problem(table[name], value)
        if wrong is not None:
            raise ValueError(f"{name} must be {wrong}, not {shown(value)}")
    return {name: float(v) if table[name].kind == "number" else v for name, v in values.items()}  # type: ignore[arg-type]
