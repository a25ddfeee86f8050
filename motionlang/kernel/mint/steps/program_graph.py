"""The structure of a Mint program: its statements from the checked tree, its graph from the steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.program_graph import (
    READ,
    SET_UP,
    WRITE,
    AxisUse,
    ChannelUse,
    Statement,
    Structure,
    Unit,
)
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.steps import CALL, Steps
from motionlang.kernel.lang.wait_causes import KINDS, LoopDependencies
from motionlang.kernel.mint.resolve.folding import fold
from motionlang.kernel.mint.resolve.handlers import label_handlers, raised_by
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import SEMAPHORE, Function
from motionlang.kernel.mint.resolve.wait_causes import keys
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from motionlang.kernel.mint.steps.program import ProgramWriter
from motionlang.kernel.mint.steps.unit import is_stop
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import children, meant, walk
from motionlang.kernel.source import Source

# Words that the program has for "not known before the run".
_UNKNOWN = "?"
# Statements that only jump or end: the graph shows them.
_JUMPS = (nodes.Exit, nodes.Return)


def written(source: Source, names: Names, settings: Mapping[str, object]) -> dict[Function, Steps]:
    """Return the steps of the functions of a checked program on a machine with these settings."""
    environment = Environment(Machine(dict(settings)), Places())
    environment.prepare()

    def line_of(offset: int) -> int:
        return source.location(offset)[0]

    environment.line_of = line_of
    return ProgramWriter(names, environment, line_of, {}).steps


def graph_of(names: Names, steps: Mapping[Function, Steps]) -> StepGraph:
    """Return the graph of the steps of the functions."""
    graph = StepGraph(list(steps.values()))
    last = graph.ranges[names.main.qualified_name][-1]
    graph.points[last] = graph.points[last]._replace(at=-1)  # the end of the text is no statement
    return graph


def structure(
    source: Source,
    names: Names,
    steps: Mapping[Function, Steps],
    graph: StepGraph,
    polls: Callable[[int], LoopDependencies | None],
) -> Structure:
    """Return the structure of a checked program."""
    reader = _Reader(source, names, polls)
    for function in names.functions:
        reader.read(function)
    units = sorted(_units(steps, graph, reader), key=lambda each: each.line)

    def polled(at: int) -> LoopDependencies | None:
        return polls(reader.repeats.get(at, at))

    return Structure(source, reader.statements, graph, units, frozenset(reader.writes), polled)


def _units(written: Mapping[Function, Steps], graph: StepGraph, reader: _Reader) -> Iterator[Unit]:
    """Yield the functions, and the labels that a Gosub calls or that handle an event."""
    for function, steps in written.items():
        entry = graph.first(steps)
        line = reader.line(function.at)
        if function.kind == "main":
            yield Unit("program", "program", 0, entry)
        elif function.kind == "event":
            yield Unit(function.name, "event", line, entry, _triggers(reader, function.name, function.at))
        else:
            is_function = isinstance(function.node, nodes.Sub) and function.node.function
            yield Unit(function.name, "function" if is_function else function.kind, line, entry)
        handlers = label_handlers(function)
        called = {to for index, (_, to) in steps.called.items() if steps[index].kind == CALL and to > 0}
        for index, label in steps.labels.items():
            is_handler = label.lower() in handlers
            if is_handler or (index in called):
                at = reader.labels.get((function, label.lower()), function.at)
                kind = "event" if is_handler else "subroutine"
                triggers = _triggers(reader, label, at) if is_handler else ()
                yield Unit(label, kind, reader.line(at), entry + index, triggers)


def _triggers(reader: _Reader, name: str, at: int) -> Sequence[ChannelUse]:
    """Return the channels whose change starts a handler."""
    return [
        ChannelUse(channel, str(number) if number >= 0 else _UNKNOWN, READ, at)
        for channel, number in raised_by(reader.names, name)
    ]


class _Reader:
    """Reads the statements of the functions of a program."""

    def __init__(self, source: Source, names: Names, polls: Callable[[int], LoopDependencies | None]) -> None:
        self.source, self.names, self.polls = source, names, polls
        self.statements: dict[int, Statement] = {}
        self.writes: set[int] = set()
        # The offsets of labels.
        self.labels: dict[tuple[Function, str], int] = {}
        # The code of each key that a node compares with.
        everything = list(walk(statement for each in names.functions for statement in each.body))
        self.keys = {id(node): code for node, code in keys(everything)}
        # The offset of each Repeat by that of its condition.
        self.repeats: dict[int, int] = {}

    def line(self, at: int) -> int:
        """Return the line of an offset."""
        return self.source.location(at)[0]

    def read(self, function: Function) -> None:
        """Add the statements of a function."""
        self._block(function, function.body)

    def _block(self, function: Function, body: list[nodes.Stmt]) -> None:
        for node in body:
            self._statement(function, node)

    def _statement(self, function: Function, node: nodes.Stmt) -> None:
        match node:
            case nodes.If():
                self._head(node.start, node.condition, "If {}", node.condition)
                self._block(function, node.body)
                self._block(function, node.orelse)
            case nodes.Select():
                self._head(node.start, node.subject, "Select Case {}", node.subject)
                for case in node.cases:
                    subject = self._text(node.subject)
                    tests = ", ".join(map(self._text, case.tests)) or "Else"
                    made = self._add(case.start, f"Case {tests}", list(case.tests))
                    characters = self._characters(case.tests)
                    made.condition = f"{subject} is {tests}{characters}" if case.tests else ""
                    made.select = node.start
                    self._block(function, case.body)
            case nodes.For():
                values = [node.first, node.stop, *([node.step] if node.step is not None else [])]
                texts = [self._text(each) for each in (node.variable, *values)]
                step = f" Step {texts[3]}" if len(texts) > 3 else ""
                made = self._add(node.start, f"For {texts[0]} = {texts[1]} To {texts[2]}{step}", list(values))
                made.condition = f"{texts[0]} in {made.text.partition('= ')[2]}"
                self._write(node.variable)
                self._block(function, node.body)
            case nodes.While():
                self._head(node.start, node.condition, "While {}", node.condition)
                self._block(function, node.body)
            case nodes.Repeat():
                self._add(node.start, "Repeat", []).is_silent = True
                made = self._add(
                    node.condition.start, f"Until {self._text(node.condition)}", [node.condition]
                )
                self.repeats[made.at] = node.start
                # The step tests if the loop goes on.
                made.condition = f"not ({self._text(node.condition)})"
                self._block(function, node.body)
            case nodes.Loop():
                self._add(node.start, "Loop", []).is_silent = True
                self._block(function, node.body)
            case _:
                self._simple(function, node)

    def _head(self, at: int, condition: nodes.Expr, form: str, *parts: nodes.Node) -> None:
        made = self._add(at, form.format(self._text(condition)), list(parts))
        made.condition = self._text(condition) + self._characters([condition])

    def _characters(self, tests: Sequence[nodes.Node]) -> str:
        """Return the keys that a condition compares with, such as " ('a', 'b')", "" if none."""
        compared = sorted((node.start, self.keys[id(node)]) for node in walk(tests) if id(node) in self.keys)
        found = [repr(chr(code)) for _, code in compared]
        return f" ({', '.join(found)})" if found else ""

    def _simple(self, function: Function, node: nodes.Stmt) -> None:
        made = self._add(node.start, self._text(node), [])
        is_goto = isinstance(node, nodes.Jump) and node.kind == "goto"
        made.is_silent = not is_stop(node) or is_goto or isinstance(node, _JUMPS)
        match node:
            case nodes.Assign():
                self._assign(made, node)
            case nodes.Call():
                self._called(made, node.target)
            case nodes.Pause():
                found = self.polls(node.start)
                causes = {KINDS[kind] for kind, _ in found.leaves} if found is not None else set()
                made.waits = causes.pop() if len(causes) == 1 else "condition"
                leaves = found.leaves if found is not None else frozenset()
                axes = {number for kind, number in leaves if KINDS[kind] == "axis" and number is not None}
                made.what = tuple(sorted(axes))
                made.condition = self._text(node.condition)
                self._read(made, node.condition)
            case nodes.Input():
                made.waits = "operator"
                prompt = "" if node.prompt is None else self._text(node.prompt).strip('" ')
                made.channels.append(
                    ChannelUse("answer", prompt or "INPUT", READ, made.at, value=self._text(node.target))
                )
                self._target(made, node.target)
            case nodes.Run():
                made.starts.append(f"task {node.name}")
            case nodes.End() if node.name is not None:
                made.ends.append(f"task {node.name}")
            case nodes.Define():
                pass  # its expression is read where its name is
            case nodes.Label():
                self.labels[function, node.name.lower()] = node.start
            case nodes.Dim():
                for variable in node.variables:
                    if variable.values:
                        self.writes.add(variable.name.start)
                    if node.nv:
                        made.channels.append(ChannelUse("nv word", str(variable.name), SET_UP, made.at))
                for each in children(node):
                    self._read(made, each)
            case _:
                for each in children(node):
                    self._read(made, each)

    def _add(self, at: int, text: str, parts: list[nodes.Node]) -> Statement:
        made = self.statements[at] = Statement(at, self.line(at), text)
        for each in parts:
            self._read(made, each)
        return made

    # ------------------------------------------------------------------------------------------- what is used

    def _assign(self, made: Statement, node: nodes.Assign) -> None:
        target = node.target
        meaning = meant(target) if isinstance(target, nodes.Name) else target
        for each in node.values:
            self._read(made, each)
        if isinstance(meaning, nodes.Name) and meaning.row is not None and meaning.symbol is None:
            self._word(made, meaning, meaning.row, WRITE, node.values, _alias(target))
        else:
            self._target(made, target)
            symbol = getattr(meaning, "symbol", None)
            if symbol is not None and symbol.type.name == SEMAPHORE:
                made.waits = "" if fold(node.values[0]) == 0 else "task"

    def _called(self, made: Statement, target: nodes.Name) -> None:
        row = target.row
        if row is not None and target.symbol is None:
            self._word(made, target, row, WRITE, list(target.args or ()) if row.index == "none" else [])
            return
        self._read(made, target)

    def _target(self, made: Statement, target: nodes.Expr) -> None:
        """Record that a variable is assigned, and what its subscripts read."""
        if isinstance(target, nodes.Name):
            self._write(target)
            for each in target.args or ():
                self._read(made, each)
        elif isinstance(target, nodes.Member):
            self._target(made, target.value)

    def _write(self, target: nodes.Expr) -> None:
        while isinstance(target, nodes.Member):
            target = target.value
        if isinstance(target, nodes.Name):
            self.writes.add(target.name.start)

    def _read(self, made: Statement, part: object, alias: str = "") -> None:
        """Record what an expression reads."""
        if isinstance(part, nodes.Name):
            if part.definition is not None and part.args is None:
                self._read(made, part.definition, str(part.name))
                return
            if part.symbol is not None and part.symbol.kind == "sub":
                parameters = part.symbol.home.parameters
                for given, parameter in zip(part.args or (), parameters, strict=False):
                    if parameter.by_ref or parameter.is_array:
                        self._write(given)
            if part.row is not None and part.symbol is None:
                self._word(made, part, part.row, READ, [], alias)
        if isinstance(part, nodes.Node):
            for each in children(part):
                self._read(made, each)

    def _word(
        self,
        made: Statement,
        name: nodes.Name,
        row: Keyword,
        access: str,
        values: list[nodes.Expr],
        alias: str = "",
    ) -> None:
        """Record the use of a keyword."""
        if access == WRITE:
            for each in name.args or ():
                self._read(made, each)
            made.waits = made.waits or row.waits
        access = READ if row.access == "R" else access
        kinds = row.index.split(", ")
        args = list(name.args or ())
        is_of_axes = bool({"axis", "axes"} & set(kinds))
        value = self._text(values[0]) if values else ""
        if row.channel:
            numbers = [
                each for k, each in enumerate(args) if kinds[min(k, len(kinds) - 1)] not in ("axis", "axes")
            ]
            several = len(kinds) == 1 and len(numbers) > 1
            for k, group in enumerate([[each] for each in numbers] if several else [numbers]):
                number = ", ".join(map(self._number, group)) or ("0" if kinds[0] != "none" else "")
                own = self._text(values[min(k, len(values) - 1)]) if values else value
                known_as = alias or next((a for a in map(_alias, group) if a), "")
                if row.channel == "key":
                    known_as = ", ".join(
                        dict.fromkeys(repr(chr(code)) for code in sorted(self.keys.values()))
                    )
                made.channels.append(
                    ChannelUse(row.channel, number, access, made.at, known_as, own, name.start)
                )
        if row.selects and access == WRITE:
            for k, each in enumerate(values):
                by = f"{row.name}({self._number(args[k])})" if k < len(args) else row.name
                number = self._number(each)
                if not number.startswith("-"):
                    made.channels.append(
                        ChannelUse(row.selects, number, SET_UP, made.at, _alias(each), by, name.start)
                    )
        if (is_of_axes or row.does("all")) and access == WRITE and row.topic:
            self._axes(made, row, args, kinds, values)

    def _axes(
        self,
        made: Statement,
        row: Keyword,
        args: list[nodes.Expr],
        kinds: list[str],
        values: list[nodes.Expr],
    ) -> None:
        axes = [each for k, each in enumerate(args) if kinds[min(k, len(kinds) - 1)] in ("axis", "axes")]
        numbers: list[int | None] = [_whole(each) for each in axes]
        if not args:
            numbers = [None if row.does("all") or self.names.uses_axes else 0]
        for k, axis in enumerate(numbers):
            given = values[min(k, len(values) - 1)] if values else None
            if isinstance(given, nodes.Omitted):
                continue
            known = None if given is None else fold(meant(given))
            figure = known if isinstance(known, (int, float)) else None
            text = "" if given is None else self._text(given)
            made.axes.append(AxisUse(axis, row, made.at, text, figure))

    # -------------------------------------------------------------------------------------------------- texts

    def _number(self, node: nodes.Expr) -> str:
        number = _whole(node)
        return _UNKNOWN if number is None else str(number)

    def _text(self, node: nodes.Node) -> str:
        """Return a part of the program as it is written, on one line and without comments."""
        text = self.source.text[node.start : node.end]
        return " ".join(text.split())


def _whole(node: nodes.Expr) -> int | None:
    value = fold(meant(node))
    return int(value) if isinstance(value, (int, float)) and value == int(value) else None


def _alias(node: nodes.Expr) -> str:
    """Return the name of the constant or Define for a number or a channel."""
    if isinstance(node, nodes.Name) and (node.definition is not None or node.symbol is not None):
        return str(node.name)
    return ""
