"""A debug build: a hook before every statement, and descriptions of variables.

    if (n := n + 1) >= N or (D is not None and 17 in D): B(t + 2.0, 17)

`n` counts the statements of all tasks. 17 is the source offset, and `t + 2.0` is the statement's number on the
time scale. `n`, `N` and `D` are cells of a `Hook`, and `B` calls it (`mint/runtime/debugging.py`). Time is counted
in whole statements, so paying for some of them earlier gives exactly the same time.

A lambda names the variables that live in a Python function and so makes them cells, because the locals of a
frame cannot be assigned before Python 3.13:

    m_ = lambda: (v_i, p_n)
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.mint.compile.body import Body
from motionlang.mint.resolve.symbols import RECORD, Function, Symbol, Type
from motionlang.mint.runtime.code_units import CELLS, COUNTING
from motionlang.mint.syntax import nodes

# Word, dimensions, and the members of a user type, each with its name.
Shape = tuple[str, tuple[int, ...], tuple[tuple[str, "Shape"], ...]]
# Name, spelling in Python, shape, and how it is stored: "", "boxed" or "by_ref".
Described = tuple[str, str, Shape, str]
# The source offsets of the statements, and the title and the variables of each function.
Stops = tuple[list[int], dict[str, tuple[str, tuple[Described, ...]]]]

# Statements that write no code.
_SILENT = (nodes.Const, nodes.Define, nodes.Label, nodes.Auto)


class Debugging:
    """The description of a program for a debugger.

    `offsets` are the source offsets of the statements. `functions` maps the Python name of each function to its
    title and its variables.
    """

    def __init__(self) -> None:
        self.offsets: set[int] = set()
        self.functions: dict[str, tuple[str, tuple[Described, ...]]] = {}

    def payload(self) -> Stops:
        """Return the whole description in a form that `marshal` accepts."""
        return sorted(self.offsets), self.functions


def before(b: Body, node: nodes.Stmt) -> None:
    """Write the hook before a statement."""
    if isinstance(node, _SILENT) or (
        isinstance(node, nodes.Dim) and not any(variable.values for variable in node.variables)
    ):
        return
    _hook(b, node.start)


def in_empty_loop(b: Body, body: Sequence[nodes.Stmt]) -> None:
    """Write the hook into a loop without statements, so that it can be stopped."""
    if all(isinstance(node, _SILENT) for node in body):
        _hook(b, b.at)


def _hook(b: Body, at: int) -> None:
    assert b.whole.debugging is not None
    b.whole.debugging.offsets.add(at)
    b.hooked = True
    time = f"t + {b.pending}.0" if b.pending else "t"
    b.names += COUNTING
    b.emit(f"if (n := n + 1) >= N or (D is not None and {at} in D): B({time}, {at})")


def cells(b: Body, symbols: Iterable[Symbol]) -> str:
    """Return the line that makes cells of a function's variables, "" for none."""
    names = [name for symbol in symbols for name in _spelled(symbol)]
    return f"{CELLS} = lambda: ({', '.join(names)},)" if names else ""


def _spelled(symbol: Symbol) -> list[str]:
    return [symbol.python, f"{symbol.python}_k"] if symbol.by_ref else [symbol.python]


def describe(debugging: Debugging, function: Function, symbols: Iterable[Symbol]) -> None:
    """Record the title and the variables of a function."""
    debugging.functions[function.python] = (
        function.name,
        tuple(
            (symbol.name, symbol.python, _shape(symbol.type, symbol.dimensions), _storage(symbol))
            for symbol in symbols
        ),
    )


def _storage(symbol: Symbol) -> str:
    return "by_ref" if symbol.by_ref else "boxed" if symbol.boxed else ""


def _shape(kind: Type, dimensions: tuple[int, ...]) -> Shape:
    members: tuple[tuple[str, Shape], ...] = ()
    if kind.name == RECORD and kind.record is not None:
        members = tuple(
            (name, _shape(member, sizes)) for name, (_, member, sizes) in kind.record.members.items()
        )
    return str(kind), dimensions, members
