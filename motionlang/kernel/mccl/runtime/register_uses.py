"""The registers that a command reads and sets; the rule of loops uses them."""

from __future__ import annotations

from motionlang.kernel.lang.steps import NOTHING, Uses, own
from motionlang.kernel.mccl.resolve.command import NONE, NUMBER, REGISTER, Command

# Registers with numbers below this one belong to a task, all others to the board.
PRIVATE = 10
ACCUMULATOR = own(0)

_NO_REGISTER: frozenset[int] = frozenset()
_ACCUMULATOR = frozenset((ACCUMULATOR,))


def variable(register: int) -> int:
    """Return the number of a register in `Uses`."""
    return own(register) if register < PRIVATE else register


def uses_of(command: Command) -> Uses | None:
    """Return the registers that a command uses; None if that is not known before the run.

    `keywords.row.accumulator` says how its action treats the accumulator. What has an effect is left out of iterations
    that are equal, since they had none.
    """
    given = frozenset((variable(int(command.value)),)) if command.kind == REGISTER else _NO_REGISTER
    match getattr(command.action, "accumulator", "keeps" if command.pure else ""):
        case "sets":
            return Uses(given, _ACCUMULATOR)
        case "reads":
            return Uses(given, _ACCUMULATOR, given)
        case "adds":
            return Uses(_ACCUMULATOR | given, _ACCUMULATOR)
        case "computes":
            return Uses(_ACCUMULATOR | given, _ACCUMULATOR, _ACCUMULATOR | given)
        case "compares":
            return Uses(_ACCUMULATOR | given, tests=_ACCUMULATOR - given)
        case "tests":
            return Uses(_ACCUMULATOR | given, nonlinear=_ACCUMULATOR | given, tests=_ACCUMULATOR - given)
        case "stores" | "recalls" as way:
            number = command.number
            if command.kind not in (NUMBER, NONE) or number is None or number < 0:
                return None
            register = frozenset((variable(number),))
            return Uses(_ACCUMULATOR, register) if way == "stores" else Uses(register, _ACCUMULATOR)
        case "keeps":
            return Uses(given, nonlinear=given)
    return NOTHING
