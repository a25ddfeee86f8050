"""The lines of Python that a program becomes, as records: what comes after them asks for fields, never for the text."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

# Kinds: LOOP is the head of a loop, BREAK leaves the innermost one, LEAVES the function or the stretch between labels,
# HORIZON lets others run when their time has come.
PLAIN, LOOP, BREAK, LEAVES, HORIZON = "", "loop", "break", "leaves", "horizon"
# Among the names of a line: it holds a `yield`.
YIELDS = "yield"
# The name of the room on the stack that a call is given: a tuple of the room that the next one is given, () for none.
ROOM = "r"
NONE: Sequence[str] = ()
JUST_YIELDS: Sequence[str] = (YIELDS,)


class Line:
    """`text` stands `indent` blanks from the left; `at` is its place in the program.

    `kind` is one of those above; `names` are the variables in it, and `YIELDS`; `cost` is how many statements it pays
    for, where it does nothing else.
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
    """The same lines, so many blanks further in."""
    if by:
        for line in found:
            line.indent += by
    return found


def names_in(found: Iterable[Line]) -> set[str]:
    """All names of some lines."""
    return set().union(*[line.names for line in found])


def text_of(found: Iterable[Line]) -> str:
    """The lines as text."""
    return "\n".join([" " * line.indent + line.text for line in found])
