"""The names of a program, as an editor needs them: definitions, uses, blocks.

`Dialect.names` returns them, in one vocabulary for all languages. Positions are character offsets in the text
of the source, so they belong to one text only.
"""

from __future__ import annotations

from bisect import bisect_right
from operator import itemgetter

from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    # The start and end of a piece of text, as character offsets.
    Span = tuple[int, int]

# The kinds of definitions.
KINDS = (
    "variable", "parameter", "constant", "define", "sub", "function", "task", "event", "label", "type", "member",
    "macro", "register",
)  # fmt: skip


class Definition:
    """A name of the program, and every position at which it is written.

    `span` is the name in its declaration, None for a register, which is not declared. `uses` has all of them
    in the order of the text, the declaration included. `scope` is where the name is visible, `home` the sub or
    task that declares it, "" for the module. `text` is the declaration, `type` and `value` what is known of them.
    `parameters` are those of a sub. `fixed` is the reason why the name cannot be changed, "" if it can.
    """

    __slots__ = (
        "fixed", "home", "kind", "name", "parameters", "scope", "span", "text", "type", "uses", "value",
    )  # fmt: skip

    def __init__(self, name: str, kind: str, scope: Span, text: str = "") -> None:
        assert kind in KINDS, kind
        self.name, self.kind, self.scope, self.text = name, kind, scope, text
        self.span: Span | None = None
        self.uses: list[Span] = []
        self.home = self.type = self.value = self.fixed = ""
        self.parameters: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"Definition({self.name!r}, {self.kind!r})"


@record
class Block:
    """A sub, a task, a handler, a loop or a branch.

    `span` is from its first to its last token. `name` is "" for a block without one, and `at` the span of its
    name, or of the keyword that opens it.
    """

    kind: str
    name: str
    at: Span
    span: Span


@record
class LineLayout:
    """The indentation of a line.

    The line is `back` levels less indented than those above; those below change by `change` levels. A
    line that `continues` another one, or has characters of no token, is not indented.
    """

    back: int = 0
    change: int = 0
    continues: bool = False
    unreadable: bool = False


class Names:
    """The names of one text.

    `complete` is False if unreadable lines had to be left out. `problem` says why a name cannot be given to a
    definition: a function of the definition and the new name that returns "" if it can.
    """

    __slots__ = ("_by_start", "_starts", "blocks", "complete", "definitions", "problem")

    def __init__(
        self,
        definitions: list[Definition],
        blocks: list[Block],
        complete: bool = True,
        problem: Callable[[Definition, str], str] | None = None,
    ) -> None:
        self.definitions, self.blocks, self.complete = definitions, blocks, complete
        self.problem = problem or (lambda definition, name: "names of this language cannot be changed")
        # The uses in the order of the text, from the first question about one on.
        self._by_start: list[tuple[int, int, Definition]] | None = None
        self._starts: list[int] = []

    def at(self, offset: int) -> tuple[Definition, Span] | None:
        """Return the definition whose name is written at an offset, or just before it."""
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
        """Yield the definitions that can be used at an offset, the innermost scope first."""
        inside = [each for each in self.definitions if each.scope[0] <= offset <= each.scope[1]]
        return iter(sorted(inside, key=lambda each: each.scope[1] - each.scope[0]))

    def named(self, name: str, kind: str) -> Definition | None:
        """Return the definition of a kind with this name, in any case."""
        key = name.lower()
        return next((e for e in self.definitions if e.kind == kind and e.name.lower() == key), None)


NO_NAMES = Names([], [])
