"""Symbols, scopes, user types, and the functions of a program."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from motionlang.kernel.mint.syntax import nodes

INTEGER, FLOAT, STRING, TIME = "Integer", "Float", "String", "Time"
SEMAPHORE, CONTROLLER, RECORD = "Semaphore", "Controller", "record"
TYPES = {name.lower(): name for name in (INTEGER, FLOAT, STRING, TIME, SEMAPHORE, CONTROLLER)}
# Types of other languages, and the type with such values.
OTHER_TYPES = {
    **dict.fromkeys(("double", "real", "single"), FLOAT),
    **dict.fromkeys(("bool", "boolean", "byte", "int", "long", "short", "word"), INTEGER),
    **dict.fromkeys(("char", "text"), STRING),
}
NUMERIC = frozenset((INTEGER, FLOAT, TIME))


@dataclass(eq=False, slots=True)
class Type:
    """A type: one of the names above, with its parameters.

    `size` is the size of a String (None means any), `record` is a user type.
    """

    name: str
    size: int | None = None
    record: Record | None = None

    def __str__(self) -> str:
        return self.record.name if self.record is not None else self.name


class Record:
    """A user type: the symbols of its members in order."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.members: dict[str, Symbol] = {}


class Symbol:
    """A symbol of the program.

    - `kind`: "variable", "parameter", "const", "define", "sub", "task", "event", "label", "type" or "member".
    - `first`: the symbol that the name refers to: the earlier one if this declaration repeats it, else this one.
    - `shared`: more than one function uses it.
    - `boxed`: it outlives the run in non-volatile memory, so its value is in a list of one element, which that shares.
      Arrays and values of user types are lists anyway.
    - `by_ref`: it is a ByRef parameter itself.
    - `declared`: False for a variable that exists only because it is assigned, and for a label without a declaration.
    - `owner`, `index`: the user type of a member, and its position in a value of that type.
    """

    def __init__(self, name: str, kind: str, type: Type, at: int, home: Function) -> None:
        self.name, self.kind, self.type, self.at, self.home = str(name), kind, type, at, home
        self.dimensions: tuple[int, ...] = ()
        self.const: float | str | None = None
        self.node: object = None
        self.shared = self.boxed = self.by_ref = False
        self.given = False  # a constant whose value is supplied when the program starts
        self.uses = 0  # the number of reads; those of a Define include writes
        self.declared = True
        self.first = self
        self.owner: Record | None = None
        self.index = 0

    @property
    def is_array(self) -> bool:
        return bool(self.dimensions)


class Scope:
    """The names of one block, and the enclosing scope."""

    __slots__ = ("function", "names", "outer")

    def __init__(self, function: Function, outer: Scope | None) -> None:
        self.function, self.outer = function, outer
        self.names: dict[str, Symbol] = {}

    def find(self, name: str) -> Symbol | None:
        """Return the symbol of a name, ignoring case, from the innermost scope outwards."""
        key = name.lower()
        scope: Scope | None = self
        while scope is not None:
            symbol = scope.names.get(key)
            if symbol is not None:
                return symbol
            scope = scope.outer
        return None

    def symbols(self) -> Iterator[Symbol]:
        """Yield all symbols visible here, innermost first."""
        scope: Scope | None = self
        while scope is not None:
            yield from scope.names.values()
            scope = scope.outer


class Function:
    """The main program, a task, a sub or an event handler."""

    def __init__(self, kind: str, name: str, body: list[nodes.Stmt], outer: Scope | None) -> None:
        self.kind, self.name, self.body = kind, str(name), body
        self.scope = Scope(self, outer)
        self.at = 0
        self.node: nodes.Node | None = None
        self.parameters: list[Symbol] = []
        self.result: Symbol | None = None
        self.calls: set[Function] = set()
        self.labels: dict[str, Symbol] = {}

    @property
    def jumps(self) -> bool:
        """True if it has a label or a jump."""
        return bool(self.labels)

    @property
    def qualified_name(self) -> str:
        """Its kind and name after those of the functions around it; unique in a program without errors."""
        outer = self.scope.outer
        own = f"{self.kind} {self.name.lower()}"
        return own if outer is None else f"{outer.function.qualified_name}, {own}"

    def result_named(self, node: nodes.Name) -> Symbol | None:
        """Return the result so far, if that is what a name means: that of a function, without brackets, in itself."""
        result = self.result
        named = result is not None and node.args is None and result.name.lower() == node.name.lower()
        return result if named else None


class PromptSymbols:
    """What the lines typed at a prompt have declared so far: names and user types."""

    def __init__(self) -> None:
        self.scope = Scope(Function("main", "main", [], None), None)
        self.types: dict[str, Symbol] = {}
