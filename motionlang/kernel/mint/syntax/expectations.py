"""Messages for syntax errors, derived from the token kinds that would be valid."""

from __future__ import annotations

import re

from motionlang.kernel.lang.syntax.grammar import BAD, END
from motionlang.kernel.lang.typography import typographic, unclosed
from motionlang.kernel.mint.syntax.tokens import SPELLINGS

VALUE = {"NUMBER", "STRING"}  # if both are valid, any value is
STATEMENT = {"PAUSE", "DIM", "GOTO"}  # if all are valid, any statement is
SEPARATORS = {"_NL", "COLON"}
MAX_ALTERNATIVES = 3  # a longer list of alternatives does not help

ONE_FILE = "one file is one program: copy the text of the other file into this one"
# A token, the unexpected token after it, and what the author probably meant; names are in lower case.
SLIPS = {
    ("=", "="): "one = both assigns and compares",
    ("!", "="): "unequal is written <>",
    (":", "="): "a value is assigned by = alone",
    ("=", ">"): "greater or equal is written >=",
    ("=", "<"): "less or equal is written <=",
    ("&", "&"): "write And",
    ("|", "|"): "write Or",
    ("/", "/"): "a comment begins with '",
    ("*", "*"): "a power is written ^",
    ("=", "{"): "values have no braces: Dim a(3) = 1, 2, 3",
    (")", "{"): "a block has no braces, and ends with End If, End While or End Sub",
    ("then", "{"): "an If has no braces, and ends with End If",
    ("+", "="): "write the name again: a = a + 1",
    ("-", "="): "write the name again: a = a - 1",
    ("%", "="): "names have no type sign: a = 3",
    ("wait", "until"): "PAUSE waits for a condition: PAUSE INX(0)",
    ("wait", "for"): "WAIT waits for a time in ms: WAIT(100)",
    ("loop", "until"): "a loop with a condition is While … End While or Repeat … Until",
    ("loop", "while"): "a loop with a condition is While … End While or Repeat … Until",
    ("pause", "until"): "PAUSE waits until its condition is true: PAUSE INX(0)",
    ("continue", "for"): "there is no Continue: put the rest of the loop in an If",
    ("continue", "while"): "there is no Continue: put the rest of the loop in an If",
    (",", "\n"): "write another value after the comma, or remove it",
    ("=", "$"): "a hexadecimal number is written 0x1F",
    ("print", "$"): "a hexadecimal number is written 0x1F",
    ("error", "goto"): "an event handles errors: Event ONERROR",
    ("error", "gosub"): "an event handles errors: Event ONERROR",
    ("include", '"'): ONE_FILE,
}
_WITH_UNIT = re.compile(r"(\d+(?:\.\d*)?)(?:m?s|[cmu]?m|in|deg|rad|rev|rpm|k?hz|v|counts?)", re.IGNORECASE)
TYPE_SIGNS = "%$"
SEPARATED = "statements are separated by : or by a new line"
# The first word of a statement, and what its wrong brackets should be.
_BRACKETS = {"DIM": "subscripts are in round brackets: Dim a(5)", "EVENT": "an event has no parameters"}


def message(kinds: set[str], kind: str, text: str) -> str:
    """Return the message for a token whose kind is not one of `kinds`."""
    if kind == BAD:
        return _bad(text)
    wanted = _names_of(kinds)
    if kind in SPELLINGS and kind.isalpha() and text.isalpha() and wanted == ["a name"]:
        return f"`{text}` is a keyword and cannot be a name here"
    if not wanted or len(wanted) > MAX_ALTERNATIVES:
        return f"{found(kind, text)} is not allowed here"
    sentence = f"expected {' or '.join(wanted)}"
    if kind in ("_NL", END):
        return f"{sentence} before the end of the line"
    return f"{sentence}, found {found(kind, text)}"


def hint(kinds: set[str], before: str, text: str, first: str) -> str:
    """Return a suggested fix, "" if none is likely.

    `before` is the token before `text`, or two equal signs, and `first` the kind of the statement's first token.
    """
    is_first = before.strip() in ("", ":")
    if text[:1] == '"' and not text.endswith('"', 1):
        misprint = unclosed(text)
        return misprint[1] if misprint else 'add the closing "'
    if found_typographic := typographic(text):
        return found_typographic[1]
    if text[:1] == "'" and kinds >= VALUE:
        return "' begins a comment; text is in double quotes"
    if text == "!":
        return SLIPS["!", "="]
    if text == "/" and is_first:
        return SLIPS["/", "/"]
    if text == "&" and before.lower() in ("=", "(", ",", "print"):
        return "a hexadecimal number is written 0x1F"
    if text.lower() == "as" and before.isidentifier():
        return f"Dim declares a variable: Dim {before} As Integer"
    if text.lower() == "elseif" and "ELSE" in kinds:
        return "in an If of one line write Else If"
    if text.lower() in ("end", "endif") and "ELSE" in kinds:
        return "an If of one line has no End If: remove it"
    if text.lower() == "in" and first == "FOR":
        return "a loop over numbers is For i = 1 To 3 … Next"
    if number := _WITH_UNIT.fullmatch(text):
        return f"numbers have no unit: {number[1]}"
    if text.lower() == "not" and kinds >= VALUE:
        return "Not takes all that follows; write it in brackets, (Not b)"
    if slip := SLIPS.get((before.lower(), text[:1])) or SLIPS.get((before.lower(), text.lower())):
        return slip
    if before in ("++", "--"):
        return SLIPS[before[:1], "="]
    wanted = _names_of(kinds)
    if text in TYPE_SIGNS and before.isidentifier():
        return f"names have no type sign: {before}"
    if text.lower() == "do":
        return (
            "a loop is While … End While, Repeat … Until or Loop … End Loop" if is_first else f"remove {text}"
        )
    if text.isdecimal() and text.endswith("0") and not before.strip():  # other Basics count lines in tens
        return "lines have no numbers; a label is a name: #begin on a line of its own"
    if text in ("(", "[") and first in _BRACKETS:
        return _BRACKETS[first]
    if len(wanted) == 1 and wanted[0].startswith("`"):
        return f"add {wanted[0].strip('`')}"
    if "THEN" in kinds:
        return "add Then"
    if before.lower() == "return":
        return "a Function gives its value to its own name: name = value"
    if before in (")", "]") and text[:1].isdigit():
        return f"write = before the value: = {text}"
    if before.lower() in ("goto", "gosub") and text.isdigit():
        return f"a label is a name: #begin on a line of its own, and {before} begin"
    if "`)`" in wanted and not text.strip():
        return "add )"
    if wanted == ["the end of the line"] and text.strip():
        if text == "#" or first == "HASH":
            return SLIPS["/", "/"]
        if first == "PRINT":
            return "values are separated by , or ; and statements by : or by a new line"
        return SEPARATED
    return ""


def found(kind: str, text: str) -> str:
    """Return a token as it is shown in messages."""
    if kind == "_NL":
        return "the end of the line"
    if kind == END:
        return "the end of the file"
    shown = text if len(text) <= 24 else text[:23] + "…"
    return f"`{shown}`"


def _bad(text: str) -> str:
    if text[0] == '"':
        misprint = unclosed(text)
        return misprint[0] if misprint else "the string is not closed"
    if text[0].isdigit():
        return f"{found('', text)} is not a number"
    if text[0] == "`":
        return "a character is written between two back quotes: `A`"
    if found_typographic := typographic(text):
        return found_typographic[0]
    if text.isprintable():
        return f"{found('', text)} has no meaning in Mint"
    return f"the character {ord(text[0]):#04x} has no meaning in Mint"


def _names_of(kinds: set[str]) -> list[str]:
    """Describe the valid kinds: whole classes first, then single keywords and symbols."""
    left = set(kinds)
    names = []
    if left >= STATEMENT:
        return ["a statement"]
    if left >= VALUE:
        return ["a value"]
    if "NAME" in left:
        names.append("a name")
        left = {kind for kind in left if not kind.isalpha() or kind in ("AS",)}
        left -= {"LPAR", "LSQB", "DOT", "EQUAL"}
    if "COMPARE" in left:
        left.discard("EQUAL")
        names.append("a comparison")
    if "THEN" in left:
        left.discard("DO")  # v4 spelling of Then
    if "END" in left:
        left -= SEPARATORS  # blank lines between the branches of a block are no useful suggestion
    if left & SEPARATORS:
        left -= SEPARATORS
        names.append("the end of the line")
    return names + sorted(f"`{SPELLINGS[kind]}`" for kind in left if kind in SPELLINGS)
