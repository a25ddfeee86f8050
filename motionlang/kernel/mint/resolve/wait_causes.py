"""Where a program depends on the inputs and keys of its machine.

`input_reads` lists the inputs and keys of the whole program. The condition of a PAUSE or a loop shows which level of an
input it waits for: `PAUSE Not INX(3)` waits for 0. Of a bank it lists the channels whose bits the program compares or
masks: `PAUSE IN(0) & 4 = 4` waits for input 2. Keys are the numbers that the program compares with the result of INKEY.
Numbers that it compares with the variable of an INPUT are the choices of a menu.

A loop that moves an axis is work: `While INX(2) = 1` is a run switch, which is on while the program works, and
`While INX(2) = 0` ends the work by a stop button, or steps towards a sensor.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import inf

from motionlang.kernel.lang.keyword import BANK
from motionlang.kernel.lang.wait_causes import InputRead
from motionlang.kernel.mint.keywords.event_kinds import label_event
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL
from motionlang.kernel.mint.resolve.handlers import raised_by
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import meant, walk

# A node of a condition, an input that it reads, and a level.
Levels = Iterator[tuple[nodes.Node, int | None, int | None]]

# The roles of keywords that move an axis.
MOTION = ("move", "course", "path", "go", "act")
COMPARISONS = ("=", "<>", "<", ">", "<=", ">=")

# The codes of keys that a person presses, from the space on.
FIRST_KEY, LAST_KEY = 32, 126


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
