"""Generated code of the step loop for one loop and one plant.

The code has only the terms that exist, and all values in local variables. A general step would spend most of its
time on deciding which terms apply. The order of a step: measure, error, integral, derivative, sum, limits, DAC, then
the plant advances by one sample with constant output. Columns are the values at the time of the measurement.
"""

from __future__ import annotations

import re
from functools import lru_cache
from math import inf
from struct import pack_into
from types import CodeType, FunctionType
from typing import TYPE_CHECKING, cast

from motionlang.servo.discrete import SLIDING_DOWN, SLIDING_UP, STUCK, discretise
from motionlang.servo.loop import FINE_BITS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from motionlang.servo.discrete import Discrete, Regime
    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor

    Row = NDArray[np.float64]
    State = tuple[float, ...]
    Columns = tuple[list[float], ...]
    Stepper = Callable[[Sequence[float], Sequence[float], State, Columns], State]

COLUMNS = ("position", "velocity", "current", "twist", "integral", "output")
"""The columns of a step: counts, counts/s, A, counts (motor minus load), V, V."""

MEMORY = ("total", "last_error", "change", "last_position", "derivative_wait", "hold_wait", "held")
"""The loop's own state after the plant's.

It is the error sum, the last derivative sample, counters, and the stored DAC value.
"""

# Adding and subtracting 1.5 * 2**52 rounds a float to an integer, at the price of two additions.
_ROUND = " + 6755399441055744.0 - 6755399441055744.0"
# A float, with its sign unless that is an operator.
_CONSTANT = re.compile(r"(?<![\w.])(?:(?<=[-(=<>+*/,] )-|(?<=\()-)?(?:\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+)")
_NAMES = {"position": "p", "velocity": "v", "current": "c", "twist": "d", "load_velocity": "w"}
_MEMORY = ("s", "q", "g", "z", "k", "h", "o")


@lru_cache(maxsize=128)
def stepper(
    loop: Loop, plant: Motor | Drive, columns: tuple[str, ...], integrating: bool = True, limited: bool = True
) -> Stepper:
    """Return a function that runs one step for every commanded position.

    It maps (demand, feed-forward, state, columns) to a state. `demand` is counts at the servo rate,
    `feed-forward` volts (ignored if the loop has none). `limited` False omits both limits, for the linear
    form.
    """
    form, constants = without_constants(source(loop, plant, columns, integrating, limited))
    made = FunctionType(_compiled(form), {"__builtins__": {"zip": zip}}, "run", constants)
    return cast("Stepper", made)


def without_constants(text: str) -> tuple[str, tuple[float, ...]]:
    """Return a step loop with parameters for its float constants, and their values.

    If the torque limit of a drive follows a reference, its loop differs in each trajectory cycle, but only in its
    constants.
    """
    names: dict[str, str] = {}
    form = _CONSTANT.sub(lambda found: names.setdefault(found[0], f"c{len(names)}"), text)
    parameters = "".join(f", {name}" for name in names.values())
    return form.replace("columns):", f"columns{parameters}):", 1), tuple(map(float, names))


@lru_cache(maxsize=128)
def _compiled(form: str) -> CodeType:
    """Return the compiled code of a step loop whose constants are parameters."""
    (code,) = (each for each in compile(form, "<servo step>", "exec").co_consts if isinstance(each, CodeType))
    return code


def initial_state(plant: Discrete, position: float) -> State:
    """Return the state at rest at `position` (counts) without wind-up."""
    states = [position if name == "position" else 0.0 for name in plant.names]
    return (*states, 0.0, 0.0, 0.0, position, 0, 0, 0.0)


def empty_columns(columns: tuple[str, ...]) -> Columns:
    """Return one empty column for each name.

    A column is a list, because appending to a list takes a quarter of the time.
    """
    return tuple([] for _ in columns)


def put(values: Sequence[float] | Row, row: Row) -> None:
    """Write a column into `row`, doubles; for a list three times as fast as by NumPy."""
    if isinstance(values, list):
        pack_into(f"{len(values)}d", row, 0, *values)  # type: ignore[arg-type]
    else:
        row[:] = values


def source(
    loop: Loop, plant: Motor | Drive, columns: tuple[str, ...], integrating: bool, limited: bool
) -> str:
    """Return the Python source of the step loop."""
    made = discretise(plant, loop.period)
    state = ", ".join([*(_NAMES[name] for name in made.names), *_MEMORY])
    head = "for r, f in zip(demand, feed):" if loop.has_feed_forward else "for r in demand:"
    body = [
        *_measure(loop, made),
        *_integral(loop, integrating, limited),
        *_derivative(loop),
        *_sum(loop, limited),
        *_write_down(loop, made, columns),
        *_velocity_memory(loop),
        *_move(made, loop.period),
    ]
    lines = [
        "def run(demand, feed, state, columns):",
        f"    {state} = state",
        *(f"    a{i} = columns[{i}]" for i in range(len(columns))),
        f"    {head}",
        *("        " + line for line in body),
        f"    return {state}",
    ]
    return "\n".join(lines) + "\n"


# ------------------------------------------------------------------------------------------------ the control law


def _measure(loop: Loop, plant: Discrete) -> list[str]:
    position = "p - d" if plant.load_encoder else "p"
    whole = loop.arithmetic != "real"
    lines = [f"y = {position}{_ROUND}"] if plant.quantised or whole else [f"y = {position}"]
    lines.append(f"e = r{_ROUND} - y" if whole else "e = r - y")
    if loop.arithmetic == "lm628":
        lines += _clamp("e", 32767.0, -32768.0)
    return lines


def _integral(loop: Loop, integrating: bool, limited: bool) -> list[str]:
    ki, limit = loop.integral, loop.integral_limit
    if not loop.has_integral:
        return []
    lines = ["s += e"] if integrating else []
    if loop.arithmetic == "lm628":
        lines += _clamp("s", 8388607.0, -8388608.0) if integrating else []
        lines += [f"i = {ki!r} * ({_floor('s', 256.0)})", *_clamp("i", limit, -limit)]
    elif loop.arithmetic == "chapter12":
        lines += [f"x = {ki!r} * s", f"i = {_truncate('x', 256.0)}", *_clamp("i", limit, -limit)]
    elif loop.limit_style == "sum":
        bound = limit / abs(ki)
        lines += _clamp("s", bound, -bound) if limited and integrating else []
        lines.append(f"i = {ki!r} * s")
    else:
        lines.append(f"i = {ki!r} * s")
        lines += _clamp("i", limit, -limit) if limited else []
    return lines


def _derivative(loop: Loop) -> list[str]:
    if not loop.derivative:
        return []
    if loop.derivative_every == 1:
        return ["g = e - q", "q = e"]
    sample = [f"k = {loop.derivative_every - 1}", "g = e - q", "q = e"]
    return ["if k:", "    k -= 1", "else:", *("    " + line for line in sample)]


def _sum(loop: Loop, limited: bool) -> list[str]:
    if loop.arithmetic == "real":
        return _real_sum(loop, limited)
    return _whole_sum(loop)


def _real_sum(loop: Loop, limited: bool) -> list[str]:
    terms = [f"{loop.proportional!r} * e"]
    if loop.has_integral:
        terms.append("i")
    if loop.derivative:
        terms.append(f"{loop.derivative!r} * g")
    if loop.velocity_feedback:
        terms.append(f"{-loop.velocity_feedback!r} * (y - z)")
    if loop.has_feed_forward:
        terms.append("f")
    lines = [f"u = {' + '.join(terms)}"]
    if loop.output_deadband:
        lines += [f"if {-loop.output_deadband!r} < u < {loop.output_deadband!r}:", "    u = 0.0"]
    if loop.output_offset:
        lines.append(f"u += {loop.output_offset!r}")
    if loop.reversed:
        lines.append("u = -u")
    if limited:
        lines += _clamp("u", loop.output_limit, -loop.output_limit)
    if loop.dac_bits:
        lines += [f"u = u * {1.0 / loop.dac_step!r}{_ROUND}", *_dac(loop)]
    return lines


def _whole_sum(loop: Loop) -> list[str]:
    """Return code for the integer sum of chapter 12 or of the LM628.

    Chapter 12 has (P + I + D)/16 for a 12-bit DAC, in general 16 bits less those of the DAC. The LM628 keeps
    the top bits of the sum.
    """
    terms = [("e", loop.proportional), ("g", loop.derivative)]
    summands = [f"{gain!r} * {name}" for name, gain in terms if gain]
    divisor = float(1 << (FINE_BITS - loop.dac_bits))
    if loop.arithmetic == "chapter12":
        summands += ["i"] if loop.has_integral else []
        lines = [f"x = {' + '.join(summands) or '0.0'}", f"u = {_truncate('x', divisor)}"]
    else:
        lines, names = [], []
        for name, text in zip("ab", summands, strict=False):
            lines += [f"{name} = {text}", *_word(name, loop.wrap)]
            names.append(name)
        names += ["i"] if loop.has_integral else []
        lines += [f"u = {' + '.join(names) or '0.0'}", *_word("u", loop.wrap), f"u = {_floor('u', divisor)}"]
    if loop.reversed:
        lines.append("u = -u")
    top = loop.output_limit / loop.dac_step
    lines += _clamp("u", float(int(top)), -float(int(top)))
    return lines + _dac(loop)


def _dac(loop: Loop) -> list[str]:
    """Return code that converts DAC steps (in u) to volts, with the override."""
    full = float(1 << (loop.dac_bits - 1))
    lines: list[str] = []
    if loop.override:
        most = float(loop.override.steps)
        renew = [
            f"h = {loop.override.hold - 1}",
            f"m = v * {full / loop.override.speed!r}{_ROUND}",
            f"if u > m + {most!r}:",
            f"    u = m + {most!r}",
            f"elif u < m - {most!r}:",
            f"    u = m - {most!r}",
            "o = u",
        ]
        lines = ["if h:", "    h -= 1", "    u = o", "else:", *("    " + line for line in renew)]
    return [*lines, *_clamp("u", full - 1.0, -full), f"u *= {loop.dac_step!r}"]


def _word(name: str, wrap: bool) -> list[str]:
    """Return code that limits a product to 16 bits."""
    if wrap:
        return [f"{name} = ({name} + 32768.0) % 65536.0 - 32768.0"]
    return _clamp(name, 32767.0, -32768.0)


def _floor(name: str, divisor: float) -> str:
    """Return code for an integer division by a power of two, rounded down.

    Subtracting half a divisor (less a half) lets rounding to nearest round down, without ties.
    """
    return f"({name} - {(divisor - 1.0) / 2.0!r}) * {1.0 / divisor!r}{_ROUND}"


def _truncate(name: str, divisor: float) -> str:
    """Return code for an integer division rounded towards zero, like C."""
    up = f"({name} + {(divisor - 1.0) / 2.0!r}) * {1.0 / divisor!r}{_ROUND}"
    return f"{_floor(name, divisor)} if {name} > 0.0 else {up}"


def _clamp(name: str, high: float, low: float) -> list[str]:
    if high == inf:
        return []
    return [
        f"if {name} > {high!r}:",
        f"    {name} = {high!r}",
        f"elif {name} < {low!r}:",
        f"    {name} = {low!r}",
    ]


def _write_down(loop: Loop, plant: Discrete, columns: tuple[str, ...]) -> list[str]:
    volts = loop.dac_step / (1 << (FINE_BITS - loop.dac_bits)) if loop.arithmetic != "real" else 1.0
    integral = ("i" if volts == 1.0 else f"i * {volts!r}") if loop.has_integral else "0.0"
    texts = {
        "position": "p",
        "velocity": "v",
        "current": _linear(plant, plant.current) or "0.0",
        "twist": "d" if "twist" in plant.names else "0.0",
        "integral": integral,
        "output": "u",
    }
    return [f"a{i}.append({texts[name]})" for i, name in enumerate(columns)]


def _velocity_memory(loop: Loop) -> list[str]:
    return ["z = y"] if loop.velocity_feedback and loop.arithmetic == "real" else []


# ------------------------------------------------------------------------------------------------------ the plant


def _move(plant: Discrete, period: float) -> list[str]:
    if not plant.backlash:
        return _move_in_contact(plant, 1, period)
    half = 0.5 * plant.backlash
    lines: list[str] = []
    for head, contact in ((f"if d > {half!r}:", 1), (f"elif d < {-half!r}:", -1), ("else:", 0)):
        lines += [head, *("    " + line for line in _move_in_contact(plant, contact, period))]
    return lines


def _move_in_contact(plant: Discrete, contact: int, period: float) -> list[str]:
    if not plant.has_friction:
        return _advance(plant, plant.regimes[SLIDING_UP, contact])
    up = _slide(plant, contact, SLIDING_UP, period)
    down = _slide(plant, contact, SLIDING_DOWN, period)
    stuck = _advance(plant, plant.regimes[STUCK, contact])
    push = _linear(plant, plant.regimes[STUCK, contact].drive, skip="v") or "0.0"
    free = plant.breakaway
    rest = [f"x = {push}", f"if x > {free!r}:", *_in(up), f"elif x < {-free!r}:", *_in(down)]
    rest += ["else:", *_in(stuck)] if stuck else []
    return ["if v > 0.0:", *_in(up), "elif v < 0.0:", *_in(down), "else:", *_in(rest)]


def _slide(plant: Discrete, contact: int, direction: int, period: float) -> list[str]:
    """Return code for one sample of sliding.

    If the motor would reverse within it, it stops, and may stick in the next sample.
    """
    comparison = "<" if direction == SLIDING_UP else ">"
    return [
        "x = p",
        "n = v",
        *_advance(plant, plant.regimes[direction, contact]),
        f"if v {comparison} 0.0:",
        f"    p = x + {0.5 * period!r} * n * n / (n - v)",
        "    v = 0.0",
    ]


def _advance(plant: Discrete, regime: Regime) -> list[str]:
    names = [_NAMES[name] for name in plant.names]
    targets: list[str] = []
    texts: list[str] = []
    for name, row, b, w in zip(names, regime.a, regime.b, regime.w, strict=True):
        text = _linear(plant, (*row, b, w)) or "0.0"
        if text != name:
            targets.append(name)
            texts.append(text)
    return [f"{', '.join(targets)} = {', '.join(texts)}"] if targets else []


def _linear(plant: Discrete, row: Sequence[float], skip: str = "") -> str:
    """Return the source of a linear combination of the states, the output and 1."""
    names = [*(_NAMES[name] for name in plant.names), "u", ""]
    terms = []
    for name, factor in zip(names, row, strict=True):
        if factor == 0.0 or (skip and name == skip):
            continue
        terms.append(repr(factor) if not name else name if factor == 1.0 else f"{factor!r} * {name}")
    return " + ".join(terms)


def _in(lines: list[str]) -> list[str]:
    return ["    " + line for line in lines]
