"""The abstract syntax of Mint: what the parser builds and the compiler reads.

Every node carries `at`, the ordinal of its first token; `Module.line(at)` and `Module.column(at)` turn it
into a place in the text. Nodes are written out by hand because thirty generated dataclasses would cost more
at start-up than parsing a page of Mint does (see docs/decisions.md).

The grammar knows no keyword of the motion library: `SPEED(0) = 10` is an `Assign` to a `Name`, `GO(0)` is a
`Call` of a `Name`; the keyword table gives them their meaning in the compiler.
"""

from __future__ import annotations

from motionlang.mint.syntax.chain import Chain as Chain  # noqa: PLC0414
from motionlang.mint.syntax.chain import Link as Link  # noqa: PLC0414
from motionlang.mint.syntax.given import Cast as Cast  # noqa: PLC0414 - so are these
from motionlang.mint.syntax.given import Given as Given  # noqa: PLC0414
from motionlang.mint.syntax.node import Node as Node  # noqa: PLC0414 - nodes.Node to everybody else
from motionlang.mint.syntax.node import Resolved

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.parsing.places import Places

# --------------------------------------------------------------------------------------------- expressions


class Number(Node):
    """A literal number; `value` is an int where the text has neither point nor exponent, else a float."""

    __slots__ = ("value",)

    def __init__(self, at: int, value: float) -> None:
        self.at, self.value = at, value


class String(Node):
    """A literal string, without its quotes."""

    __slots__ = ("value",)

    def __init__(self, at: int, value: str) -> None:
        self.at, self.value = at, value


class Name(Resolved):
    """A word with or without arguments: variable, array element, keyword, function.

    `name` keeps the spelling of the source; `args` is None where no bracket follows. `axes` is true for the
    v4 forms `MOVER.0` and `MOVER[0, 1]`, whose indices can only be axes or channels.
    """

    __slots__ = ("args", "axes", "name")

    def __init__(self, at: int, name: str, args: list[Expr] | None = None, axes: bool = False) -> None:
        self.at, self.name, self.args, self.axes = at, name, args, axes


class Member(Node):
    """`value.field` of a user type; `args` are the subscripts of `value.field(…)`, None without a bracket."""

    __slots__ = ("args", "field", "value")

    def __init__(self, at: int, value: Expr, field: str, args: list[Expr] | None = None) -> None:
        self.at, self.value, self.field, self.args = at, value, field, args


class Unary(Node):
    """`op` is one of `-`, `+`, `Not`, `~`."""

    __slots__ = ("op", "operand")

    def __init__(self, at: int, op: str, operand: Expr) -> None:
        self.at, self.op, self.operand = at, op, operand


class Binary(Node):
    """`op` is one of `^ * / \\ Mod + - << >> & | Xor = <> < > <= >= And Or` in canonical spelling."""

    __slots__ = ("left", "op", "right")

    def __init__(self, at: int, op: str, left: Expr, right: Expr) -> None:
        self.at, self.op, self.left, self.right = at, op, left, right


class Omitted(Node):
    """A place left free in a list of values, `SPEED(0, 1) = , 20`; it stands at the `,` after it."""

    __slots__ = ()

    def __init__(self, at: int) -> None:
        self.at = at


Expr = Number | String | Given | Cast | Name | Member | Unary | Binary | Chain | Omitted


# ---------------------------------------------------------------------------------------------- statements


class Assign(Node):
    """`target = value, value …`; `repeat` is the trailing `;` that gives the last value to all other axes.

    An `Omitted` among the values leaves its axis as it is; the last value is never omitted.
    """

    __slots__ = ("repeat", "target", "values")

    def __init__(self, at: int, target: Name | Member, values: list[Expr], repeat: bool = False) -> None:
        self.at, self.target, self.values, self.repeat = at, target, values, repeat


class Call(Node):
    """A command or a sub: `GO(0)`, `Fill(3)`, `Fill 3, 4` (`args` of the bare form live in `target.args`)."""

    __slots__ = ("target",)

    def __init__(self, at: int, target: Name) -> None:
        self.at, self.target = at, target


class PrintItem(Node):
    """One value of a PRINT with its `USING` formats, and the separator (`,` or `;` or "") that follows it."""

    __slots__ = ("separator", "using", "value")

    def __init__(self, at: int, value: Expr, using: list[Expr], separator: str) -> None:
        self.at, self.value, self.using, self.separator = at, value, using, separator


class Print(Resolved):
    """`PRINT [#terminal,] items`; the last item's separator decides whether the line ends.

    `word` is another word than PRINT that stands before items, which only LINE may; its `line` comes before them.
    """

    __slots__ = ("items", "line", "terminal", "word")

    def __init__(
        self,
        at: int,
        items: list[PrintItem],
        terminal: Expr | None = None,
        word: str = "",
        line: Expr | None = None,
    ) -> None:
        self.at, self.items, self.terminal, self.word, self.line = at, items, terminal, word, line


class Input(Node):
    """`INPUT [#terminal,] ["prompt",] variable [USING …]`."""

    __slots__ = ("prompt", "target", "terminal", "using")

    def __init__(
        self, at: int, target: Name | Member, prompt: Expr | None, using: list[Expr], terminal: Expr | None
    ) -> None:
        self.at, self.target, self.prompt, self.using, self.terminal = at, target, prompt, using, terminal


class TypeName(Node):
    """`Integer`, `Float`, `String * size`, `Time`, `Semaphore`, `Controller` or a user type."""

    __slots__ = ("name", "size")

    def __init__(self, at: int, name: str, size: Expr | None = None) -> None:
        self.at, self.name, self.size = at, name, size


class Variable(Resolved):
    """One name of a `Dim`: its dimensions (empty for a plain variable), its type and its initial values."""

    __slots__ = ("dimensions", "name", "type", "values")

    def __init__(
        self, at: int, name: str, dimensions: list[Expr], type: TypeName | None, values: list[Expr]
    ) -> None:
        self.at, self.name, self.dimensions, self.type, self.values = at, name, dimensions, type, values


class Dim(Node):
    """`Dim a As Integer, b(3) = 1, 2, 3`; `nv` for data that survives between runs."""

    __slots__ = ("nv", "variables")

    def __init__(self, at: int, variables: list[Variable], nv: bool = False) -> None:
        self.at, self.variables, self.nv = at, variables, nv


class Const(Node):
    """`Const name [As type] = value, …`; the further names of the statement stand in `more`, each by itself."""

    __slots__ = ("more", "name", "type", "value")

    def __init__(self, at: int, name: str, type: TypeName | None, value: Expr) -> None:
        self.at, self.name, self.type, self.value = at, name, type, value
        self.more: list[Const] = []


class Define(Node):
    """`Define name = text`: `name` stands for an expression wherever it is used."""

    __slots__ = ("name", "value")

    def __init__(self, at: int, name: str, value: Expr) -> None:
        self.at, self.name, self.value = at, name, value


class If(Node):
    """`If … Then … ElseIf … Else … End If` and the one-line form; an `ElseIf` is an `If` in `orelse`."""

    __slots__ = ("body", "condition", "orelse")

    def __init__(self, at: int, condition: Expr, body: list[Stmt], orelse: list[Stmt]) -> None:
        self.at, self.condition, self.body, self.orelse = at, condition, body, orelse


class CaseTest(Node):
    """One entry of a `Case`: a value (`op` "="), a range (`op` "To", with `high`) or `Is op value`."""

    __slots__ = ("high", "op", "value")

    def __init__(self, at: int, op: str, value: Expr, high: Expr | None = None) -> None:
        self.at, self.op, self.value, self.high = at, op, value, high


class Case(Node):
    """`Case tests`; `Case Else` has no tests."""

    __slots__ = ("body", "tests")

    def __init__(self, at: int, tests: list[CaseTest], body: list[Stmt]) -> None:
        self.at, self.tests, self.body = at, tests, body


class Select(Node):
    """`Select Case subject … End Select`."""

    __slots__ = ("cases", "subject")

    def __init__(self, at: int, subject: Expr, cases: list[Case]) -> None:
        self.at, self.subject, self.cases = at, subject, cases


class For(Node):
    """`For variable = start To stop Step step … Next`."""

    __slots__ = ("body", "start", "step", "stop", "variable")

    def __init__(
        self, at: int, variable: Name, start: Expr, stop: Expr, step: Expr | None, body: list[Stmt]
    ) -> None:
        self.at, self.variable, self.start, self.stop, self.step, self.body = (
            at,
            variable,
            start,
            stop,
            step,
            body,
        )


class While(Node):
    """`While condition … End While`."""

    __slots__ = ("body", "condition")

    def __init__(self, at: int, condition: Expr, body: list[Stmt]) -> None:
        self.at, self.condition, self.body = at, condition, body


class Repeat(Node):
    """`Repeat … Until condition`."""

    __slots__ = ("body", "condition")

    def __init__(self, at: int, body: list[Stmt], condition: Expr) -> None:
        self.at, self.body, self.condition = at, body, condition


class Loop(Node):
    """`Loop … End Loop`."""

    __slots__ = ("body",)

    def __init__(self, at: int, body: list[Stmt]) -> None:
        self.at, self.body = at, body


class Exit(Node):
    """`Exit [For | While | Repeat | Loop | Select | Sub | Function | Task | Event]`; `kind` is lower case."""

    __slots__ = ("kind",)

    def __init__(self, at: int, kind: str) -> None:
        self.at, self.kind = at, kind


class Pause(Node):
    """`Pause condition`: wait until it is true."""

    __slots__ = ("condition",)

    def __init__(self, at: int, condition: Expr) -> None:
        self.at, self.condition = at, condition


class Run(Resolved):
    """`Run task`."""

    __slots__ = ("name",)

    def __init__(self, at: int, name: str) -> None:
        self.at, self.name = at, name


class End(Resolved):
    """`End` (the program) or `End task`."""

    __slots__ = ("name",)

    def __init__(self, at: int, name: str | None = None) -> None:
        self.at, self.name = at, name


class Label(Node):
    """`#NAME` (v4) or `NAME:` on a line of its own."""

    __slots__ = ("name",)

    def __init__(self, at: int, name: str) -> None:
        self.at, self.name = at, name


class Jump(Node):
    """`kind` is "goto" or "gosub"; where blocks were taken apart "exit" (`unless` a condition holds) and "again"."""

    __slots__ = ("kind", "name", "unless")

    def __init__(self, at: int, kind: str, name: str, unless: Expr | None = None) -> None:
        self.at, self.kind, self.name, self.unless = at, kind, name, unless


class Return(Node):
    """`Return` from a `Gosub`, an event or a sub."""

    __slots__ = ()

    def __init__(self, at: int) -> None:
        self.at = at


class Auto(Node):
    """`Auto`: start the program at power-up."""

    __slots__ = ()

    def __init__(self, at: int) -> None:
        self.at = at


Stmt = (
    Assign
    | Call
    | Print
    | Input
    | Dim
    | Const
    | Define
    | If
    | Select
    | For
    | While
    | Repeat
    | Loop
    | Exit
    | Pause
    | Run
    | End
    | Label
    | Jump
    | Return
    | Auto
)


# -------------------------------------------------------------------------------------------- declarations


class Parameter(Node):
    """One parameter of a sub or a function."""

    __slots__ = ("by_ref", "is_array", "name", "type")

    def __init__(
        self, at: int, name: str, type: TypeName | None, by_ref: bool = False, is_array: bool = False
    ) -> None:
        self.at, self.name, self.type, self.by_ref, self.is_array = at, name, type, by_ref, is_array


class Sub(Node):
    """`Sub name(parameters) … End Sub`; a `Function` has a `result` type."""

    __slots__ = ("body", "function", "name", "parameters", "result")

    def __init__(
        self,
        at: int,
        name: str,
        parameters: list[Parameter],
        body: list[Stmt],
        function: bool = False,
        result: TypeName | None = None,
    ) -> None:
        self.at, self.name, self.parameters, self.body = at, name, parameters, body
        self.function, self.result = function, result


class Task(Node):
    """`Task name … End Task`, with the subs and functions written inside it."""

    __slots__ = ("body", "name", "subs")

    def __init__(self, at: int, name: str, body: list[Stmt], subs: list[Sub]) -> None:
        self.at, self.name, self.body, self.subs = at, name, body, subs


class Event(Node):
    """`Event name … End Event`."""

    __slots__ = ("body", "name")

    def __init__(self, at: int, name: str, body: list[Stmt]) -> None:
        self.at, self.name, self.body = at, name, body


class Startup(Node):
    """`Startup … End Startup`."""

    __slots__ = ("body",)

    def __init__(self, at: int, body: list[Stmt]) -> None:
        self.at, self.body = at, body


class UserType(Node):
    """`Type name … End Type`."""

    __slots__ = ("members", "name")

    def __init__(self, at: int, name: str, members: list[Variable]) -> None:
        self.at, self.name, self.members = at, name, members


class Placed(Node):
    """A tree that knows where its tokens stand; that takes no part in equality, as no position does."""

    __slots__ = ("places",)

    places: Places

    def line(self, at: int) -> int:
        """The line, from 1, of a token; `at` is that of any node of the tree."""
        return self.places.line(at)

    def column(self, at: int) -> int:
        """The column, from 1, of a token."""
        return self.places.column(at)

    def length(self, at: int) -> int:
        """The number of characters of a token; of a value that begins with a sign, those of the whole."""
        return self.places.value_length(at)


class Module(Placed):
    """A whole program: the parent task's statements, then its blocks, in source order."""

    __slots__ = ("body", "events", "startup", "subs", "tasks", "types")

    def __init__(
        self,
        body: list[Stmt],
        subs: list[Sub],
        tasks: list[Task],
        events: list[Event],
        startup: list[Startup],
        types: list[UserType],
    ) -> None:
        self.at = 0
        self.body, self.subs, self.tasks, self.events = body, subs, tasks, events
        self.startup, self.types = startup, types
