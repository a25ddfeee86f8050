"""The words that are known and not simulated, sorted by what a program that comes to one of them can be told.

They stand in the text files of `type_library/`, each with what becomes of it. A "value" is one that nobody knows here:
a reading, or drive data. The program may write it and read it back; what it reads without having written it, the
machine file says, or the run ends there. A "command" has no effect on motion, inputs or outputs: the program goes on,
and the report names it. A "motion" moves an axis or decides what becomes of the program: the run ends where one is
written or carried out, as everything after it would be wrong; one that is given 0 is switched off, which needs no
simulation. Every operation is given the line of its statement and the place of its word, last.
"""

from __future__ import annotations

from motionlang.lang.keyword import Actions
from motionlang.mint.keywords.no_effect import Kept, note
from motionlang.mint.keywords.no_effect import write_value as _keep

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.runtime.binding import Operation
    from motionlang.mint.runtime.environment import Environment

# Words that are simulated when they are read, and what writing them would do.
WRITTEN = {"POSDEMAND": "makes the demanded position jump, without a profile"}

# ----------------------------------------------------------------------------- values that nobody knows here


def read_value(environment: Environment, row: Keyword) -> Operation:
    """What the program wrote, or the machine file says; otherwise the run ends."""
    kept = environment.part(Kept)

    def read(*given: object) -> object:
        *where, _, at = given
        found = kept.find(row, tuple(where))
        if found is None:
            _end(row, f"the value of {row.name} is not known here", at, told=True)
        return found

    return read


def write_value(environment: Environment, row: Keyword) -> Operation:
    keep = _keep(environment, row)
    return lambda *given: keep(*given[:-1])


# ----------------------------------------------------------------------------------------------- commands


def do_command(environment: Environment, row: Keyword) -> Operation:
    """A command that changes nothing here."""
    name, without_effect = row.name, environment.machine.without_effect
    return lambda *given: note(without_effect, name, given[-2])


# ------------------------------------------------------------------------------------------------- motion


def read_motion(environment: Environment, row: Keyword) -> Operation:
    return read_value(environment, row)


def write_motion(environment: Environment, row: Keyword) -> Operation:
    """Given 0 it is switched off and nothing moves; any other value ends the run."""
    keep = _keep(environment, row)

    def write(*given: object) -> None:
        if given[-3] != 0:
            _end(row, f"{row.name} is not simulated", given[-1])
        keep(*given[:-1])

    return write


def do_motion(environment: Environment, row: Keyword) -> Operation:
    return lambda *given: _end(row, f"{row.name} is not simulated", given[-1])


def write_jump(environment: Environment, row: Keyword) -> Operation:
    """A word that is simulated where it is read."""
    return lambda *given: _end(
        row, f"writing {row.name} {WRITTEN[row.name]}: this is not simulated", given[-1]
    )


def _end(row: Keyword, message: str, at: object, told: bool = False) -> NoReturn:
    """End the run with the word's meaning, and with what the machine file could say."""
    from motionlang.lang.run_errors import NotSimulated

    hint = f"{row.name}: {row.help.rstrip('.')}"
    if told:
        example = {"text": '"…"', "number": "1.5"}.get(row.unit, "1")
        hint = f"{hint}; the machine file can say it: [mint.readings] {row.name} = {example}"
    raise NotSimulated(message, hint, int(at))  # type: ignore[call-overload]


# ------------------------------------------------------------------------------------------------- keywords

VALUE, COMMAND, MOTION = "unsimulated.value", "unsimulated.command", "unsimulated.motion"
JUMP = "unsimulated.jump"
ACTIONS = {
    VALUE: Actions(VALUE, read=read_value, write=write_value),
    COMMAND: Actions(COMMAND, do=do_command),
    MOTION: Actions(MOTION, read=read_motion, write=write_motion, do=do_motion),
}
# What becomes of a word, as the groups of the vocabulary say it.
GROUPS = {
    VALUE: "known only if the program writes it or the machine file says it",
    COMMAND: "without an effect",
    MOTION: "where it moves or decides, the run ends",
}
KEPT_GROUP = "kept without an effect"


def written(row: Keyword) -> Keyword:
    """The row by which a word is written, where that is another one: some are simulated only where they are read."""
    changed = _changed.get(row.name)
    if changed is None:
        from copy import copy

        changed = _changed[row.name] = copy(row)
        changed.verb, changed.simulated = JUMP, False
    return changed


_changed: dict[str, Keyword] = {}
