"""Literals by address: `--set` and `--vary` reach numbers without a name.

    SPEED[0]@12    the number that line 12 writes to SPEED of axis 0; SPEED(0)@12 and SPEED.0@12 are the same
    1SV@3          the parameter of the command 1SV in line 3
    d@7            the number that line 7 assigns to the variable d, or that a Define gives
    SPEED[0]       every number that the program writes to SPEED of axis 0
    MOVER[0]@9:2   the second number of an expression, or of several writes in one line
    POS[0]@10      the number with which a condition in line 10 compares POS of axis 0
    i@4:2          the second number of For i = 1 To 10 in line 4, its end
    WAIT@5         the time of WAIT 7 or WAIT(7) in line 5
    line:12        the only number in line 12

Each language finds the literals of a program in its tree (`Program.literals`); this module gives them their addresses
and finds those that an address means. A value replaces the literal in the tree, so a run is that of the edited program.
SPEED[0] without a line means writes only, not conditions. Numbers in the brackets of a word, such as channels, and
those of CASE and PRINT have no address.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import isfinite

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.dialect import dialect
from motionlang.kernel.lang.program import Program
from motionlang.kernel.source import Source
from motionlang.kernel.tools import count_of, nearest

Values = Mapping[str, float | str]

_LINE = re.compile(r"line:(\d+)(?:\.value)?", re.IGNORECASE)
_ADDRESS = re.compile(
    r"(\d*[A-Za-z_]\w*)(?:\.(\d+(?:\.\d+)*)|\[([^\[\]]*)\]|\(([^()]*)\))?(?:@(\d+))?(?::(\d+))?"
)
# So many addresses are named in a hint.
MAX_NAMED = 4


@dataclass(eq=False, slots=True)
class Literal:
    """A number in the text: its `address`, its target (`base`), its position, its text and its value.

    `is_whole` is true if the number is the whole value and not part of an expression, `is_write` if a
    statement writes it, rather than a condition or a loop.
    """

    address: str
    base: str
    line: int
    offset: int
    text: str
    value: float
    is_whole: bool
    is_write: bool


def canonical(name: str) -> str | None:
    """Return an address in its canonical spelling; None if a name is not an address."""
    text = name.replace(" ", "")
    line = _LINE.fullmatch(text)
    if line is not None:
        return f"line:{int(line[1])}"
    found = _ADDRESS.fullmatch(text)
    if found is None:
        return None
    word, dotted, square, round_, at, number = found.groups()
    index = next(
        (each for each in (dotted and dotted.replace(".", ","), square, round_) if each is not None), None
    )
    if index is None and at is None and not word[0].isdigit():
        return None
    base = word if index is None else f"{word}[{index}]"
    return base + (f"@{int(at)}" if at else "") + (f":{int(number)}" if number else "")


def addressed(found: Sequence[Literal]) -> list[Literal]:
    """Return literals in the order of the text, with addresses made of their bases and lines.

    The writes of a line are numbered before its conditions, so that a condition does not change the address
    of a write.
    """
    found = sorted(found, key=lambda each: each.offset)
    counts: dict[tuple[str, int, bool], int] = {}
    for each in found:
        key = each.base.lower(), each.line, each.is_write
        counts[key] = counts.get(key, 0) + 1
    numbers: dict[tuple[str, int, bool], int] = {}
    for each in found:
        key = each.base.lower(), each.line, each.is_write
        before = 0 if each.is_write else counts.get((each.base.lower(), each.line, True), 0)
        number = numbers[key] = numbers.get(key, 0) + 1
        several = counts[key] > 1 or before or not each.is_whole
        each.address = f"{each.base}@{each.line}{f':{before + number}' if several else ''}"
    return found


@dataclass(eq=False, slots=True)
class Placed:
    """Values of a program by their places.

    `literals` maps the offset of each literal that has a value to the name of that value, which is an address. `names`
    are the names of the other values. `notes` say which literals an address without a line means, for the report.
    """

    literals: dict[int, str] = field(default_factory=dict)
    names: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def placed(program: Program, values: Values) -> Placed:
    """Find the places of values by name or address; raise ProgramError with every address that is wrong."""
    found, wrong = Placed(), list[Diagnostic]()
    for name, value in values.items():
        address = _address(program, name)
        if address is None:
            found.names.append(name)
            continue
        try:
            chosen = _chosen(program.literals, address, program.source)
            text = number_text(address, value)
        except ProgramError as error:
            wrong += error.diagnostics
            continue
        found.literals |= dict.fromkeys((each.offset for each in chosen), name)
        if "@" not in address and ":" not in address:
            lines = ", ".join(str(each.line) for each in chosen)
            count = "1 literal, line" if len(chosen) == 1 else f"{len(chosen)} literals, lines"
            found.notes.append(f"{address} = {text} sets {count} {lines}")
    if wrong:
        raise ProgramError(wrong)
    return found


def _address(program: Program, name: str) -> str | None:
    """Return the address that the name of a value is, or None.

    A keyword is an address unless the program declares it as a name.
    """
    address = canonical(name)
    row = dialect(program.language).table().get(name) if address is None else None
    if row is None or name.lower() in program.declared:
        return address
    return row.name


def revalued(program: Program) -> list[Literal]:
    """Return the literals of a program, with the values in place of its own."""
    names, values = program.places.literals, program.values
    return [
        replace(each, text=number_text(name, values[name]), value=number(name, values[name]))
        if (name := names.get(each.offset, "")) in values
        else each
        for each in program.literals
    ]


def replaced(text: str, edits: Mapping[int, tuple[int, str]]) -> str:
    """Return a text with replacements at some offsets.

    Each edit has the length of the text that it replaces, and the new text.
    """
    chunks, end = [], 0
    for offset, (length, word) in sorted(edits.items()):
        chunks += [text[end:offset], word]
        end = offset + length
    return "".join(chunks) + text[end:]


def _chosen(found: Sequence[Literal], address: str, source: Source) -> list[Literal]:
    """Return the literals that an address means.

    Raises ProgramError if there is none, or if the address is ambiguous.
    """
    if address.startswith("line:"):
        line = int(address[5:])
        here = [each for each in found if each.line == line]
        written = [each for each in here if each.is_write]
        if len(here) == 1 or len(written) == 1:
            return written or here
        raise _wrong(_in_line(here, line, source), here or found)
    key = address.lower()
    exact = [each for each in found if each.address.lower() == key]
    if exact:
        return exact
    base, at, line_text = key.partition("@")
    same = [each for each in found if each.base.lower() == base]
    if not at:
        indexed = [each for each in found if each.base.lower().startswith(f"{base}[")]
        every = [
            each for each in found if each.is_write and ((each in same and each.is_whole) or each in indexed)
        ]
        if every:
            return every
        raise _wrong(f"the program writes no literal to {address}", same or indexed or found, address)
    here = [each for each in same if str(each.line) == line_text]
    if here:
        raise _wrong(f"{address} is one of {len(here)} literals", here)
    line = int(line_text.partition(":")[0])
    in_line = [each for each in found if each.line == line]
    here = [each for each in same if each.line == line]
    if here:
        raise _wrong(f"line {line} has {count_of(len(here), 'literal')} of {base.upper()}", here)
    if not in_line and re.search(r"\b\d", source.line(line)):
        raise _wrong(_in_line(in_line, line, source), same or found, address)
    raise _wrong(f"line {line} writes no literal to {base.upper()}", same or found, address)


def _in_line(here: Sequence[Literal], line: int, source: Source) -> str:
    """Return the reason why a line does not have exactly one literal."""
    if not here and re.search(r"\b\d", source.line(line)):
        return f"the numbers of line {line} have no address: those of CASE, PRINT and brackets have none"
    return f"line {line} has {len(here) or 'no'} literals"


def _wrong(message: str, others: Sequence[Literal], address: str = "") -> ProgramError:
    """Return the error for an address, with the addresses that were probably meant."""
    names = [each.address for each in others]
    near = nearest(address, names) if address else None
    if len(names) > MAX_NAMED and near is not None:
        names = [near]
    listed = ", ".join(names[:MAX_NAMED])
    hint = (
        f"write {listed}{' …' if len(names) > MAX_NAMED else ''}; check --literals lists all" if names else ""
    )
    return ProgramError.of("option", message, hint=hint)


def number(address: str, value: float | str) -> float:
    """Return a value as a program has it: an integer if it is whole; raise ProgramError if it is no number."""
    if isinstance(value, str) or not isfinite(value):
        raise ProgramError.of("option", f"{address} is a number, not {value!r}")
    return int(value) if value == int(value) and abs(value) < 1e15 else float(value)


def number_text(address: str, value: float | str) -> str:
    """Return a value in the notation of the program."""
    return repr(number(address, value))
