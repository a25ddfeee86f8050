"""Where a program depends on the digital inputs of its machine.

The condition of a statement shows at which level of an input it is true: that of `PAUSE Not INX(3)` at 0. Of a bank it
shows the channels whose bits the program compares or masks: `PAUSE IN(0) & 4 = 4` waits for input 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from motionlang.kernel.lang.keyword import BANK
from motionlang.kernel.lang.wait_causes import InputRead
from motionlang.kernel.mint.keywords.event_kinds import label_event
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL
from motionlang.kernel.mint.resolve.handlers import raised_by
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import meant, walk

# A node of a condition, an input that it reads, and a level.
Levels = Iterator[tuple[nodes.Node, int | None, int | None]]

COMPARISONS = ("=", "<>", "<", ">", "<=", ">=")


def input_reads(module: Module, names: Names) -> list[InputRead]:
    """Return the reads of inputs in a program, in the order of its lines."""
    found: list[InputRead] = []
    bodies = [(function, list(walk(function.body))) for function in names.functions]
    banks = _Banks(node for _, body in bodies for node in body)
    for function, body in bodies:
        found += _inputs(module, body, banks)
        handlers = [(function.name, function.at)] if function.kind == "event" else []
        labels = [node for node in body if isinstance(node, nodes.Label)]
        handlers += [(node.name, node.start) for node in labels if label_event(node.name) is not None]
        for name, at in handlers:
            raised = [number for kind, number in raised_by(names, name) if kind == "input" and number >= 0]
            found += [InputRead(number, None, module.line(at)) for number in raised]
    return sorted(found, key=lambda each: (each.line, each.channel is None, each.channel or 0))


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


def _inputs(module: Module, body: list[nodes.Node], banks: _Banks) -> Iterator[InputRead]:
    seen: set[int] = set()
    # The expression of a Define counts where its name is used. Each use is a copy with the same positions.
    aliases = [node for node in body if isinstance(node, nodes.Name) and meant(node) is not node]
    defined = {each.start for alias in aliases for each in walk([meant(alias)])}
    for node in body:
        if isinstance(node, (nodes.Pause, nodes.While, nodes.Repeat, nodes.If)):
            condition = node.condition
            found = [each for each in _levels(condition, True, banks) if id(each[0]) not in seen]
            seen.update(id(each) for each in walk([read for read, _, _ in found]))
            seen.update(id(each) for each in walk([condition]) if each in aliases)
            for read, channel, level in found:
                at = condition.start if read.start in defined else read.start
                yield InputRead(channel, level, module.line(at))
    for node in body:
        if not isinstance(node, nodes.Name) or id(node) in seen or node.start in defined:
            continue
        line = module.line(node.start)
        for name in walk([meant(node)]):
            if isinstance(name, nodes.Name) and (_is_input(name) or _is_bank(name)):
                for each in [_channel(name)] if _is_input(name) else banks.channels(name):
                    yield InputRead(each, None, line)


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
