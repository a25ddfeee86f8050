"""The nesting of a tree: its blocks, long chains of operations, expressions nested too deeply.

The grammar is left-associative, so the parser makes `a + b + c …` a `Binary` in a `Binary` and so on. The
later passes are recursive, and Python's recursion is limited. To its author a chain of operations is not
nested, so a long one becomes a `Chain`, which counts as one level. Brackets, arguments and signs count as levels,
too. Only texts with long lines are processed here. Cost: one visit of each node, without recursion.
"""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Binary, Chain, Link, Module, Node, Stmt, Wrong
from motionlang.kernel.mint.syntax.tokens import token_at

# Nesting of blocks. This is a limit of motionlang, not of Mint.
MAX_DEPTH = 200
MAX_EXPRESSION_DEPTH = (
    200  # nesting of nodes; each level takes two or three of the compiler's 1,000 stack frames
)
LINKS = 50  # operations in a row that remain nested

# Nodes that nest inside an expression. Any other node, such as a statement, starts again at depth 0.
_NESTS = (
    nodes.Name,
    nodes.Member,
    nodes.Unary,
    Binary,
    Chain,
    Link,
    nodes.Number,
    nodes.String,
    nodes.Omitted,
)


def bodies(module: Module) -> Iterator[tuple[list[Stmt], int]]:
    """Yield every list of statements of a program with its depth, which counts an ElseIf as a level."""
    subs = [*module.subs, *(sub for task in module.tasks for sub in task.subs)]
    waiting = [(module.body, 0), *((sub.body, 1) for sub in subs)]
    waiting += ((task.body, 1) for task in module.tasks)
    waiting += ((event.body, 1) for event in module.events)
    waiting += ((startup.body, 1) for startup in module.startup)
    while waiting:
        body, depth = waiting.pop()
        yield body, depth
        for each in body:
            if isinstance(each, nodes.If):
                waiting += ((each.body, depth + 1), (each.orelse, depth + 1))
            elif isinstance(each, nodes.Select):
                waiting += ((case.body, depth + 1) for case in each.cases)
            elif isinstance(each, (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)):
                waiting.append((each.body, depth + 1))


def flatten_chains(module: Module) -> None:
    """Replace every run of more than `LINKS` operations by a `Chain`."""
    waiting: list[Node] = [module]
    while waiting:
        node = waiting.pop()
        for name in node.__slots__:
            value = getattr(node, name)
            if isinstance(value, Node):
                value = _flat(value)
                setattr(node, name, value)
                waiting.append(value)
            elif isinstance(value, list):
                value[:] = [_flat(each) for each in value]
                waiting += value


def _flat(node: Node) -> Node:
    """Return a `Chain` for a long run of operations, and any other node unchanged."""
    operations: list[Binary] = []
    first = node
    while type(first) is Binary:
        operations.append(first)
        first = first.left
    if len(operations) <= LINKS:
        return node
    links = [Link(each.right.start, each.right.end, each.op, each.right) for each in reversed(operations)]
    return Chain(node.start, node.end, first, links)  # type: ignore[arg-type]


def cut_too_deep(module: Module) -> None:
    """Put a `Wrong` in place of each expression that is nested too deeply, and report its line."""
    lines = {module.line(node.start): node.start for node in _cut(module)}
    found = [
        Diagnostic(
            "syntax",
            f"the expression is nested more than {MAX_EXPRESSION_DEPTH} deep",
            line,
            module.column(at),
            length=len(token_at(module.source.text, at)),
            hint="split it into several statements",
        )
        for line, at in lines.items()
    ]
    module.errors = ProgramError([*module.errors, *found]).diagnostics


def _cut(module: Module) -> list[Node]:
    """Cut the tree below the depth limit, and return the nodes there, found without recursion."""
    found = []
    waiting: list[tuple[Node, int]] = [(module, 0)]
    while waiting:
        node, depth = waiting.pop()
        below = _children(node, depth + 1)
        if depth == MAX_EXPRESSION_DEPTH and any(each > depth for _, each in below):
            found += [child for child, _ in below]
            _without_children(node)
        else:
            waiting += below
    return found


def _without_children(node: Node) -> None:
    """Put a `Wrong` in place of each child of an expression."""
    for name in node.__slots__:
        value = getattr(node, name)
        if isinstance(value, Node):
            setattr(node, name, Wrong(value.start, value.end))
        elif isinstance(value, list):
            value.clear()


def depth_of(expression: Node) -> int:
    """Return the number of levels in an expression."""
    deepest, waiting = 0, [(expression, 1)]
    while waiting:
        node, depth = waiting.pop()
        deepest = max(deepest, depth)
        waiting += _children(node, depth + 1)
    return deepest


def _children(node: Node, depth: int) -> list[tuple[Node, int]]:
    values = [getattr(node, name) for name in node.__slots__]
    found = [value for value in values if isinstance(value, Node)]
    for value in values:
        if isinstance(value, list):
            found += value
    return [(each, depth if isinstance(each, _NESTS) else 0) for each in found]
