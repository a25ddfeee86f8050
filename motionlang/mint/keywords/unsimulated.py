"""The words that are known and not simulated, sorted by what a program that comes to one of them can be told.

They stand in the text files of `type_library/`, each with what becomes of it. A "value" is one that nobody knows here:
a reading, or drive data. The program may write it and read it back; what it reads without having written it, the
machine file says, or the run ends there. A "command" has no effect on motion, inputs or outputs: the program goes on,
and the report names it. A "motion" moves an axis or decides what becomes of the program: the run ends where one is
written or carried out, as everything after it would be wrong; one that is given 0 is switched off, which needs no
simulation.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword

VALUE, COMMAND, MOTION = "unsimulated.value", "unsimulated.command", "unsimulated.motion"
JUMP = "unsimulated.jump"
# What becomes of a word, as the groups of the vocabulary say it.
GROUPS = {
    VALUE: "known only if the program writes it or the machine file says it",
    COMMAND: "without an effect",
    MOTION: "where it moves or decides, the run ends",
}
KEPT_GROUP = "kept without an effect"
# Words that are simulated when they are read, and what writing them would do.
WRITTEN = {"POSDEMAND": "makes the demanded position jump, without a profile"}


def written(row: Keyword) -> Keyword:
    """The row by which a word is written, where that is another one: some are simulated only where they are read."""
    changed = _changed.get(row.name)
    if changed is None:
        from copy import copy

        changed = _changed[row.name] = copy(row)
        changed.verb, changed.simulated = JUMP, False
    return changed


_changed: dict[str, Keyword] = {}


def is_known(verb: str) -> bool:
    """Whether a word has one of the verbs of this module."""
    return verb in GROUPS or verb == JUMP
