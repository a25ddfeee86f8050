"""Traverse the tree of a function once, for the passes that resolve its names."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Assign, Binary, For, Given, Input, Name, Number, String

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.symbols import Symbol

# Slots that hold no nodes, such as names and operators. All other slots of a class are in `_CHILDREN`.
_NOT_NODES = frozenset(("args_are", "axes", "by_ref", "field", "function", "is_array", "kind", "name", "nv", "op",
                        "repeat", "separator", "source", "word"))  # fmt: skip
_CHILDREN: dict[type, tuple[str, ...]] = {
    cls: tuple(slot for slot in cls.__slots__ if slot not in _NOT_NODES)
    for cls in vars(nodes).values()
    if isinstance(cls, type) and issubclass(cls, nodes.Node)
}
_CHILDREN[Number] = _CHILDREN[String] = _CHILDREN[Given] = ()

# Statements at which nothing happens.
_SILENT = (nodes.Const, nodes.Define, nodes.Label, nodes.Auto)


def children(node: object) -> list[object]:
    """Return the children of a node, with its other attribute values but without None."""
    out: list[object] = []
    for slot in _CHILDREN.get(node.__class__, ()):
        value = getattr(node, slot)
        if value.__class__ is list:
            out += value
        elif value is not None:
            out.append(value)
    return out


def walk(start: Iterable[object]) -> Iterator[nodes.Node]:
    """Yield `start` and every node below it, in no particular order."""
    stack = list(start)
    while stack:
        node = stack.pop()
        children = _CHILDREN.get(node.__class__)
        if children is None:
            continue
        yield node  # type: ignore[misc]
        for slot in children:
            value = getattr(node, slot)
            if value.__class__ is list:
                stack.extend(value)
            elif value is not None:
                stack.append(value)


def replace(start: Iterable[object], change: Callable[[object], object]) -> None:
    """Put `change(node)` in place of each node below `start`; for most it returns the node itself."""
    for node in walk(start):
        for slot in _CHILDREN[node.__class__]:
            value = getattr(node, slot)
            if value.__class__ is list:
                value[:] = map(change, value)
            else:
                setattr(node, slot, change(value))


def by_kind(start: Iterable[object]) -> dict[type, list[Any]]:
    """Return the nodes that `walk` yields by class, without literals.

    The nodes of a class are in the order of `walk`. The code repeats that of `walk`, as `Survey` does, because every
    node passes through it.
    """
    found: dict[type, list[Any]] = {kind: [] for kind in _CHILDREN}
    stack = list(start)
    while stack:
        node = stack.pop()
        kind = node.__class__
        if kind is Number or kind is String or (children := _CHILDREN.get(kind)) is None:
            continue
        found[kind].append(node)
        if kind is Binary:
            stack += (node.left, node.right)  # type: ignore[attr-defined]
            continue
        for slot in children:
            value = getattr(node, slot)
            if value.__class__ is list:
                stack += value
            elif value is not None:
                stack.append(value)
    return found


def meant(node: nodes.Expr) -> nodes.Expr:
    """Return the expression that a Define gives to a name; any other node unchanged."""
    while isinstance(node, Name) and node.args is None and node.definition is not None:
        node = node.definition
    return node


def is_stop(node: nodes.Node) -> bool:
    """True if something happens at a statement, so that a debugger can stop before it."""
    if isinstance(node, nodes.Dim):
        return any(variable.values for variable in node.variables)
    return isinstance(node, nodes.Stmt) and not isinstance(node, _SILENT)


def copied(node: object) -> object:
    """Return a copy of a tree, with the same positions; what a check has added is not copied."""
    waiting: list[object] = []
    found = _copy(node, waiting)
    while waiting:
        made = waiting.pop()
        if made.__class__ is list:
            made[:] = [_copy(each, waiting) for each in made]
        else:
            for slot in _CHILDREN[made.__class__]:
                setattr(made, slot, _copy(getattr(made, slot), waiting))
    return found


def _copy(node: object, waiting: list[object]) -> object:
    """Return a copy of a node or list with the same children, which is then among those that are waiting for theirs."""
    if node.__class__ is list:
        made: object = list(node)
    elif node.__class__ in _CHILDREN:
        made = node.__class__.__new__(node.__class__)
        made.start, made.end = node.start, node.end  # type: ignore[attr-defined]
        for slot in node.__class__.__slots__:  # type: ignore[attr-defined]
            setattr(made, slot, getattr(node, slot))
        if isinstance(node, For) and isinstance(made, For):
            made.last_name = node.last_name  # it is no part of the content
    else:
        return node
    waiting.append(made)
    return made


class Survey:
    """The nodes of a body that the passes of name resolution need.

    `names` are the Names by spelling, `targets` the targets of assignments and INPUT, `assigned` the
    variables that are assigned a value, each spelling once, and `statements` all nodes except assignments, operations
    and literals. It visits the same nodes as `walk`. The code is long and does not use `walk`, because every
    node of every program passes through it.
    """

    def __init__(self, body: Iterable[object]) -> None:
        self.names: dict[str, list[Name]] = {}
        self.targets: list[nodes.Expr] = []
        self.assigned: dict[str, Name] = {}
        self.statements: list[nodes.Node] = []
        stack: list[object] = list(body)
        names = self.names
        while stack:
            node = stack.pop()
            kind = node.__class__
            if kind is Name:
                try:
                    names[node.name].append(node)  # type: ignore[attr-defined, arg-type]
                except KeyError:
                    names[node.name] = [node]  # type: ignore[attr-defined, list-item]
                if node.args:  # type: ignore[attr-defined]
                    stack += node.args  # type: ignore[attr-defined]
            elif kind is Number:
                continue
            elif kind is Binary:
                if (child := node.left).__class__ is not Number:  # type: ignore[attr-defined]
                    stack.append(child)
                if (child := node.right).__class__ is not Number:  # type: ignore[attr-defined]
                    stack.append(child)
            elif kind is Assign:
                target = node.target  # type: ignore[attr-defined]
                self.targets.append(target)
                if target.__class__ is Name and target.args is None:
                    self.assigned.setdefault(target.name, target)
                stack.append(target)
                stack += node.values  # type: ignore[attr-defined]
            elif kind is String:
                continue
            elif kind in _CHILDREN:
                self.statements.append(node)  # type: ignore[arg-type]
                if kind is For or kind is Input:
                    self._give(node)  # type: ignore[arg-type]
                for slot in _CHILDREN[kind]:
                    value = getattr(node, slot)
                    if value.__class__ is list:
                        stack += value
                    elif value is not None:
                        stack.append(value)

    def _give(self, node: For | Input) -> None:
        """Record the variable of a For or the target of an INPUT as assigned."""
        target: nodes.Expr = node.variable if isinstance(node, For) else node.target
        if isinstance(node, Input):
            self.targets.append(target)
        if isinstance(target, Name) and target.args is None:
            self.assigned.setdefault(target.name, target)

    def of(self, *kinds: type) -> list[nodes.Node]:
        """Return the statements of these kinds, in the order of the text."""
        return sorted(
            (node for node in self.statements if node.__class__ in kinds), key=lambda node: node.start
        )


def names_of(module: nodes.Module) -> Iterator[nodes.Name]:
    """Yield every name of a program, in no particular order."""
    for node in walk(module.everything):
        if type(node) is nodes.Name:
            yield node


def changed(node: nodes.Node) -> Iterator[nodes.Name]:
    """Yield the names of variables that a node changes, including arrays and ByRef arguments."""
    found: list[nodes.Expr] = []
    if isinstance(node, nodes.Assign | nodes.Input):
        found.append(node.target)
    elif isinstance(node, nodes.For):
        found.append(node.variable)
    elif isinstance(node, nodes.Name) and node.symbol is not None and node.symbol.kind == "sub":
        parameters = node.symbol.home.parameters
        given = zip(node.args or (), parameters, strict=False)
        found += [each for each, parameter in given if parameter.by_ref or parameter.is_array]
    for target in found:
        while isinstance(target, nodes.Member):
            target = target.value
        if isinstance(target, nodes.Name):
            yield target


def meaning(name: nodes.Name) -> Symbol | None:
    """Return the variable that a name refers to, directly or through a Define."""
    found = meant(name)
    return found.symbol if isinstance(found, nodes.Name) else name.symbol
