"""The names of a Mint program for an editor: definitions, uses and blocks.

The resolver declares the names, as it does for the compiler. It records names by nodes, but some names are in
no node: variables after `Next`, labels, types and members. So the uses are found from the tokens. Each name is
looked up in the scope of the enclosing sub, as the resolver does.
"""

from __future__ import annotations

from motionlang.errors import ProgramError
from motionlang.lang.collector import CollectorOff
from motionlang.lang.names import NO_NAMES, Block, Definition, Names
from motionlang.lang.nesting import StackSpace
from motionlang.mint.keywords import table
from motionlang.mint.keywords.event_kinds import kind_and_number
from motionlang.mint.resolve.names import Names as Resolver
from motionlang.mint.resolve.problems import Problems
from motionlang.mint.resolve.symbols import FLOAT, RECORD, STRING
from motionlang.mint.syntax import nodes, outline
from motionlang.mint.syntax.blocks import OPENERS
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.recovery import readable
from motionlang.mint.syntax.tables import TABLES
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.names import Span
    from motionlang.mint.resolve.symbols import Function, Record, Scope, Symbol, Type
    from motionlang.mint.syntax.nodes import Module
    from motionlang.source import Source

# Kinds of token that may be a name where their own sense is impossible.
_LEADING = frozenset(("AUTO", "BYREF", "BYVAL", "EVENT", "INPUT", "NV", "RUN", "STARTUP", "STEP", "TASK", "TO", "TYPE",
                      "USING"))  # fmt: skip
_NAMES = frozenset(("NAME", "DOTTED"))
# Kinds of token before a name that may be no variable, such as a label.
_SPECIAL = frozenset(("HASH", "GOTO", "GOSUB", "TYPE", "AS", "EVENT", "DOT"))
_JUMPS = frozenset(("GOTO", "GOSUB"))
_BEFORE_NAMES = _JUMPS | {"HASH"}
_LABELS = _LEADING | {"NAME", "END", "EXIT", "LOOP", "NEXT", "PAUSE", "REPEAT", "RETURN"}
# Kinds of token before the `#` of a label; after others it begins the number of a terminal.
_BEFORE_LABELS = _JUMPS | {"_NL", "COLON", "THEN", "ELSE"}
_KINDS = {"const": "constant"}
# The scope of names that are visible in the whole text.
_WHOLE = -1, -1
_NOT_RENAMED = "an event handler has the name of its event"


def names(source: Source) -> Names:
    """Return the names of a program; unreadable lines contribute none."""
    with CollectorOff(), StackSpace():
        complete = True
        try:
            module = parse(source)
        except ProgramError as error:
            found, _ = readable(source, error)
            if found is None:
                return NO_NAMES
            module, complete = found, False
        return _Finder(module).found(complete)


class _Positions:
    """The offsets of the tokens of a program, computed on first use."""

    def __init__(self, text: str, texts: list[str]) -> None:
        self._text, self._texts = text, texts
        self._starts: list[int] = []

    def of_name(self, token: int, length: int) -> Span:
        """Return the span of a name that begins with a token."""
        start = self._offsets()[token]
        return start, start + length

    def of_block(self, first: int, last: int) -> Span:
        """Return the span from the start of one token to the end of another.

        A negative `first` returns the span of the whole text.
        """
        if first < 0:
            return 0, len(self._text)
        starts = self._offsets()
        return starts[first], starts[last] + len(self._texts[last])

    def _offsets(self) -> list[int]:
        if not self._starts:
            self._starts = [match.start(1) for match in TABLES.matches(self._text)]
            self._starts += [len(self._text)] * (len(self._texts) - len(self._starts))
        return self._starts


class _Finder:
    """One pass over the tokens of a program whose names are declared."""

    def __init__(self, module: Module) -> None:
        self.module = module
        self.text = module.offsets.source.text
        self.texts, self.kinds = module.offsets.tokens()
        self.positions = _Positions(self.text, self.texts)
        self.resolver = Resolver(table(), Problems(module))
        self.resolver.declare(module)
        self.blocks = outline.blocks(self.kinds)
        self.whole = _WHOLE
        self.definitions: dict[object, Definition] = {}
        self.scopes: dict[Function, tuple[int, int]] = {self.resolver.main: self.whole}
        self.function = self.resolver.main
        # The declarations of members, by their tokens.
        self.members: dict[int, tuple[Record, nodes.Variable]] = {}
        for user_type in module.types:
            record = self.resolver.types[user_type.name.lower()]
            self.members.update(
                (m.at, (record, m)) for m in user_type.members if m.name.lower() in record.members
            )

    def found(self, complete: bool) -> Names:
        """Return the names; `complete` is as in `Names`."""
        extents = {block.first: block for block in self.blocks}
        functions = {each.at: each for each in self.resolver.functions if each is not self.resolver.main}
        for at, function in functions.items():
            block = extents.get(at)
            if block is not None:
                self.scopes[function] = block.first, block.last
        self._walk(functions, extents)
        made = [each for each in self.definitions.values() if each.is_used]
        return Names(made, self._outline, complete, _Renaming(self, made).problem)

    def _walk(self, functions: dict[int, Function], extents: dict[int, outline.Span]) -> None:
        """Record every use of a name in its definition."""
        kinds, texts, members = self.kinds, self.texts, self.members
        names = [at for at, kind in enumerate(kinds) if kind in _NAMES]
        others = self._leading()
        if not _BEFORE_NAMES.isdisjoint(kinds):
            others |= {
                at for at, before in enumerate(kinds, 1) if before in _BEFORE_NAMES and self._is_label(at)
            }
        if others:
            names = sorted({*names, *others})
        heads = sorted((at for at in functions if at in extents), reverse=True)
        ends: list[tuple[int, Function]] = []
        skip: set[int] = set()
        # The definitions of names in the present function, where nothing but the use is to be entered.
        known: dict[str, Definition | None] = {}
        for at in names:
            while (ends and at > ends[-1][0]) or (heads and at > heads[-1]):
                known = {}
                if ends and (not heads or ends[-1][0] < heads[-1]):
                    self.function = ends.pop()[1]
                else:
                    head = heads.pop()
                    ends.append((extents[head].last, self.function))
                    self.function = functions[head]
            text = texts[at]
            is_special = kinds[at - 1] in _SPECIAL or kinds[at + 1] == "COLON" or at in members
            if is_special or text not in known:
                if at not in skip:
                    known[text] = self._use(at, skip)
                    if known[text] is None and self.function.scope.find(text.partition(".")[0]) is not None:
                        del known[text]
                continue
            definition = known[text]
            if definition is not None:
                definition.use((at, len(text)))

    def _leading(self) -> set[int]:
        """Return the tokens of keywords that are used as names, such as a variable `step`."""
        scopes = {function.scope for function in self.resolver.functions}
        words = {name for scope in scopes for name in scope.names}
        if not words & {kind.lower() for kind in _LEADING}:
            return set()
        found = {
            node.at
            for function in self.resolver.functions
            for node in walk(function.body)
            if isinstance(node, (nodes.Name, nodes.Variable, nodes.Const, nodes.Define))
        }
        declared = {s.at for scope in scopes for s in scope.names.values()}
        return {at for at in found | declared if at < len(self.kinds) and self.kinds[at] in _LEADING}

    def _is_label(self, at: int) -> bool:
        """True for the name of a label after `#`, GoTo or GoSub.

        It may be a keyword of the language.
        """
        if self.kinds[at] not in _LABELS:
            return False
        before = self.kinds[at - 1]
        if before != "HASH":
            return before in _JUMPS
        return at == 1 or self.kinds[at - 2] in _BEFORE_LABELS

    def _use(self, at: int, skip: set[int]) -> Definition | None:
        """Record the use of a name.

        Returns the definition if it also applies to later uses of the same spelling in the same function.
        """
        text, before = self.texts[at], self.kinds[at - 1] if at else "_NL"
        if self._is_label(at) or self._is_line_label(at):
            self._label(at)
        elif before == "TYPE":
            self._type(at)
        elif before == "AS":
            if text.lower() in self.resolver.types:
                self._type(at)
        elif before == "EVENT" and self.function.kind == "event" and self.function.at == at - 1:
            self._event(at)
        elif at in self.members:
            self._enter(self._member(*self.members[at]), at)
        elif before != "DOT":
            name = text.partition(".")[0]
            symbol = self.function.scope.find(name)
            if symbol is None:
                return None
            made = self._of_symbol(symbol)
            self._enter(made, at, len(name), is_declaration=at >= symbol.at)
            if symbol.type.record is not None:
                self._members(at, symbol.type.record, skip)
            elif made.is_declared and name == text:
                return made
        return None

    def _enter(
        self, made: Definition, at: int, length: int | None = None, is_declaration: bool = True
    ) -> None:
        span = at, len(self.texts[at]) if length is None else length
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
        made = Definition(symbol.name, kind, self.scopes.get(owner, self.whole), positions=self.positions)
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
        equal = next((i for i in range(at, min(at + 4, len(self.kinds))) if self.kinds[i] == "EQUAL"), at)
        last = equal
        while self.kinds[last + 1] not in ("_NL", "COLON", "$END"):
            last += 1
        offsets = self.module.offsets
        return self.text[offsets.span(equal)[1] : offsets.span(last)[1]].strip()

    def _is_line_label(self, at: int) -> bool:
        """True for the name of `NAME:` on a line of its own."""
        return (
            self.kinds[at + 1] == "COLON"
            and self.kinds[at + 2] in ("_NL", "$END")
            and (at == 0 or self.kinds[at - 1] == "_NL")
        )

    def _label(self, at: int) -> None:
        key = "label", self.function, self.texts[at].lower()
        made = self.definitions.get(key)
        if made is None:
            made = Definition(self.texts[at], "label", self.scopes.get(self.function, self.whole),
                              positions=self.positions)  # fmt: skip
            made.home = "" if self.function is self.resolver.main else self.function.name
            made.fixed = _NOT_RENAMED if kind_and_number(made.name) is not None else ""
            self.definitions[key] = made
        before = self.kinds[at - 1] if at else "_NL"
        is_target = before == "_NL" or (
            before == "HASH" and self.kinds[at - 2 : at - 1] not in ([k] for k in _JUMPS)
        )
        self._enter(made, at, is_declaration=is_target)
        if is_target:
            made.text = f"#{made.name}" if before == "HASH" else f"{made.name}:"

    def _type(self, at: int) -> None:
        key = "type", self.texts[at].lower()
        made = self.definitions.get(key)
        if made is None:
            made = self.definitions[key] = Definition(
                self.texts[at], "type", self.whole, positions=self.positions
            )
            record = self.resolver.types.get(key[1])
            members = ", ".join(record.members) if record is not None else ""
            made.text = f"Type {made.name}: {members}" if members else f"Type {made.name}"
        self._enter(made, at, is_declaration=self.kinds[at - 1] == "TYPE")

    def _event(self, at: int) -> None:
        made = Definition(self.texts[at], "event", self.whole, f"Event {self.texts[at]}", self.positions)
        made.fixed = _NOT_RENAMED
        self.definitions["event", at] = made
        self._enter(made, at)

    def _members(self, at: int, record: Record, skip: set[int]) -> None:
        """Record the members in `value.member(…).member`, which begins with a token."""
        following: Record | None = record
        while following is not None:
            at += 1
            if self.kinds[at] in ("LPAR", "LSQB"):
                depth = 1
                while depth and self.kinds[at] not in ("_NL", "$END"):
                    at += 1
                    depth += (self.kinds[at] in ("LPAR", "LSQB")) - (self.kinds[at] in ("RPAR", "RSQB"))
                at += 1
            if self.kinds[at] != "DOT" or self.texts[at + 1].lower() not in following.members:
                return
            at += 1
            skip.add(at)
            key = self.texts[at].lower()
            node = next(m for r, m in self.members.values() if r is following and m.name.lower() == key)
            self._enter(self._member(following, node), at, is_declaration=False)
            following = following.members[key][1].record

    def _member(self, record: Record, node: nodes.Variable) -> Definition:
        key = node.name.lower()
        made = self.definitions.get((record, key))
        if made is None:
            kind = _type(record.members[key][1])
            made = Definition(
                node.name, "member", self.whole, f"{record.name}.{node.name} As {kind}", self.positions
            )
            made.home, made.type = record.name, kind
            self.definitions[record, key] = made
        return made

    def _outline(self) -> list[Block]:
        found, positions = [], self.positions
        for block in self.blocks:
            at = block.first if block.name < 0 else block.name
            name = "" if block.name < 0 else self.texts[block.name]
            span = positions.of_block(block.first, block.last)
            found.append(Block(block.kind.lower(), name, positions.of_block(at, at), span))
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
        kinds = TABLES.kinds_of(TABLES.texts(name))
        if kinds[:1] != ["NAME"] or TABLES.texts(name)[0] != name:
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
