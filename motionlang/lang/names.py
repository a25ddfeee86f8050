"""The names of a program, for an editor: definitions, uses and blocks.

`Dialect.names` returns them, in one vocabulary for all languages. Positions are character offsets in the text
of the source, so they are valid for one text only.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from operator import itemgetter

from motionlang.record import record

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


@record
class Block:
    """A sub, a task, a handler, a loop or a branch.

    `span` extends from its first to its last token. `name` is "" for a block without one. `at` is the span of
    its name, or of the keyword that opens it.
    """

    kind: str
    name: str
    at: Span
    span: Span


@record
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
    and a new name that returns the reason why it cannot have this name, "" if it can. `find_blocks` is called
    when `blocks` is first read.
    """

    def __init__(
        self,
        definitions: list[Definition],
        find_blocks: Callable[[], list[Block]],
        complete: bool = True,
        problem: Callable[[Definition, str], str] | None = None,
    ) -> None:
        self.definitions, self.complete = definitions, complete
        self._find_blocks = find_blocks
        self._blocks: list[Block] | None = None
        self.problem = problem or (lambda definition, name: "names of this language cannot be changed")
        # The uses in the order of the text, from the first question about one on.
        self._by_start: list[tuple[int, int, Definition]] | None = None
        self._starts: list[int] = []

    @property
    def blocks(self) -> list[Block]:
        """The blocks in the order in which they begin."""
        if self._blocks is None:
            self._blocks = self._find_blocks()
        return self._blocks

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


NO_NAMES = Names([], list)
