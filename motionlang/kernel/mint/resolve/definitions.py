"""The names of a Mint program for an editor: definitions, uses and blocks.

The resolver declares the names, as it does for the compiler. The tree has each name with its position, except the one
after `Next`. Each is looked up in the scope of the enclosing sub, as the resolver does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from operator import itemgetter

from motionlang.kernel.lang.names import Block, Definition, Names, Span
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number
from motionlang.kernel.mint.resolve.names import Names as Resolver
from motionlang.kernel.mint.resolve.symbols import (
    FLOAT,
    RECORD,
    STRING,
    Function,
    Record,
    Scope,
    Symbol,
    Type,
)
from motionlang.kernel.mint.syntax import nodes, outline
from motionlang.kernel.mint.syntax.blocks import OPENERS
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import Tokens
from motionlang.kernel.mint.syntax.traversal import walk

# A name, and what records it.
Use = tuple[Word, Callable[[], None]]

_KINDS = {"const": "constant"}
# Nodes that have a name of a variable, a constant, a sub or a task.
_NAMED = (nodes.Name, nodes.Variable, nodes.Const, nodes.Define, nodes.Parameter, nodes.Run, nodes.End)
_NOT_RENAMED = "an event handler has the name of its event"


def names(module: Module, resolver: Resolver, complete: bool) -> Names:
    """Return the names of a module that are declared; `complete` is as in `Names`."""
    return _Finder(module, resolver).found(complete)


class _Finder:
    """One pass over the names of a program whose names are declared."""

    def __init__(self, module: Module, resolver: Resolver) -> None:
        self.module, self.resolver = module, resolver
        self.text = module.source.text
        self.defines: dict[int, nodes.Define] = {}
        tops: list[nodes.Sub | nodes.Task | nodes.Event] = [
            *module.subs,
            *module.tasks,
            *module.events,
            *(sub for task in module.tasks for sub in task.subs),
        ]
        main = [*module.body, *module.startup]
        self.words: dict[int, list[Use]] = {id(each): [*self._of_block(each)] for each in tops}
        self.words[id(None)] = [*self._words(main)]
        self.whole = 0, len(self.text)
        self.definitions: dict[object, Definition] = {}
        self.function = self.resolver.main
        self.scopes: dict[Function, Span] = {self.resolver.main: self.whole}
        self.scopes |= {
            each: (each.node.start, each.node.end)
            for each in self.resolver.functions
            if each.node is not None
        }

    def found(self, complete: bool) -> Names:
        """Return the names; `complete` is as in `Names`."""
        uses: list[tuple[int, Function, Callable[[], None]]] = []
        for function in self.resolver.functions:
            uses += ((word.start, function, enter) for word, enter in self.words[id(function.node)])
        for user_type in self.module.types:
            uses += ((word.start, self.resolver.main, enter) for word, enter in self._of_type(user_type))
        for _, self.function, enter in sorted(uses, key=itemgetter(0)):
            enter()
        made = [each for each in self.definitions.values() if each.is_used]
        return Names(made, self._outline(), complete, _Renaming(self, made).problem)

    def _of_block(self, node: nodes.Sub | nodes.Task | nodes.Event) -> Iterator[Use]:
        """Yield the names of a block, without those of subs in it."""
        yield node.name, partial(self._event if isinstance(node, nodes.Event) else self._name, node.name)
        if isinstance(node, nodes.Sub):
            yield from self._words([*node.parameters, node.result])
        yield from self._words(node.body)

    def _of_type(self, node: nodes.UserType) -> Iterator[Use]:
        """Yield the names in a declaration of a type."""
        yield node.name, partial(self._type, node.name, True)
        record = self.resolver.types[node.name.lower()]
        for member in node.members:
            if member.name.lower() in record.members:
                yield member.name, partial(self._member, record, member.name, True)
            yield from self._words([*member.dimensions, member.type, *member.values])

    def _words(self, body: Iterable[object]) -> Iterator[Use]:
        """Yield the names in some nodes, in no particular order."""
        for node in walk(body):
            if isinstance(node, nodes.TypeName):
                yield node.name, partial(self._type, node.name, False)
            elif isinstance(node, nodes.Member):
                yield node.field, partial(self._field, node)
            elif isinstance(node, nodes.Label):
                mark = "#{}" if node.start < node.name.start else "{}:"
                yield node.name, partial(self._label, node.name, mark)
            elif isinstance(node, nodes.Jump):
                yield node.name, partial(self._label, node.name, "")
            elif isinstance(node, nodes.Print):
                if node.word:
                    yield node.word, partial(self._name, node.word)
            elif isinstance(node, _NAMED) and node.name is not None:
                yield node.name, partial(self._name, node.name)
                if isinstance(node, nodes.Define):
                    self.defines[node.start] = node
            elif isinstance(node, nodes.For):
                word = self._after_next(node)
                if word is not None:
                    yield word, partial(self._name, word)

    def _after_next(self, node: nodes.For) -> Word | None:
        """Return the name after `Next`, with which a For ends if there is one."""
        begin = node.end - len(node.variable.name)
        word = Word(self.text[begin : node.end], begin, node.end)
        is_name = word.lower() == node.variable.name.lower() and not self.text[begin - 1].isalnum()
        return word if is_name else None

    def _name(self, word: Word) -> None:
        symbol = self.function.scope.find(word)
        if symbol is not None:
            self._enter(self._of_symbol(symbol), word, is_declaration=word.start >= symbol.at)

    def _field(self, node: nodes.Member) -> None:
        record = self._record_of(node.value)
        if record is not None and node.field.lower() in record.members:
            self._member(record, node.field, False)

    def _record_of(self, node: nodes.Expr) -> Record | None:
        """Return the type of a record, None for any other value."""
        if isinstance(node, nodes.Name):
            symbol = self.function.scope.find(node.name)
            return None if symbol is None else symbol.type.record
        if isinstance(node, nodes.Member) and (record := self._record_of(node.value)) is not None:
            found = record.members.get(node.field.lower())
            return None if found is None else found[1].record
        return None

    def _enter(self, made: Definition, word: Word, is_declaration: bool = True) -> None:
        span = word.start, word.end
        made.use(span)
        if is_declaration and not made.is_declared:
            made.declare(span)

    # ----------------------------------------------------------------------------------- kinds of names

    def _of_symbol(self, symbol: Symbol) -> Definition:
        known = self.definitions.get(symbol)
        if known is None:
            known = self.definitions[symbol] = self._defined(symbol)
        return known

    def _defined(self, symbol: Symbol) -> Definition:
        home, node = symbol.home, symbol.home.node
        kind = _KINDS.get(symbol.kind, symbol.kind)
        if kind == "define" and symbol.given:
            kind = "constant"
        if kind == "sub" and isinstance(node, nodes.Sub) and node.function:
            kind = "function"
        # A sub belongs to the function around it, other names to the function that declares them.
        owner = self._around(home) if symbol.kind in ("sub", "task") else home
        made = Definition(symbol.name, kind, self.scopes[owner])
        made.home = "" if owner is self.resolver.main else owner.name
        if kind in ("sub", "function"):
            made.parameters = tuple(map(_parameter, home.parameters))
            made.type = str(symbol.type) if kind == "function" else ""
            result = f" As {made.type}" if made.type else ""
            made.text = f"{OPENERS[kind.upper()]} {symbol.name}({', '.join(made.parameters)}){result}"
        elif kind == "task":
            made.text = f"Task {symbol.name}"
        elif kind == "constant":
            made.value = "" if symbol.const is None else _literal(symbol.const)
            made.type = str(symbol.type)
            made.text = f"Const {symbol.name} = {made.value or '…'}"
        elif kind == "define":
            made.value = self._rest_of_define(symbol.at)
            made.text = f"Define {symbol.name} = {made.value}"
        elif kind == "parameter":
            made.type, made.text = _type(symbol.type), _parameter(symbol)
        else:
            made.type = _type(symbol.type)
            made.text = f"Dim {_shape(symbol)} As {made.type}"
            if not symbol.declared:
                made.text = f"{symbol.name} As {FLOAT}, declared by its first assignment"
        return made

    def _around(self, function: Function) -> Function:
        outer: Scope | None = function.scope.outer
        return outer.function if outer is not None else self.resolver.main

    def _rest_of_define(self, at: int) -> str:
        """Return the text of the expression in a Define, as written."""
        node = self.defines[at]
        return self.text[self.text.index("=", node.name.end) + 1 : node.end].strip()

    def _label(self, word: Word, mark: str) -> None:
        """Record a label; `mark` is how it is declared, "" for a jump to it."""
        key = "label", self.function, word.lower()
        made = self.definitions.get(key)
        if made is None:
            made = Definition(str(word), "label", self.scopes[self.function])
            made.home = "" if self.function is self.resolver.main else self.function.name
            made.fixed = _NOT_RENAMED if kind_and_number(made.name) is not None else ""
            self.definitions[key] = made
        self._enter(made, word, is_declaration=bool(mark))
        if mark:
            made.text = mark.format(made.name)

    def _type(self, word: Word, is_declaration: bool) -> None:
        key = "type", word.lower()
        if key[1] not in self.resolver.types:
            return  # a type of Mint itself
        made = self.definitions.get(key)
        if made is None:
            made = self.definitions[key] = Definition(str(word), "type", self.whole)
            record = self.resolver.types.get(key[1])
            members = ", ".join(record.members) if record is not None else ""
            made.text = f"Type {made.name}: {members}" if members else f"Type {made.name}"
        self._enter(made, word, is_declaration)

    def _event(self, word: Word) -> None:
        made = Definition(str(word), "event", self.whole, f"Event {word}")
        made.fixed = _NOT_RENAMED
        self.definitions["event", word.start] = made
        self._enter(made, word)

    def _member(self, record: Record, word: Word, is_declaration: bool) -> None:
        key = word.lower()
        made = self.definitions.get((record, key))
        if made is None:
            name = next(
                member.name
                for node in self.module.types
                if self.resolver.types.get(node.name.lower()) is record
                for member in node.members
                if member.name.lower() == key
            )
            kind = _type(record.members[key][1])
            made = Definition(str(name), "member", self.whole, f"{record.name}.{name} As {kind}")
            made.home, made.type = record.name, kind
            self.definitions[record, key] = made
        self._enter(made, word, is_declaration)

    def _outline(self) -> list[Block]:
        tokens = Tokens(self.text)
        found = []
        for block in outline.blocks(tokens.kinds):
            at = block.first if block.name < 0 else block.name
            name = "" if block.name < 0 else tokens.texts[block.name]
            span = tokens.starts[block.first], tokens.ends[block.last]
            found.append(Block(block.kind.lower(), name, (tokens.starts[at], tokens.ends[at]), span))
        return found


class _Renaming:
    """Finds the reasons why a definition cannot be renamed."""

    def __init__(self, finder: _Finder, definitions: list[Definition]) -> None:
        self._definitions = definitions
        # The names in the expressions of Defines, which are resolved where the Define is used.
        self._in_defines: dict[str, str] = {}
        for function in finder.resolver.functions:
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
