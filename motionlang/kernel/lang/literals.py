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

A value replaces the text of the number, so a run is that of the edited program. The tokens of the highlighter are
enough to find literals: a statement is a word with an index, an equals sign and values, or a command of MCCL. A
condition is a comparison after IF, PAUSE, AND and the like. SPEED[0] without a line means writes only, not conditions.
Numbers in the brackets of a word, such as channels, and those of CASE and PRINT have no address.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.source import Source
from motionlang.kernel.tools import nearest

Token = tuple[str, str, int]
Values = Mapping[str, float | str]

_LINE = re.compile(r"line:(\d+)(?:\.value)?", re.IGNORECASE)
_ADDRESS = re.compile(
    r"(\d*[A-Za-z_]\w*)(?:\.(\d+(?:\.\d+)*)|\[([^\[\]]*)\]|\(([^()]*)\))?(?:@(\d+))?(?::(\d+))?"
)
_DOTTED = re.compile(r"(\w+?)((?:\.\d+)+)")
# So many addresses are named in a hint.
MAX_NAMED = 4


@dataclass(eq=False, slots=True)
class Literal:
    """A number in the text: its `address`, its target (`base`), and its position.

    `is_whole` is true if the number is the whole value and not part of an expression, `is_write` if a
    statement writes it, rather than a condition or a loop.
    """

    address: str
    base: str
    line: int
    offset: int
    text: str
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


def literals_of(source: Source, language: Dialect) -> list[Literal]:
    """Return the literals of a program that have an address, in the order of the text."""
    starts = [0, *(found.end() for found in re.finditer("\n", source.text))]
    found: list[tuple[str, int, Token, bool, bool]] = []
    counted = ""  # the variable of the For whose numbers these are
    for statement in _statements(source.text, language):
        line = bisect_right(starts, statement[0][2])
        word = statement[0][1].lower() if statement[0][0] == "control" else ""
        if word in language.before_conditions:
            rows = [(*each, False) for each in _compared(statement[1:], language)]
        elif word in language.counting and (counted or word == language.counting[0]):
            if word == language.counting[0]:
                counted = _target(statement[1:], language)[0] if len(statement) > 1 else ""
            rows = [
                (counted, token, whole, False) for token, whole in _numbers(_behind_equals(statement[1:]))
            ]
        else:
            rows = [(*each, True) for each in _values(statement, language)]
        counted = counted if word in language.counting else ""
        found += [(base, line, token, whole, writes) for base, token, whole, writes in rows]
    return _addressed(found)


def _addressed(found: Sequence[tuple[str, int, Token, bool, bool]]) -> list[Literal]:
    """Assign addresses to literals and return them.

    The writes of a line are numbered before its conditions, so that a condition does not change the address
    of a write.
    """
    counts: dict[tuple[str, int, bool], int] = {}
    for base, line, _, _, writes in found:
        key = base.lower(), line, writes
        counts[key] = counts.get(key, 0) + 1
    made: list[Literal] = []
    numbers: dict[tuple[str, int, bool], int] = {}
    for base, line, (_, text, offset), whole, writes in found:
        key = base.lower(), line, writes
        before = 0 if writes else counts.get((base.lower(), line, True), 0)
        number = numbers[key] = numbers.get(key, 0) + 1
        several = counts[key] > 1 or before or not whole
        suffix = f":{before + number}" if several else ""
        made.append(Literal(f"{base}@{line}{suffix}", base, line, offset, text, whole, writes))
    return made


def edited(
    source: Source, language: Dialect, values: Values, found: Sequence[Literal] | None = None
) -> tuple[Source, dict[str, float | str], list[str]]:
    """Return the edited program, the values of names, and notes for the report.

    In the program's text the literals have their new values. `found` are the program's `literals`, if they
    are known. Raises ProgramError with every address that is wrong.
    """
    addressed, named = _sorted(source, language, values)
    if not addressed:
        return source, named, []
    found = literals_of(source, language) if found is None else found
    edits: dict[int, tuple[int, str]] = {}
    notes: list[str] = []
    wrong: list[Diagnostic] = []
    for address, value in addressed.items():
        try:
            chosen = _chosen(found, address, source)
            text = number_text(address, value)
        except ProgramError as error:
            wrong += error.diagnostics
            continue
        edits |= {each.offset: (len(each.text), text) for each in chosen}
        if "@" not in address and ":" not in address:
            lines = ", ".join(str(each.line) for each in chosen)
            count = "1 literal, line" if len(chosen) == 1 else f"{len(chosen)} literals, lines"
            notes.append(f"{address} = {text} sets {count} {lines}")
    if wrong:
        raise ProgramError(wrong)
    return Source(source.name, replaced(source.text, edits)), named, notes


def constants(source: Source, language: Dialect) -> list[Literal]:
    """Return the numbers that a program gives to names, in the order of the text; the address is the name."""
    found: list[Literal] = []
    tokens = [*language.tokens(source.text), ("separator", "\n", len(source.text))]
    for number, (kind, word, _) in enumerate(tokens):
        if kind != "control" or word.lower() not in language.declaring:
            continue
        line, _ = source.location(tokens[number][2])
        rest = [each for each in tokens[number + 1 : number + 7] if source.location(each[2])[0] == line]
        equals = next((k for k, each in enumerate(rest) if each[1] == "="), len(rest))
        after = rest[equals + 1 : equals + 3]
        if after and after[0][0] == "number" and (len(after) == 1 or after[1][0] not in ("operator", "word")):
            name, (_, text, offset) = rest[0][1], after[0]
            found.append(Literal(name, name, line, offset, text, True, True))
    return found


def bound(
    source: Source, language: Dialect, values: Values, found: Sequence[Literal]
) -> tuple[Source, dict[str, str]] | None:
    """Return the program with constants in place of literals, and the constant names.

    The result maps the names in `values` to these names. Such a program is compiled once for many values.
    None if this is not possible: the language has no constants, or a literal is not the whole value of a
    keyword.
    """
    if not language.constant:
        return None
    edits: dict[int, tuple[int, str]] = {}
    names: dict[str, str] = {}
    for given, value in values.items():
        addressed, _ = _sorted(source, language, {given: value})
        for address in addressed:
            chosen = _chosen(found, address, source)
            keywords = [language.table().get(each.base.partition("[")[0]) for each in chosen]
            fits = all(each.is_whole and each.is_write for each in chosen)
            if isinstance(value, str) or not fits or None in keywords:
                return None
            names[given] = f"literal_{len(names) + 1}"
            edits |= {each.offset: (len(each.text), names[given]) for each in chosen}
    if not names or "literal_" in source.text.lower():
        return None
    constants = "".join(
        f"{language.constant.format(name, number_text(given, values[given]))} : "
        for given, name in names.items()
    )
    return Source(source.name, constants + replaced(source.text, edits)), names


def has_address(values: Values, language: Dialect) -> bool:
    """True if a name may be an address: by its form, or because it is a keyword."""
    return any(canonical(name) is not None or language.table().get(name) is not None for name in values)


def replaced(text: str, edits: Mapping[int, tuple[int, str]]) -> str:
    """Return a text with replacements at some offsets.

    Each edit has the length of the text that it replaces, and the new text.
    """
    chunks, end = [], 0
    for offset, (length, word) in sorted(edits.items()):
        chunks += [text[end:offset], word]
        end = offset + length
    return "".join(chunks) + text[end:]


def _sorted(
    source: Source, language: Dialect, values: Values
) -> tuple[dict[str, float | str], dict[str, float | str]]:
    """Separate the values by address from those by name.

    A keyword is not a name unless the program declares it.
    """
    addressed: dict[str, float | str] = {}
    named: dict[str, float | str] = {}
    own: set[str] | None = None
    for name, value in values.items():
        address = canonical(name)
        row = language.table().get(name) if address is None else None
        if row is not None:
            own = _declared(source, language) if own is None else own
            address = None if name.lower() in own else row.name
        if address is None:
            named[name] = value
        else:
            addressed[address] = value
    return addressed, named


def _declared(source: Source, language: Dialect) -> set[str]:
    """Return the words of the statements that declare names, in lower case.

    A keyword may be among them, because a program may declare it as a name.
    """
    found: set[str] = set()
    end, declares = 0, False
    for kind, text, offset in language.tokens(source.text):
        if "\n" in source.text[end:offset] or (kind == "separator" and text == ":"):
            declares = False
        declares = declares or (kind == "control" and text.lower() in language.declaring)
        if declares and kind in ("word", "control"):
            found.add(text.lower())
        end = offset + len(text)
    return found


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
        count = "1 literal" if len(here) == 1 else f"{len(here)} literals"
        raise _wrong(f"line {line} has {count} of {base.upper()}", here)
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


def number_text(address: str, value: float | str) -> str:
    """Return a value in the notation of the program."""
    if isinstance(value, str) or not isfinite(value):
        raise ProgramError.of("option", f"{address} is a number, not {value!r}")
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))


def _statements(text: str, language: Dialect) -> Iterator[list[Token]]:
    """Yield the tokens of each statement; a control word such as THEN begins one."""
    statement: list[Token] = []
    depth, end = 0, 0
    for kind, word, offset in language.tokens(text):
        if kind == "separator" and word.startswith("\\"):  # the statement continues on the next line
            end = text.find("\n", offset) + 1
            continue
        ends = "\n" in text[end:offset] or (
            kind == "separator" and (word.strip() in ("", ":") or word == "\n")
        )
        if kind == "axis" or (kind == "command" and (not statement or statement[-1][0] != "axis")):
            ends = True
        if (ends or kind in ("control", "comment")) and depth <= 0:
            if statement:
                yield statement
            statement = []
        depth += (word in ("(", "[")) - (word in (")", "]")) if kind == "separator" else 0
        if "\n" in text[end:offset]:
            depth = int(kind == "separator" and word in ("(", "["))
        end = offset + len(word)
        if kind != "comment" and not (kind == "separator" and (not word.strip() or word == ":")):
            statement.append((kind, word, offset))
    if statement:
        yield statement


def _values(statement: list[Token], language: Dialect) -> Iterator[tuple[str, Token, bool]]:
    """Yield the target of each literal of a statement, and the literal itself.

    The third item is true if the literal is the whole value.
    """
    kinds = [kind for kind, _, _ in statement]
    if kinds[0] in ("axis", "command"):
        yield from _of_command(statement, language)
        return
    if kinds[0] == "control":
        if statement[0][1].lower() not in language.before_statements:
            return
        statement = statement[1:]
    if not statement or statement[0][0] != "word":
        return
    base, index, rest = _target(statement, language)
    if rest and rest[0][1] == "=":
        values, repeated = _split(rest[1:])
        indices = index.split(",") if index else []
        for number, value in enumerate(values):
            if len(values) == len(indices):
                where = indices[number]
            elif repeated and indices:
                where = ",".join(indices[number:]) if number == len(values) - 1 else indices[number]
            else:
                where = index
            for token, whole in _numbers(value):
                yield (
                    (f"{base}[{where}]" if where else base),
                    token,
                    whole and (len(values) <= max(1, len(indices))),
                )
    elif bool(rest) is not bool(index):
        row = language.table().get(base)
        if row is None or row.index != "none" or row.kind not in ("setting", "statement", "command"):
            return
        values = _split(statement[2:-1])[0] if index else [rest] if row.kind == "setting" else []
        for value in values:  # of WAIT(7) or WAIT 7
            for token, whole in _numbers(value):
                yield base, token, whole


_COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))


def _compared(condition: list[Token], language: Dialect) -> Iterator[tuple[str, Token, bool]]:
    """Yield the word that is compared, and each number in the comparison."""
    tokens = [each for number, each in enumerate(condition) if not _groups(condition, number)]
    comparisons: list[list[Token]] = [[]]
    for token in tokens:
        if token[0] == "operator" and token[1] in ("&", "|"):
            comparisons.append([])
        else:
            comparisons[-1].append(token)
    if not all(_comparison(comparison) for comparison in comparisons):  # the operator works on bits
        comparisons = [tokens]
    for comparison in comparisons:
        at = _comparison(comparison)
        first = next((number for number, each in enumerate(comparison) if each[0] == "word"), None)
        if not at or first is None:
            continue
        base, index, _ = _target(comparison[first:], language)
        for side in (comparison[:at], comparison[at + 1 :]):
            for token, whole in _numbers(side):
                yield (f"{base}[{index}]" if index else base), token, whole


def _comparison(tokens: list[Token]) -> int:
    """Return the index of the comparison operator, 0 if there is none."""
    found = (n for n, (kind, text, _) in enumerate(tokens) if kind == "operator" and text in _COMPARISONS)
    return next(found, 0)


def _groups(tokens: list[Token], number: int) -> bool:
    """True if a token is a bracket that groups a condition and follows no word."""
    if tokens[number][1] in ("(", "["):
        return not number or tokens[number - 1][0] != "word"
    if tokens[number][1] not in (")", "]"):
        return False
    depth = 0
    for before in range(number, -1, -1):
        depth += (tokens[before][1] in (")", "]")) - (tokens[before][1] in ("(", "["))
        if depth == 0:
            return not before or tokens[before - 1][0] != "word"
    return True  # it closes a bracket in front of an AND


def _behind_equals(tokens: list[Token]) -> list[Token]:
    """Return the tokens after an equals sign, or all tokens if there is none."""
    at = next((n for n, each in enumerate(tokens) if each[1] == "="), -1)
    return tokens[at + 1 :]


def _of_command(statement: list[Token], language: Dialect) -> Iterator[tuple[str, Token, bool]]:
    axis = statement[0][1] if statement[0][0] == "axis" else ""
    command = next((text for kind, text, _ in statement if kind == "command"), "")
    number = next((token for token in statement if token[0] == "number"), None)
    row = language.table().get(command)
    if command and number is not None and (row is None or row.verb not in language.jumps):
        yield f"{axis}{command.upper()}", number, True


def _target(statement: list[Token], language: Dialect) -> tuple[str, str, list[Token]]:
    """Return the first word of a statement, its index as text, and the other tokens."""
    word, index, end = statement[0][1], "", 1
    dotted = _DOTTED.fullmatch(word)
    if dotted is not None:
        word, index = dotted[1], dotted[2][1:].replace(".", ",")
    elif len(statement) > 1 and statement[1][1] in ("(", "["):
        end = _closing(statement) + 1
        index = "".join(text for _, text, _ in statement[2 : end - 1])
    row = language.table().get(word)
    return row.name if row is not None else word, index, statement[end:]


def _closing(statement: list[Token]) -> int:
    """Return the index of the bracket that closes the first one, or of the last token."""
    depth = 0
    for number, (_, text, _) in enumerate(statement):
        depth += (text in ("(", "[")) - (text in (")", "]"))
        if depth == 0 and number:
            return number
    return len(statement) - 1


def _split(tokens: list[Token]) -> tuple[list[list[Token]], bool]:
    """Return the values of a list, and True if a final `;` repeats the last one."""
    values: list[list[Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token[1] in ("(", "[")) - (token[1] in (")", "]"))
        if depth == 0 and token[1] == ",":
            values.append([])
        elif depth == 0 and token[1] == ";":
            return values, True
        else:
            values[-1].append(token)
    return values, False


def _numbers(value: list[Token]) -> Iterator[tuple[Token, bool]]:
    """Yield the numbers of a value, except those in the brackets of a word.

    A sign is part of a number that is the only one.
    """
    if len(value) == 2 and value[0][1] == "-" and value[1][0] == "number":
        (_, _, begin), (_, text, offset) = value
        yield ("number", "-" + " " * (offset - begin - 1) + text, begin), True
        return
    within, depth = 0, 0
    for number, (kind, text, offset) in enumerate(value):
        if text in ("(", "["):
            depth += 1
            if not within and number and value[number - 1][0] == "word":
                within = depth
        elif text in (")", "]"):
            within = 0 if within == depth else within
            depth -= 1
        elif kind == "number" and not within:
            yield (kind, text, offset), len(value) == 1
