"""The names of a program, for an editor: definitions, uses and blocks.

`Program.names` returns them, in one vocabulary for all languages. Positions are character offsets in the text
of the source, so they are valid for one text only. `Names.shifted` returns those that still hold after changes of the
text. All of it is plain data, so that a worker process can make it.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import dataclass
from operator import itemgetter

# The start and end of a piece of text, as character offsets.
Span = tuple[int, int]

# The kinds of definitions.
KINDS = (
    "variable", "parameter", "constant", "define", "sub", "function", "task", "event", "label", "type", "member",
    "macro", "register",
)  # fmt: skip


class Definition:
    """A name of the program, and every position at which it is written.

    `span` is the name in its declaration, None for a register, which is not declared. `uses` has all
    positions in the order of the text, including the declaration. `scope` is where the name is visible,
    `home` the sub or task that declares it, "" for the module. `text` is the declaration, `type` and `value`
    what is known about them. `parameters` are the parameters of a sub. `fixed` is the reason why the name
    cannot be changed, "" if it can.
    """

    __slots__ = (
        "fixed",
        "home",
        "kind",
        "name",
        "parameters",
        "scope",
        "span",
        "text",
        "type",
        "uses",
        "value",
    )

    def __init__(self, name: str, kind: str, scope: Span, text: str = "") -> None:
        assert kind in KINDS, kind
        self.name, self.kind, self.scope, self.text = name, kind, scope, text
        self.span: Span | None = None
        self.uses: list[Span] = []
        self.home = self.type = self.value = self.fixed = ""
        self.parameters: tuple[str, ...] = ()

    @property
    def is_declared(self) -> bool:
        """True if the text has its declaration."""
        return self.span is not None

    @property
    def is_used(self) -> bool:
        """True if the text has the name anywhere, including the declaration."""
        return bool(self.uses)

    def use(self, span: Span) -> None:
        """Add a use."""
        self.uses.append(span)

    def declare(self, span: Span) -> None:
        """Add the declaration, which counts as a use."""
        self.span = span

    def __repr__(self) -> str:
        return f"Definition({self.name!r}, {self.kind!r})"


@dataclass(eq=False, slots=True)
class Block:
    """A sub, a task, a handler, a loop or a branch.

    `span` extends from its first to its last token. `name` is "" for a block without one. `at` is the span of
    its name, or of the keyword that opens it.
    """

    kind: str
    name: str
    at: Span
    span: Span


@dataclass(eq=False, slots=True)
class LineLayout:
    """The indentation of a line.

    The line is indented by `back` levels less than the lines above; the lines below change by `change`
    levels. A line that `continues` another one, or has characters of no token, is not indented.
    """

    back: int = 0
    change: int = 0
    continues: bool = False
    unreadable: bool = False


class Names:
    """The names of one text.

    `complete` is False if lines with syntax errors had to be skipped. `problem` is a function of a definition
    and a new name that returns the reason why it cannot have this name, "" if it can. `blocks` are in the
    order in which they begin.
    """

    def __init__(
        self,
        definitions: list[Definition],
        blocks: list[Block],
        complete: bool,
        problem: Callable[[Definition, str], str],
    ) -> None:
        self.definitions, self.blocks = definitions, blocks
        self.complete, self.problem = complete, problem
        # The uses in the order of the text, from the first question about one on.
        self._by_start: list[tuple[int, int, Definition]] | None = None
        self._starts: list[int] = []

    def at(self, offset: int) -> tuple[Definition, Span] | None:
        """Return the definition whose name is at an offset or just before it."""
        if self._by_start is None:
            uses = [(start, end, each) for each in self.definitions for start, end in each.uses]
            self._by_start = sorted(uses, key=itemgetter(0, 1))
            self._starts = [start for start, _, _ in self._by_start]
        i = bisect_right(self._starts, offset) - 1
        if i < 0:
            return None
        start, end, definition = self._by_start[i]
        return (definition, (start, end)) if offset <= end else None

    def visible(self, offset: int) -> Iterator[Definition]:
        """Yield the definitions that can be used at an offset, innermost scope first."""
        inside = [each for each in self.definitions if each.scope[0] <= offset <= each.scope[1]]
        return iter(sorted(inside, key=lambda each: each.scope[1] - each.scope[0]))

    def shifted(self, changes: Changes) -> Names:
        """Return the names with their positions after changes of the text.

        A name that a change touches is left out, with all its uses if it is a declaration. Blocks are left out, too.
        """
        found = []
        for each in self.definitions:
            span = None if each.span is None else changes.span(each.span)
            uses = [use for use in map(changes.span, each.uses) if use is not None]
            if uses and (span is None) is (each.span is None):
                moved = copy(each)
                moved.span, moved.uses, moved.scope = span, uses, changes.around(each.scope)
                found.append(moved)
        return Names(found, [], False, self.problem)


class Changes:
    """The changes of a text since its names were found.

    They are stored as the pieces of the old text that are left. A piece is its start and end in the old text, and the
    distance by which it has moved. The text has an unchangeable character more at either end, so that there is always a
    piece before and after each position.
    """

    __slots__ = ("_pieces", "_starts", "_stops")

    def __init__(self, length: int) -> None:
        self._pieces = [(-1, length + 1, 0)]
        self._starts, self._stops = [-1], [length + 1]

    def __bool__(self) -> bool:
        """True if the text has changed."""
        return len(self._pieces) > 1

    def add(self, at: int, removed: int, added: int) -> None:
        """Add a change, which replaces `removed` characters of the present text by `added` ones."""
        end, found = at + removed, []
        for start, stop, by in self._pieces:
            if start + by < at:
                found.append((start, min(stop, at - by), by))
            if stop + by > end:
                found.append((max(start, end - by), stop, by + added - removed))
        self._pieces = found
        self._starts, self._stops = [each[0] for each in found], [each[1] for each in found]

    def span(self, span: Span) -> Span | None:
        """Return the present span of a text, None if a change touches it."""
        start, end = span
        _, stop, by = self._pieces[bisect_left(self._starts, start) - 1]
        return (start + by, end + by) if end < stop else None

    def around(self, span: Span) -> Span:
        """Return the present span of a scope, which includes what was added at its ends."""
        _, stop, back = self._pieces[bisect_left(self._starts, span[0]) - 1]
        start, _, forth = self._pieces[bisect_right(self._stops, span[1])]
        return min(span[0], stop) + back, max(span[1], start) + forth


def _no_problem(definition: Definition, name: str) -> str:
    return ""


# The names of a text that defines none.
NO_NAMES = Names([], [], True, _no_problem)
