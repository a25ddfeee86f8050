"""The lines of generated Python, as records: later passes never parse their text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

# Kinds: LOOP is the head of a loop, BREAK leaves the innermost loop, LEAVES the function or the stretch
# between labels, and HORIZON lets others run if they are due.
PLAIN, LOOP, BREAK, LEAVES, HORIZON = "", "loop", "break", "leaves", "horizon"
# Among the names of a line: it contains a `yield`.
YIELDS = "yield"
# The name for the remaining stack depth in a call: a tuple with that of the next call, or () for none.
DEPTH = "r"
NONE: Sequence[str] = ()
JUST_YIELDS: Sequence[str] = (YIELDS,)


class Line:
    """A line of Python.

    It is indented by `indent` blanks. `at` is its source offset in the program. `kind` is one of the kinds above.
    `names` are the variables in it, and `YIELDS` if it yields. `cost` is the number of statements that it pays
    for, if it does nothing else.
    """

    __slots__ = ("at", "cost", "indent", "kind", "names", "text")

    def __init__(
        self,
        indent: int,
        text: str,
        at: int,
        kind: str = PLAIN,
        names: Sequence[str] = NONE,
        cost: int = 0,
    ) -> None:
        self.indent, self.text, self.at = indent, text, at
        self.kind, self.names, self.cost = kind, names, cost


def moved(found: list[Line], by: int) -> list[Line]:
    """Indent lines by `by` more blanks."""
    if by:
        for line in found:
            line.indent += by
    return found


def names_in(found: Iterable[Line]) -> set[str]:
    """Return all names of some lines."""
    return set().union(*[line.names for line in found])


def text_of(found: Iterable[Line]) -> str:
    """Return the lines as text."""
    return "\n".join([" " * line.indent + line.text for line in found])
