"""What a mistake of the text is called: from the kinds of token that could stand there to a sentence."""

from __future__ import annotations

from motionlang.lang.parsing.parser import BAD, END
from motionlang.lang.typography import typographic
from motionlang.mint.syntax.tables import SPELLINGS

VALUE = {"NUMBER", "STRING"}  # where both may stand, any value may
STATEMENT = {"PAUSE", "DIM", "GOTO"}  # likewise
SEPARATORS = {"_NL", "COLON"}
FEW = 3  # more things than this are no help

# A token that does not fit, the token before it, and what the writer probably meant.
SLIPS = {
    ("=", "="): "one = both assigns and compares",
    ("!", "="): "unequal is written <>",
    ("=", ">"): "greater or equal is written >=",
    ("=", "<"): "less or equal is written <=",
    ("&", "&"): "write And",
    ("|", "|"): "write Or",
    ("/", "/"): "a comment begins with '",
    ("*", "*"): "a power is written ^",
    ("+", "="): "write the name again: a = a + 1",
    ("-", "="): "write the name again: a = a - 1",
}


def message(kinds: set[str], kind: str, text: str) -> str:
    """The sentence for a token of a kind that is none of `kinds`."""
    if kind == BAD:
        return _bad(text)
    wanted = _things(kinds)
    if kind in SPELLINGS and kind.isalpha() and text.isalpha() and wanted == ["a name"]:
        return f"`{text}` is a word of the language and cannot be a name here"
    if not wanted or len(wanted) > FEW:
        return f"{found(kind, text)} cannot stand here"
    sentence = f"expected {' or '.join(wanted)}"
    if kind in ("_NL", END):
        return f"{sentence} before the end of the line"
    return f"{sentence}, found {found(kind, text)}"


def hint(kinds: set[str], before: str, text: str) -> str:
    """What to do about it, as far as one can tell."""
    if text[:1] == '"' and not text.endswith('"', 1):
        return 'add the closing "'
    if found_typographic := typographic(text):
        return found_typographic[1]
    if text == "!":
        return SLIPS["!", "="]
    if text.lower() == "elseif" and "ELSE" in kinds:
        return "in an If of one line write Else If"
    if text.lower() == "not" and kinds >= VALUE:
        return "Not takes all that follows; write it in brackets, (Not b)"
    if slip := SLIPS.get((before, text[:1])):
        return slip
    wanted = _things(kinds)
    if len(wanted) == 1 and wanted[0].startswith("`"):
        return f"add {wanted[0].strip('`')}"
    if "THEN" in kinds:
        return "add Then"
    if before.lower() == "return":
        return "a Function gives its value to its own name: name = value"
    if before in (")", "]") and text[:1].isdigit():
        return f"write = before the value: = {text}"
    if wanted == ["the end of the line"] and text.strip():
        return "statements are separated by : or by a new line"
    return ""


def found(kind: str, text: str) -> str:
    """A token as a sentence names it."""
    if kind == "_NL":
        return "the end of the line"
    if kind == END:
        return "the end of the file"
    shown = text if len(text) <= 24 else text[:23] + "…"
    return f"`{shown}`"


def _bad(text: str) -> str:
    if text[0] == '"':
        return "the string is not closed"
    if text[0].isdigit():
        return f"{found('', text)} is not a number"
    if text[0] == "`":
        return "a character is written between two back quotes: `A`"
    if found_typographic := typographic(text):
        return found_typographic[0]
    if text.isprintable():
        return f"{found('', text)} has no meaning in Mint"
    return f"the character {ord(text[0]):#04x} has no meaning in Mint"


def _things(kinds: set[str]) -> list[str]:
    """The kinds in human terms: whole classes first, then the words and signs that are left."""
    left = set(kinds)
    things = []
    if left >= STATEMENT:
        return ["a statement"]
    if left >= VALUE:
        return ["a value"]
    if "NAME" in left:
        things.append("a name")
        left = {kind for kind in left if not kind.isalpha() or kind in ("AS",)}
        left -= {"LPAR", "LSQB", "DOT", "EQUAL"}
    if "COMPARE" in left:
        left.discard("EQUAL")
        things.append("a comparison")
    if "THEN" in left:
        left.discard("DO")  # v4's word for the same
    if "END" in left:
        left -= SEPARATORS  # between the parts of a block: blank lines help nobody
    if left & SEPARATORS:
        left -= SEPARATORS
        things.append("the end of the line")
    if END in left:
        left.discard(END)
    return things + sorted(f"`{SPELLINGS[kind]}`" for kind in left if kind in SPELLINGS)
