"""Assemble the function bodies into units for compilation, with a source map.

The source map gives the source offset of each generated line of Python.
"""

from __future__ import annotations

from motionlang.mint.compile import stops
from motionlang.mint.compile.calls import whole_stack
from motionlang.mint.compile.expressions import counted
from motionlang.mint.compile.first_values import fresh
from motionlang.mint.compile.lines import DEPTH, Line, names_in, text_of
from motionlang.mint.compile.splitting import SIZE, dispatcher
from motionlang.mint.resolve.handlers import label_handlers
from motionlang.mint.resolve.symbols import FLOAT, Function, Symbol
from motionlang.mint.runtime.code_units import COUNTING, FILE, TIME, Code, Unit

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import TypeVar

    from motionlang.mint.compile.body import Body, SharedData
    from motionlang.mint.compile.splitting import Chunk
    from motionlang.mint.resolve.problems import Problems

    Made = TypeVar("Made")

# A program of up to this many lines of Python is compiled at once, a longer one as its functions are called.
SHORT = 1000
# Units that CPython might reject for the depth of their blocks or brackets are compiled at once.
DEEP, LONG = 15, 400
_DEEP = "\n" + " " * DEEP


class TypedLine:
    """A line typed at a prompt: its functions, its source map, and its operations.

    `first` sets the initial values of its variables. `blocks` maps each task and event handler ("task blink",
    "event timer") to its name in the code.
    """

    __slots__ = ("blocks", "first", "offsets", "operations", "specs", "unit")

    def __init__(self, whole: SharedData, first: str, names: list[str], lines: list[Line], file: str) -> None:
        self.first = compile(first, file, "exec")
        self.offsets = _offsets(lines, [0])
        self.unit = Unit(tuple(names), text_of(lines), 0, TIME)
        _checked(lambda: self.unit.compile(file), self.offsets, 0, whole.problems)
        self.specs, self.operations = whole.described(), list(whole.spec_names.values())
        self.blocks = _blocks(whole)


def assemble(whole: SharedData, bodies: dict[Function, Body]) -> Code:
    """Return the code of a program."""
    shared = _shared(whole, bodies)
    units = _Units(shared)
    for function, b in bodies.items():
        units.add(function.python, _head(whole, b) + _dispatched(whole, b))
        for chunk in b.chunks:
            if not chunk.inside:
                units.add_chunk(chunk)
    units.close()
    first = _first_values(whole)
    start = compile(first, FILE, "exec") if first else None
    blocks = {"main": "main", **_blocks(whole)}
    code = Code(units.made, start, shared, whole.described(), blocks, units.offsets, first)
    _compile_now(code, units.risky, whole.problems)
    return code


def _compile_now(code: Code, risky: set[Unit], problems: Problems) -> None:
    """Compile the units that run at once, and those that CPython may reject."""
    for number, unit in enumerate(code.units):
        if number == 0 or len(code.offsets) <= SHORT or unit in risky:
            _checked(unit.compile, code.offsets, unit.before, problems)


def _blocks(whole: SharedData) -> dict[str, str]:
    return {_key(f): f.python for f in whole.names.functions if f.kind in ("task", "event")}


def _key(function: Function) -> str:
    return f"{function.kind} {function.name.lower()}"


def _shared(whole: SharedData, bodies: dict[Function, Body]) -> list[str]:
    """Return the names of the variables that all units share as cells."""
    names = [symbol.python for symbol in _of_module(whole)]
    for function, b in bodies.items():
        if function.kind != "sub":
            names += [
                s.python for s in _own(function) if s.home is not whole.names.main and not b.is_local(s)
            ]
            names += [s.python for s in _own(function) if b.chunks and b.is_local(s)] or sorted(b.cells)
    return names


def _of_module(whole: SharedData) -> list[Symbol]:
    return [s for s in whole.names.module.names.values() if s.kind == "variable" and s.shared]


def _first_values(whole: SharedData) -> str:
    """Return Python that sets the initial values of the module's shared variables."""
    plain: dict[str, list[str]] = {}
    lines = []
    for symbol in _of_module(whole):
        text = _first(symbol, False)
        if "[" in text:
            lines.append(f"{symbol.python} = {text}")
        else:
            plain.setdefault(text, []).append(symbol.python)
    return "\n".join([f"{' = '.join(names)} = {text}" for text, names in plain.items()] + lines)


class _Units:
    """The units of a program during assembly.

    `offsets[n]` is the source offset of line n, counted over all units. `shared` are the names of all cells.
    `risky` are units that CPython may reject.
    """

    def __init__(self, shared: Sequence[str]) -> None:
        self.shared = frozenset((*TIME, *COUNTING, *shared))
        self.made: list[Unit] = []
        self.risky: set[Unit] = set()
        self.offsets = [0]
        self._names: list[str] = []
        self._lines: list[Line] = []

    def add(self, name: str, lines: list[Line]) -> None:
        """Add a function; short ones share a unit."""
        if self._lines and len(self._lines) + len(lines) > SIZE:
            self.close()
        self._names.append(name)
        self._lines += lines

    def add_chunk(self, chunk: Chunk) -> None:
        """Add a chunk of the preceding function."""
        self.close()
        self._names = [chunk.name]
        self._lines = chunk.written({*TIME, *(chunk.names & self.shared)}, 0)
        self.close()

    def close(self) -> None:
        """End the unit; the next function starts a new one."""
        if not self._lines:
            return
        lines, before = self._lines, len(self.offsets) - 1
        _offsets(lines, self.offsets)
        cells = tuple(sorted(names_in(lines) & self.shared))
        unit = Unit(tuple(self._names), text_of(lines), before, cells)
        if _DEEP in unit.text or max(map(len, unit.text.split("\n"))) > LONG:
            self.risky.add(unit)
        self.made.append(unit)
        self._names, self._lines = [], []


def _offsets(lines: list[Line], offsets: list[int]) -> list[int]:
    """Append the source offsets of a unit's lines, after those of its two head lines."""
    offsets += [lines[0].at] * 2
    offsets += [line.at for line in lines]
    return offsets


def _checked(work: Callable[[], Made], offsets: Sequence[int], before: int, problems: Problems) -> Made:
    """Compile a unit; report blocks that are nested too deeply for Python.

    Python allows twenty nested loops, which limits how deeply a statement may be nested that leaves all of them.
    """
    try:
        return work()
    except SyntaxError as error:
        if not str(error.msg).startswith("too many"):
            raise
        at = offsets[min(before + (error.lineno or 0), len(offsets) - 1)]
        message = "the blocks here are nested too deeply"
        hint = "a Return or an Exit may leave at most twenty of them; move the inner ones into a sub"
        problems.add("syntax", message, at, hint)
        problems.raise_errors()
        raise


def assemble_line(
    whole: SharedData, bodies: dict[Function, Body], known_before: dict[str, Symbol], file: str
) -> TypedLine:
    """Return the code of a line typed at a prompt."""
    first, names = [], []
    lines: list[Line] = []
    for key, symbol in whole.names.module.names.items():
        if symbol.kind == "variable" and known_before.get(key) is not symbol:
            first.append(f"{symbol.python} = {_first(symbol, False)}")
    for function, b in bodies.items():
        names.append(function.python)
        lines += _head(whole, b) + _dispatched(whole, b)
    return TypedLine(whole, "\n".join(first), names, lines, file)


# ------------------------------------------------------------------------------------------------ functions


def _dispatched(whole: SharedData, b: Body) -> list[Line]:
    """Return the lines of a function, including its dispatcher if it has labels."""
    if not b.function.jumps:
        return b.lines
    function = b.function
    own = {symbol.python for symbol in _own(function) if b.is_local(symbol)} & b.outside
    name = dispatcher(function)
    counted = function.counted
    texts = [f"def {name}(pc{f', {DEPTH}' if counted else ''}):"]
    texts += [f" {text}" for text in _shared_names(whole, {*TIME, *_count(whole), *own}, b.outside - own)]
    out = [Line(b.indent, text, function.at, names=[*b.outside, *_count(whole)]) for text in texts] + b.lines
    texts = []
    handlers = label_handlers(function)
    for number, (label, _) in enumerate(b.stretches()):
        if label in handlers:
            texts += _label_handler(b, label, number)
    begin = f", {DEPTH if function.kind == 'sub' else whole_stack(b)}" if counted else ""
    last = function.result.python if function.result else ""
    texts += [f"yield from {name}(0{begin})", f"return {last}".rstrip()]
    return out + [Line(b.indent, text, function.at) for text in texts]


def _label_handler(b: Body, label: str, number: int) -> list[str]:
    """Return the event handler of Mint v4 that begins at a label.

    The label has the name of an event, and no jump leads to it.
    """
    begin = f", {whole_stack(b)}" if b.function.counted else ""
    return [
        f"def e_{label}(): yield from {dispatcher(b.function)}({number}{begin})",
        f"E.blocks['event {label}'] = e_{label}; E.listen()",
    ]


def _shared_names(whole: SharedData, own: set[str], outer: set[str]) -> list[str]:
    """Declare the outer names to which a function assigns (`nonlocal`, `global`).

    They belong to the module or to the enclosing function, which holds the time.
    """
    if whole.typed:
        return [f"nonlocal {', '.join(sorted(own))}"] + (
            [f"global {', '.join(sorted(outer))}"] if outer else []
        )
    return [f"nonlocal {', '.join(sorted(own | outer))}"]


def _count(whole: SharedData) -> tuple[str, ...]:
    """Return the statement counter that functions of a debug build assign to."""
    return COUNTING[:1] if whole.debugging is not None else ()


def _variables(function: Function) -> list[Symbol]:
    """Return the variables of a function that hold the program's data."""
    return [symbol for symbol in _own(function) if symbol.home is function]


def _own(function: Function) -> list[Symbol]:
    """Return the variables of a function."""
    mine = [s for s in function.scope.names.values() if s.kind in ("variable", "parameter")]
    return mine if function.result is None else [*mine, function.result]


def _head(whole: SharedData, b: Body) -> list[Line]:
    """Return the `def` line of a function and the statements on entry."""
    function = b.function
    is_unit = bool(b.chunks) and function.kind != "sub"
    outside = set() if function.jumps else set(b.outside)
    if function.kind in ("task", "event") or is_unit:
        outside.update(s.python for s in _own(function) if is_unit or not b.is_local(s))
    texts = _shared_names(whole, {*("t" if function.plain else TIME), *_count(whole)}, outside)
    out = [Line(b.indent - 1, f"def {function.python}({', '.join(_parameters(function))}):", function.at)]
    out += [Line(b.indent, text, function.at, names=[*outside, *TIME, *_count(whole)]) for text in texts]
    if not (whole.typed and function is whole.names.main):
        out += [Line(b.indent, text, function.at) for text in _own_variables(function, b)]
    if whole.debugging is not None:
        own = _variables(function)
        stops.describe(whole.debugging, function, own)
        names = [symbol.python for symbol in own]
        out += [Line(b.indent, text, function.at, names=names) for text in [stops.cells(b, own)] if text]
    inside = [chunk for chunk in b.chunks if chunk.inside]
    known = _known_in(function) if inside else set()
    time = {*(TIME if not function.plain else "t"), *_count(whole)}
    for chunk in inside:
        out += chunk.written(time | (known & chunk.names), b.indent - 1)
    return out


def _known_in(function: Function) -> set[str]:
    """Return the names that chunks inside a sub may share with the sub."""
    known = {name for symbol in _own(function) for name in _spellings(symbol)}
    scope = function.scope.outer
    while scope is not None:
        known.update(symbol.python for symbol in scope.names.values() if symbol.shared)
        scope = scope.outer
    return known


def _parameters(function: Function) -> list[str]:
    names = [name for parameter in function.parameters for name in _spellings(parameter)]
    return [*names, DEPTH] if function.counted and function.kind == "sub" else names


def _spellings(symbol: Symbol) -> list[str]:
    """Return the Python names of a variable or parameter, with its index or its sizes."""
    if symbol.by_ref:
        return [symbol.python, f"{symbol.python}_k"]
    sizes = counted(symbol.python, symbol.dimensions) if len(symbol.dimensions) > 1 else []
    return [symbol.python, *(size for size in sizes if not size.isdecimal())]


def _own_variables(function: Function, b: Body) -> list[str]:
    """Return the initial values of the variables that live in the function.

    Shared variables of the parent task live outside its function.
    """
    lines = []
    for symbol in function.scope.names.values():
        if symbol.kind == "variable" and not (function.kind == "main" and symbol.shared):
            lines.append(f"{symbol.python} = {_first(symbol, symbol in b.analysed)}")
    if function.result is not None:
        lines.append(f"{function.result.python} = {_first(function.result, function.result in b.analysed)}")
    return lines


def _first(symbol: Symbol, followed: bool) -> str:
    if followed and symbol.type.name == FLOAT:
        return "0"
    text = fresh(symbol.type, symbol.dimensions)
    return f"[{text}]" if symbol.boxed else text
