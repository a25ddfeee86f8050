r"""The lines of MCAPI's port: a call is one line, and its answer is one line.

    MCMoveAbsolute 1 2 5000.0
    0
    MCGetPositionEx 1 2 +
    0 3125.0

A call is the name of the function, the handle, and the arguments in the order of C, separated by blanks. An
answer is the value that the function returns, then its results. A function without a result answers with the
error code. A failed call has no results. The full protocol is in docs/mcapi-protocol.md.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from math import isfinite

from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.session import BadCall, function_named
from motionlang_mcapi.table import FUNCTIONS, STRUCTURES, Value

VERSION = 1
# The longest line, in characters.
MAX_LINE = 32_768
# The words for a NULL pointer, and for a result that the host has room for.
NULL, ROOM = "-", "+"
_TOKEN = re.compile(r'"((?:[^"\\]|\\.)*)"(?=\s|$)|(\S+)')
_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{2}|.)", re.DOTALL)
_ESCAPES = {"n": "\n", "r": "\r", "t": "\t", '"': '"', "\\": "\\"}
# `=` is escaped, too, so that ` = ` separates a call from its answer in a log.
_NAMES = {"=": "\\x3d", "\n": "\\n", "\r": "\\r", "\t": "\\t", '"': '\\"', "\\": "\\\\"}


def encode(values: Iterable[Value | None]) -> str:
    """Return values as the words of a line."""
    return " ".join(map(_word, values))


def decode(text: str) -> list[Value | None]:
    """Return the values of the words of a line; raise BadCall for an invalid word."""
    if '"' not in text:
        return [_value(word) for word in text.split()]
    found: list[Value | None] = []
    for match in _TOKEN.finditer(text):
        quoted, word = match.groups()
        found.append(_value(word) if quoted is None else _unescaped(quoted))
    return found


def parse(line: str) -> tuple[str, int, list[Value | None]]:
    """Return function, handle and arguments of a call.

    The handle is 0 for functions without one.
    """
    name, _, rest = line.partition(" ")
    function = function_named(name)
    values = decode(rest)
    if not function.has_handle:
        return name, 0, values
    if not values or not isinstance(values[0], int):
        raise BadCall(f"{name} needs a handle")
    return name, values[0], values[1:]


def request(name: str, handle: int, arguments: Sequence[Value | None]) -> str:
    """Return the line of a call."""
    function = FUNCTIONS[name]
    words = [name, str(handle)] if function.has_handle else [name]
    at = 0
    for each in function.arguments:
        value = arguments[at]
        at += 1
        if (each.out or each.kind == "memory") and value is not None:
            words.append(ROOM)
            continue
        words.append(_word(value))
        if (each.size or each.kind in STRUCTURES) and not each.out and isinstance(value, int):
            words += map(_word, arguments[at : at + value])
            at += value
    return " ".join(words)


def answer(call: ApiCall) -> str:
    """Return the line that answers a call."""
    return encode((call.result, *call.outputs))


def _word(value: Value | None) -> str:
    if value is None:
        return NULL
    if isinstance(value, str):
        return '"' + "".join(map(_escaped, value)) + '"'
    return repr(value)


def _escaped(character: str) -> str:
    if character in _NAMES:
        return _NAMES[character]
    if " " <= character <= "~":
        return character
    code = ord(character)
    return f"\\x{code:02x}" if code < 256 else "?"


def _value(word: str) -> Value | None:
    if word == NULL:
        return None
    if word == ROOM:
        return 1
    try:
        return int(word)
    except ValueError:
        pass
    try:
        found = float(word)
    except ValueError:
        raise BadCall(f"{word[:40]!r} is not a value") from None
    if isfinite(found) or word.lstrip("+-").lower() in ("inf", "nan"):
        return found
    raise BadCall(f"{word[:40]!r} is too large")


def _unescaped(text: str) -> str:
    return _ESCAPE.sub(lambda match: _character(match.group(1)), text)


def _character(code: str) -> str:
    if len(code) == 3:
        return chr(int(code[1:], 16))
    if code not in _ESCAPES:
        raise BadCall(f"\\{code} is no escape")
    return _ESCAPES[code]
