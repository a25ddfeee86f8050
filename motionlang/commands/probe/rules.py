"""The open facts of a keyword as assumptions, with generated probes.

Alternatives and probe are derived from the kind of fact and the keyword's row. A default is tested by reading the
keyword after power-up, a range by writing a value beyond it, a type by writing a fraction, a scale by reading a value
back under another scale. A fact that cannot be tested in this way (a meaning, a unit that appears only in motion) is
not handled here; it has an entry of its own, or no probe.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

from motionlang.commands.probe.assumption import ERROR, REFUSED, SETTLED, Assumption, Probe
from motionlang.commands.probe.fact_evidence import of_word
from motionlang.kernel import Keyword
from motionlang.kernel.files import package_text

# Units of integer values, and of those that have a scale.
SCALED = ("uu", "uu/s", "uu/s2", "uu/s3")
# If an integer setting has no more values than this, each alternative is named.
MAX_NAMED_VALUES = 4
# The two scales between which a value is read back, and the value.
SCALES, VALUE = (10, 20), 5
# The fraction that is written, relative to the lowest value: no rounding makes it another value's.
FRACTION = 0.75
# The text of a handler, before the value that was an error.
REFUSES = "refuses"
# Below this a Float of 32 bits distinguishes adjacent integers.
EXACT = 1e7
AGAIN = "switch the drive off, and restart the controller afterwards"


def other_defaults(row: Keyword) -> list[str]:
    """Return the alternatives to a default: each possible value, or a general text."""
    low, high = row.low if row.low is not None else 0, 1 if row.unit == "bool" else row.high
    if not row.takes_fractions and high is not None and high - low < MAX_NAMED_VALUES:
        few = [f"{value}" for value in range(int(low), int(high) + 1) if value != row.default]
        if few:
            return few
    if isinstance(row.default, str):
        return ["any other text"]
    return ["any other number"]


def default_probe(row: Keyword) -> Probe:
    """Return the probe of an axis setting, which is read after power-up."""
    return Probe("mint", f"{row.name}({{a}})", answers=(f"{row.default:.10g}",), form="{}")


def unsettled_facts(language: str, row: Keyword) -> list[Assumption]:
    """Return the open facts of a keyword that a generated probe can test.

    A default that has an entry is not included.
    """
    if not row.simulated:
        return []
    makers = MINT if language == "mint" else MCCL
    found: list[Assumption] = []
    for fact, evidence in of_word(language, row).items():
        if evidence.strength in SETTLED or fact not in makers or (row.name, fact) in unasked(language):
            continue
        for name, question, chosen, others, probe in makers[fact](row):
            found.append(
                Assumption(
                    f"{language}.{row.name.lower().replace('_', '')}-{name}",
                    question,
                    chosen,
                    alternatives=tuple(others),
                    why=evidence.source,
                    strength=evidence.strength,
                    words=(row.name,),
                    probe=probe,
                )
            )
    return found


@cache
def unasked(language: str) -> frozenset[tuple[str, str]]:
    """Return the keywords and facts that the dialect's `unasked.txt` excludes."""
    found: set[tuple[str, str]] = set()
    facts: list[str] = []
    for line in package_text(f"commands/probe/evidence/{language}/unasked.txt").splitlines():
        if line.startswith("  "):
            found.update((word, fact) for word in line.split() for fact in facts)
        elif line and not line.startswith("#"):
            facts = line.partition(" · ")[0].split()
    return frozenset(found)


Questions = list[tuple[str, str, str, list[str], Probe]]


def _subscript(row: Keyword) -> str | None:
    """Return the text in the brackets after a keyword: the axis, or its example's.

    None if it is unknown.
    """
    if row.index == "axis":
        return "({a})"
    if row.index in ("none", ""):
        return ""
    match = re.search(rf"\b{re.escape(row.name)}(\([\d, ]+\))", row.example)
    return match[1] if match else None


def _is_stored(row: Keyword) -> bool:
    """True if a keyword of Mint only stores a value of an axis, without any effect."""
    return (
        row.kind == "setting"
        and {"R", "W"} == set(row.access)
        and row.index == "axis"
        and row.is_stored
        and row.function != "enable_output"
    )


# ------------------------------------------------------------------------------------------------------ Mint


def _default(row: Keyword) -> Questions:
    subscript = _subscript(row)
    if subscript is None or row.kind != "setting" or "R" not in row.access or isinstance(row.default, str):
        return []
    probe = Probe("mint", f"{row.name}{subscript}", answers=(f"{row.default:.10g}",), form="{}", alone=True)
    question = f"What {row.name}{subscript.replace('{a}', 'axis')} is at power-up"
    return [("default", question, f"{row.default:.10g}", other_defaults(row), probe)]


def _range(row: Keyword) -> Questions:
    """Return questions with the last valid value and one beyond it.

    The error handler reports the rejected one.
    """
    if not _is_stored(row):
        return []
    found: Questions = []
    for end, most, bound, step in (("high", "greatest", row.high, 1), ("low", "least", row.low, -1)):
        if bound is None:
            continue
        beyond = _beyond(bound, step)
        probe = Probe(
            "mint",
            f"{row.name}({{a}})",
            before=(
                f"fa = {bound:.10g}",
                f"{row.name}({{a}}) = fa",
                f"fa = {beyond}",
                f"{row.name}({{a}}) = fa",
            ),
            error=f'"{REFUSES} "; fa',
            answers=(f"{REFUSES} {beyond}", f"{REFUSES} {bound:.10g}", beyond, f"{bound:.10g}"),
            alone=True,
            needs=AGAIN,
        )
        others = [
            f"it ends before {bound:.10g}",
            f"{beyond} is taken, too",
            f"{beyond} becomes {bound:.10g}, without an error",
        ]
        found.append((f"range-{end}", f"The {most} value of {row.name}", f"{bound:.10g}", others, probe))
    return found


def _beyond(bound: float, step: int) -> str:
    """Return a number clearly outside a range, beyond the given bound."""
    if abs(bound) >= EXACT:
        return f"{bound * 2:.10g}"
    return f"{bound + step:.10g}" if bound == int(bound) else f"{0 if bound * step < 0 else 2 * bound:.10g}"


def _unit(row: Keyword) -> Questions:
    if not _is_stored(row):
        return []
    if row.unit in SCALED:
        return _scale(row)
    if not row.takes_fractions and (row.high is None or row.high > (row.low or 0)):
        return _type(row)
    return []


def _scale(row: Keyword) -> Questions:
    """Return a question with a second scale, which changes values stored in counts."""
    first, second = SCALES
    stored = VALUE * first / second
    if (row.low is not None and row.low > VALUE) or (row.high is not None and row.high < VALUE):
        return []
    probe = Probe(
        "mint",
        f"{row.name}({{a}})",
        before=(
            f"SCALEFACTOR({{a}}) = {first}",
            f"{row.name}({{a}}) = {VALUE}",
            f"SCALEFACTOR({{a}}) = {second}",
        ),
        answers=(f"{stored:.10g}", f"{VALUE}"),
        alone=True,
        needs=AGAIN,
    )
    question = f"Whether {row.name} follows SCALEFACTOR"
    return [
        ("scale", question, "yes: user units, stored in counts", ["no, or it is stored as written"], probe)
    ]


def _type(row: Keyword) -> Questions:
    low = int(row.low or 0)
    probe = Probe(
        "mint",
        f"{row.name}({{a}})",
        before=(f"fa = {low + FRACTION:.10g}", f"{row.name}({{a}}) = fa"),
        answers=(f"{low}", f"{low + FRACTION:.10g}", f"{low + 1}", ERROR),
        alone=True,
        needs=AGAIN,
    )
    others = [
        "it keeps a fraction",
        "a fraction is rounded to the nearest whole number",
        "a fraction is an error",
    ]
    return [("type", f"What {row.name} makes of a fraction", "it is cut off: a whole number", others, probe)]


def _short(row: Keyword) -> Questions:
    """Return a question that compares a short form with its keyword.

    There is none if reading causes motion.
    """
    subscript = _subscript(row)
    if subscript is None or "R" not in row.access:
        return []
    ask = f'{row.short}{subscript}; " "; {row.name}{subscript}'
    probe = Probe("mint", ask, answers=(r"re:(\S+) \1", REFUSED, r"re:(\S+) (?!\1$)\S+"), alone=True)
    others = ["no such short form is known", f"it is the short form of another word than {row.name}"]
    return [("short", f"The short form of {row.name}", row.short.upper(), others, probe)]


def _number(row: Keyword) -> Questions:
    """Return a question about the number of a constant."""
    if row.kind != "constant" or not re.fullmatch(r"-?\d+", row.function):
        return []
    others = [
        "another number: then a program that writes the name still fits, and one that writes the number does not"
    ]
    probe = Probe("mint", row.name, answers=(row.function,), form="{}", alone=True)
    return [("number", f"The number of {row.name}", row.function, others, probe)]


# ------------------------------------------------------------------------------------------------------ MCCL


def _code(row: Keyword) -> Questions:
    """Return a question whose parameter a board rejects with a code, or accepts."""
    if row.kind != "setting" or not row.is_stored:
        return []
    found: Questions = []
    axis = "{a}" if row.index in ("axis", "axes") else ""
    for end, most, bound, step in (("high", "greatest", row.high, 1), ("low", "least", row.low, -1)):
        if bound is not None:
            beyond = _beyond(bound, step)
            probe = Probe("mccl", f"{axis}{row.name}{beyond}", answers=("?-1", ""), alone=True, needs=AGAIN)
            others = [f"{beyond} is taken, too"]
            found.append((f"range-{end}", f"The {most} value of {row.name}", f"{bound:.10g}", others, probe))
    return found


def _bare(row: Keyword) -> Questions:
    """Return a question about a command without an axis."""
    if row.kind != "reading" or row.access != "R" or row.index not in ("axis", "axes"):
        return []
    lines, code = "it reports every axis, one per line", "it answers a code: an axis must be named"
    outcomes = [(lines, r"re:\d.*"), (code, r"re:\?-?\d+")]
    (chosen, first), (other, second) = outcomes if row.index == "axes" else outcomes[::-1]
    probe = Probe("mccl", row.name, answers=(first, second), alone=True)
    return [("axis", f"{row.name} without an axis number", chosen, [other], probe)]


MINT: dict[str, Callable[[Keyword], Questions]] = {
    "meaning": _number,
    "default": _default,
    "range": _range,
    "unit": _unit,
    "short": _short,
}
MCCL: dict[str, Callable[[Keyword], Questions]] = {"range": _code, "index": _bare}
