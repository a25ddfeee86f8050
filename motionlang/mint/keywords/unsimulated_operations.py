"""Words that are known and not simulated: what they can do without a lie they do, for the others the run ends.

Every operation is given the line of its statement and the place of its word, last.
"""

from __future__ import annotations

from motionlang.mint.keywords import table
from motionlang.mint.keywords.no_effect_operations import Kept, note
from motionlang.mint.keywords.no_effect_operations import write_value as _keep
from motionlang.mint.keywords.unsimulated import WRITTEN

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


# ----------------------------------------------------------------------------- values that nobody knows here


def read_value(environment: Environment, row: Row) -> Operation:
    """What the program wrote, or the machine file says; otherwise the run ends."""
    kept = environment.part(Kept)

    def read(*given: object) -> object:
        *where, _, at = given
        found = kept.find(row, tuple(where))
        if found is None:
            _end(row, f"the value of {row.name} is not known here", at, told=True)
        return found

    return read


def write_value(environment: Environment, row: Row) -> Operation:
    keep = _keep(environment, row)
    return lambda *given: keep(*given[:-1])


# ----------------------------------------------------------------------------------------------- commands


def do_command(environment: Environment, row: Row) -> Operation:
    """A command that changes nothing here."""
    name, without_effect = row.name, environment.machine.without_effect
    return lambda *given: note(without_effect, name, given[-2])


# ------------------------------------------------------------------------------------------------- motion


def read_motion(environment: Environment, row: Row) -> Operation:
    return read_value(environment, row)


def write_motion(environment: Environment, row: Row) -> Operation:
    """Given 0 it is switched off and nothing moves; any other value ends the run."""
    keep = _keep(environment, row)

    def write(*given: object) -> None:
        if given[-3] != 0:
            _end(row, f"{row.name} is not simulated", given[-1])
        keep(*given[:-1])

    return write


def do_motion(environment: Environment, row: Row) -> Operation:
    return lambda *given: _end(row, f"{row.name} is not simulated", given[-1])


def write_jump(environment: Environment, row: Row) -> Operation:
    """A word that is simulated where it is read."""
    return lambda *given: _end(
        row, f"writing {row.name} {WRITTEN[row.name]}: this is not simulated", given[-1]
    )


def _end(row: Row, message: str, at: object, told: bool = False) -> NoReturn:
    """End the run with the word's meaning, and with what the machine file could say."""
    from motionlang.lang.run_errors import NotSimulated

    known = table().get(row.name)
    hint = f"{row.name}: {known.help.rstrip('.')}" if known is not None else ""
    if told:
        example = {"text": '"…"', "number": "1.5"}.get(row.unit, "1")
        hint = f"{hint}; the machine file can say it: [mint.readings] {row.name} = {example}"
    raise NotSimulated(message, hint, int(at))  # type: ignore[call-overload]


OPERATIONS = {
    "unsimulated.value": {"read": read_value, "write": write_value},
    "unsimulated.motion": {"read": read_motion, "write": write_motion, "do": do_motion},
    "unsimulated.command": {"do": do_command},
    "unsimulated.jump": {"write": write_jump},
}
