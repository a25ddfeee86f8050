"""Check for lines that poll a position of an axis until it equals a number.

    LU"POSITION",1RL@0,IE500,BK,NO,JR-4

The axis may pass a count between two readings, so IE may never see it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from motionlang.kernel.mccl import Command, Fault, Line

Add = Callable[[int, Fault], None]

_POSITIONS = frozenset({"POSITION", "AUXPOSITION"})
_READS = frozenset({"read_word", "read_long", "read_float", "read_double"})
_EQUALITIES = {"if_equal": "IG{0} is true behind {0}, IB{0} before it",
               "if_unequal": "IB{0} is true before {0}, IG{0} behind it"}  # fmt: skip
_REPEATS = frozenset({"repeat", "jump", "jump_by", "jump_macro"})


def exact_positions(lines: Iterable[Line], add: Add) -> None:
    """Warn of each IE and IU that polls a position."""
    # What the registers hold: the name of a variable whose address LU has looked up. Register 0 is the accumulator.
    names: dict[int, str] = {}
    for line in lines:
        polls = any(command.verb in _REPEATS for command in line.commands)
        position = False
        for command, at in zip(line.commands, line.offsets, strict=True):
            verb = command.verb
            if verb in _EQUALITIES:
                if position and polls:
                    add(at, _exact(command, verb))
                continue
            if verb == "look_up":
                names[0] = str(command.value).upper()
            elif verb == "store" and command.number is not None:
                names[command.number] = names.get(0, "")
            elif verb in _READS:
                position = names.get(int(command.value), "") in _POSITIONS  # @n: its value is the register
                names[0] = ""
                continue
            elif command.axis == 0 and verb not in _REPEATS:
                names[0] = ""
            position = False


def _exact(command: Command, verb: str) -> Fault:
    message = f"{command.text} compares a moving position for equality, which is rarely true"
    return Fault(0, message, _EQUALITIES[verb].format(f"{command.value:.10g}"), "exact-position")
