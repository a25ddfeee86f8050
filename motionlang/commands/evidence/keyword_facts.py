"""The facts of a keyword as text, each with its evidence."""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.commands.evidence.fact_evidence import Evidence, is_remembered, of_word
from motionlang.kernel import Keyword
from motionlang.kernel import dialect as language

ACCESS = {"R": "read", "W": "write", "RW": "read and write", "C": "command"}
# The certainty of a fact, by its strength.
TRUST = {
    "manual": "printed in a manual",
    "code": "taken from running code",
    "sibling": "printed for a similar product",
    "name only": "only the name, the arguments and the type; the meaning is assumed",
    "memory high": "from memory with high confidence, not checked against a manual",
    "memory medium": "from memory with medium confidence, not checked against a manual",
    "memory low": "from memory with low confidence, not checked against a manual",
    "choice": "a choice: no source",
}
UNITS = {
    "uu": "user units",
    "uu/s": "user units/s",
    "uu/s2": "user units/s²",
    "uu/s3": "user units/s³",
    "s": "seconds",
    "ms": "milliseconds",
    "%": "percent",
    "bool": "0 or 1",
    "bits": "a bit pattern",
}
# What a run does with a keyword that is not simulated, by the function of its row.
IN_A_RUN = {
    "no_effect.value": "what is written is stored and read back, without an effect",
    "unsimulated.value": "a run ends where it reads a value that neither the program nor the machine file has given",
    "unsimulated.command": "it has no effect",
    "unsimulated.motion": "a run ends where the program uses it, unless it writes 0",
}
INDEX = {
    "axis": "an axis",
    "axes": "one axis or several",
    "channel": "a channel",
    "bank": "a bank",
    "none": "",
}


def facts(row: Keyword, dialect: str) -> list[tuple[str, str]]:
    """Return the facts of a row as pairs of label and text.

    A missing fact has an empty text. A fact is followed by its evidence if that differs from the evidence of
    the keyword itself.
    """
    default = "" if row.default is None else _figure(row.default)
    evidence = of_word(dialect, row)
    known = evidence["meaning"]
    trust = TRUST[known.strength]
    source = f"{known.source} ({trust})" if known.source else trust
    return [
        ("form", ", ".join(language(dialect).forms(row))),
        ("short form", _with(row.short, "short", evidence)),
        ("use", ACCESS.get(row.access, row.access)),
        ("for", _with(INDEX.get(row.index, row.index), "index", evidence)),
        ("unit", _with(UNITS.get(row.unit, row.unit), "unit", evidence)),
        ("default", _with(default, "default", evidence)),
        ("range", _with(row.accepted, "range", evidence)),
        ("group", row.group),
        ("known from", source),
    ]


def standing(row: Keyword, dialect: str) -> str:
    """Return what a reader should know of a keyword first: that it is not simulated, or only remembered; or ""."""
    if is_remembered(row, dialect):
        return "as remembered, not as printed: no document that could be read says what it does."
    if row.caveat:
        is_named = of_word(dialect, row)["meaning"].strength == "name only"
        reason = (
            "the sources have only its name"
            if is_named
            else "no document that could be read says what it does"
        )
        effect = IN_A_RUN.get(row.function, "a program that uses it gets a message")
        return f"known, not simulated: {effect}. Reason: {reason}."
    return ""


def _with(text: str, fact: str, evidence: Mapping[str, Evidence]) -> str:
    own, meaning = evidence.get(fact), evidence["meaning"]
    if not text or own is None or (own.strength, own.source) == (meaning.strength, meaning.source):
        return text
    if own.strength == meaning.strength and not own.source:
        return text
    return f"{text} ({own})"


def _figure(value: float | str) -> str:
    return value if isinstance(value, str) else f"{value:.10g}"
