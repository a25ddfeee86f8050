"""Build the tree of a program: the methods that the alternatives of grammars/mint.lark name.

Lark calls the method when it has read the alternative, with a token or a value for each symbol, and None for what is
left out of `[…]`. Most methods make one node. A node extends from its first token to its last. An expression in
brackets begins behind the opening one, at which no message points, and ends with the closing one.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import Any, TypeVar

import lark
from lark import Transformer, v_args

from motionlang.kernel.lang.syntax.grammar import Token
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.syntax.nodes import (
    Assign,
    Auto,
    Binary,
    Call,
    Case,
    CaseTest,
    Const,
    Define,
    Dim,
    End,
    Event,
    Exit,
    Expr,
    For,
    If,
    Input,
    Jump,
    Label,
    Loop,
    Member,
    Module,
    Name,
    Node,
    Number,
    Omitted,
    Parameter,
    Pause,
    Print,
    PrintItem,
    Repeat,
    Return,
    Run,
    Select,
    Startup,
    Stmt,
    String,
    Sub,
    Task,
    TypeName,
    Unary,
    UserType,
    Variable,
    While,
    Wrong,
)

T = TypeVar("T")
# What follows the values of a LINE: formats, separator, further items.
Rest = tuple[list[Expr], str, list[PrintItem]]

ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "0": "\0"}
# The operators with more than one spelling.
OPERATORS = {
    "AND": "And",
    "OR": "Or",
    "XOR": "Xor",
    "NOT": "Not",
    "MOD": "Mod",
    "PERCENT": "Mod",
    "COMPLEMENT": "~",
}
_BEYOND = 1 << 1023


class Misuse(Exception):
    """Raised for text that the grammar accepts but the language does not allow.

    `motionlang.kernel.mint.syntax.errors` then finds the error and its position.
    """


def number(text: str) -> float:
    """Return the value of a literal number, such as `12`, `1.5e-3`, `0x1F` or `0b101`.

    The value is infinite if the number is too large for a Float.
    """
    if text[1:2] in ("x", "X", "b", "B"):
        return _finite(int(text, 0))
    try:
        return _finite(int(text)) if text.isdigit() else float(text)
    except ValueError:  # more digits than Python converts
        return inf


def _finite(whole: int) -> float:
    """Return an integer, or infinity if a Float cannot hold it."""
    return whole if whole < _BEYOND else inf


def string(text: str) -> str:
    """Return the text of a literal string or character, without its quotes."""
    if "\\" not in text:
        return text[1:-1]
    first, *rest = text[1:-1].split("\\")
    out = [first]
    pieces = iter(rest)
    for piece in pieces:
        if piece:
            out.append(ESCAPES.get(piece[0], piece[0]) + piece[1:])
        else:  # `\\`: the text after it is literal
            out.append("\\" + next(pieces, ""))
    return "".join(out)


def _word(token: Token) -> Word:
    return Word(token, token.start_pos, token.end_pos)


def _end(symbol: Token | Node) -> int:
    return symbol.end if isinstance(symbol, Node) else symbol.end_pos


def _value(text: str) -> float:
    value = number(text)
    if value == inf:
        raise Misuse
    return value


@v_args(inline=True)
class Builder(Transformer[lark.Token, Module]):
    """A method for each alternative; its parameters are the symbols."""

    # ----------------------------------------------------------------------------------- lists and choices

    def none(self, *_symbols: object) -> list[object]:
        return []

    def one(self, item: T, _separator: object = None) -> list[T]:
        return [item]

    def pair(self, first: T, _comma: object, second: T) -> list[T]:
        return [first, second]

    def add(self, items: list[T], item: T, _separator: object = None) -> list[T]:
        items.append(item)
        return items

    def more(self, items: list[T], _separator: object, item: T) -> list[T]:
        items.append(item)
        return items

    def extend(self, items: list[T], _dim: object, more: list[T], _separator: object) -> list[T]:
        items += more
        return items

    def first(self, symbol: T, *_others: object) -> T:
        return symbol

    def second(self, _first: object, symbol: T, *_others: object) -> T:
        return symbol

    # ---------------------------------------------------------------------------------------- declarations

    def module(self, items: list[Stmt | Sub | Task | Event | Startup | UserType]) -> Module:
        """Put the blocks of a program into separate lists, by kind."""
        module = Module(0, items[-1].end if items else 0, [], [], [], [], [], [])
        lists: dict[type, list[Any]] = {
            Sub: module.subs,
            Task: module.tasks,
            Event: module.events,
            Startup: module.startup,
            UserType: module.types,
        }
        for item in items:
            lists.get(type(item), module.body).append(item)
        return module

    def task(
        self,
        first: Token,
        name: Token,
        _separator: object,
        items: list[Stmt | Sub],
        _end_word: object,
        last: Token,
    ) -> Task:
        """`Task name … End Task`: its statements, and apart from them its subs."""
        subs = [each for each in items if isinstance(each, Sub)]
        statements = [each for each in items if not isinstance(each, Sub)]
        return Task(first.start_pos, last.end_pos, _word(name), statements, subs)

    def event(
        self, first: Token, name: Token, _separator: object, body: list[Stmt], _end_word: object, last: Token
    ) -> Event:
        return Event(first.start_pos, last.end_pos, _word(name), body)

    def startup(
        self, first: Token, _separator: object, body: list[Stmt], _end_word: object, last: Token
    ) -> Startup:
        return Startup(first.start_pos, last.end_pos, body)

    def user_type(
        self,
        first: Token,
        name: Token,
        _separators: object,
        members: list[Variable],
        _end_word: object,
        last: Token,
    ) -> UserType:
        """`Type name … End Type`."""
        return UserType(first.start_pos, last.end_pos, _word(name), members)

    def sub(
        self,
        first: Token,
        name: Token,
        parameters: list[Parameter],
        _separator: object,
        body: list[Stmt],
        _end_word: object,
        last: Token,
    ) -> Sub:
        """`Sub name(…) … End Sub`."""
        return Sub(first.start_pos, last.end_pos, _word(name), parameters, body)

    def function(
        self,
        first: Token,
        name: Token,
        parameters: list[Parameter],
        _as: object,
        result: TypeName | None,
        _separator: object,
        body: list[Stmt],
        _end_word: object,
        last: Token,
    ) -> Sub:
        """`Function name(…) As type … End Function`."""
        return Sub(first.start_pos, last.end_pos, _word(name), parameters, body, True, result)

    def parameter(
        self,
        how: Token | None,
        name: Token,
        _open: object,
        close: Token | None,
        _as: object,
        kind: TypeName | None,
    ) -> Parameter:
        """`ByRef name() As type`, all but the name optional."""
        by_reference = how is not None and how.type == "BYREF"
        start, end = (how or name).start_pos, _end(kind or close or name)
        return Parameter(start, end, _word(name), kind, by_reference, close is not None)

    def type_name(self, name: Token, _star: object, size: Expr | None) -> TypeName:
        return TypeName(name.start_pos, _end(size or name), _word(name), size)

    # ------------------------------------------------------------------------------------------ statements

    def if_branch(self, first: Token, condition: Expr, *_symbols: object) -> list[If]:
        """Begin a block If: the list of its branches."""
        return [If(first.start_pos, condition.end, condition, [], [])]

    def else_if_branch(
        self, branches: list[If], body: list[Stmt], first: Token, condition: Expr, _then: object
    ) -> list[If]:
        branches[-1].body = body
        branches.append(If(first.start_pos, condition.end, condition, [], []))
        return branches

    def block_if(self, branches: list[If], body: list[Stmt], *symbols: Any) -> If:
        """Complete a block If, with its Else if it has one: each branch is in the Else of the one before."""
        *others, last = symbols
        orelse: list[Stmt] = others[-1] if others else []
        branches[-1].body = body
        for branch in reversed(branches):
            branch.orelse, branch.end = orelse, last.end_pos
            orelse = [branch]
        return branches[0]

    def line_if(
        self,
        first: Token,
        condition: Expr,
        _then: object,
        body: list[Stmt],
        _else: object = None,
        orelse: Sequence[Stmt] = (),
    ) -> If:
        """`If condition Then a : b Else c`; the tail of an Else may be another one."""
        return If(first.start_pos, (orelse or body)[-1].end, condition, body, [*orelse])

    def for_head(
        self,
        word: Token,
        name: Token,
        _equal: object,
        first: Expr,
        _to: object,
        stop: Expr,
        _step: object,
        step: Expr | None,
        _separator: object,
    ) -> For:
        """Begin a For; its body follows."""
        variable = Name(name.start_pos, name.end_pos, _word(name))
        return For(word.start_pos, stop.end, variable, first, stop, step, [])

    def for_loop(self, loop: For, body: list[Stmt], first: Token, *names: Token | None) -> For:
        """Complete a For; raise Misuse if its last symbol, its name, is another variable."""
        name = names[0] if names else first
        if name and name.lower() != loop.variable.name.lower():
            raise Misuse
        loop.body, loop.end = body, (name or first).end_pos
        loop.last_name = None if name is None else _word(name)
        return loop

    def shared(self, statements: list[Stmt], loop: For, body: list[Stmt], *symbols: Token) -> list[Stmt]:
        return self.add(statements, self.for_loop(loop, body, *symbols[:-1]))

    def while_loop(
        self, first: Token, condition: Expr, _separator: object, body: list[Stmt], last: Token
    ) -> While:
        return While(first.start_pos, last.end_pos, condition, body)

    def repeat(
        self, first: Token, _separator: object, body: list[Stmt], _until: object, condition: Expr
    ) -> Repeat:
        return Repeat(first.start_pos, condition.end, body, condition)

    def loop(self, first: Token, _separator: object, body: list[Stmt], last: Token) -> Loop:
        return Loop(first.start_pos, last.end_pos, body)

    def select(self, first: Token, _case: object, subject: Expr, _separators: object, case: Case) -> Select:
        """Begin a Select with its first case, whose body follows."""
        return Select(first.start_pos, case.end, subject, [case])

    def next_case(self, select: Select, body: list[Stmt], case: Case) -> Select:
        self._complete(select.cases[-1], body)
        select.cases.append(case)
        return select

    def last_case(self, select: Select, body: list[Stmt], _end_word: object, last: Token) -> Select:
        self._complete(select.cases[-1], body)
        select.end = last.end_pos
        return select

    def _complete(self, case: Case, body: list[Stmt]) -> None:
        case.body = body
        case.end = body[-1].end if body else case.end

    def no_case(
        self, first: Token, _case: object, subject: Expr, _separators: object, _end_word: object, last: Token
    ) -> Select:
        return Select(first.start_pos, last.end_pos, subject, [])

    def case(self, first: Token, tests: list[CaseTest], _separator: object) -> Case:
        return Case(first.start_pos, tests[-1].end, tests, [])

    def case_else(self, first: Token, last: Token, _separator: object) -> Case:
        return Case(first.start_pos, last.end_pos, [], [])

    def test(self, value: Expr) -> CaseTest:
        return CaseTest(value.start, value.end, "=", value)

    def range_test(self, low: Expr, _to: object, high: Expr) -> CaseTest:
        return CaseTest(low.start, high.end, "To", low, high)

    def is_test(self, first: Token, op: Token, value: Expr) -> CaseTest:
        return CaseTest(first.start_pos, value.end, str(op), value)

    def assign(
        self, target: Name | Member, _equal: object, values: list[Expr], semicolon: Token | None
    ) -> Assign:
        return Assign(target.start, _end(semicolon or values[-1]), target, values, semicolon is not None)

    def omitted(self, comma: Token) -> Expr:
        return Omitted(comma.start_pos, comma.start_pos)

    def call(self, target: Name) -> Call:
        return Call(target.start, target.end, target)

    def bare_call(self, name: Token, values: list[Expr]) -> Call:
        start, end = name.start_pos, values[-1].end
        return Call(start, end, Name(start, end, _word(name), values))

    def line_print(self, name: Token, values: list[Expr], rest: Rest) -> Print:
        """Build a `LINE row, values` that has formats or separators, as a PRINT can.

        What follows the values belongs to the last of them.
        """
        using, separator, items = rest
        row = None if using and len(values) == 1 else values[0]
        shown = [
            PrintItem(each.start, each.end, each, [], ",") for each in values[1 if row is not None else 0 :]
        ]
        if shown:
            last = shown[-1]
            last.using, last.separator, last.end = using, separator, [last, *using][-1].end
        end = [*values, *using, *items][-1].end
        return Print(name.start_pos, end, [*shown, *items], None, _word(name), row)

    def rest(self, *symbols: Any) -> Rest:
        """Return the formats and the separator after the values of a LINE, and further items."""
        *using, separator, items, last = symbols
        return self._formats(using), str(separator), self._items(items, last)

    def last_rest(self, _using: object, formats: list[Expr]) -> Rest:
        return formats, "", []

    def _items(self, items: list[PrintItem], last: PrintItem | None) -> list[PrintItem]:
        return items if last is None else [*items, last]

    def print(
        self,
        first: Token,
        number_sign: Token,
        terminal: Expr | None,
        comma: Token | None,
        items: list[PrintItem],
        last: PrintItem | None,
    ) -> Print:
        """`PRINT #terminal, items`."""
        items = self._items(items, last)
        return Print(first.start_pos, _end(items[-1] if items else comma or first), items, terminal)

    def item(self, items: list[PrintItem], value: Expr, *symbols: Token | Expr) -> list[PrintItem]:
        return self.add(items, self.open_item(value, *symbols))

    def open_item(self, value: Expr, *symbols: Token | Expr) -> PrintItem:
        """`value USING width, decimals;`, with its separator."""
        *using, separator = symbols
        return PrintItem(value.start, _end(separator), value, self._formats(using), str(separator))

    def last_item(self, value: Expr, _using: object = None, formats: Sequence[Expr] = ()) -> PrintItem:
        return PrintItem(value.start, [value, *formats][-1].end, value, [*formats], "")

    def _formats(self, symbols: Sequence[Token | Expr]) -> list[Expr]:
        return [each for each in symbols if isinstance(each, Node)]

    def input(
        self,
        first: Token,
        _sign: object,
        terminal: Expr | None,
        _comma: object,
        prompt: Token | None,
        _separator: object,
        target: Name | Member,
        _using: object,
        formats: list[Expr] | None,
    ) -> Input:
        """`INPUT #terminal, "prompt", variable USING formats`."""
        text = None if prompt is None else self.string(prompt)
        end = (formats or [target])[-1].end
        return Input(first.start_pos, end, target, text, formats or [], terminal)

    def dim(self, first: Token, nv: Token | None, variables: list[Variable]) -> Dim:
        return Dim(first.start_pos, variables[-1].end, variables, nv is not None)

    def variable(self, name: Name, _as: object = None, kind: TypeName | None = None) -> Variable:
        return self._variable(name, kind, [])

    def valued(self, name: Name, _as: object, kind: TypeName | None, _equal: object, value: Expr) -> Variable:
        return self._variable(name, kind, [value])

    def _variable(self, name: Name, kind: TypeName | None, values: list[Expr]) -> Variable:
        """Build a variable of a Dim; the values in brackets are its dimensions."""
        last = values[-1] if values else kind or name
        return Variable(name.start, last.end, name.name, name.args or [], kind, values)

    def more_values(self, variables: list[Variable], _comma: object, value: Expr) -> list[Variable]:
        """Handle a `,` after an initial value: extend an array or begin a variable.

        A second value for a simple variable is stored with it. The check counts the values and reports the error.
        """
        last = variables[-1]
        if isinstance(value, Name) and not last.dimensions and not value.axes:
            variables.append(self._variable(value, None, []))
        else:
            last.values.append(value)
            last.end = value.end
        return variables

    def const(self, keyword: Token, names: list[Const]) -> Const:
        """Build a Const: the node of the first name holds the further ones."""
        first, *first.more = names
        first.start, first.end = keyword.start_pos, names[-1].end
        return first

    def constant(self, name: Token, _as: object, kind: TypeName | None, _equal: object, value: Expr) -> Const:
        return Const(name.start_pos, value.end, _word(name), kind, value)

    def define(self, first: Token, name: Token, _equal: object, value: Expr) -> Define:
        return Define(first.start_pos, value.end, _word(name), value)

    def exit(self, first: Token, kind: Token | None) -> Exit:
        return Exit(first.start_pos, (kind or first).end_pos, "" if kind is None else kind.lower())

    def pause(self, first: Token, condition: Expr) -> Pause:
        return Pause(first.start_pos, condition.end, condition)

    def run(self, first: Token, name: Token) -> Run:
        return Run(first.start_pos, name.end_pos, _word(name))

    def end(self, first: Token, name: Token | None) -> End:
        return End(first.start_pos, (name or first).end_pos, None if name is None else _word(name))

    def label(self, sign: Token, name: Token) -> Label:
        return Label(sign.start_pos, name.end_pos, _word(name))

    def jump(self, kind: Token, _sign: object, name: Token) -> Jump:
        return Jump(kind.start_pos, name.end_pos, kind.lower(), _word(name))

    def return_(self, word: Token) -> Return:
        return Return(word.start_pos, word.end_pos)

    def auto(self, word: Token) -> Auto:
        return Auto(word.start_pos, word.end_pos)

    # ------------------------------------------------------------------------------ names and expressions

    def name(self, token: Token) -> Name:
        return Name(token.start_pos, token.end_pos, _word(token))

    def name_with(self, token: Token, _open: object, values: list[Expr] | None, close: Token) -> Name:
        return Name(token.start_pos, close.end_pos, _word(token), values or [])

    def name_of_axes(self, token: Token, _open: object, values: list[Expr], close: Token) -> Name:
        return Name(token.start_pos, close.end_pos, _word(token), values, True)

    def dotted(self, token: Token) -> Name:
        """Build the name for `REMOTEOUT.1.2`: a keyword with its channels."""
        text, *channels = token.split(".")
        start, end = token.start_pos, token.end_pos
        values: list[Expr] = [Number(start, end, _value(each)) for each in channels]
        return Name(start, end, Word(text, start, start + len(text)), values, True)

    def member(
        self,
        value: Name | Member,
        _dot: object,
        field: Token,
        _open: object,
        values: list[Expr] | None,
        close: Token | None,
    ) -> Member:
        """`value.field`, or `value.field(…)`: an element of an array in a record."""
        return Member(value.start, (close or field).end_pos, value, _word(field), values)

    def binary(self, left: Expr, op: Token, right: Expr) -> Binary:
        return Binary(left.start, right.end, OPERATORS.get(op.type) or str(op), left, right)

    def unary(self, op: Token, operand: Expr) -> Unary:
        return Unary(op.start_pos, operand.end, OPERATORS.get(op.type) or str(op), operand)

    def bracketed(self, _open: object, value: Expr, close: Token) -> Expr:
        value.end = close.end_pos
        return value

    def number(self, token: Token) -> Number:
        return Number(token.start_pos, token.end_pos, _value(token))

    def string(self, token: Token) -> String:
        return String(token.start_pos, token.end_pos, string(token))

    def wrong(self, token: Token) -> Wrong:
        return Wrong(token.start_pos, token.end_pos)

    def character(self, token: Token) -> Number:
        return Number(token.start_pos, token.end_pos, ord(string(token)))
