"""Where the variables of a program are: in the list that its functions share, or in that of a call.

The variables of the main program, of tasks and of event handlers are shared, because subs may use them. Each call of a
sub has its own list, so a sub may call itself. What a step remembers for a later one is in the list of its call, too.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from motionlang.kernel.lang.steps import Values, own
from motionlang.kernel.mint.resolve.symbols import INTEGER, SEMAPHORE, STRING, Function, Symbol, Type
from motionlang.kernel.mint.runtime import functions


class Array(list[Any]):
    """The elements of an array, which begin at index 1, and its sizes."""

    __slots__ = ("sizes",)

    def __init__(self, elements: list[Any], sizes: tuple[int, ...]) -> None:
        super().__init__(elements)
        self.sizes = sizes

    def __reduce__(self) -> Any:
        return Array, (list(self), self.sizes)


class Places:
    """The places of all variables of a program; `shared` are the contents of those that its functions share."""

    def __init__(self) -> None:
        self.shared: list[Any] = []
        self._indices: dict[Symbol, int] = {}
        self._sizes: dict[Function, int] = {}

    def index(self, symbol: Symbol) -> int:
        """Return the index of a variable in its list."""
        found = self._indices.get(symbol)
        if found is None:
            if is_shared(symbol):
                found = len(self.shared)
                self.shared.append(first_content(symbol))
            else:
                found = self.new_index(symbol.home)
            self._indices[symbol] = found
        return found

    def number(self, symbol: Symbol) -> int:
        """Return the number of a variable in `Uses`."""
        index = self.index(symbol)
        return index if is_shared(symbol) else own(index)

    def names(self) -> dict[int, str]:
        """Return the names of the shared variables, by their numbers in `Uses`."""
        return {index: symbol.name for symbol, index in self._indices.items() if is_shared(symbol)}

    def new_index(self, function: Function) -> int:
        """Return a further index in the list of a call."""
        size = self._sizes.get(function, 0)
        self._sizes[function] = size + 1
        return size

    def new_values(self, function: Function) -> Values:
        """Return the list of a call, with the first values of its variables."""
        values = [0] * self._sizes.get(function, 0)
        for symbol in variables_of(function):
            if not (is_shared(symbol) or symbol.kind == "parameter"):
                values[self._indices[symbol]] = first_content(symbol)
        return values

    def forget(self, function: Function) -> None:
        """Discard what is known of a function that never runs again."""
        self._sizes.pop(function, None)

    def reset(self, symbols: Iterable[tuple[int, Symbol]]) -> None:
        """Give shared variables their first values."""
        for index, symbol in symbols:
            self.shared[index] = first_content(symbol)


def variables_of(function: Function) -> list[Symbol]:
    """Return the variables and parameters of a function, with its result."""
    found = [each for each in function.scope.names.values() if each.kind in ("variable", "parameter")]
    return found if function.result is None else [*found, function.result]


def is_shared(symbol: Symbol) -> bool:
    """True if a variable is in the list that the functions of a program share."""
    return symbol.home.kind != "sub"


def first_content(symbol: Symbol) -> Any:
    """Return the first content of a variable or array."""
    content = elements(symbol.type, symbol.dimensions) if symbol.is_array else first_value(symbol.type)
    return [content] if symbol.boxed else content


def first_value(kind: Type) -> Any:
    """Return the first value of a variable of a type; a user type and a semaphore are lists."""
    if kind.record is not None:
        return [
            elements(each.type, each.dimensions) if each.is_array else first_value(each.type)
            for each in kind.record.members.values()
        ]
    return [None] if kind.name == SEMAPHORE else {INTEGER: 0, STRING: ""}.get(kind.name, 0.0)


def elements(kind: Type, sizes: tuple[int, ...]) -> Array:
    """Return a new array; its element 0 is never used."""
    count = 1
    for size in sizes:
        count *= size
    if kind.record is not None:
        return Array([None, *(first_value(kind) for _ in range(count))], sizes)
    return Array([first_value(kind)] * (count + 1), sizes)


def copied(content: Any) -> Any:
    """Return a copy of a value of a user type, with its arrays and members."""
    if isinstance(content, Array):
        return Array([copied(each) for each in content], content.sizes)
    return [copied(each) for each in content] if isinstance(content, list) else content


def subscript(array: Array, found: list[float]) -> int:
    """Return the index of an element of an array with several subscripts."""
    position = 0
    for value, size in zip(found, array.sizes, strict=True):
        position = position * size + functions.subscript(value, size) - 1
    return position + 1
