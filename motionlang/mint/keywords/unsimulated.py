"""The words that are known and not simulated, sorted by what a program that comes to one of them can be told.

A word of the type library that no list has is a value that nobody knows here: a reading, or drive data. The program may
write it and read it back; what it reads without having written it, the machine file says, or the run ends there.
A word that is simulated stands in another group, which takes precedence.
"""

from __future__ import annotations

VALUE, COMMAND, MOTION, FACTOR = (
    "unsimulated.value",
    "unsimulated.command",
    "unsimulated.motion",
    "unsimulated.factor",
)
JUMP = "unsimulated.jump"
# What becomes of a word, as the groups of the vocabulary say it.
GROUPS = {
    VALUE: "known only if the program writes it or the machine file says it",
    COMMAND: "without an effect",
    MOTION: "where it moves or decides, the run ends",
    FACTOR: "where it is not 1, the run ends",
}
KEPT_GROUP = "kept without an effect"

# Commands without an effect on motion, inputs or outputs: the program goes on, and the report names them.
_COMMANDS = """
AUTOTUNEABORT BINARY CAPTURETRIGGER CLEARERRORLOG CON EDIT NEW PARAMETERSAVE PLCDEFAULT PLCTASK POPREDIRECT
PROG SENTINEL VIEW
"""
# Words that move an axis, or decide what becomes of the program: the run ends where one is written or carried out, as
# everything after it would be wrong. A setting of them that is given 0 is switched off, which needs no simulation.
_MOTION = """
AUTOHOMEMODE AUTOTUNE CONTROLLERRESET JOGAWAY KNIFE MOVECORRECTION MOVEFIDUCIAL MOVERTEST PRESETMOVEENABLE
PRESETMOVEENABLEOLD PROCESSORRESET PUSHREDIRECT SERVOC USERMOTION
"""
# Factors of everything that moves: without an effect as long as they are 1.
_FACTORS = "TIMESCALE"

_VERBS = {
    word: verb
    for verb, text in ((COMMAND, _COMMANDS), (MOTION, _MOTION), (FACTOR, _FACTORS))
    for word in text.split()
}
# Words of Mint v4 that no type library lists: NAME|short form|index|meaning.
COMMANDS = """\
SERVOC||axis|v4: close the servo loop again where the axis stands
"""
# Words that are simulated when they are read, and what writing them would do.
WRITTEN = {"POSDEMAND": "makes the demanded position jump, without a profile"}


def verb(name: str) -> str:
    """What a word stands for that is neither simulated nor kept."""
    return _VERBS.get(name, VALUE)


def is_known(verb: str) -> bool:
    """Whether a word has one of the verbs of this module."""
    return verb in GROUPS or verb == JUMP


def words() -> frozenset[str]:
    """Every word that a list has."""
    return frozenset(_VERBS)
