"""The names of a Mint program for an editor: definitions, uses and blocks.

Name resolution has recorded in the tree what each name refers to. `names` reads it there.
"""

from __future__ import annotations

from collections.abc import Iterator
from operator import itemgetter

from motionlang.kernel.lang.names import Definition, Names
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number
from motionlang.kernel.mint.resolve.names import Symbols as Resolver
from motionlang.kernel.mint.resolve.symbols import FLOAT, RECORD, STRING, Function, Symbol, Type
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.blocks import OPENERS
from motionlang.kernel.mint.syntax.extent import blocks
from motionlang.kernel.mint.syntax.tokens import Tokens
from motionlang.kernel.mint.syntax.traversal import walk

# A name with the node that has it.
Use = tuple[Word, nodes.Node]

# The slot of a node that has a name.
_SLOTS = {
    **dict.fromkeys(
        (
            nodes.Const, nodes.Define, nodes.End, nodes.Event, nodes.Jump, nodes.Label, nodes.Name, nodes.Parameter,
            nodes.Run, nodes.Sub, nodes.Task, nodes.TypeName, nodes.UserType, nodes.Variable,
        ),
        "name",
    ),
    nodes.For: "last_name",
    nodes.Member: "field",
    nodes.Print: "word",
}  # fmt: skip
_KINDS = {"const": "constant"}
_NOT_RENAMED = "an event handler has the name of its event"


def names(module: nodes.Module, resolver: Resolver) -> Names:
    """Return the names of a module whose names are resolved."""
    text = module.source.text
    uses: dict[Symbol, list[Use]] = {}
    for _, word, node, symbol in sorted(_named(module), key=itemgetter(0)):
        uses.setdefault(symbol.first, []).append((word, node))
    definitions = [_definition(symbol, found, resolver.main, text) for symbol, found in uses.items()]
    return Names(definitions, blocks(module), not module.errors, _Renaming(resolver, definitions).problem)


def _named(module: nodes.Module) -> Iterator[tuple[int, Word, nodes.Node, Symbol]]:
    """Yield each name of the program's own with its start, its node and its symbol, in no particular order."""
    for node in walk([*module.everything, *module.types]):
        slot = _SLOTS.get(type(node))
        word = None if slot is None else getattr(node, slot)
        if word:
            symbol = node.variable.symbol if isinstance(node, nodes.For) else node.symbol  # type: ignore[attr-defined]
            if symbol is not None:
                yield word.start, word, node, symbol


# --------------------------------------------------------------------------------------------- definitions


def _definition(symbol: Symbol, uses: list[Use], main: Function, text: str) -> Definition:
    declaration = next((use for use in uses if _declares(use[1], symbol)), None)
    kind = _kind(symbol)
    # A block belongs to the function around it, other names to the function that declares them.
    function = _around(symbol.home) if symbol.kind in ("sub", "task", "event") else symbol.home
    node = function.node
    made = Definition(symbol.name, kind, (0, len(text)) if node is None else (node.start, node.end))
    made.uses = [(word.start, word.end) for word, _ in uses]
    if declaration is not None:
        made.span = declaration[0].start, declaration[0].end
    made.home = "" if function is main else function.name
    _describe(made, symbol, None if declaration is None else declaration[1], text)
    return made


def _declares(node: nodes.Node, symbol: Symbol) -> bool:
    return node.start == symbol.at and not isinstance(node, nodes.Jump)


def _kind(symbol: Symbol) -> str:
    if symbol.given:
        return "constant"
    node = symbol.home.node
    is_function = symbol.kind == "sub" and isinstance(node, nodes.Sub) and node.function
    return "function" if is_function else _KINDS.get(symbol.kind, symbol.kind)


def _around(function: Function) -> Function:
    outer = function.scope.outer
    assert outer is not None
    return outer.function


def _describe(made: Definition, symbol: Symbol, declaration: nodes.Node | None, text: str) -> None:
    """Set what is known of a definition."""
    match made.kind:
        case "sub" | "function":
            made.parameters = tuple(map(_parameter, symbol.home.parameters))
            made.type = str(symbol.type) if made.kind == "function" else ""
            result = f" As {made.type}" if made.type else ""
            made.text = f"{OPENERS[made.kind.upper()]} {made.name}({', '.join(made.parameters)}){result}"
        case "task" | "event":
            made.text = f"{made.kind.capitalize()} {made.name}"
        case "constant":
            made.value = "" if symbol.const is None else _literal(symbol.const)
            made.type = str(symbol.type)
            made.text = f"Const {made.name} = {made.value or '…'}"
        case "define":
            assert isinstance(declaration, nodes.Define)
            expression = text.index("=", declaration.name.end) + 1
            made.value = text[expression : declaration.end].strip()
            made.text = f"Define {made.name} = {made.value}"
        case "parameter":
            made.type, made.text = _type(symbol.type), _parameter(symbol)
        case "label":
            if isinstance(declaration, nodes.Label):
                has_sign = declaration.start < declaration.name.start
                made.text = f"#{made.name}" if has_sign else f"{made.name}:"
        case "type":
            members = ", ".join(symbol.type.record.members) if symbol.type.record is not None else ""
            made.text = f"Type {made.name}: {members}" if members else f"Type {made.name}"
        case "member":
            assert symbol.owner is not None
            made.home, made.type = symbol.owner.name, _type(symbol.type)
            made.text = f"{made.home}.{made.name} As {made.type}"
        case "variable":
            made.type = _type(symbol.type)
            made.text = f"Dim {_shape(symbol)} As {made.type}"
            if not symbol.declared:
                made.text = f"{made.name} As {FLOAT}, declared by its first assignment"
    if made.kind == "event" or (made.kind == "label" and kind_and_number(made.name) is not None):
        made.fixed = _NOT_RENAMED


def _type(kind: Type) -> str:
    if kind.name == STRING and kind.size is not None:
        return f"String * {kind.size}"
    return str(kind.record.name) if kind.name == RECORD and kind.record is not None else str(kind)


def _shape(symbol: Symbol) -> str:
    sizes = ", ".join(str(size) for size in symbol.dimensions)
    return f"{symbol.name}({sizes})" if symbol.dimensions else symbol.name


def _parameter(symbol: Symbol) -> str:
    by_ref = "ByRef " if symbol.by_ref else ""
    return f"{by_ref}{symbol.name}{'()' if symbol.is_array else ''} As {_type(symbol.type)}"


def _literal(value: float | str) -> str:
    return f'"{value}"' if isinstance(value, str) else f"{value:.10g}"


# ------------------------------------------------------------------------------------------------ renaming


class _Renaming:
    """Finds the reasons why a definition cannot be renamed."""

    def __init__(self, resolver: Resolver, definitions: list[Definition]) -> None:
        self._definitions = definitions
        # The names in the expressions of Defines, which are resolved where the Define is used.
        self._in_defines: dict[str, str] = {}
        for function in resolver.functions:
            for symbol in function.scope.names.values():
                if symbol.kind == "define" and symbol.node is not None:
                    for node in walk([symbol.node]):
                        if isinstance(node, nodes.Name):
                            self._in_defines.setdefault(node.name.lower(), symbol.name)

    def problem(self, definition: Definition, name: str) -> str:
        """Return why a definition cannot be named `name`, "" if it can."""
        if definition.fixed:
            return definition.fixed
        if definition.span is None:
            return f"{definition.name} is not declared in this text"
        tokens = Tokens(name)
        if tokens.kinds[0] != "NAME" or tokens.texts[0] != name:
            return f"{name} is not a name: use letters, digits and _, and no keyword"
        key = name.lower()
        if key == definition.name.lower():
            return ""
        row = table().get(name)
        if row is not None and definition.kind not in ("label", "member"):
            return f"{row.name} is a keyword of Mint"
        used_by = self._in_defines.get(definition.name.lower()) or self._in_defines.get(key)
        if used_by and (definition.home or self._in_defines.get(key)):
            return f"Define {used_by} contains the name, and its meaning depends on where the Define is used"
        for other in self._definitions:
            if other is not definition and other.name.lower() == key and _collide(definition, other):
                line = "" if other.span is None else f" as a {other.kind}"
                return f"{other.name} is already declared{line}"
        return ""


def _collide(one: Definition, other: Definition) -> bool:
    """True if two definitions could not have the same name."""
    spaces = {"label": "label", "member": "member", "type": "type", "event": "event"}
    if spaces.get(one.kind, "") != spaces.get(other.kind, ""):
        return False
    if one.kind == "member":
        return one.home == other.home
    return one.scope[0] <= other.scope[1] and other.scope[0] <= one.scope[1]
