"""AV: a function of the accumulator, by number.

Angles are in degrees, as in contour arcs. The board's function numbers are not known; these are ours.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.registers import limited, too_large
from motionlang.kernel.mccl.keywords.row import Group, accumulator, pure

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask

Function = Callable[[float], float | int]


def _tangent(angle: float) -> float:
    if math.fmod(angle, 180.0) in (90.0, -90.0):
        raise ValueError
    return math.tan(math.radians(angle))


def _sine(angle: float) -> float:
    """Return the sine of an angle in degrees, exactly 0 at multiples of 180."""
    return 0.0 if math.fmod(angle, 180.0) == 0.0 else math.sin(math.radians(angle))


# The name and function by number; ValueError and OverflowError if it has no value.
FUNCTIONS: tuple[tuple[str, Function], ...] = (
    ("change of sign", lambda a: -a),
    ("absolute value", abs),
    ("sine of degrees", _sine),
    ("cosine of degrees", lambda a: _sine(math.fmod(a, 360.0) + 90.0)),
    ("tangent of degrees", _tangent),
    ("arc sine, degrees", lambda a: math.degrees(math.asin(a))),
    ("arc cosine, degrees", lambda a: math.degrees(math.acos(a))),
    ("arc tangent, degrees", lambda a: math.degrees(math.atan(a))),
    ("square root", math.sqrt),
    ("power of e", math.exp),
    ("natural logarithm", math.log),
    ("whole part", int),
    ("real number", float),
)


@accumulator("computes")
@pure
def evaluate(task: CommandTask, command: Command) -> None:
    """Replace the accumulator with the value of function n of it.

    Raises Fault if the function is undefined there.
    """
    name, function = FUNCTIONS[task.whole(command)]
    given = value = task.registers[0]
    radians = task.board.assumptions.get("mccl.angles") == "radians"
    try:
        if radians and name.endswith("of degrees"):
            value = math.degrees(value)
        result = function(value)
        if radians and name.endswith(", degrees"):
            result = math.radians(result)
        task.registers[0] = limited(task, result)
    except OverflowError:
        raise too_large() from None
    except ValueError:
        plain = name.removesuffix(" of degrees").removesuffix(", degrees")
        raise Fault(codes.PARAMETER, f"there is no {plain} of {given:.10g}", kind="range") from None


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("registers").row


ROWS = (
    _row("AV", "command", "W", "none", "number", evaluate,
         "Evaluate a function of the accumulator: 0 change of sign, 1 absolute value, 2 sine, 3 cosine, 4 tangent, "
         "5 arc sine, 6 arc cosine, 7 arc tangent (all in degrees), 8 square root, 9 power of e, 10 natural "
         "logarithm, 11 whole part, 12 as a real number. The numbers are ours.", "AL30,AV2,TR0", low=0, high=12),
)  # fmt: skip
