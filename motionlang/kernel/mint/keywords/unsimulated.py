"""Keywords that are known but not simulated, and their treatment in a run.

The text files of `type_library/` list them, each with its treatment:

- A "value", such as a reading or drive data, cannot be computed here. The program may write it and read it back.
  If the program reads a value that it did not write, the machine file supplies it; without an entry the run ends.
- A "command" has no effect on motion, inputs or outputs: the program continues, and the report names it.
- A "motion" moves an axis or changes the course of the program. The run ends where one is written or carried out,
  because everything after it would be wrong. Writing 0 switches it off, which needs no simulation.

Every operation receives the line of its statement and the source offset of its keyword as last arguments.
"""

from __future__ import annotations

from copy import copy
from typing import NoReturn

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.lang.run_errors import NotSimulated
from motionlang.kernel.mint.keywords.no_effect import StoredValues, note
from motionlang.kernel.mint.keywords.no_effect import write_value as _store
from motionlang.kernel.mint.runtime.binding import Operation
from motionlang.kernel.mint.runtime.environment import Environment

# Keywords that are simulated for reads only, and the effect of writing them.
WRITTEN = {"POSDEMAND": "makes the demanded position jump, without a profile"}

# ----------------------------------------------------------------------------- values that are not known


def read_value(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that reads a value from the program or the machine file.

    The run ends if neither has one.
    """
    stored = environment.component(StoredValues)

    def read(*given: object) -> object:
        *where, _, at = given
        found = stored.find(row, tuple(where))
        if found is None:
            _end(row, f"the value of {row.word} is not known here", at, with_hint=True)
        return found

    return read


def write_value(environment: Environment, row: Keyword) -> Operation:
    store = _store(environment, row)
    return lambda *given: store(*given[:-1])


# ----------------------------------------------------------------------------------------------- commands


def do_command(environment: Environment, row: Keyword) -> Operation:
    """Make an operation for a command that has no effect here."""
    name, without_effect = row.name, environment.machine.without_effect
    return lambda *given: note(without_effect, name, given[-2])


# ------------------------------------------------------------------------------------------------- motion


def write_motion(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that accepts 0 and ends the run for any other value."""
    store = _store(environment, row)

    def write(*given: object) -> None:
        if given[-3] != 0:
            _end(row, f"{row.word} is not simulated", given[-1])
        store(*given[:-1])

    return write


def do_motion(environment: Environment, row: Keyword) -> Operation:
    return lambda *given: _end(row, f"{row.word} is not simulated", given[-1])


def write_jump(environment: Environment, row: Keyword) -> Operation:
    """Make an operation that ends the run: the keyword is simulated for reads only."""
    return lambda *given: _end(
        row, f"writing {row.word} {WRITTEN[row.name]}: this is not simulated", given[-1]
    )


def _end(row: Keyword, message: str, at: object, with_hint: bool = False) -> NoReturn:
    """End the run with the meaning of the keyword.

    With `with_hint` the message suggests a machine file entry.
    """
    hint = f"{row.name}: {row.help.rstrip('.')}"
    if with_hint:
        hint = f"{hint}; give it in the machine file: [mint.values] {row.example_value}"
    raise NotSimulated(message, hint, int(at))  # type: ignore[call-overload]


# ------------------------------------------------------------------------------------------------- keywords

VALUE, COMMAND, MOTION = "unsimulated.value", "unsimulated.command", "unsimulated.motion"
JUMP = "unsimulated.jump"
ACTIONS = {
    VALUE: Actions(VALUE, read=read_value, write=write_value),
    COMMAND: Actions(COMMAND, do=do_command),
    MOTION: Actions(MOTION, read=read_value, write=write_motion, do=do_motion),
}
# The groups of the vocabulary for each treatment.
GROUPS = {
    VALUE: "known only if the program writes it or the machine file says it",
    COMMAND: "without an effect",
    MOTION: "where it moves or decides, the run ends",
}


def written(row: Keyword) -> Keyword:
    """Return the row for writing a keyword that is simulated only for reads."""
    changed = _changed.get(row.name)
    if changed is None:
        changed = _changed[row.name] = copy(row)
        changed.function, changed.simulated = JUMP, False
    return changed


_changed: dict[str, Keyword] = {}
