"""From a syntax tree to Python: one text, compiled once, with the place in the program of each of its lines.

    def make(E, C, P, dt, K):            the runtime: environment, clock, print, cost of a statement, operations
        d1 = dt; …                        costs of basic blocks
        v_x = 0.0                         variables that several functions share, as cells
        def s_fill(p_n): …                subs: plain functions, or generators where they may wait
        def main(t, H): …                 the parent task, tasks and events: generators
        return {"main": main, …}

A line typed at a prompt has no `make`: its names are the globals of one namespace that lives as long as the session.
"""

from __future__ import annotations

from motionlang.mint import jumping
from motionlang.mint.body import Body, Line, Whole
from motionlang.mint.events import kind_and_number
from motionlang.mint.flow import Flow, analysed
from motionlang.mint.keywords import table
from motionlang.mint.names import Names, walk
from motionlang.mint.nodes import Jump
from motionlang.mint.overriding import override
from motionlang.mint.parser import parse
from motionlang.mint.problems import Problems
from motionlang.mint.runtime import FILE, MintProgram
from motionlang.mint.statements import block, fresh, leave
from motionlang.mint.symbols import FLOAT, Function, Scope, Symbol

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from types import CodeType

    from motionlang.errors import Diagnostic
    from motionlang.mint.nodes import Module
    from motionlang.source import Source

DEFAULT_AXES = 8


class Compiled:
    """The code, the place (`at`) of each of its lines, and what each `kN` in it stands for.

    `blocks` are the tasks and event handlers by "task blink", "event timer", with their names in the code.
    """

    __slots__ = ("blocks", "code", "costs", "operations", "places", "problems", "specs", "text")

    def __init__(self, whole: Whole, lines: list[Line], file: str) -> None:
        self.text = "\n".join(line for line, _ in lines)
        self.places = [0, *(at for _, at in lines)]
        self.code = _code(self.text, file, self.places, whole.problems)
        self.specs, self.operations = whole.specs, list(whole.spec_names.values())
        self.costs = sorted(whole.costs)
        self.problems = whole.problems
        self.blocks = {_key(f): f.python for f in whole.names.functions if f.kind in ("task", "event")}


def _code(text: str, file: str, places: list[int], problems: Problems) -> CodeType:
    """The code of a text; Python takes twenty loops within one another and a hundred blocks, and so does Mint here."""
    try:
        return compile(text, file, "exec")
    except SyntaxError as error:
        if not str(error.msg).startswith("too many"):
            raise
        at = places[min(error.lineno or 0, len(places) - 1)]
        problems.add("syntax", "blocks are nested too deeply here", at, "move a part of them into a sub")
        problems.raise_errors()
        raise


def compile_module(
    module: Module,
    settings: dict[str, object] | None = None,
    scope: Scope | None = None,
    suffix: str = "",
    file: str = FILE,
) -> Compiled:
    """Compile a program, or with `scope` a line typed at a prompt; ProgramError with every mistake."""
    problems = Problems(module)
    if settings and "fault" in settings and scope is None:
        from motionlang.mint.marking import mark

        mark(module, settings, problems)
    known_before = dict(scope.names) if scope is not None else {}
    names = Names(table(), problems, scope)
    names.declare_module(module)
    whole = Whole(table(), problems, names, range(_number_of_axes(settings)), suffix)
    bodies = {function: _function(whole, function) for function in names.functions}
    if not names.typed:
        warn_of_misspellings(whole)
    problems.raise_errors()
    lines = _assemble_line(whole, bodies, known_before) if names.typed else _assemble(whole, bodies)
    return Compiled(whole, lines, file)


def _key(function: Function) -> str:
    return f"{function.kind} {function.name.lower()}"


def _number_of_axes(settings: dict[str, object] | None) -> int:
    count = (settings or {}).get("controller.axes", DEFAULT_AXES)
    return count if isinstance(count, int) else DEFAULT_AXES


# ------------------------------------------------------------------------------------------------ functions


def _function(whole: Whole, function: Function) -> Body:
    """The body of one function, indented for where it will stand."""
    depth = 0 if whole.typed else 1
    if any(function in other.inner for other in whole.names.functions):
        depth += 1
    b = Body(whole, function, depth + 1)
    if not (whole.typed and function is whole.names.main):
        b.analysed = analysed(function)
        if b.analysed:
            b.facts = Flow(function, b.analysed, whole.table).run()
    if function.jumps:
        b.indent += 1
        jumping.write(b, block)
        b.indent -= 1
        return b
    block(b, function.body)
    leave(b)
    if not (function.plain or b.waits):
        b.emit("yield")
    return b


def _dispatched(whole: Whole, b: Body) -> list[Line]:
    """The lines of a function: those of its dispatcher inside it, where it has labels."""
    if not b.function.jumps:
        return b.lines
    function, indent = b.function, " " * b.indent
    word = "global" if whole.typed else "nonlocal"
    own = {symbol.python for symbol in _kept_inside(whole, function)} & b.outside
    name = jumping.dispatcher(function)
    lines = [
        f"{indent}def {name}(pc):",
        f"{indent} {word} {', '.join(sorted({'t', 'H'} | (b.outside - own)))}",
    ]
    if own:
        lines.append(f"{indent} nonlocal {', '.join(sorted(own))}")
    out = [(line, function.at) for line in lines] + b.lines
    for number, (label, _) in enumerate(b.labels_body()):
        out += [(indent + line, function.at) for line in _label_handler(whole, function, label, number)]
    out.append((f"{indent}yield from {name}(0)", function.at))
    last = (
        f"return {function.result.python}"
        if function.result
        else "return"
        if function.kind == "sub"
        else "return t"
    )
    return [*out, (indent + last, function.at)]


def _label_handler(whole: Whole, function: Function, label: str, number: int) -> list[str]:
    """v4: a label with the name of an event, to which nothing jumps, is its handler."""
    if function.kind != "main" or kind_and_number(label) is None:
        return []
    if any(type(node) is Jump and node.name.lower() == label for node in walk(function.body)):
        return []
    word = "global" if whole.typed else "nonlocal"
    return [
        f"def e_{label}(t_, H_):",
        f" {word} t, H",
        " t = t_; H = H_",
        f" yield from {jumping.dispatcher(function)}({number})",
        " return t",
        f"E.blocks['event {label}'] = e_{label}; E.listen()",
    ]


def _kept_inside(whole: Whole, function: Function) -> list[Symbol]:
    """The variables that live in the Python function itself."""
    if whole.typed and function is whole.names.main:
        return []
    mine = [s for s in function.scope.names.values() if s.kind in ("variable", "parameter")]
    if function.result is not None:
        mine.append(function.result)
    return [s for s in mine if not (function.kind == "main" and s.shared)]


def _head(whole: Whole, b: Body) -> list[Line]:
    """The line `def …` and what must be done on entry."""
    function = b.function
    indent = " " * (b.indent - 1)
    # A sub runs on its caller's time, which therefore lives in cells that all functions share.
    shared_time = function.kind == "sub" or bool(function.calls) or function.jumps
    outside = set() if function.jumps else set(b.outside)
    if shared_time:
        outside.add("t")
        if not function.plain:
            outside.add("H")
    lines = [f"{indent}def {function.python}({_parameters(function, shared_time)}):"]
    if outside:
        word = "global" if whole.typed else "nonlocal"
        lines.append(f"{indent} {word} {', '.join(sorted(outside))}")
    if function.kind != "sub" and shared_time:
        lines.append(f"{indent} t = t_; H = H_")
    if not (whole.typed and function is whole.names.main):
        lines += [f"{indent} {line}" for line in _own_variables(function, b)]
    return [(line, function.at) for line in lines]


def _parameters(function: Function, shared_time: bool) -> str:
    if function.kind != "sub":
        return "t_, H_" if shared_time else "t, H"
    return ", ".join(f"{p.python}, {p.python}_k" if p.by_ref else p.python for p in function.parameters)


def _own_variables(function: Function, b: Body) -> list[str]:
    """First values of the variables that live in the function (those of the parent task may live around it)."""
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


# ------------------------------------------------------------------------------------------------- assembly


def _assemble(whole: Whole, bodies: dict[Function, Body]) -> list[Line]:
    lines: list[Line] = [("def make(E, C, P, dt, K):", 0)]
    if whole.specs:
        lines.append((f" {', '.join(f'k{n}' for n in range(len(whole.specs)))}, = K", 0))
    lines += [(f" d{n} = {n} * dt", 0) for n in sorted(whole.costs)]
    lines.append((" t = H = 0.0", 0))
    for symbol in whole.names.module.names.values():
        if symbol.kind == "variable" and symbol.shared:
            lines.append((f" {symbol.python} = {_first(symbol, False)}", 0))
    inner = {each for function in bodies for each in function.inner}
    for function, b in bodies.items():
        if function not in inner:
            lines += _head(whole, b)
            for each in function.inner:
                lines += _head(whole, bodies[each]) + _dispatched(whole, bodies[each])
            lines += _dispatched(whole, b)
    named = [f"{_key(f)!r}: {f.python}" for f in bodies if f.kind in ("task", "event")]
    everything = ", ".join(["'main': main", *named])
    lines.append((f" return {{{everything}}}", 0))
    return lines


def _assemble_line(whole: Whole, bodies: dict[Function, Body], known_before: dict[str, Symbol]) -> list[Line]:
    lines: list[Line] = []
    for key, symbol in whole.names.module.names.items():
        if symbol.kind == "variable" and known_before.get(key) is not symbol:
            lines.append((f"{symbol.python} = {_first(symbol, False)}", symbol.at))
    for b in bodies.values():
        lines += _head(whole, b) + _dispatched(whole, b)
    return lines


def warn_of_misspellings(whole: Whole) -> None:
    """A name that is only ever assigned to and looks like a keyword is a typing error, not a variable."""
    words = [row.name.lower() for row in whole.table if row.simulated and row.kind != "statement"]
    for function in whole.names.functions:
        for symbol in function.scope.names.values():
            if symbol.kind != "variable" or symbol.declared or symbol.uses > 0:
                continue
            from difflib import get_close_matches

            near = get_close_matches(symbol.name.lower(), words, n=1, cutoff=0.75)
            row = whole.table.get(near[0]) if near and len(symbol.name) > 2 else None
            if row is not None:
                whole.problems.add(
                    "unknown-word", f"{symbol.name} is given a value that nothing reads", symbol.at,
                    f"did you mean {row.name}? If it is a variable, declare it with Dim",
                )  # fmt: skip


def compile_source(
    source: Source,
    settings: dict[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
) -> tuple[MintProgram, list[Diagnostic]]:
    """Parse and compile a program; its warnings come with it. ProgramError with every mistake."""
    module = parse(source)
    if overrides:
        override(module, overrides)
    compiled = compile_module(module, settings)
    program = MintProgram(compiled.code, compiled.places, compiled.specs, source.name, source.text, settings)
    return program, list(compiled.problems.found.values())
