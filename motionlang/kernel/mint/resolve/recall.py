"""Reuse the findings of earlier checks in functions that have not changed.

Problem. An editor checks a program after each pause. One sub has changed, and checking all others again takes
fifteen times as long as parsing.

Idea. A stage, such as `kernel/mint/check`, finds the same in a function if three things are equal: the text
of the function, what its names refer to, and the facts about the program that the stage uses. These three form its
key. The findings under a key are stored with positions relative to the function, and repeated at its present
position.

    Sub fill(n)            key: the text · fill, n, level and drain as `Interfaces` describes them ·
     level = level + n          the facts of the stage
     drain
    End Sub

Data. `Recall` belongs to one check. The dict `known` passes from one check to the next; after a complete check it has
the entries of that check alone. `OwnText` is the text that belongs to one function. The text of a sub inside a task
does not belong to the task, and the parent task has the text outside all blocks. A finding has the arguments with which
a problem was reported (`recorder.py`). Its offsets are numbered within the function's own text.

Invariants.
- Findings that the key does not determine are not stored: a finding in the text of another function, as in a Define,
  and a message that is reported once in a program. Nothing of a program with errors is stored; their hints use all
  names.
- Findings are repeated through the same function that recorded them, in the order of the functions, so limits and
  duplicates are treated as if they were new.

Cost. The program is still parsed and resolved, which takes about as long as parsing it twice. Describing the names that
the functions use takes about a fifth of a parse.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Hashable, Sequence
from typing import Any

from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.recorder import Recorder
from motionlang.kernel.mint.resolve.symbols import Function, Symbol, Type
from motionlang.kernel.mint.syntax.nodes import Module

# Findings and a value of the stage by key.
Known = dict[object, Any]
Findings = list[dict[str, Any]]

# Arguments of the functions that record a problem which are offsets.
_OFFSETS = ("at", "other")


class OwnText:
    """The text of one function as ranges of offsets, numbered within the function."""

    __slots__ = ("_firsts", "_numbers", "ranges")

    def __init__(self, ranges: Sequence[tuple[int, int]]) -> None:
        self.ranges = [each for each in ranges if each[0] < each[1]]
        self._firsts, self._numbers = [first for first, _ in self.ranges], [0]
        for first, end in self.ranges:
            self._numbers.append(self._numbers[-1] + end - first)

    def number(self, at: int) -> int | None:
        """Return the number of an offset within the function, None if it is not its own."""
        index = bisect_right(self._firsts, at) - 1
        if index < 0 or at >= self.ranges[index][1]:
            return None
        return self._numbers[index] + at - self._firsts[index]

    def at(self, number: int) -> int:
        """Return the offset that has a number within the function."""
        index = bisect_right(self._numbers, number) - 1
        return self._firsts[index] + number - self._numbers[index]


def own_text(names: Names, module: Module) -> dict[Function, OwnText]:
    """Return the text of each function."""
    found: dict[Function, list[tuple[int, int]]] = {names.main: []}
    # The functions around an offset, each with its end.
    opened: list[tuple[Function, int]] = [(names.main, len(module.source.text))]
    begin = 0
    blocks = [(each.node, each) for each in names.functions if each.node is not None]
    for node, function in sorted(blocks, key=lambda each: each[0].start):
        while node.start >= opened[-1][1]:
            around, end = opened.pop()
            found[around].append((begin, end))
            begin = end
        found[opened[-1][0]].append((begin, node.start))
        begin = node.start
        found[function] = []
        opened.append((function, node.end))
    while opened:
        around, end = opened.pop()
        found[around].append((begin, end))
        begin = end
    return {function: OwnText(ranges) for function, ranges in found.items()}


class Interfaces:
    """The properties of functions and names that other functions see, as plain values."""

    def __init__(self, names: Names) -> None:
        self._symbols: dict[Symbol, Hashable] = {}
        self.types = tuple(
            (each.name, *((name, self._type(kind), more) for name, (_, kind, more) in each.members.items()))
            for each in names.types.values()
        )

    def seen_by(self, function: Function) -> Hashable:
        """Describe a function and all names that it uses or declares."""
        names = {**function.scope.names, **function.scope.found}
        return self.function(function), tuple(
            (name, None if symbol is None else self.symbol(symbol)) for name, symbol in names.items()
        )

    def symbol(self, symbol: Symbol) -> Hashable:
        """Describe what a name refers to, except where it is declared."""
        known = self._symbols.get(symbol)
        if known is None:
            known = self._symbols[symbol] = (
                symbol.name,
                symbol.kind,
                self._type(symbol.type),
                symbol.home.qualified_name,
                symbol.dimensions,
                (symbol.given, symbol.shared, symbol.boxed, symbol.by_ref, symbol.declared),
                repr(symbol.const),
                repr(symbol.node) if symbol.kind == "define" else "",
                self.function(symbol.home) if symbol.kind in ("sub", "task") else None,
            )
        return known

    def function(self, function: Function) -> Hashable:
        """Describe a function for its callers."""
        result = None if function.result is None else self._type(function.result.type)
        parameters = tuple(map(self.symbol, function.parameters))
        return function.qualified_name, parameters, result

    def _type(self, kind: Type) -> Hashable:
        return kind.name, kind.size, None if kind.record is None else kind.record.name


class Recall:
    """The findings of earlier checks, as used by one check; see the module."""

    def __init__(self, module: Module, known: Known) -> None:
        self._module, self._known = module, known
        self._used: Known = {}
        self._own: dict[Function, OwnText] = {}
        self._keys: dict[Function, Hashable] = {}
        # What each function uses of its own names and of those around it.
        self.symbols: dict[Function, list[Symbol]] = {}
        self.recorder = Recorder()

    def resolve(self, names: Names) -> Interfaces:
        """Compute the keys of all functions, after all names are resolved."""
        interfaces = Interfaces(names)
        self._own = own_text(names, self._module)
        program = self._module.source.text
        for function, own in self._own.items():
            self.symbols[function] = [each for each in function.scope.found.values() if each is not None]
            text = "\0".join(program[first:end] for first, end in own.ranges)
            self._keys[function] = text, interfaces.seen_by(function)
        return interfaces

    def own(self, function: Function) -> OwnText:
        """Return the text of a function."""
        return self._own[function]

    def key(self, stage: str, function: Function, *facts: Hashable) -> Hashable:
        """Return the key of a function for a stage, None if it cannot be recalled."""
        own = self._keys.get(function)
        return None if own is None else (stage, own, facts)

    def find(self, key: Hashable) -> Any:
        """Return the entry stored under a key, None if there is none."""
        found = None if key is None else self._known.get(key)
        if found is not None:
            self._used[key] = found
        return found

    # ---------------------------------------------------------------------------------------- findings

    def store(self, key: Hashable, function: Function, value: object = None) -> None:
        """Store the recorded findings and a value, if they depend only on the key."""
        recorded = self.recorder.end()
        if key is None or recorded is None:
            return
        own, findings = self.own(function), []
        for given in recorded:
            moved = {name: own.number(given[name]) for name in _OFFSETS if name in given}
            if None in moved.values():
                return
            findings.append({**given, **moved})
        self._used[key] = findings, value

    def repeat(self, found: tuple[Findings, object], function: Function, add: Callable[..., None]) -> None:
        """Record stored findings again, at the present position of their function."""
        own = self.own(function)
        for given in found[0]:
            add(**{**given, **{name: own.at(given[name]) for name in _OFFSETS if name in given}})

    def finish(self) -> None:
        """Pass the entries of a complete check on to the next one."""
        self._known.clear()
        self._known.update(self._used)
