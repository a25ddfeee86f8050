"""The statements of a Mint program: what each does with keywords, axes, channels and variables."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Sequence

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.structure import (
    LEADS,
    PRINTS,
    READ,
    SET_UP,
    STARTS,
    WRITE,
    AxisKey,
    ChannelUse,
    Statement,
    Use,
    Written,
    role_of,
)
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.resolve.folding import fold
from motionlang.kernel.mint.resolve.forms import case_form, form
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.symbols import SEMAPHORE, TIME, Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import changed, children, is_stop, meaning, meant, walk
from motionlang.kernel.source import Source

# Words that the program has for "not known before the run".
_UNKNOWN = "?"
# Statements that only jump or end: the graph shows them.
_JUMPS = (nodes.Exit, nodes.Return)
# Statements that only lead elsewhere, or whose content is where their names are.
_DEFINING = (nodes.Const, nodes.Define)
_LEADING = (*_JUMPS, nodes.Jump, nodes.Label, *_DEFINING)
# Kinds of keywords that neither read the machine nor act on it.
_PURE = frozenset(("function", "constant", "statement"))
# A text, and the code of a character.
_QUOTED = re.compile(r"\"[^\"]*\"|'.'")
# The codes of keys that a person presses, from the space on.
_FIRST_KEY, _LAST_KEY = 32, 126


class FactsReader:
    """Reads the statements of the functions of a program whose names are resolved."""

    def __init__(self, source: Source, names: Symbols) -> None:
        self.source, self.names = source, names
        self.statements: dict[int, Statement] = {}
        # The offsets of labels.
        self.labels: dict[tuple[Function, str], int] = {}
        everything = list(walk(statement for each in names.functions for statement in each.body))
        # The code of each key that a node compares with.
        self._keys = {id(node): code for node, code in _keys(everything)}
        names_changed = [name for node in everything for name in changed(node)]
        dims = [each for node in everything if isinstance(node, nodes.Dim) for each in node.variables]
        self._changed = {meaning(name) for name in names_changed}
        # The offsets of the names of variables that a statement gives a value to, with simple values.
        self.writes = dict.fromkeys((each.name.start for each in names_changed), "")
        self.writes |= {each.name.start: "" for each in dims if each.values}
        for node in everything:
            if isinstance(node, nodes.Assign) and node.target.start in self.writes:
                self.writes[node.target.start] = self._given(node)
        for self._function in names.functions:
            self._block(self._function.body)

    def line(self, at: int) -> int:
        """Return the line of an offset."""
        return self.source.location(at)[0]

    def _block(self, body: list[nodes.Stmt]) -> None:
        for node in body:
            self._statement(node)

    def _statement(self, node: nodes.Stmt) -> None:
        match node:
            case nodes.If():
                self._if(node)
            case nodes.Select():
                self._head(node.start, node.subject, "Select Case {}")
                for case in node.cases:
                    tests = ", ".join(map(self._text, case.tests)) or "Else"
                    made = self._add(case.start, f"Case {tests}", case.tests)
                    characters = self._characters(case.tests)
                    made.condition = (
                        f"{self._text(node.subject)} is {tests}{characters}" if case.tests else ""
                    )
                    made.select = node.start
                    made.normal = case_form(node.subject, case.tests)
                    self._block(case.body)
            case nodes.For():
                values = [node.first, node.stop, *([node.step] if node.step is not None else [])]
                texts = [self._text(each) for each in (node.variable, *values)]
                step = f" Step {texts[3]}" if len(texts) > 3 else ""
                made = self._add(node.start, f"For {texts[0]} = {texts[1]} To {texts[2]}{step}", values)
                made.form, made.normal = (
                    f"For {form([node.variable, *values], each)}" for each in (False, True)
                )
                made.condition = f"{texts[0]} in {made.text.partition('= ')[2]}"
                self._block(node.body)
            case nodes.While():
                self._head(node.start, node.condition, "While {}")
                self._block(node.body)
            case nodes.Repeat():
                self._loop(node, "Repeat")
                at, text = node.condition.start, self._text(node.condition)
                # The step tests if the loop goes on.
                self._add(at, f"Until {text}", [node.condition]).condition = f"not ({text})"
                self._block(node.body)
            case nodes.Loop():
                self._loop(node, "Loop")
                self._block(node.body)
            case _:
                self._simple(node)

    def _if(self, node: nodes.If) -> None:
        """Read an If and its ElseIfs, each the only statement of the Else before, without nesting."""
        chain = [node]
        while len(chain[-1].orelse) == 1 and isinstance(following := chain[-1].orelse[0], nodes.If):
            chain.append(following)
        for each in chain:
            self._head(each.start, each.condition, "If {}")
            self._block(each.body)
        self._block(chain[-1].orelse)

    def _head(self, at: int, condition: nodes.Expr, form: str) -> None:
        text = self._text(condition)
        made = self._add(at, form.format(text), [condition])
        made.condition = text + self._characters([condition])

    def _characters(self, tests: Sequence[nodes.Node]) -> str:
        """Return the keys that a condition compares with, such as " ('a', 'b')", "" if none."""
        compared = sorted(
            (each.start, self._keys[id(each)]) for each in walk(tests) if id(each) in self._keys
        )
        found = [repr(chr(code)) for _, code in compared]
        return f" ({', '.join(found)})" if found else ""

    def _loop(self, node: nodes.Stmt, text: str) -> None:
        made = self._add(node.start, text, [])
        made.is_silent, made.effect = True, LEADS

    def _simple(self, node: nodes.Stmt) -> None:
        made = self._add(node.start, self._text(node), [])
        made.form = "" if isinstance(node, _DEFINING) else form(node)
        made.normal = made.form and form(node, is_normal=True)
        is_call = isinstance(node, nodes.Call) and node.target.symbol is not None and not node.target.args
        if is_call or isinstance(node, _LEADING):
            made.effect = LEADS
        elif isinstance(node, nodes.Print):
            made.effect = PRINTS
        elif isinstance(node, nodes.Auto):
            made.effect = STARTS
        is_goto = isinstance(node, nodes.Jump) and node.kind == "goto"
        made.is_silent = not is_stop(node) or is_goto or isinstance(node, _JUMPS)
        match node:
            case nodes.Assign():
                self._assign(made, node)
            case nodes.Call():
                self._called(made, node.target)
            case nodes.Pause():
                made.waits, made.condition = "condition", self._text(node.condition)
                self._read(made, node.condition)
            case nodes.Input():
                made.waits = "operator"
                prompt = "" if node.prompt is None else self._text(node.prompt).strip('" ')
                answer = ChannelUse("answer", prompt or "INPUT", READ, made.at, value=self._text(node.target))
                made.channels.append(answer)
                self._target(made, node.target)
            case nodes.Run():
                made.starts.append(f"task {node.name}")
            case nodes.End() if node.name is not None:
                made.ends.append(f"task {node.name}")
            case nodes.Define():
                pass  # its expression is read where its name is
            case nodes.Label():
                self.labels[self._function, node.name.lower()] = node.start
            case _:
                if isinstance(node, nodes.Dim) and node.nv:
                    names = [str(each.name) for each in node.variables]
                    made.channels += [ChannelUse("nv word", name, SET_UP, made.at) for name in names]
                for each in children(node):
                    self._read(made, each)

    def _add(self, at: int, text: str, parts: Sequence[nodes.Node]) -> Statement:
        made = self.statements[at] = Statement(at, self.line(at), text)
        word = text.split(maxsplit=1)[0]
        made.form, made.normal = (f"{word} {form([*parts], each)}" for each in (False, True))
        for each in parts:
            self._read(made, each)
        return made

    # ------------------------------------------------------------------------------------------- what is used

    def _assign(self, made: Statement, node: nodes.Assign) -> None:
        target = node.target
        meaning = meant(target)
        for each in node.values:
            self._read(made, each)
        if isinstance(meaning, nodes.Name) and meaning.row is not None and meaning.symbol is None:
            self._word(made, meaning, meaning.row, WRITE, node.values, _alias(target))
            return
        self._target(made, target)
        symbol = getattr(meaning, "symbol", None)
        if symbol is not None and symbol.type.name == SEMAPHORE:
            made.waits = "" if fold(node.values[0]) == 0 else "task"

    def _called(self, made: Statement, target: nodes.Name) -> None:
        row = target.row
        if row is not None and target.symbol is None:
            self._word(made, target, row, WRITE, list(target.args or ()) if row.index == "none" else [])
        else:
            self._read(made, target)

    def _target(self, made: Statement, target: nodes.Expr) -> None:
        """Record what the subscripts of a variable read that is assigned."""
        while isinstance(target, nodes.Member):
            target = target.value
        if isinstance(target, nodes.Name):
            for each in target.args or ():
                self._read(made, each)

    def _read(self, made: Statement, part: object, alias: str = "") -> None:
        """Record what an expression reads, and the functions that it calls."""
        if not isinstance(part, nodes.Node):
            return
        if isinstance(part, nodes.Name) and part.definition is not None and part.args is None:
            self._read(made, part.definition, str(part.name))
            return
        for each in children(part):
            self._read(made, each)
        if not isinstance(part, nodes.Name):
            return
        if part.symbol is None:
            if part.row is not None:
                self._word(made, part, part.row, READ, [], alias)
        elif part.symbol.kind in ("variable", "parameter") and part.symbol.type.name == TIME:
            made.uses.append(Use("read", table().get("TIME"), part.start))
        elif part.symbol.kind == "sub" and self._function.result_named(part) is None:
            callee = part.symbol.home.qualified_name
            axes = tuple(axis_of(each, self._changed) for each in part.args or ())
            made.uses.append(Use("call", None, part.start, callee=callee, arguments=axes))

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
        args = list(name.args or ())
        if row.kind not in _PURE:
            axes = axes_of(name, row, self.names, self._changed)
            written = [Written(self._text(each), fold(meant(each))) for each in values]
            numbers = tuple(int(n) if (n := _number(each)) != _UNKNOWN else None for each in args)
            made.uses.append(Use(role_of(row, access), row, name.start, axes, written, numbers=numbers))
        access = READ if row.access == "R" else access
        if row.channel:
            made.channels += self._channels(made.at, name, row, access, values, alias)
        if row.selects and access == WRITE:
            for k, each in enumerate(values):
                by = f"{row.name}({_number(args[k])})" if k < len(args) else row.name
                if not _number(each).startswith("-"):
                    made.channels.append(
                        ChannelUse(row.selects, _number(each), SET_UP, made.at, _alias(each), by, name.start)
                    )

    def _channels(
        self, at: int, name: nodes.Name, row: Keyword, access: str, values: list[nodes.Expr], alias: str
    ) -> Iterator[ChannelUse]:
        kinds = row.index.split(", ")
        numbers = [
            each
            for k, each in enumerate(name.args or ())
            if kinds[min(k, len(kinds) - 1)] not in ("axis", "axes")
        ]
        several = len(kinds) == 1 and len(numbers) > 1
        for k, group in enumerate([[each] for each in numbers] if several else [numbers]):
            number = ", ".join(map(_number, group)) or ("0" if kinds[0] != "none" else "")
            value = self._text(values[min(k, len(values) - 1)]) if values else ""
            known_as = alias or next((a for a in map(_alias, group) if a), "")
            if row.channel == "key":
                codes = sorted(self._keys.values())
                known_as = ", ".join(dict.fromkeys(repr(chr(code)) for code in codes))
            yield ChannelUse(row.channel, number, access, at, known_as, value, name.start, row.unit)

    # -------------------------------------------------------------------------------------------------- texts

    def _given(self, node: nodes.Assign) -> str:
        """Return the number, text or name that a statement assigns, behind the index of an element; "" for others."""
        value = node.values[0]
        number = value.operand if isinstance(value, nodes.Unary) else value
        is_name = isinstance(value, nodes.Name) and value.args is None
        if len(node.values) > 1 or not (is_name or isinstance(number, (nodes.Number, nodes.String))):
            return ""
        index = (
            self._text(node.target)[len(node.target.name) :] if isinstance(node.target, nodes.Name) else ""
        )
        return f"{index}: {self._text(value)}".removeprefix(": ")

    def _text(self, node: nodes.Node) -> str:
        """Return a part of the program as it is written, on one line and without comments."""
        text = " ".join(self.source.text[node.start : node.end].split())
        code = _QUOTED.sub("", text)
        return "(" * (code.count(")") - code.count("(")) + text  # a node in brackets begins behind them


def axes_of(
    name: nodes.Name, row: Keyword, names: Symbols, changed: Container[Symbol | None]
) -> tuple[AxisKey, ...]:
    """Return the axes that a keyword names; `changed` are the variables that the program assigns to."""
    if row.does("all"):
        return (None,)
    kinds = row.index.split(", ")
    if not {"axis", "axes"} & set(kinds):
        return ()
    if not name.args:
        return (None,) if names.uses_axes else (0,)
    of_axes = [each for k, each in enumerate(name.args) if kinds[min(k, len(kinds) - 1)] in ("axis", "axes")]
    return tuple(axis_of(each, changed) for each in of_axes)


def axis_of(node: nodes.Expr, changed: Container[Symbol | None]) -> AxisKey:
    """Return the axis that an expression is: its number, or the parameter that holds it; None if it is unknown."""
    value = fold(meant(node))
    if isinstance(value, (int, float)):
        return int(value) if value == int(value) else None
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "parameter" or symbol.by_ref or symbol.is_array or symbol in changed:
        return None
    return symbol.name


def _number(node: nodes.Expr) -> str:
    value = fold(meant(node))
    if isinstance(value, (int, float)) and value == int(value):
        return str(int(value))
    return _UNKNOWN


def _alias(node: nodes.Expr) -> str:
    """Return the name of the constant or Define for a number or a channel."""
    if isinstance(node, nodes.Name) and (node.definition is not None or node.symbol is not None):
        return str(node.name)
    return ""


def _keys(body: list[nodes.Node]) -> Iterator[tuple[nodes.Node, int]]:
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
            code = fold(meant(other))
            is_read = _is_key(side) or (isinstance(side, nodes.Name) and side.symbol in given)
            if is_read and isinstance(code, (int, float)) and _FIRST_KEY <= code <= _LAST_KEY:
                yield at, int(code)


def _is_key(node: object) -> bool:
    row = node.row if isinstance(node, nodes.Name) else None
    return row is not None and row.driven == "key"
