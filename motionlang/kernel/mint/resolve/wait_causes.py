"""Dependencies of loops and PAUSEs: the inputs and positions they wait for.

These are the readings in their conditions. If the loop itself assigns a variable of its condition, the assigned value
counts instead: in `done = IDLE(0)` … `While Not done` the loop waits for axis 0. If only other tasks assign a variable,
the loop waits for these tasks. A call of a function counts as the readings in the function.

`input_reads` lists the inputs and keys of the whole program. The condition of a PAUSE or a loop shows which level of an
input it waits for: `PAUSE Not INX(3)` waits for 0. Of a bank it lists the channels whose bits the program compares or
masks: `PAUSE IN(0) & 4 = 4` waits for input 2. Keys are the numbers that the program compares with the result of INKEY.
Numbers that it compares with the variable of an INPUT are the choices of a menu.

A loop that moves an axis is work: `While INX(2) = 1` is a run switch, which is on while the program works, and
`While INX(2) = 0` ends the work by a stop button, or steps towards a sensor.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache, cached_property
from math import inf

from motionlang.kernel.lang.keyword import BANK, Keyword
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.wait_causes import InputRead, LoopDependencies, Read
from motionlang.kernel.mint.keywords.event_kinds import label_event
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL
from motionlang.kernel.mint.resolve.handlers import handled, raised_by
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import TIME, Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import meant, walk
from motionlang.kernel.mint.syntax.unparse import shown

# A node of a condition, an input that it reads, and a level.
Levels = Iterator[tuple[nodes.Node, int | None, int | None]]

LOOPS = (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)
LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End)
# The kind of a read, by the section of the machine file that drives the keyword.
DRIVEN = {
    "input": "input",
    "analogue": "analogue",
    "encoder": "encoder",
    "key": "operator",
    "answer": "operator",
    "comms": "host",
    "netdata": "host",
    "dpr": "host",
    "serial": "host",
    "remote": "host",
}

# The roles of keywords that move an axis.
MOTION = ("move", "course", "path", "go", "act")
COMPARISONS = ("=", "<>", "<", ">", "<=", ">=")

# The codes of keys that a person presses, from the space on.
FIRST_KEY, LAST_KEY = 32, 126


def finder(module: Module, names: Names, graph: StepGraph) -> Callable[[int], LoopDependencies | None]:
    """Return a function that maps an offset to the dependencies of its loop or PAUSE, each analysed once."""
    return cache(_Survey(module, names.functions, graph).at)


class _Part:
    """Summary of a statement or an expression with all below it, but not of what it calls.

    `calls`    the subs, labels and Defines that it uses
    `lines`    its lines
    `leaving`  the conditions that guard a statement that leaves a loop, and `why` their texts
    `tested`   the conditions of all statements in it
    `given`    the values that it assigns to each variable, and the conditions for it
    `reads`    the readings of keywords in it
    `symbols`  the variables and parameters in it
    """

    def __init__(self, survey: _Survey, node: object) -> None:
        self.nodes = list(walk([node]))
        self.lines = frozenset(survey.module.line(each.start) for each in self.nodes)
        conditions = sorted(_leaving([node]), key=lambda each: each.start)
        self.leaving, self.why = survey.parts(conditions), [shown(each) for each in conditions]
        self.calls: list[Symbol | nodes.Node] = []
        self.tested: list[_Part] = []
        self.given: dict[Symbol | None, list[_Part]] = {}
        self.reads: set[Read] = set()
        self.symbols: set[Symbol] = set()
        for each in self.nodes:
            if isinstance(each, (nodes.If, nodes.Select, nodes.While, nodes.Repeat)):
                self.tested += survey.parts(_guarded(each)[0])
            if isinstance(each, nodes.Assign):
                self.given.setdefault(each.target.symbol, []).extend(survey.parts(each.values))
            elif isinstance(each, nodes.If):
                for symbol in _assigned(walk([*each.body, *each.orelse])):
                    self.given.setdefault(symbol, []).extend(survey.parts([each.condition]))
            elif isinstance(each, nodes.Jump):
                if each.kind == "gosub" and each.symbol is not None:
                    self.calls.append(each.symbol)
            elif isinstance(each, nodes.Name):
                if each.definition is not None:
                    self.calls.append(each.definition)
                elif each.symbol is None:
                    self.reads.update(_read(each, each.row))
                elif each.symbol.kind == "sub":
                    self.calls.append(each.symbol)
                elif each.symbol.kind in ("variable", "parameter"):
                    self.symbols.add(each.symbol)


class _Survey:
    """The loops and PAUSEs of a program, each analysed on request.

    Loops made of Gotos overlap, so a statement may belong to many; it is summarised once.
    """

    def __init__(self, module: Module, functions: Iterable[Function], graph: StepGraph) -> None:
        self.module = module
        self._parts: dict[int, _Part] = {}
        # The parts of each body, by the id of its list.
        self._bodies: dict[int, list[_Part]] = {}
        self._nodes: dict[int, nodes.Node] = {}
        self._by_labels: dict[int, tuple[list[nodes.Stmt], slice]] = {}
        # The statements of each label that a Gosub may call, to their Return.
        self._routines: dict[Symbol | None, tuple[list[nodes.Stmt], slice]] = {}
        for function in functions:
            for node in walk(function.body):
                if isinstance(node, (*LOOPS, nodes.Pause)):
                    self._nodes[node.start] = node
            self._by_labels.update(_by_labels(function))
            self._routines.update(_routines(function))
        # The statements of each task, of the parent task and of each event handler.
        self._tasks: list[Sequence[nodes.Node]] = []
        # The variables that labels which handle events assign, as an Event does.
        self._handled: set[Symbol | None] = set()
        for function in functions:
            if function.kind in ("main", "task", "event"):
                self._tasks.append(function.body)
            if labelled := list(handled(function, graph)):
                self._tasks.append(labelled)
                for part in self._reached(self.parts(labelled)):
                    self._handled.update(part.given)

    @cached_property
    def _roots(self) -> list[tuple[set[int], set[Symbol | None]]]:
        """The ids of the nodes that each task or handler may execute, and the variables that these assign."""
        nodes_of = [
            [node for part in self._reached(self.parts(body)) for node in part.nodes] for body in self._tasks
        ]
        return [({id(node) for node in found}, _assigned(found)) for found in nodes_of]

    def at(self, offset: int) -> LoopDependencies | None:
        """Return the dependencies of the loop or PAUSE at an offset, None if there is none."""
        node = self._nodes.get(offset)
        if isinstance(node, nodes.Pause):
            reads = self._reads(self.parts([node.condition]), [])
            return LoopDependencies(reads, why=f"until {shown(node.condition)}")
        if node is not None:
            return self._loop(node)  # type: ignore[arg-type]
        if offset not in self._by_labels:
            return None
        body, own = self._by_labels[offset]
        return self._dependencies(self._body(body)[own])

    def _loop(self, node: nodes.For | nodes.While | nodes.Repeat | nodes.Loop) -> LoopDependencies:
        condition = None if isinstance(node, (nodes.For, nodes.Loop)) else node.condition
        word = "until" if isinstance(node, nodes.Repeat) else "while"
        found = self._dependencies(self._body(node.body), condition, word)
        found.counts = isinstance(node, nodes.For)
        return found

    def _dependencies(
        self, body: list[_Part], condition: nodes.Expr | None = None, word: str = ""
    ) -> LoopDependencies:
        """Return the dependencies of a loop with a condition at its head or end, or of a loop made of Gotos."""
        leaving = [each for part in body for each in part.leaving]
        why = " or ".join(dict.fromkeys([text for part in body for text in part.why]))
        if condition is not None:
            leaving += self.parts([condition])
            why = f"{word} {shown(condition)}"
        reached = self._reached(body)
        lines = frozenset[int]().union(*[part.lines for part in reached])
        tested = [each for part in reached for each in part.tested]
        within = self._reads([*leaving, *tested], reached)
        return LoopDependencies(self._reads(leaving, reached), within, lines, why)

    def _reads(self, conditions: list[_Part], body: list[_Part]) -> frozenset[Read]:
        """Return the readings in the conditions of a loop; `body` are its statements and what they call."""
        given: defaultdict[Symbol | None, list[_Part]] = defaultdict(list)
        for part in body:
            for assigned in part.given:
                given[assigned] += part.given[assigned]
        found: set[Read] = set()
        seen: set[Symbol] = set()
        others: set[Symbol] = set()
        counts = False
        while conditions:
            reached = self._reached(conditions)
            conditions = []
            found.update(*[part.reads for part in reached])
            for symbol in {each for part in reached for each in part.symbols} - seen:
                seen.add(symbol)
                if symbol.type.name == TIME:
                    found.add(("time", None))
                elif symbol in given:
                    conditions += given[symbol]
                    counts = True
                elif symbol.shared or symbol in self._handled:
                    others.add(symbol)
        if others and not counts and self._is_written(others, body):
            found.add(("task", None))
        return frozenset(found)

    def _is_written(self, symbols: set[Symbol], body: list[_Part]) -> bool:
        """True if a task or handler other than the loop's own assigns one of the variables."""
        inside = {id(node) for part in body for node in part.nodes}
        return any(inside.isdisjoint(root) and assigned & symbols for root, assigned in self._roots)

    def _reached(self, body: list[_Part]) -> list[_Part]:
        """Return the parts of a body and of the subs, routines and Defines that it uses."""
        found = list(body)
        seen: set[int] = set()
        for part in found:  # the list grows during the loop
            for called in part.calls:
                if id(called) not in seen:
                    seen.add(id(called))
                    found += self._called(called)
        return found

    def _called(self, called: Symbol | nodes.Node) -> list[_Part]:
        if not isinstance(called, Symbol):
            return self.parts([called])
        if called.kind == "sub":
            return self._body(called.home.body)
        if called not in self._routines:
            return []
        body, own = self._routines[called]
        return self._body(body)[own]

    def _body(self, body: list[nodes.Stmt]) -> list[_Part]:
        if id(body) not in self._bodies:
            self._bodies[id(body)] = self.parts(body)
        return self._bodies[id(body)]

    def parts(self, of: Iterable[object]) -> list[_Part]:
        """Return the summaries of some nodes."""
        found: list[_Part] = []
        for node in of:
            part = self._parts.get(id(node))
            if part is None:
                part = self._parts[id(node)] = _Part(self, node)
            found.append(part)
        return found


def _by_labels(function: Function) -> Iterator[tuple[int, tuple[list[nodes.Stmt], slice]]]:
    """Yield each loop made of Gotos: its label, and its statements to the last jump back: a list and its slice."""
    body = function.body
    labels = {each.symbol: number for number, each in enumerate(body) if isinstance(each, nodes.Label)}
    last: dict[int, int] = {}
    for number, statement in enumerate(body):
        for node in walk([statement]):
            if isinstance(node, nodes.Jump) and node.kind != "gosub":
                first = labels.get(node.symbol, number)
                if first < number:
                    last[first] = number
    for first, number in last.items():
        yield body[first].start, (body, slice(first, number + 1))


def _routines(function: Function) -> Iterator[tuple[Symbol | None, tuple[list[nodes.Stmt], slice]]]:
    """Yield each label of a function, with the statements from there to the next Return: a list and its slice."""
    body, end = function.body, len(function.body)
    for first in range(len(body) - 1, -1, -1):
        if isinstance(body[first], nodes.Return):
            end = first
        elif isinstance(label := body[first], nodes.Label):
            yield label.symbol, (body, slice(first, end))


def _guarded(
    node: nodes.If | nodes.Select | nodes.While | nodes.Repeat,
) -> tuple[list[nodes.Expr], list[object]]:
    """Return the condition of a statement, and the statements that it guards: those of a loop run in any case."""
    if isinstance(node, nodes.If):
        return [node.condition], [*node.body, *node.orelse]
    if isinstance(node, nodes.Select):
        return [node.subject], [each for case in node.cases for each in case.body]
    return [node.condition], []


def _leaving(body: Iterable[object]) -> list[nodes.Expr]:
    """Return the conditions in a body that guard a statement that leaves a loop."""
    found: list[nodes.Expr] = []
    for node in walk(body):
        if isinstance(node, (nodes.If, nodes.Select)):
            conditions, inner = _guarded(node)
            if any(isinstance(each, LEAVES) for each in walk(inner)):
                found += conditions
    return found


def _assigned(body: Iterable[nodes.Node]) -> set[Symbol | None]:
    """Return the variables that some nodes assign."""
    return {node.target.symbol for node in body if isinstance(node, nodes.Assign)}


def _read(node: nodes.Name, row: Keyword | None) -> Iterator[Read]:
    """Yield the readings that the use of a keyword depends on."""
    if row is None or row.kind not in ("reading", "setting"):
        return
    if row.verb == "time" or (row.unit == "s" and row.index == "none"):
        yield "time", None
    elif row.driven in DRIVEN and row.index not in ("axis", "axes"):
        kind = DRIVEN[row.driven]
        number = next(_numbers(node), None) if row.index in ("input", "channel") else None
        yield kind, number
    elif row.driven == "input":
        yield "input", None
    elif row.index in ("axis", "axes"):
        numbers = list(_numbers(node))
        kind = "position" if row.solved or row.changes == "motion" else "axis"
        yield from ((kind, number) for number in numbers or [None])
    elif row.index == "task":
        yield "task", None
    elif row.index == "latch":
        yield "latch", next(_numbers(node), None)
    else:
        yield "other", None


def _numbers(node: nodes.Name) -> Iterator[int | None]:
    """Yield the indices in the brackets, None for one known only at run time."""
    for each in node.args or ():
        found = meant(each)
        value: object = found.value if isinstance(found, nodes.Number) else None
        if isinstance(found, nodes.Name) and found.symbol is not None:
            value = found.symbol.const
        yield int(value) if isinstance(value, (int, float)) else None


def input_reads(module: Module, names: Names) -> list[InputRead]:
    """Return the reads of inputs and keys in a program, in the order of its lines."""
    found: list[InputRead] = []
    bodies = [(function, list(walk(function.body))) for function in names.functions]
    banks = _Banks(node for _, body in bodies for node in body)
    for function, body in bodies:
        found += _inputs(module, body, banks, _timed(module, function), function.kind == "event")
        lines = ((module.line(node.start), code) for node, code in keys(body))
        found += [InputRead("key", code, None, line, line) for line, code in lines]
        found += _choices(module, body)
        if function.kind == "event":
            line = module.line(function.at)
            first = min((module.line(node.start) for node in body), default=line)
            found += _events(names, function.name, line, first)
        for label in (node for node in body if isinstance(node, nodes.Label)):
            if label_event(label.name) is not None:
                line = module.line(label.start)
                found += _events(names, label.name, line, line)
    return sorted(found, key=lambda each: (each.line, each.kind, each.channel is None, each.channel or 0))


def _events(names: Names, name: str, line: int, last: int) -> Iterator[InputRead]:
    """Yield the inputs whose change calls a handler."""
    for kind, number in raised_by(names, name):
        if kind == "input" and number >= 0:
            yield InputRead("event", number, None, line, last)


class _Banks:
    """The channels of each bank that a program compares with constants or tests by bits."""

    def __init__(self, body: Iterable[nodes.Node]) -> None:
        found = list(body)
        # Variables that hold a bank, such as `b` after `b = IN(0)`.
        self._copies: dict[Symbol, int] = {}
        for node in found:
            symbol = node.target.symbol if isinstance(node, nodes.Assign) else None
            if symbol is not None and isinstance(node, nodes.Assign):
                for each in node.values:
                    bank = self.bank(each)
                    if bank is not None:
                        self._copies[symbol] = bank
        self._masks: dict[int, int] = {}
        for node in found:
            if isinstance(node, nodes.Binary) and node.op in (*COMPARISONS, "&"):
                for side, other in ((node.left, node.right), (node.right, node.left)):
                    bank, bits = self.bank(side), _whole(other)
                    if bank is not None and bits is not None:
                        self._masks[bank] = self._masks.get(bank, 0) | bits

    def bank(self, node: nodes.Expr) -> int | None:
        """Return the bank that an expression reads, None if it reads none or its number is unknown."""
        node = meant(node)
        if not isinstance(node, nodes.Name):
            return None
        if _is_bank(node):
            return _whole(node.args[0]) if node.args else 0
        return self._copies.get(node.symbol) if node.symbol is not None else None

    def tested(self, node: nodes.Expr) -> dict[int, int]:
        """Return the channels of `IN(0)` or `IN(0) & 6`, each with its bit; empty for anything else."""
        node = meant(node)
        bank, mask = self.bank(node), None
        if isinstance(node, nodes.Binary) and node.op == "&":
            for side, other in ((node.left, node.right), (node.right, node.left)):
                if self.bank(side) is not None and _whole(other) is not None:
                    bank, mask = self.bank(side), _whole(other)
        if bank is None:
            return {}
        bits = (self._masks.get(bank) or 1) if mask is None else mask
        channels = {bank * BANK + k: 1 << k for k in range(BANK) if bits >> k & 1}
        return {each: bit for each, bit in channels.items() if 0 <= each <= LAST_CHANNEL}

    def channels(self, name: nodes.Name) -> list[int | None]:
        """Return the channels of a bank that the program tests; None for unknown ones."""
        bank = self.bank(name)
        return list(self.tested(name)) if bank is not None and self._masks.get(bank) else [None]


def _timed(module: Module, function: Function) -> dict[int, int]:
    """Return the Ifs that leave a loop of Gotos which a limit of time ends, too, each with the last line of the loop.

    #PICK
    IF INX.2 THEN GOTO GRIPPED
    IF TIME < 1500 THEN GOTO PICK
    """
    found: dict[int, int] = {}
    for _, (statements, own) in _by_labels(function):
        *body, back = statements[own]
        if not isinstance(back, nodes.If) or not _ends_without_inputs(back.condition, False):
            continue
        leaving = [
            each
            for each in body
            if isinstance(each, nodes.If) and any(_leaves(inner) for inner in walk(each.body))
        ]
        if len(leaving) == 1 and not any(_works(each) for each in walk([*body, back])):
            found[leaving[0].start] = module.line(back.start)
    return found


def _inputs(
    module: Module, body: list[nodes.Node], banks: _Banks, timed: dict[int, int], in_handler: bool
) -> Iterator[InputRead]:
    seen: set[int] = set()
    # The expression of a Define counts where its name is used. Each use is a copy with the same positions.
    aliases = [node for node in body if isinstance(node, nodes.Name) and meant(node) is not node]
    defined = {each.start for alias in aliases for each in walk([meant(alias)])}

    def reads(kind: str, condition: nodes.Expr, wanted: bool, last: int = 0) -> Iterator[InputRead]:
        found = [each for each in _levels(condition, wanted, banks) if id(each[0]) not in seen]
        seen.update(id(each) for each in walk([node for node, _, _ in found]))
        seen.update(id(each) for each in walk([condition]) if each in aliases)
        for node, channel, level in found:
            line = module.line(condition.start if node.start in defined else node.start)
            yield InputRead(kind, channel, level, line, max(last, line), in_handler)

    for node in body:
        if isinstance(node, nodes.Pause):
            optional = _ends_without_inputs(node.condition, True)
            yield from reads("either" if optional else "wait", node.condition, True)
        elif isinstance(node, (nodes.While, nodes.Repeat)):
            last = max((module.line(each.start) for each in walk([node])), default=0)
            until = isinstance(node, nodes.Repeat)
            if any(_works(each) for each in walk(node.body)):
                for read in reads("guard", node.condition, not until, last):
                    ends = 1 if read.level == 0 else None
                    yield read if read.level else replace(read, kind="work", level=ends)
            else:
                optional = _ends_without_inputs(node.condition, until)
                yield from reads("test" if optional else "poll", node.condition, until, last)
        elif isinstance(node, nodes.If):
            leaves = not node.orelse and any(_leaves(each) for each in walk(node.body))
            if node.start in timed:
                yield from reads("poll", node.condition, True, timed[node.start])
                continue
            yield from reads("guard" if leaves else "test", node.condition, not leaves)
    for node in body:
        if not isinstance(node, nodes.Name) or id(node) in seen or node.start in defined:
            continue
        line = module.line(node.start)
        for name in walk([meant(node)]):
            if isinstance(name, nodes.Name) and (_is_input(name) or _is_bank(name)):
                for channel in [_channel(name)] if _is_input(name) else banks.channels(name):
                    yield InputRead("test", channel, None, line, line, in_handler)


def _leaves(node: nodes.Node) -> bool:
    """True for a statement that leaves the normal flow, such as `GoTo Fault`."""
    return isinstance(node, nodes.End) or (isinstance(node, nodes.Jump) and node.kind == "goto")


def _works(node: nodes.Node) -> bool:
    """True for a statement that moves an axis, or calls a subroutine that may do so."""
    if isinstance(node, nodes.Jump):
        return node.kind == "gosub"
    if not isinstance(node, nodes.Name):
        return False
    is_sub = node.symbol is not None and node.symbol.kind == "sub"
    return is_sub or (node.row is not None and node.row.role in MOTION)


def _ends_without_inputs(node: nodes.Expr, wanted: bool) -> bool:
    """True if a condition may become `wanted` while all its inputs stay as they are."""
    node = meant(node)
    if isinstance(node, nodes.Unary) and node.op == "Not":
        return _ends_without_inputs(node.operand, not wanted)
    if isinstance(node, nodes.Binary) and node.op in ("And", "Or"):
        sides = [_ends_without_inputs(each, wanted) for each in (node.left, node.right)]
        return any(sides) if (node.op == "Or") is wanted else all(sides)
    return not any(
        isinstance(each, nodes.Name) and (_is_input(each) or _is_bank(each)) for each in walk([node])
    )


def _levels(node: nodes.Expr, wanted: bool, banks: _Banks) -> Levels:
    """Yield the inputs of a condition, each with the level that makes it `wanted`."""
    node = meant(node)
    tested = banks.tested(node)
    if tested:
        yield from ((node, channel, int(wanted)) for channel in tested)
    elif isinstance(node, nodes.Name):
        if _is_input(node):
            yield node, _channel(node), int(wanted)
    elif isinstance(node, nodes.Unary) and node.op == "Not":
        yield from _levels(node.operand, not wanted, banks)
    elif isinstance(node, nodes.Binary) and node.op in ("And", "Or"):
        yield from _levels(node.left, wanted, banks)
        yield from _levels(node.right, wanted, banks)
    elif isinstance(node, nodes.Binary):
        for side, other in ((node.left, node.right), (node.right, node.left)):
            value = _whole(other)
            tested = banks.tested(side)
            if tested:
                is_equality = node.op in ("=", "<>") and value is not None
                equal = (node.op == "=") is wanted
                for channel, bit in tested.items():
                    level = int(bool((value or 0) & bit)) if is_equality else None
                    if level is not None and not equal:
                        level = 1 - level if not value or len(tested) == 1 else None
                    yield node, channel, level
                continue
            for name in walk([meant(side)]):
                if isinstance(name, nodes.Name) and _is_input(name):
                    plain = meant(side) is name and node.op in ("=", "<>") and value in (0, 1)
                    level = int((value == 1) is ((node.op == "=") is wanted)) if plain else None
                    yield name, _channel(name), level


def _is_input(name: nodes.Name) -> bool:
    row = name.row
    return row is not None and row.driven == "input" and row.index == "input"


def _is_bank(name: nodes.Name) -> bool:
    row = name.row
    return row is not None and row.driven == "input" and row.index == "bank"


def _channel(name: nodes.Name) -> int | None:
    number = _whole(name.args[0]) if name.args else None
    return number if number is not None and 0 <= number <= LAST_CHANNEL else None


def _whole(node: nodes.Expr) -> int | None:
    """Return the value of an expression as an int, None if unknown before the run."""
    found = meant(node)
    value: object = found.value if isinstance(found, nodes.Number) else None
    if isinstance(found, nodes.Name):
        value = found.symbol.const if found.symbol is not None else _constant(found)
    return int(value) if isinstance(value, (int, float)) else None


def _constant(name: nodes.Name) -> int | None:
    """Return the value of a constant of the language such as _ON."""
    row = name.row
    text = row.verb if row is not None else ""
    return int(text) if text.isdigit() else None


def keys(body: list[nodes.Node]) -> Iterator[tuple[nodes.Node, int]]:
    """Yield each comparison of a key with a number, and the number."""
    given: set[Symbol] = set()
    for node in body:
        if isinstance(node, nodes.Assign) and any(_is_key(each) for each in node.values):
            symbol = node.target.symbol
            if symbol is not None:
                given.add(symbol)
    for node in body:
        compared: list[tuple[nodes.Expr, nodes.Node, nodes.Expr]] = []
        if isinstance(node, nodes.Binary) and node.op in ("=", "<>"):
            compared = [(node.left, node, node.right), (node.right, node, node.left)]
        elif isinstance(node, nodes.Select):
            tests = (test for case in node.cases for test in case.tests if test.op == "=")
            compared = [(node.subject, test, test.value) for test in tests]
        for side, at, other in compared:
            code = _whole(other)
            is_read = _is_key(side) or (isinstance(side, nodes.Name) and side.symbol in given)
            if is_read and code is not None and FIRST_KEY <= code <= LAST_KEY:
                yield at, code


def _choices(module: Module, body: list[nodes.Node]) -> Iterator[InputRead]:
    """Yield the numbers that a menu compares an answer with; one number alone is no menu."""
    compared: dict[Symbol, dict[int, float]] = {}

    def add(subject: nodes.Expr, value: nodes.Expr) -> None:
        number = _whole(value)
        if isinstance(subject, nodes.Name) and subject.symbol is not None and number is not None:
            lines = compared.setdefault(subject.symbol, {})
            lines[number] = min(lines.get(number, inf), module.line(value.start))

    for node in body:
        if isinstance(node, nodes.Binary) and node.op in ("=", "<>"):
            add(node.left, node.right)
            add(node.right, node.left)
        elif isinstance(node, nodes.Select):
            for test in (each for case in node.cases for each in case.tests if each.op == "="):
                add(node.subject, test.value)
    for node in body:
        if isinstance(node, nodes.Input) and isinstance(node.target, nodes.Name):
            numbers = compared.get(node.target.symbol, {}) if node.target.symbol is not None else {}
            asked = module.line(node.start)
            for number, line in numbers.items() if len(numbers) > 1 else ():
                yield InputRead("answer", number, None, int(line), asked)


def _is_key(node: object) -> bool:
    row = node.row if isinstance(node, nodes.Name) else None
    return row is not None and row.driven == "key"
